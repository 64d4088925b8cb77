// SPDX-License-Identifier: MIT
#pragma once
// Settings under the XDG folders: one small file for each name, and where exports go.

#include <string>

#include "base/status.h"

namespace versorium {

// $XDG_CONFIG_HOME/versorium, or ~/.config/versorium; empty when neither is known.
std::string settingsFolder();
// Empty where nothing was stored; without the line end that an editor leaves behind.
std::string readSetting(const std::string& name);
Status writeSetting(const std::string& name, const std::string& text);

// A path in the current folder that no file has yet: "name.png", "name-2.png", ….
std::string freePath(const std::string& name);

}  // namespace versorium
