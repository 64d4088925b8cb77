// SPDX-License-Identifier: MIT
// The lesson's pane in the window: its text, its question and its goal. A page draws the same out
// of lesson_page.cpp.
#include <algorithm>

#include "ui/controls/access.h"
#include "ui/lesson/lesson_pane.h"
#include "ui/session/context.h"
#include "ui/widgets/help.h"
#include "ui/widgets/panel_parts.h"
#include "ui/widgets/prose.h"

namespace versorium {
namespace {

constexpr const char* kDone = "✓ ";

bool button(const char* label, const char* help) {
    const bool pressed = ImGui::Button(tr(label));
    explain(help);
    return pressed;
}

// On the same line where there is room for it.
void beside(const char* label) {
    const float needed = ImGui::CalcTextSize(label).x + 2 * ImGui::GetStyle().FramePadding.x;
    const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
    ImGui::SameLine();
    if (ImGui::GetCursorScreenPos().x + needed > right) ImGui::NewLine();
}

void strong(const std::string& text) { drawProse({{.runs = {{.text = text, .strong = true}}}}); }

void drawList(StudioContext& context) {
    strong(tr("Lessons"));
    drawParagraph(
        tr("Each takes five to ten minutes. What you have done is kept here, on this device."));
    for (const LessonEntry& entry : lessonList(context)) {
        ImGui::PushID(entry.id.c_str());
        const std::string label = (entry.done == entry.head.steps ? kDone : "") + entry.head.title;
        if (ImGui::Button(label.c_str(), {-1, 0}))
            context.report(openLesson(context, entry.id, {}));
        explain("lesson");
        ImGui::TextDisabled(
            "%s", (std::to_string(entry.head.minutes) + " min · " + entry.head.level + " · " +
                   std::to_string(entry.done) + " / " + std::to_string(entry.head.steps))
                      .c_str());
        ImGui::PopID();
    }
    ImGui::Spacing();
    if (button("Open a lesson's file", "open lesson")) context.chooseFile();
    beside(tr("Close"));
    if (button("Close", "close lessons")) context.lessons.open = false;
}

// One small mark for each step: full where it is done, with a ring around the present one.
void drawProgress(StudioContext& context) {
    const LessonSession& session = context.lessons.now->session;
    const float size = 0.8f * ImGui::GetFontSize();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (std::size_t k = 0; k < session.lesson().steps.size(); ++k) {
        ImGui::PushID(static_cast<int>(k));
        if (k > 0) ImGui::SameLine(0, 0.35f * size);
        const ImVec2 at = ImGui::GetCursorScreenPos();
        if (ImGui::InvisibleButton("step", {size, 1.2f * size})) goToStep(context, k);
        explainBy(session.lesson().steps[k].title);
        const ImVec2 middle{at.x + 0.5f * size, at.y + 0.6f * size};
        const ImU32 colour = ImGui::GetColorU32(ImGuiCol_CheckMark);
        if (session.done(k))
            list.AddCircleFilled(middle, 0.3f * size, colour);
        else
            list.AddCircle(middle, 0.3f * size, ImGui::GetColorU32(ImGuiCol_TextDisabled), 0, 1.5f);
        if (k == session.at()) list.AddCircle(middle, 0.48f * size, colour, 0, 2);
        ImGui::PopID();
    }
    ImGui::SameLine();
    ImGui::TextDisabled("%d / %d", static_cast<int>(session.at()) + 1,
                        static_cast<int>(session.lesson().steps.size()));
}

void drawChoices(StudioContext& context, const Question& question) {
    OpenLesson& lesson = *context.lessons.now;
    const float wide = ImGui::GetContentRegionAvail().x;
    const auto choice = [&](const std::string& text, const std::string& answer) {
        ImGui::PushID(answer.c_str());
        if (ImGui::RadioButton("##choice", lesson.typed == answer)) lesson.typed = answer;
        explain("answer choice");
        ImGui::SameLine();
        ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + wide - 1.6f * ImGui::GetFrameHeight());
        ImGui::TextUnformatted(text.c_str());
        ImGui::PopTextWrapPos();
        if (ImGui::IsItemClicked()) lesson.typed = answer;
        ImGui::PopID();
    };
    for (std::size_t k = 0; k < question.choices.size(); ++k)
        choice(question.choices[k].text, std::to_string(k + 1));
    for (const Question::Place& place : question.places)
        choice(place.text, formatNumber(place.x, 6) + ", " + formatNumber(place.y, 6));
}

void drawQuestion(StudioContext& context, const Question& question) {
    OpenLesson& lesson = *context.lessons.now;
    const LessonSession::StepState& state = lesson.session.state();
    strong(question.prompt);
    drawChoices(context, question);
    bool enter = false;
    if (question.kind != AnswerKind::choice) {
        static char typed[128];
        std::snprintf(typed, sizeof typed, "%s", lesson.typed.c_str());
        ImGui::SetNextItemWidth(-1);
        enter = ImGui::InputTextWithHint(
            "##answer",
            question.kind == AnswerKind::point ? tr("two numbers: x, y") : tr("a number"), typed,
            sizeof typed, ImGuiInputTextFlags_EnterReturnsTrue);
        explain("answer");
        lesson.typed = typed;
    }
    if (question.kind == AnswerKind::point) {
        if (button("Take the ring's place", "ring answer")) lesson.typed = ringAnswer(context);
        beside(tr("Commit"));
    }
    if ((button("Commit", "commit") || enter) && !lesson.typed.empty())
        commitAnswer(context, lesson.typed);
    if (!lesson.problem.empty()) drawParagraph(tr(std::string_view(lesson.problem)));
    if (state.answer.empty()) return;
    ImGui::Spacing();
    drawParagraph(tr("Your answer: {1}", {spokenAnswer(question, state.answer)}));
    const Judgement judgement = lesson.session.judgement();
    strong(judgement.right ? kDone + std::string(tr("Right.")) : tr("Not yet."));
    if (!judgement.text.empty()) drawParagraph(judgement.text);
}

void drawReveal(StudioContext& context) {
    OpenLesson& lesson = *context.lessons.now;
    const LessonStep& step = lesson.session.step();
    if (lesson.session.canReveal() && button("Show me", "show answer")) showAnswer(context);
    if (!lesson.session.state().revealed) return;
    if (!lesson.session.state().right)
        drawParagraph(tr("The answer: {1}", {rightAnswer(*step.question)}));
    drawProse(step.reveal);
    if (step.revealStage &&
        button(lesson.revealShown ? "Back to my picture" : "Show it in the picture",
               "reveal scene"))
        toggleReveal(context);
}

void drawGoal(StudioContext& context, const Goal& goal) {
    const bool reached = context.lessons.now->session.state().reached;
    ImGui::Spacing();
    strong((reached ? kDone : "○ ") + goal.text);
    if (reached && !goal.praise.empty()) drawParagraph(goal.praise);
}

void drawHints(StudioContext& context) {
    const LessonSession& session = context.lessons.now->session;
    for (int k = 0; k < session.state().hints; ++k) {
        ImGui::Indent(0.8f * ImGui::GetFontSize());
        drawProse(session.step().hints[static_cast<std::size_t>(k)]);
        ImGui::Unindent(0.8f * ImGui::GetFontSize());
    }
    if (session.canHint() && button("Hint", "hint")) showHint(context);
}

void drawEnd(StudioContext& context) {
    ImGui::Spacing();
    if (button("Export this as a plate", "export step")) exportStep(context);
    if (button("Save my answers", "save answers")) saveAnswers(context, false);
    beside(tr("… as JSON"));
    if (button("… as JSON", "save answers json")) saveAnswers(context, true);
    if (button("Begin again", "begin again")) beginLessonAgain(context);
}

void drawWandering(StudioContext& context) {
    OpenLesson& lesson = *context.lessons.now;
    ImGui::Spacing();
    if (lesson.wandering() && !lesson.revealShown) {
        drawParagraph(tr("You are exploring freely. The step waits as you left it."));
        if (button("Back to the step", "back to step")) backToStep(context);
        beside(tr("Reset"));
    } else if (stepNamesControls(context) && !isRestricted(context)) {
        if (button("All controls", "all controls")) leaveStep(context);
        beside(tr("Reset"));
    }
    if (button("Reset", "reset step")) resetStep(context);
}

void drawStep(StudioContext& context) {
    OpenLesson& lesson = *context.lessons.now;
    const LessonStep& step = lesson.session.step();
    strong(step.title);
    drawProse(step.prose);
    if (step.question) drawQuestion(context, *step.question);
    if (step.question) drawReveal(context);
    if (step.goal) drawGoal(context, *step.goal);
    drawHints(context);
    drawWandering(context);
    if (lesson.session.at() + 1 == lesson.left.size()) drawEnd(context);
    if (!step.notes.empty() && section("For teachers", false))
        for (const auto& note : step.notes) drawProse(note);
}

}  // namespace

void drawLessonPane(StudioContext& context) {
    if (!context.lessons.now) return drawList(context);
    const float foot = ImGui::GetFrameHeightWithSpacing() + ImGui::GetStyle().ItemSpacing.y;
    const std::string title = context.lessons.now->session.lesson().title;
    ImGui::PushTextWrapPos();
    ImGui::TextDisabled("%s", title.c_str());
    ImGui::PopTextWrapPos();
    drawProgress(context);
    ImGui::BeginChild("step", {0, -foot});
    drawStep(context);
    ImGui::EndChild();
    if (!context.lessons.now) return;
    const std::size_t at = context.lessons.now->session.at();
    const std::size_t count = context.lessons.now->left.size();
    ImGui::BeginDisabled(at == 0);
    if (button("← Back", "step back")) goToStep(context, at - 1);
    ImGui::EndDisabled();
    ImGui::SameLine();
    ImGui::BeginDisabled(at + 1 == count);
    if (button("Next →", "step on")) goToStep(context, at + 1);
    ImGui::EndDisabled();
    ImGui::SameLine();
    if (!isRestricted(context) && button("All lessons", "all lessons")) closeLesson(context);
}

}  // namespace versorium
