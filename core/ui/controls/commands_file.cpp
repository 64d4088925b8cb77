// SPDX-License-Identifier: MIT
// Commands for what is open: history, files, clipboard, exports.
#include "ui/controls/command_families.h"
#include "ui/session/context.h"

namespace versorium {

void addFileCommands(StudioContext& context, Commands& all) {
    StudioContext* c = &context;
    const auto add = [&](Command command) { all.push_back(std::move(command)); };
    add(harmless({"undo",
                  trLater("Undo"),
                  trLater("Takes back the last change. There is no limit."),
                  {"Z", true},
                  [c] { c->undo(); }}));
    add(harmless({"redo",
                  trLater("Redo"),
                  trLater("Makes the change again that was taken back."),
                  {"Z", true, true},
                  [c] { c->redo(); }}));
    add({"find",
         trLater("Find a map, a preset or a command"),
         trLater("Finds maps, presets, recent scenes and commands by any part of their name."),
         {"K", true},
         [c] { c->dialogs.find = true; }});
    add({"open",
         trLater("Open a file"),
         trLater("Opens a scene, a picture that carries one, a mesh, an image or a palette."),
         {"O", true},
         [c] { c->chooseFile(); }});
    add({"paste",
         trLater("Open what is on the clipboard"),
         trLater("A scene, a link, a palette or a formula, as text."),
         {"V", true},
         [c] { c->paste(); }});
    add({"gallery",
         trLater("Gallery"),
         trLater("Presets and recent scenes as pictures."),
         {"G", true},
         [c] { c->dialogs.gallery = true; }});
    add({"export.dialog",
         trLater("Export a picture or a plate"),
         trLater("A picture or a figure plate of what is shown, as a PNG of any size."),
         {"E", true},
         [c] { c->dialogs.exporting = true; }});
    add({"copy.image",
         trLater("Copy the focused view as an image"),
         trLater("Draws the focused view in full quality and puts it on the clipboard."),
         {"I", true},
         [c] { c->copyImage(); }});
    add({"copy.link",
         trLater("Copy a link to what is shown"),
         trLater("Whoever opens the link sees the same views with the same values."),
         {"L", true},
         [c] { c->copyLink(); }});
    add({"save",
         trLater("Save the scene as a file"),
         trLater("Saves the focused view's scene as JSON. It can be opened and edited."),
         {"S", true},
         [c] { c->saveScene(); }});
    add({"teacher.link",
         trLater("Make a teacher's link"),
         trLater("A link to this lesson or view in which you choose what learners may change."),
         {},
         [c] { c->dialogs.teacher = true; }});
}

}  // namespace versorium
