// SPDX-License-Identifier: MIT
#pragma once
// What is exported, as the document that the command line would be given: `versorium render` or
// `versorium plate` makes the same bytes of it.

#include "io/document.h"
#include "plate/plate_picture.h"
#include "workspace/workspace.h"

namespace versorium {

struct ExportOptions {
    bool motion = false;    // the pictures of the workspace's motion, one after the other
    bool film = false;      // of a motion: as a film, where the host makes one
    bool plate = false;     // with axes, keys and a caption; else the bare picture
    std::string builtIn;    // of plates: one of the program's own instead of the views
    bool allViews = false;  // as panels of the plate; else the focused view alone
    int width = 1600;       // of the bare picture, in pixels; its height follows from the view
    double millimetres = 178, dotsPerInch = 300;
    std::string theme = "paper";
    bool title = true, caption = true;
    std::string language = "en";  // of a plate of the views
};

// The views as panels of a plate, all of them or the focused one, with the title and the caption
// that follow from them, in that language (Plate::language). `aspects` holds width over height of
// every view as it is shown.
PlateDocument plateOfViews(const Workspace& workspace, const std::vector<double>& aspects, bool all,
                           const std::string& language);

// The motion of the moving view, as an animation: for `versorium animate`.
Document motionDocument(const Workspace& workspace);

// Fails where the picture would be larger than any may be.
Expected<Document> exportDocument(const Workspace& workspace, const std::vector<double>& aspects,
                                  const ExportOptions& options);

}  // namespace versorium
