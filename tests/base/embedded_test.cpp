// SPDX-License-Identifier: MIT
#include "base/embedded.h"

#include <gtest/gtest.h>

namespace versorium {
namespace {

TEST(Embedded, FilesAreFoundByName) {
    const auto names = embeddedNames("fonts/");
    ASSERT_EQ(names.size(), 5u);
    for (const auto name : names) {
        const auto bytes = embedded(name);
        // A TrueType file begins with version 1.0 and holds more than a few glyphs.
        ASSERT_GT(bytes.size(), 10000u) << name;
        EXPECT_EQ(bytes[0] * 16777216 + bytes[1] * 65536 + bytes[2] * 256 + bytes[3], 0x10000);
    }
    EXPECT_TRUE(embedded("no such file").empty());
}

}  // namespace
}  // namespace versorium
