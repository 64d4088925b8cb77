// SPDX-License-Identifier: MIT
#include "lesson/session.h"

#include <algorithm>

#include "lesson/observables.h"
#include "lesson/stage.h"

namespace versorium {

namespace {

constexpr std::size_t kAnswerBytes = 200;

}  // namespace

bool LessonSession::done(std::size_t step) const {
    const LessonStep& what = lesson_.steps[step];
    const StepState& state = states_[step];
    if (!what.question && !what.goal) return state.read;
    return (!what.question || state.right || state.revealed) && (!what.goal || state.reached);
}

std::size_t LessonSession::stepsDone() const {
    std::size_t count = 0;
    for (std::size_t k = 0; k < states_.size(); ++k) count += done(k);
    return count;
}

void LessonSession::goTo(std::size_t step) {
    const std::size_t next = std::min(step, states_.size() - 1);
    if (next != at_) states_[at_].read = true;
    at_ = next;
}

Expected<Judgement> LessonSession::commit(const std::string& answer) {
    if (!step().question) return Status::usage("this step asks nothing");
    if (answer.size() > kAnswerBytes) return Status::usage("the answer is too long");
    Expected<Judgement> judged = judge(*step().question, answer);
    if (!judged) return judged;
    StepState& state = states_[at_];
    state.answer = answer;
    state.right = judged->right;
    ++state.attempts;
    if (judged->right)
        state.revealed = true;
    else
        hint();
    return judged;
}

Judgement LessonSession::judgement() const {
    if (!step().question || state().answer.empty()) return {};
    const Expected<Judgement> judged = judge(*step().question, state().answer);
    return judged ? *judged : Judgement{};
}

bool LessonSession::canHint() const {
    return state().hints < static_cast<int>(step().hints.size()) && !done(at_);
}

void LessonSession::hint() {
    if (canHint()) ++states_[at_].hints;
}

bool LessonSession::canReveal() const {
    return step().question && state().attempts > 0 && !state().revealed;
}

void LessonSession::reveal() {
    if (canReveal()) states_[at_].revealed = true;
}

bool LessonSession::note(const Workspace& workspace) {
    if (!step().goal || state().reached) return false;
    // A map that lacks what is asked for has not reached it.
    for (const std::string& name : step().goal->when.names)
        if (!isObservable(workspace, name)) return false;
    states_[at_].reached =
        holds(step().goal->when, [&](const std::string& name) { return observe(workspace, name); });
    return states_[at_].reached;
}

void LessonSession::beginAgain() {
    states_.assign(lesson_.steps.size(), {});
    at_ = 0;
}

bool LessonSession::translate(Lesson lesson) {
    if (lesson.id != lesson_.id || lesson.steps.size() != lesson_.steps.size()) return false;
    lesson_ = std::move(lesson);
    return true;
}

Json LessonSession::progress() const {
    Json steps = Json::array();
    for (const StepState& state : states_)
        steps.push_back({{"answer", state.answer},
                         {"attempts", state.attempts},
                         {"right", state.right},
                         {"revealed", state.revealed},
                         {"hints", state.hints},
                         {"reached", state.reached},
                         {"read", state.read}});
    return {{"lesson", lesson_.id},
            {"at", static_cast<int>(at_)},
            {"done", stepsDone()},  // for lists
            {"steps", std::move(steps)}};
}

Status LessonSession::resume(const Json& progress) {
    ObjectReader reader(progress, "progress");
    std::string id;
    int at = 0, done = 0;
    std::vector<StepState> states;
    reader.text("lesson", id)
        .integer("at", at, 0, static_cast<int>(states_.size()) - 1)
        .integer("done", done, 0, static_cast<int>(states_.size()));
    if (id != lesson_.id) return Status::data("this progress is of another lesson");
    const Json* steps = reader.child("steps");
    if (!steps || !steps->is_array() || steps->size() != states_.size())
        return Status::data("the lesson has other steps than those of this progress");
    for (std::size_t k = 0; k < steps->size(); ++k) {
        StepState state;
        ObjectReader one((*steps)[k], "steps[" + std::to_string(k) + "]");
        one.text("answer", state.answer)
            .integer("attempts", state.attempts, 0, 1000000)
            .boolean("right", state.right)
            .boolean("revealed", state.revealed)
            .integer("hints", state.hints, 0, static_cast<int>(kMostHints))
            .boolean("reached", state.reached)
            .boolean("read", state.read);
        if (Status status = one.finish(); !status.ok()) return status;
        // A lesson may have been changed: what was right may not be an answer any more.
        const LessonStep& what = lesson_.steps[k];
        state.hints = std::min(state.hints, static_cast<int>(what.hints.size()));
        if (!state.answer.empty() && (!what.question || !judge(*what.question, state.answer)))
            state = {};
        states.push_back(std::move(state));
    }
    if (Status status = reader.finish(); !status.ok()) return status;
    states_ = std::move(states);
    at_ = static_cast<std::size_t>(at);
    return {};
}

std::string spokenAnswer(const Question& question, const std::string& answer) {
    const std::vector<double> numbers = answerNumbers(answer);
    if (question.kind == AnswerKind::choice) {
        const std::size_t index = numbers.size() == 1 && numbers[0] >= 1
                                      ? static_cast<std::size_t>(numbers[0]) - 1
                                      : question.choices.size();
        return index < question.choices.size() ? question.choices[index].text : answer;
    }
    for (const Question::Place& place : question.places)
        if (numbers == std::vector<double>{place.x, place.y})
            return place.text + " (" + answer + ")";
    return answer;
}

std::string rightAnswer(const Question& question) {
    if (question.kind == AnswerKind::choice) {
        std::string all;
        for (const Question::Choice& choice : question.choices)
            if (choice.right) all += (all.empty() ? "" : "; ") + choice.text;
        return all;
    }
    std::string answer = formatNumber(question.answer[0], 6);
    if (question.kind == AnswerKind::point) answer += ", " + formatNumber(question.answer[1], 6);
    return answer;
}

Json LessonSession::answers() const {
    Json steps = Json::array();
    for (std::size_t k = 0; k < states_.size(); ++k) {
        const LessonStep& what = lesson_.steps[k];
        const StepState& state = states_[k];
        Json entry{{"step", static_cast<int>(k) + 1}, {"title", what.title}};
        if (what.question) {
            entry["question"] = what.question->prompt;
            entry["answer"] =
                state.answer.empty() ? Json() : Json(spokenAnswer(*what.question, state.answer));
            entry["right"] = state.right;
            entry["attempts"] = state.attempts;
            entry["hints"] = state.hints;
        }
        if (what.goal) {
            entry["goal"] = what.goal->text;
            entry["reached"] = state.reached;
        }
        steps.push_back(std::move(entry));
    }
    return {{"versorium", "answers"},
            {"lesson", lesson_.id},
            {"title", lesson_.title},
            {"language", lesson_.language},
            {"steps", std::move(steps)}};
}

std::string answersAsText(const LessonSession& session) {
    std::string text = session.lesson().title + "\n";
    for (std::size_t k = 0; k < session.lesson().steps.size(); ++k) {
        const LessonStep& what = session.lesson().steps[k];
        const LessonSession::StepState& state = session.state(k);
        if (!what.question && !what.goal) continue;
        text += "\n" + std::to_string(k + 1) + ". " + what.title + "\n";
        if (what.question) {
            text += "   ? " + what.question->prompt + "\n";
            text += "   = " +
                    (state.answer.empty() ? "-" : spokenAnswer(*what.question, state.answer)) +
                    (state.right ? "  [+]" : "  [ ]") + "  (" + std::to_string(state.attempts) +
                    ")\n";
        }
        if (what.goal) text += "   " + what.goal->text + (state.reached ? "  [+]\n" : "  [ ]\n");
    }
    return text;
}

}  // namespace versorium
