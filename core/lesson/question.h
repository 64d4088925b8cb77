// SPDX-License-Identifier: MIT
#pragma once
// A question of a lesson, and what an answer to it is worth.

#include <optional>
#include <string>
#include <vector>

#include "base/status.h"
#include "base/words.h"
#include "lesson/condition.h"

namespace versorium {

inline constexpr std::size_t kMostChoices = 8;

enum class AnswerKind { choice, number, point };
template <>
struct EnumWords<AnswerKind> {
    static constexpr std::array<std::string_view, 3> table{"choice", "number", "point"};
};

// A prediction: it is committed to before anything is revealed.
struct Question {
    AnswerKind kind = AnswerKind::choice;
    std::string prompt;
    struct Choice {
        std::string text;
        bool right = false;
        std::string meaning;  // what the answer would have meant
    };
    std::vector<Choice> choices;
    // A number, or a point (x, y) of a view, is right within the tolerance.
    double answer[2] = {};
    double tolerance = 0;
    // … or where this holds of x and y: a region.
    std::optional<Condition> within;
    int view = 0;  // of a point
    // Points by their names, so that one can be answered in words.
    struct Place {
        std::string text;
        double x = 0, y = 0;
    };
    std::vector<Place> places;
    // What a number would have meant, by conditions on it: the first that holds.
    struct Meaning {
        Condition when;  // names "answer"; of a point "x" and "y"
        std::string text;
    };
    std::vector<Meaning> meanings;
    std::string praise;  // said of a right number or point
};

// The lines of an ```ask, the first of which is line `first` of its file (lessons/README.md).
// ErrorKind::data with the line.
Expected<Question> parseQuestion(const std::string& text, int first);

// The numbers of an answer, with decimal points, or with decimal commas where that is clear: "0,5",
// "0,5; -0,25". Empty where they are none.
std::vector<double> answerNumbers(const std::string& answer);

// Whether an answer is right, and what it means: the text to say. ErrorKind::usage where it cannot
// be an answer at all: an index of a choice from 1, a number, or two numbers.
struct Judgement {
    bool right = false;
    std::string text;  // may be empty
};
Expected<Judgement> judge(const Question& question, const std::string& answer);

}  // namespace versorium
