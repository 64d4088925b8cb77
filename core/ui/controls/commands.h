// SPDX-License-Identifier: MIT
#pragma once
// The one table of commands: for the keys, for Find, for the list behind `?`, for the accessible
// controls, and for the locks of a teacher's link. A command is known by its id, in every language.

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "i18n/language.h"
#include "ui/widgets/chord.h"

namespace versorium {

struct StudioContext;

struct Command {
    std::string id;     // "undo", "view.zoom.in"
    std::string label;  // in English, or in the language where it is put together
    std::string help;   // what it does, in a sentence or two; the same
    Chord chord;
    std::function<void()> run;
    std::function<bool()> when = {};  // whether it can be had now; empty: always
    std::string also = {};            // another name that Find knows it by
    bool harmless = false;            // it may be had where a teacher's link locks things

    std::string title() const { return tr(std::string_view(label)); }
    std::string explanation() const { return tr(std::string_view(help)); }
    bool available() const { return !when || when(); }
};

// Without those that a teacher's link takes away.
std::vector<Command> commandsOf(StudioContext& context);
// False where there is no such command, or where it cannot be had now.
bool runCommand(StudioContext& context, std::string_view id);

// What Find offers: lessons, presets, maps, plates, recent scenes, saved formulas and what is typed
// if it is a formula, each as a command that opens it; and all commands. Where a teacher's link
// locks things, the commands that it leaves.
std::vector<Command> findable(StudioContext& context, const std::string& question);

}  // namespace versorium
