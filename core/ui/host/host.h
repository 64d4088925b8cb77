// SPDX-License-Identifier: MIT
#pragma once
// Host: what the studio asks of whatever it runs in, a window or a page. The only seam between the
// two: everything else of the studio is the same code.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/status.h"
#include "ui/host/work.h"

namespace versorium {

// A file to be made, as the command line makes it: a PNG that carries its scene or its plate, or a
// ZIP archive of the pictures of an animation.
struct ExportRequest {
    std::string document;      // JSON of a Document without its assets
    std::string name;          // proposed file name
    bool toClipboard = false;  // as an image; where that cannot be, as a file
    Assets assets = {};        // of the document
};

struct FolderEntry {
    std::string name;
    bool isFolder = false;
};
struct Folder {
    std::string path;  // absolute
    std::vector<FolderEntry> entries;
};

class Host {
  public:
    virtual ~Host() = default;

    // Seconds from some fixed moment.
    virtual double now() const = 0;
    // Asks for another frame, even where nothing else happens.
    virtual void wake() = 0;
    // Asks for a frame in so many seconds: for what ends by itself. An earlier one does as well.
    virtual void wakeAfter(double) { wake(); }

    virtual std::string clipboard() = 0;
    virtual void setClipboard(const std::string& text) = 0;

    // Computes beside the studio, never within its frame.
    virtual void requestWork(WorkRequest request) = 0;
    virtual std::optional<WorkAnswer> takeAnswer() = 0;
    // Nobody waits for this view's picture any more.
    virtual void dropPicture(int /*view*/) {}

    // One export at a time; takeExport gives its outcome once: where the picture is, such as the
    // file's path or "the clipboard", or what failed; ErrorKind::cancelled after cancelExport.
    virtual void startExport(ExportRequest request) = 0;
    virtual void cancelExport() = 0;
    // Whether an animation becomes a film where the proposed name ends in ".webm".
    virtual bool makesFilms() const { return false; }
    virtual double exportProgress() const = 0;  // 0 … 1; negative while there is none
    virtual std::optional<Expected<std::string>> takeExport() = 0;

    // Gives the user a file of these bytes; says where it is.
    virtual Expected<std::string> saveFile(const std::string& name,
                                           std::span<const unsigned char> bytes) = 0;

    // Lets the user choose a file by the host's own dialog; it comes through Studio::openBytes.
    // False where there is none: the studio then shows folders itself.
    virtual bool chooseFile() { return false; }
    // ".." first, then folders and files by name; an empty path is where the user begins.
    virtual Expected<Folder> listFolder(const std::string&) {
        return Status::usage("there are no folders here");
    }
    virtual Expected<std::vector<unsigned char>> readFile(const std::string& path) {
        return Status::usage(path + ": files are not read by name here");
    }

    // What links begin with: the page's address, or the configured one; empty where there is none.
    virtual std::string publicAddress() const = 0;
    // The state of the studio as a link's fragment ("v1:…") changed.
    virtual void setFragment(const std::string& fragment) = 0;

    // A text kept from one start to the next, under a name.
    virtual std::string stored(const std::string& name) = 0;
    virtual void store(const std::string& name, const std::string& text) = 0;

    // The language of the system, as it names it: "es_MX.UTF-8", "es-419". English where unknown.
    virtual std::string preferredLanguage() const { return "en"; }

    // Fills the screen, or no longer; false where that cannot be.
    virtual bool toggleFullscreen() { return false; }

    // Whether lessons are drawn by the host itself, from Studio::lesson, rather than as a pane.
    virtual bool drawsLessons() const { return false; }

    virtual bool reducedMotion() const { return false; }
    // What a screen reader should say of what is shown.
    virtual void announce(const std::string&) {}
};

}  // namespace versorium
