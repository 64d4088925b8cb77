// SPDX-License-Identifier: MIT
// Each kind of view has a home, a neighbour and words of its own.
#include "scene/view_kind.h"

#include <gtest/gtest.h>

#include <set>

#include "workspace/workspace.h"

namespace versorium {
namespace {

constexpr ViewKind kKinds[] = {ViewKind::parameters, ViewKind::startingPoints};

TEST(ViewKind, TheHomeOfAKindIsOfThisKind) {
    for (const MapKernels& map : catalogue()) {
        const Scene scene = sceneOf(map);
        const Scene set = homeView(ViewKind::parameters, scene);
        // A map of the line is shown against its parameter, a map with too few of them as points.
        if (map.dimension == 1 || viewKind(set) != ViewKind::parameters) continue;
        for (const ViewKind kind : kKinds) {
            const Scene home = homeView(kind, scene);
            EXPECT_EQ(viewKind(home), kind) << map.info.name;
            EXPECT_EQ(homeOf(home), home.slice) << map.info.name;
            // What stands beside it stands in the order of the kinds, and it is meant.
            const Workspace workspace = workspaceOf(home);
            ASSERT_EQ(workspace.views.size(), 2u);
            EXPECT_EQ(viewKind(workspace.view()), kind);
            EXPECT_EQ(viewKind(workspace.views[static_cast<std::size_t>(1 - workspace.focused)]),
                      besideOf(kind));
            EXPECT_LT(viewKind(workspace.views[0]), viewKind(workspace.views[1]));
        }
    }
}

TEST(ViewKind, AViewOfAKindIsTheFocusedOneElseTheFirst) {
    Workspace workspace = workspaceOf(sceneOf(*findMap("quadratic")));
    setViewCount(workspace, 4);
    workspace.focused = 3;
    for (const ViewKind kind : kKinds) {
        const int first = firstOfKind(workspace, kind);
        EXPECT_LT(first, 2);
        EXPECT_EQ(viewOfKind(workspace, kind), viewKind(workspace.view()) == kind ? 3 : first);
    }
    setViewCount(workspace, 1);
    EXPECT_EQ(viewOfKind(workspace, besideOf(viewKind(workspace.view()))), -1);
}

TEST(ViewKind, NothingIsCalledTheSame) {
    std::set<std::string> words, titles;
    for (const ViewKind kind : kKinds) {
        EXPECT_TRUE(words.insert(std::string(wordOf(kind))).second);
        EXPECT_TRUE(titles.insert(traitsOf(kind).title).second);
        EXPECT_EQ(fromWord<ViewKind>(wordOf(kind)), kind);
        EXPECT_NE(besideOf(kind), kind);
    }
    EXPECT_EQ(std::size(kKinds), EnumWords<ViewKind>::table.size());
}

}  // namespace
}  // namespace versorium
