// SPDX-License-Identifier: MIT
#pragma once
// The workspace that is open, its history, and the one way to change it: whatever edit() does
// becomes a step of the history once the hand is off. Nothing else can write to a workspace.

#include <cstdint>
#include <utility>

#include "ui/host/host.h"
#include "workspace/workspace.h"

namespace versorium {

class OpenWorkspace {
  public:
    OpenWorkspace(Workspace first, Host& host)
        : history_(std::move(first)), workspace_(history_.now()), host_(host) {}

    const Workspace& now() const { return workspace_; }
    // Returns what the change returns, by value.
    template <class Change>
    auto edit(Change&& change) {
        const Edited edited{*this};
        return std::forward<Change>(change)(workspace_);
    }
    // Which view is focused: shown at once, but by itself no step of the history.
    void focus(int view) { workspace_.focused = view; }

    // What was edited is a step of the history now.
    void record();
    // What was edited and is no step yet is one first. False where there is none to go to.
    bool undo();
    bool redo();

    // Grows with every edit: what was made of the workspace at another revision is old.
    std::uint64_t revision() const { return revision_; }
    // What the workspace is shown with has changed: a grid has come, the language is another.
    void refresh();
    bool unrecorded() const { return unrecorded_; }
    double editedAt() const { return editedAt_; }  // seconds of the host's clock

  private:
    struct Edited {  // once the change is over
        OpenWorkspace& open;
        ~Edited();
    };

    History history_;
    Workspace workspace_;
    Host& host_;
    std::uint64_t revision_ = 1;
    bool unrecorded_ = false;
    double editedAt_ = 0;
};

}  // namespace versorium
