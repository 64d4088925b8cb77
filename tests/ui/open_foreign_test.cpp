// SPDX-License-Identifier: MIT
// Files of other programs in the studio.
#include <gtest/gtest.h>

#include "ui/host/worker.h"
#include "ui/session/open_file.h"

namespace versorium {
namespace {

Status openForeign(StudioContext& context, const std::string& name, std::string_view text) {
    return openBytes(context, name,
                     {reinterpret_cast<const unsigned char*>(text.data()), text.size()});
}

TEST(OpenForeign, WhatIsDoubtfulAboutAMeshIsSaid) {
    SilentHost host;
    StudioContext context(host);
    // A tetrahedron without one face; and one with a face turned.
    ASSERT_TRUE(openForeign(context, "open (1).OBJ",
                            "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\n")
                    .ok());
    EXPECT_NE(context.notices.last().find("It is open: 3 sides"), std::string::npos)
        << context.notices.last();
    ASSERT_TRUE(openForeign(context, "turned.stl",
                            "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\n"
                            "f 2 4 3\n")
                    .ok());
    EXPECT_NE(context.notices.last().find("3 sides run one way only"), std::string::npos)
        << context.notices.last();
}

TEST(OpenForeign, PalettesAndViewsOpen) {
    SilentHost host;
    StudioContext context(host);
    ASSERT_TRUE(openForeign(context, "fire.MAP", "0 0 0\n255 128 0\n255 255 255\n").ok());
    EXPECT_EQ(context.workspace.view().colour.palette, "fire");
    ASSERT_TRUE(openText(context, "#001122\n#334455").ok());
    ASSERT_TRUE(context.workspace.view().colour.ownPalette.is_object());
    EXPECT_EQ(context.workspace.view().colour.ownPalette["stops"].size(), 2u);
    ASSERT_TRUE(openForeign(context, "sea.par",
                            "Sea { type=mandel center-mag=-0.745/0.113/100 maxiter=700 }")
                    .ok());
    EXPECT_EQ(context.workspace.view().iterations, 700);
    EXPECT_NE(context.notices.last().find("Fractint"), std::string::npos);
}

TEST(OpenForeign, KnownFormatsAreRefusedByName) {
    SilentHost host;
    StudioContext context(host);
    for (const auto& [name, text, word] : {std::array<const char*, 3>{"a.gif", "GIF89a", "GIF"},
                                           {"a.json", "<svg/>", "SVG"},
                                           {"a.obj", "glTF", "glTF"},
                                           {"a.png", "%PDF", "PDF"}}) {
        const Status status = openForeign(context, name, text);
        ASSERT_FALSE(status.ok()) << name;
        EXPECT_NE(status.message().find(word), std::string::npos) << status.message();
    }
}

}  // namespace
}  // namespace versorium
