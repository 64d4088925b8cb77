// SPDX-License-Identifier: MIT
// The studio's font draws every letter that the faces were cut to.
#include <gtest/gtest.h>
#include <imgui.h>

#include "ui/widgets/theme.h"

namespace versorium {
namespace {

TEST(StudioFont, HasTheMarkOfSuccessAndHighLetters) {
    ImGuiContext* before = ImGui::GetCurrentContext();
    ImGuiContext* own = ImGui::CreateContext();
    ImGui::SetCurrentContext(own);
    loadFonts(themes()[0], 1);
    ASSERT_TRUE(ImGui::GetIO().Fonts->Build());
    const ImFont* font = ImGui::GetIO().Fonts->Fonts[0];
    for (ImWchar letter : {0x41, 0xf1, 0x3b1, 0x2713, 0x25cb, 0x1d4d, 0x2b0, 0x2081, 0x2074, 0x207b,
                           0xb7, 0x2032, 0x2212, 0x2264, 0x27e8})
        EXPECT_NE(font->FindGlyphNoFallback(letter), nullptr) << std::hex << letter;
    EXPECT_EQ(font->FindGlyphNoFallback(0xe000), nullptr);
    ImGui::DestroyContext(own);
    ImGui::SetCurrentContext(before);
}

}  // namespace
}  // namespace versorium
