// SPDX-License-Identifier: MIT
// The lesson's pane as values, for a page that draws it with elements of its own.
#include <algorithm>

#include "lesson/spoken.h"
#include "ui/controls/access.h"
#include "ui/controls/controls.h"
#include "ui/lesson/lesson_pane.h"
#include "ui/session/context.h"

namespace versorium {
namespace {

Json runsOf(const std::string& text, const std::string& language, Json look) {
    Json runs = Json::array();
    for (const SpokenPart& part : spokenParts(text, language)) {
        Json run = look;
        run["text"] = part.text;
        if (!part.spoken.empty()) run["spoken"] = part.spoken;
        runs.push_back(std::move(run));
    }
    return runs;
}

Json blocksOf(const std::vector<MarkdownBlock>& blocks, const std::string& language) {
    Json all = Json::array();
    for (const MarkdownBlock& block : blocks) {
        Json runs = Json::array();
        for (const TextRun& run : block.runs) {
            Json look = Json::object();
            if (run.strong) look["strong"] = true;
            if (run.emphasis) look["emphasis"] = true;
            if (run.code) look["code"] = true;
            for (Json& part : runsOf(run.text, language, look)) runs.push_back(std::move(part));
        }
        Json entry{{"runs", std::move(runs)}};
        if (block.kind == MarkdownBlock::Kind::item)
            entry["item"] = {{"level", block.level}, {"number", block.number}};
        all.push_back(std::move(entry));
    }
    return all;
}

Json plain(const std::string& text, const std::string& language) {
    return runsOf(text, language, Json::object());
}

Json questionOf(const OpenLesson& lesson, const Question& question, const std::string& language) {
    const LessonSession::StepState& state = lesson.session.state();
    constexpr const char* kKinds[] = {"choice", "number", "point"};
    Json json{{"kind", kKinds[static_cast<std::size_t>(question.kind)]},
              {"prompt", plain(question.prompt, language)},
              {"answer", state.answer},
              {"problem", tr(std::string_view(lesson.problem))}};
    json["choices"] = Json::array();
    for (std::size_t k = 0; k < question.choices.size(); ++k)
        json["choices"].push_back({{"text", plain(question.choices[k].text, language)},
                                   {"value", std::to_string(k + 1)}});
    for (const Question::Place& place : question.places)
        json["choices"].push_back(
            {{"text", plain(place.text, language)},
             {"value", formatNumber(place.x, 6) + ", " + formatNumber(place.y, 6)}});
    if (state.answer.empty()) return json;
    const Judgement judgement = lesson.session.judgement();
    json["said"] = plain(spokenAnswer(question, state.answer), language);
    json["right"] = judgement.right;
    json["meaning"] = plain(judgement.text, language);
    return json;
}

Json stepControls(StudioContext& context) {
    Json ids = Json::array();
    if (!stepNamesControls(context)) return ids;
    for (const Control& control : controlsOf(context))
        if (isOpenInStep(context, control.id)) ids.push_back(control.id);
    return ids;
}

Json stepOf(StudioContext& context) {
    const OpenLesson& lesson = *context.lessons.now;
    const LessonSession& session = lesson.session;
    const std::string& language = session.lesson().language;
    const LessonStep& step = session.step();
    Json json{{"title", plain(step.title, language)},
              {"prose", blocksOf(step.prose, language)},
              {"controls", stepControls(context)},
              {"wandering", lesson.wandering() && !lesson.revealShown},
              {"mayWander", stepNamesControls(context) && !isRestricted(context)},
              {"canHint", session.canHint()},
              {"canReveal", session.canReveal()},
              {"last", session.at() + 1 == lesson.left.size()}};
    if (step.question) json["question"] = questionOf(lesson, *step.question, language);
    json["hints"] = Json::array();
    for (int k = 0; k < session.state().hints; ++k)
        json["hints"].push_back(blocksOf(step.hints[static_cast<std::size_t>(k)], language));
    if (step.question && session.state().revealed) {
        json["reveal"] = blocksOf(step.reveal, language);
        if (!session.state().right)
            json["rightAnswer"] = plain(rightAnswer(*step.question), language);
        if (step.revealStage) json["revealShown"] = lesson.revealShown;
    }
    if (step.goal)
        json["goal"] = {
            {"text", plain(step.goal->text, language)},
            {"reached", session.state().reached},
            {"praise", plain(session.state().reached ? step.goal->praise : "", language)}};
    json["notes"] = Json::array();
    for (const auto& note : step.notes) json["notes"].push_back(blocksOf(note, language));
    return json;
}

}  // namespace

std::string lessonText(StudioContext& context) {
    Json json{{"open", context.lessons.open}, {"language", languageNow().id}};
    if (!context.lessons.open) return json.dump();
    if (!context.lessons.now) {
        json["lessons"] = Json::array();
        for (const LessonEntry& entry : lessonList(context))
            json["lessons"].push_back({{"id", entry.id},
                                       {"title", entry.head.title},
                                       {"level", entry.head.level},
                                       {"minutes", entry.head.minutes},
                                       {"steps", entry.head.steps},
                                       {"done", entry.done}});
        return json.dump();
    }
    const LessonSession& session = context.lessons.now->session;
    Json steps = Json::array();
    for (std::size_t k = 0; k < session.lesson().steps.size(); ++k)
        steps.push_back({{"title", session.lesson().steps[k].title}, {"done", session.done(k)}});
    json["lesson"] = {{"id", session.lesson().id},
                      {"title", session.lesson().title},
                      {"language", session.lesson().language},
                      {"at", session.at()},
                      {"steps", std::move(steps)},
                      {"locked", isRestricted(context)}};
    json["step"] = stepOf(context);
    return json.dump();
}

bool lessonDo(StudioContext& context, const std::string& action, const std::string& value) {
    context.host.wake();
    if (action == "list") return context.lessons.open = true;
    if (action == "close") return context.lessons.open = false, true;
    if (action == "open") {
        const Status status = openLesson(context, value, {});
        context.report(status);
        return status.ok();
    }
    if (!context.lessons.now) return false;
    const LessonSession& session = context.lessons.now->session;
    const std::size_t at = session.at();
    if (action == "all")
        closeLesson(context);
    else if (action == "next")
        goToStep(context, at + 1);
    else if (action == "back" && at > 0)
        goToStep(context, at - 1);
    else if (action == "step")
        goToStep(context, static_cast<std::size_t>(std::strtoul(value.c_str(), nullptr, 10)));
    else if (action == "commit")
        commitAnswer(context, value);
    else if (action == "hint")
        showHint(context);
    else if (action == "show")
        showAnswer(context);
    else if (action == "reveal")
        toggleReveal(context);
    else if (action == "reset")
        resetStep(context);
    else if (action == "wander")
        leaveStep(context);
    else if (action == "return")
        backToStep(context);
    else if (action == "again")
        beginLessonAgain(context);
    else if (action == "answers")
        saveAnswers(context, value == "json");
    else if (action == "plate")
        exportStep(context);
    else
        return false;
    return true;
}

}  // namespace versorium
