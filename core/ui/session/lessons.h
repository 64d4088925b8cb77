// SPDX-License-Identifier: MIT
#pragma once
// The lesson that is open in the studio, and all that can be done with it: for the pane of the
// window, for a page's own, for keys and for tests.

#include <optional>
#include <string>
#include <vector>

#include "lesson/session.h"

namespace versorium {

struct StudioContext;

struct OpenLesson {
    explicit OpenLesson(Lesson lesson)
        : session(std::move(lesson)), left(session.lesson().steps.size()) {}

    LessonSession session;
    bool own = true;  // one of the program's
    // What the learner had made of each step when it was left.
    std::vector<std::optional<Workspace>> left;
    // The learner wanders about in the studio; the step's own state waits here.
    std::optional<Workspace> waiting;
    bool revealShown = false;  // the reveal's scene is on the screen
    std::string typed;         // an answer that is being written
    std::string problem;       // why it could not be taken
    // The goal was looked for in this revision of the workspace, at this time.
    std::uint64_t noted = 0;
    double notedAt = -100;

    bool wandering() const { return waiting.has_value(); }
};

// One of the program's lessons, and what was done of it.
struct LessonEntry {
    std::string id;
    LessonHead head;
    std::size_t done = 0;  // steps
};
struct Lessons {
    bool open = false;  // the pane; with no lesson it shows the list
    std::optional<OpenLesson> now;
    std::vector<LessonEntry> list;  // empty until it is asked for
    std::string listLanguage;
};

// All of them, in teaching order.
const std::vector<LessonEntry>& lessonList(StudioContext& context);

// One of the program's lessons, where the learner left it, or at a step (from 0).
Status openLesson(StudioContext& context, const std::string& id, std::optional<std::size_t> step);
// A lesson's file.
Status openLessonFile(StudioContext& context, const std::string& name, const std::string& text);
void closeLesson(StudioContext& context);
// The same lesson in the language that the studio speaks now.
void translateLesson(StudioContext& context);

// Something else is about to be shown: the learner wanders off.
void leaveStep(StudioContext& context);
void backToStep(StudioContext& context);
void goToStep(StudioContext& context, std::size_t step);
// The teacher's state of the step, or of the view that a teacher's link opened.
void resetStep(StudioContext& context);
void beginLessonAgain(StudioContext& context);

void commitAnswer(StudioContext& context, const std::string& answer);
void showHint(StudioContext& context);
void showAnswer(StudioContext& context);
// The reveal's own scene, or back to the learner's.
void toggleReveal(StudioContext& context);
// The place of the ring in the question's view, as an answer.
std::string ringAnswer(StudioContext& context);
// Looks whether the goal is reached; says so when it is.
void noteGoal(StudioContext& context);
void saveAnswers(StudioContext& context, bool asJson);
// The step as a plate of what the learner sees.
void exportStep(StudioContext& context);

// Whether a control is one of those that the step opens; all are, where it names none or the
// learner wanders.
bool isOpenInStep(StudioContext& context, const std::string& id);
// Whether the step names its controls: they alone are shown.
bool stepNamesControls(const StudioContext& context);

}  // namespace versorium
