// SPDX-License-Identifier: MIT
#include "ui/controls/commands.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "ui/headless_gui.h"
#include "ui/keyboard.h"
#include "ui/widgets/keys.h"

namespace versorium {
namespace {

// States in which other commands can be had.
std::vector<std::function<void(StudioContext&)>> states() {
    return {[](StudioContext&) {}, [](StudioContext& c) { c.newMap("planar"); },
            [](StudioContext& c) {
                c.newMap("shape-modulus");
                c.probe.view = 1;
                c.versor.chosen = {"roots", 1};
            },
            [](StudioContext& c) {
                c.newMap("quadratic");
                c.probe.view = 1;
                runCommand(c, "circles.drop");
            }};
}

TEST(Commands, HaveIdsOfTheirOwnAndNoChordTwiceInOneState) {
    SilentHost host;
    HeadlessGui gui;
    for (const auto& enter : states()) {
        StudioContext context(host);
        enter(context);
        std::set<std::string> ids;
        std::map<std::string, std::string> chords;
        for (const Command& command : commandsOf(context)) {
            EXPECT_FALSE(command.id.empty()) << command.label;
            EXPECT_FALSE(command.label.empty()) << command.id;
            EXPECT_GT(command.help.size(), 12u) << command.id;
            EXPECT_TRUE(ids.insert(command.id).second) << command.id;
            if (!command.chord || (command.when && !command.when())) continue;
            const auto [other, isNew] = chords.emplace(textOf(command.chord), command.id);
            EXPECT_TRUE(isNew) << command.id << " and " << other->second << ": " << other->first;
        }
    }
}

// What Find offers beside the commands has names of its own as well.
TEST(Commands, FindOffersNothingTwice) {
    SilentHost host;
    HeadlessGui gui;
    StudioContext context(host);
    std::set<std::string> ids;
    for (const Command& command : findable(context, "z^3 + c")) {
        EXPECT_TRUE(ids.insert(command.id).second) << command.id;
        EXPECT_FALSE(command.help.empty()) << command.id;
    }
    for (const char* id :
         {"preset.henon", "map.quadratic", "formula.typed", "lesson.open.1-orbits"})
        EXPECT_EQ(ids.count(id), 1u) << id;
}

TEST(Commands, AreKnownByTheSameIdsInEveryLanguage) {
    SilentHost host;
    HeadlessGui gui;
    StudioContext context(host);
    std::vector<std::string> ids, english;
    for (const Command& command : commandsOf(context)) {
        ids.push_back(command.id);
        english.push_back(command.title());
    }
    ASSERT_TRUE(setLanguage("es"));
    const std::vector<Command> spanish = commandsOf(context);
    ASSERT_EQ(spanish.size(), ids.size());
    std::size_t different = 0;
    for (std::size_t k = 0; k < ids.size(); ++k) {
        EXPECT_EQ(spanish[k].id, ids[k]);
        if (spanish[k].title() != english[k]) ++different;
    }
    setLanguage("en");
    // All but the names of languages.
    EXPECT_GE(different + 2 * languages().size(), ids.size());
}

TEST(Commands, RunByIdAndByChord) {
    SilentHost host;
    HeadlessGui gui;
    StudioContext context(host);
    EXPECT_FALSE(runCommand(context, "no such command"));
    EXPECT_TRUE(runCommand(context, "cycles"));
    EXPECT_TRUE(context.workspace.study.cycles);
    gui.frame([&] { handleKeys(context); });
    const double height = context.workspace.view().slice.height;
    // A sign is what is typed, whatever key has it.
    ImGui::GetIO().AddInputCharacter('+');
    gui.frame([&] { handleKeys(context); });
    for (int k = 0; k < 3; ++k) gui.frame([&] { context.glide(); });
    EXPECT_TRUE(context.views[static_cast<std::size_t>(context.workspace.focused)].glide ||
                context.workspace.view().slice.height < height);
    ImGui::GetIO().AddInputCharacter('?');
    gui.frame([&] { handleKeys(context); });
    EXPECT_TRUE(context.dialogs.keys);
    // "Take the chosen root away" can be had only where one is chosen.
    EXPECT_FALSE(runCommand(context, "roots.remove"));
}

}  // namespace
}  // namespace versorium
