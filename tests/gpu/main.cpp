// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstdio>

#include "headless_context.h"

int main(int count, char** arguments) {
    testing::InitGoogleTest(&count, arguments);
    if (const std::string why = versorium::makeHeadlessContext(); !why.empty()) {
        std::printf("SKIPPED: %s\n", why.c_str());
        return 77;
    }
    const int result = RUN_ALL_TESTS();
    versorium::loseHeadlessContext();
    return result;
}
