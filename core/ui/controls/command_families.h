// SPDX-License-Identifier: MIT
#pragma once
// The table of commands by family: each file adds its own.

#include <utility>
#include <vector>

#include "ui/controls/commands.h"

namespace versorium {

using Commands = std::vector<Command>;

void addFileCommands(StudioContext& context, Commands& all);
void addWindowCommands(StudioContext& context, Commands& all);
void addViewCommands(StudioContext& context, Commands& all);
void addStudyCommands(StudioContext& context, Commands& all);
void addShapeCommands(StudioContext& context, Commands& all);
void addMotionCommands(StudioContext& context, Commands& all);

// A command that may be had where a teacher's link locks things: it changes nothing, or only what
// a lock watches over.
inline Command harmless(Command command) {
    command.harmless = true;
    return command;
}

}  // namespace versorium
