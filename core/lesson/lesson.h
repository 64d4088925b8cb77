// SPDX-License-Identifier: MIT
#pragma once
// A lesson: steps of text, each with what the studio shows, and perhaps a question to commit to and
// a goal to reach by hand. It is read from one Markdown file (lessons/README.md is the guide for
// authors); such a file may be anybody's, so everything in it is checked and bounded.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lesson/markdown.h"
#include "lesson/question.h"
#include "workspace/workspace.h"

namespace versorium {

inline constexpr std::size_t kMostLessonSteps = 40;
inline constexpr std::size_t kMostHints = 8;
inline constexpr std::size_t kMostControls = 64;
// Of a title and of a choice, in characters: what a phone shows without a wall of text.
inline constexpr std::size_t kTitleCharacters = 60, kChoiceCharacters = 140;
// Of the prose of one step, in words.
inline constexpr std::size_t kMostWords = 160;

struct Goal {
    Condition when;
    std::string text;    // what is to be reached
    std::string praise;  // said once it is
};

struct LessonStep {
    std::string title;
    int line = 0;
    std::vector<MarkdownBlock> prose;
    Workspace stage;  // the teacher's state
    // The controls that are open to the learner: ids of ui/controls/controls.h, a parameter's name
    // for all of its numbers, or "point" for all of the starting point's. All controls where there
    // are none.
    std::vector<std::string> controls;
    std::optional<Question> question;
    std::optional<Goal> goal;
    std::optional<Workspace> solution;  // in which the goal is reached
    std::vector<MarkdownBlock> reveal;  // shown beside the answer once that is committed
    std::optional<Workspace> revealStage;
    std::vector<std::vector<MarkdownBlock>> hints;
    std::vector<std::vector<MarkdownBlock>> notes;  // for teachers
};

struct Lesson {
    std::string id, language;  // of the file's name: "orbit.en.md"
    std::string title, level;
    int minutes = 0;
    std::vector<std::string> rows;  // of the list of capabilities
    std::vector<LessonStep> steps;
};

// ErrorKind::data with the line. `name` is the file's own.
Expected<Lesson> parseLesson(std::string_view text, const std::string& name);

// Lessons that the program carries, in teaching order, which is that of their names; and one of
// them, in English where there is none in that language.
std::vector<std::string> lessonIds();
Expected<Lesson> lessonNamed(const std::string& id, const std::string& language);
// What a list of lessons shows, without the scenes being made.
struct LessonHead {
    std::string title, level;
    int minutes = 0;
    std::size_t steps = 0;
};
Expected<LessonHead> parseLessonHead(std::string_view text, const std::string& name);
Expected<LessonHead> lessonHead(const std::string& id, const std::string& language);

// What is wrong with a lesson that can be read: goals that hold from the beginning or that their
// solution does not reach, texts too long for a phone. Each with its line.
std::vector<std::string> faultsOf(const Lesson& lesson);

}  // namespace versorium
