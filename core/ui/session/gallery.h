// SPDX-License-Identifier: MIT
#pragma once
// Presets and recent scenes with small pictures of them. Recent scenes are links that the host
// keeps from one start to the next, the newest first; what is being worked on stands on top and is
// one entry, however much it changes. Pictures are made while nothing else is, and kept until the
// end.

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "ui/host/host.h"
#include "workspace/workspace.h"

namespace versorium {

class Gallery {
  public:
    static constexpr std::size_t kMostRecent = 24;
    static constexpr int kWidth = 192, kHeight = 120;  // of a picture, in pixels

    struct Entry {
        std::string title;
        std::string preset;  // its name, or
        std::string link;    // a recent workspace
        std::string key() const { return preset.empty() ? link : preset; }
    };

    // Reads what the host kept. Links that do not open any more are left out.
    void load(Host& host);
    // The workspace that is being worked on, after each deed.
    void remember(Host& host, const Workspace& workspace);
    // What is remembered next is another piece of work.
    void beginAnew() { working_ = false; }
    const std::vector<Entry>& presets();
    const std::vector<Entry>& recent() const { return recent_; }

    // Asks for one picture that is missing among the entries.
    void ask(Host& host);
    void take(WorkAnswer answer);
    // Null while there is none.
    unsigned picture(const Entry& entry);
    void contextLost();
    // Somebody else asks for small pictures now: what was asked for does not come.
    void letGo() { asked_.clear(); }

  private:
    struct Picture {
        std::vector<unsigned char> rgba;
        Size size{0, 0};
        unsigned texture = 0;
    };
    void store(Host& host) const;

    std::vector<Entry> presets_, recent_;
    bool working_ = false;
    std::map<std::string, Picture> pictures_;
    std::string asked_;  // the key of the picture that is being made
    std::uint64_t id_ = 0;
};

// "Quadratic family · 0.25": the map and how deep the focused view looks.
std::string titleOf(const Workspace& workspace);
// The title in the language of the interface.
std::string shownTitle(const Gallery::Entry& entry);

}  // namespace versorium
