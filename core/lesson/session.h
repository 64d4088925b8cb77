// SPDX-License-Identifier: MIT
#pragma once
// What a learner has done in a lesson: answers committed to, hints asked for, goals reached. It
// says what may be seen by now: hints in their order, a reveal not before an answer. Kept from one
// start to the next as JSON, and handed in as a text or as JSON.

#include <cstddef>
#include <string>
#include <vector>

#include "base/json.h"
#include "lesson/lesson.h"

namespace versorium {

class LessonSession {
  public:
    struct StepState {
        std::string answer;  // the last one that was committed to; empty where there is none
        int attempts = 0;
        bool right = false;
        bool revealed = false;
        int hints = 0;         // that are shown
        bool reached = false;  // the goal
        bool read = false;     // another step was gone to from here
        friend bool operator==(const StepState&, const StepState&) = default;
    };

    explicit LessonSession(Lesson lesson) : lesson_(std::move(lesson)) {
        states_.resize(lesson_.steps.size());
    }

    const Lesson& lesson() const { return lesson_; }
    std::size_t at() const { return at_; }
    const LessonStep& step() const { return lesson_.steps[at_]; }
    const StepState& state() const { return states_[at_]; }
    const StepState& state(std::size_t step) const { return states_[step]; }
    // The question is answered or given up, and the goal is reached, where there are such; a step
    // with neither is read.
    bool done(std::size_t step) const;
    std::size_t stepsDone() const;

    void goTo(std::size_t step);  // the last one where there are not so many

    // Judges an answer and keeps it. A right one reveals; a wrong one shows the next hint.
    // ErrorKind::usage, and nothing is kept, where it cannot be an answer.
    Expected<Judgement> commit(const std::string& answer);
    // What was said of the answer that is kept.
    Judgement judgement() const;
    bool canHint() const;
    void hint();
    // After a first attempt the answer may be asked for.
    bool canReveal() const;
    void reveal();
    // Looks whether the state satisfies the goal; true the first time that it does.
    bool note(const Workspace& workspace);
    // Forgets what was done in all steps.
    void beginAgain();

    // The same lesson in another language: what was done stays. False where it has other steps.
    bool translate(Lesson lesson);

    Json progress() const;
    // Of another lesson, or of one that has been changed since: ErrorKind::data, and nothing
    // changes.
    Status resume(const Json& progress);

    // What was asked, answered and reached, to hand in.
    Json answers() const;

  private:
    Lesson lesson_;
    std::vector<StepState> states_;
    std::size_t at_ = 0;
};

// The same as a text for a reader.
std::string answersAsText(const LessonSession& session);

// An answer as a person would say it: the choice's text, the place's name, or the numbers.
std::string spokenAnswer(const Question& question, const std::string& answer);
// The right one.
std::string rightAnswer(const Question& question);

}  // namespace versorium
