// SPDX-License-Identifier: MIT
#include "ui/session/open_workspace.h"

namespace versorium {

OpenWorkspace::Edited::~Edited() {
    open.unrecorded_ = true;
    open.editedAt_ = open.host_.now();
    open.refresh();
}

void OpenWorkspace::refresh() {
    ++revision_;
    host_.wake();
}

void OpenWorkspace::record() {
    history_.record(workspace_);
    unrecorded_ = false;
}

bool OpenWorkspace::undo() {
    if (unrecorded_) record();
    if (!history_.canUndo()) return false;
    workspace_ = history_.undo();
    refresh();
    return true;
}

bool OpenWorkspace::redo() {
    if (!history_.canRedo()) return false;
    workspace_ = history_.redo();
    unrecorded_ = false;
    refresh();
    return true;
}

}  // namespace versorium
