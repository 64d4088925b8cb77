// SPDX-License-Identifier: MIT
#include "ui/widgets/prose.h"

#include "imgui.h"

namespace versorium {
namespace {

// Writes words one behind the other, and goes to the next line where one does not fit.
class Writer {
  public:
    explicit Writer(float indent)
        : left_(ImGui::GetCursorScreenPos().x + indent),
          right_(ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x),
          at_{left_, ImGui::GetCursorScreenPos().y} {}

    void write(const TextRun& run) {
        std::string word;
        for (const char c : run.text) {
            if (c != ' ' && c != '\n') {
                word += c;
                continue;
            }
            put(word, run);
            word.clear();
            at_.x += ImGui::CalcTextSize(" ").x;
        }
        put(word, run);
    }
    void finish() {
        ImGui::SetCursorScreenPos({left_, at_.y});
        ImGui::Dummy({1, ImGui::GetTextLineHeight()});
    }

  private:
    float left_, right_;
    ImVec2 at_;

    void put(const std::string& word, const TextRun& run) {
        if (word.empty()) return;
        const float width = ImGui::CalcTextSize(word.c_str()).x;
        if (at_.x + width > right_ && at_.x > left_)
            at_ = {left_, at_.y + ImGui::GetTextLineHeight() * 1.2f};
        ImDrawList& list = *ImGui::GetWindowDrawList();
        const float tall = ImGui::GetTextLineHeight();
        if (run.code)
            list.AddRectFilled({at_.x - 2, at_.y}, {at_.x + width + 2, at_.y + tall},
                               ImGui::GetColorU32(ImGuiCol_FrameBg), 3);
        const ImU32 colour = ImGui::GetColorU32(ImGuiCol_Text);
        list.AddText(at_, colour, word.c_str());
        // There is one weight of letters: a second stroke beside the first makes them bold.
        if (run.strong) list.AddText({at_.x + 0.04f * tall, at_.y}, colour, word.c_str());
        if (run.emphasis)
            list.AddLine({at_.x, at_.y + tall}, {at_.x + width, at_.y + tall},
                         ImGui::GetColorU32(ImGuiCol_TextDisabled));
        at_.x += width;
    }
};

void gap() { ImGui::Dummy({1, 0.35f * ImGui::GetTextLineHeight()}); }

}  // namespace

void drawProse(const std::vector<MarkdownBlock>& blocks) {
    for (const MarkdownBlock& block : blocks) {
        const bool item = block.kind == MarkdownBlock::Kind::item;
        const float step = 1.4f * ImGui::GetFontSize();
        if (item) {
            const float indent = static_cast<float>(block.level - 1) * step;
            const ImVec2 at = ImGui::GetCursorScreenPos();
            const std::string mark = block.number > 0 ? std::to_string(block.number) + "." : "•";
            ImGui::GetWindowDrawList()->AddText({at.x + indent, at.y},
                                                ImGui::GetColorU32(ImGuiCol_Text), mark.c_str());
        }
        Writer writer(item ? static_cast<float>(block.level) * step : 0);
        for (const TextRun& run : block.runs) writer.write(run);
        writer.finish();
        gap();
    }
}

void drawParagraph(const std::string& text) {
    Writer writer(0);
    writer.write({text});
    writer.finish();
    gap();
}

}  // namespace versorium
