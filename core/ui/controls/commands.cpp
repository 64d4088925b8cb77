// SPDX-License-Identifier: MIT
#include "ui/controls/commands.h"

#include "ui/controls/access.h"
#include "ui/controls/command_families.h"
#include "ui/session/context.h"

namespace versorium {

std::vector<Command> commandsOf(StudioContext& context) {
    Commands all;
    addFileCommands(context, all);
    addViewCommands(context, all);
    addStudyCommands(context, all);
    addShapeCommands(context, all);
    addMotionCommands(context, all);
    addWindowCommands(context, all);
    if (isRestricted(context))
        std::erase_if(all, [](const Command& command) { return !command.harmless; });
    return all;
}

bool runCommand(StudioContext& context, std::string_view id) {
    for (const Command& command : commandsOf(context))
        if (command.id == id) {
            if (!command.available()) return false;
            command.run();
            return true;
        }
    return false;
}

}  // namespace versorium
