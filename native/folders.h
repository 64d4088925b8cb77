// SPDX-License-Identifier: MIT
#pragma once
// Folders of the machine, for the studio's list of files.

#include "ui/host/host.h"

namespace versorium {

// Hidden entries and what cannot be looked at are left out. An empty path is the current folder.
Expected<Folder> listFolder(const std::string& path);

}  // namespace versorium
