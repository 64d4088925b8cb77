// SPDX-License-Identifier: MIT
#include "lesson/question.h"

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "lesson/stage.h"

namespace versorium {
namespace {

bool isAnswerName(const std::string& name) {
    return name == "answer" || name == "x" || name == "y";
}

// A point's line: "- words => x, y".
Status placeOf(const std::string& line, int number, Question& question) {
    const std::size_t arrow = line.find("=>");
    const std::vector<double> place =
        arrow == std::string::npos ? std::vector<double>() : numbersOf(line.substr(arrow + 2));
    if (place.size() != 2)
        return Status::data(atLine(number) + "a place of a point is \"- words => x, y\"");
    question.places.push_back({trimmed(line.substr(1, arrow - 1)), place[0], place[1]});
    return {};
}

// A choice's line: "- text => what it means", "+ text" where it is right.
Question::Choice choiceOf(const std::string& line) {
    Question::Choice choice;
    choice.right = line[0] == '+';
    const std::size_t arrow = line.find("=>");
    choice.text = trimmed(line.substr(1, arrow == std::string::npos ? arrow : arrow - 1));
    if (arrow != std::string::npos) choice.meaning = trimmed(line.substr(arrow + 2));
    return choice;
}

// Takes the choices, or the places of a point; the other lines stay, with these left blank so that
// lines still count.
Expected<std::string> takeChoices(const std::string& text, int first, Question& question) {
    const bool ofPlaces = trimmed(text).starts_with("point");
    std::string keyed;
    std::size_t begin = 0;
    for (int number = first; begin < text.size(); ++number) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string line = trimmed(text.substr(begin, end - begin));
        begin = end + 1;
        const bool isChoice =
            line.size() > 2 && (line[0] == '-' || line[0] == '+') && line[1] == ' ';
        if (isChoice && ofPlaces) {
            if (Status status = placeOf(line, number, question); !status.ok()) return status;
        } else if (isChoice) {
            question.choices.push_back(choiceOf(line));
        }
        keyed += (isChoice ? std::string() : line) + "\n";
    }
    return keyed;
}

// `answered` where it says what is right.
Status takeLine(const StageLine& line, Question& question, bool& answered) {
    if (line.key == "choice" || line.key == "number" || line.key == "point") {
        question.kind = *fromWord<AnswerKind>(line.key);
        question.prompt = line.value;
    } else if (line.key == "answer") {
        const std::vector<double> numbers = numbersOf(line.value);
        const std::size_t wanted = question.kind == AnswerKind::point ? 2 : 1;
        if (numbers.size() != wanted)
            return Status::data(std::string("answer must be ") +
                                (wanted == 2 ? "two numbers" : "a number"));
        std::copy(numbers.begin(), numbers.end(), question.answer);
        answered = true;
    } else if (line.key == "tolerance") {
        const std::vector<double> numbers = numbersOf(line.value);
        if (numbers.size() != 1 || !(numbers[0] >= 0))
            return Status::data("tolerance must be a number that is not negative");
        question.tolerance = numbers[0];
    } else if (line.key == "within") {
        Expected<Condition> within = parseCondition(line.value, isAnswerName);
        if (!within) return within.status();
        question.within = std::move(*within);
    } else if (line.key == "view") {
        if (line.value != "left" && line.value != "right")
            return Status::data("view must be left or right");
        question.view = line.value == "right" ? 1 : 0;
    } else if (line.key == "right") {
        question.praise = line.value;
    } else if (line.key.starts_with("when ")) {
        Expected<Condition> when = parseCondition(trimmed(line.key.substr(5)), isAnswerName);
        if (!when) return when.status();
        question.meanings.push_back({std::move(*when), line.value});
    } else {
        return Status::data("\"" + line.key +
                            "\" is none of choice, number, point, answer, tolerance, within, "
                            "view, right and when …");
    }
    return {};
}

Status checkQuestion(const Question& question, bool answered) {
    if (question.prompt.empty())
        return Status::data("ask begins with choice, number or point and the question");
    if (std::max(question.choices.size(), question.places.size()) > kMostChoices)
        return Status::data("there are more than eight choices");
    if (question.kind != AnswerKind::choice)
        return answered ? Status() : Status::data("answer is missing");
    const bool right = std::any_of(question.choices.begin(), question.choices.end(),
                                   [](const auto& choice) { return choice.right; });
    if (question.choices.size() < 2 || !right)
        return Status::data(
            "a choice has 2 to 8 lines \"- text => meaning\", and \"+\" before one that is right");
    return {};
}

}  // namespace

Expected<Question> parseQuestion(const std::string& text, int first) {
    Question question;
    const Expected<std::string> keyed = takeChoices(text, first, question);
    if (!keyed) return keyed.status();
    const Expected<std::vector<StageLine>> lines = readLines(*keyed, first);
    if (!lines) return lines.status();
    bool answered = false;
    for (const StageLine& line : *lines)
        if (Status status = takeLine(line, question, answered); !status.ok())
            return Status::data(atLine(line.line) + status.message());
    if (Status status = checkQuestion(question, answered); !status.ok())
        return Status::data(atLine(first - 1) + status.message());
    return question;
}

std::vector<double> answerNumbers(const std::string& answer) {
    // With semicolons between them, or alone, numbers may have decimal commas: "0,5; -0,25".
    const auto commas = std::count(answer.begin(), answer.end(), ',');
    if (answer.find(';') == std::string::npos &&
        !(commas == 1 && answer.find_first_of(". ") == std::string::npos))
        return numbersOf(answer);
    std::string pointed = answer;
    std::replace(pointed.begin(), pointed.end(), ',', '.');
    std::replace(pointed.begin(), pointed.end(), ';', ',');
    return numbersOf(pointed);
}

Expected<Judgement> judge(const Question& question, const std::string& answer) {
    std::vector<double> numbers = answerNumbers(answer);
    // "1,2" of a point is two numbers.
    if (question.kind == AnswerKind::point && numbers.size() == 1) numbers = numbersOf(answer);
    if (question.kind == AnswerKind::choice) {
        if (numbers.size() != 1 || !(numbers[0] >= 1) ||
            !(numbers[0] <= static_cast<double>(question.choices.size())) ||
            numbers[0] != std::floor(numbers[0]))
            return Status::usage("choose one of the answers");
        const Question::Choice& choice = question.choices[static_cast<std::size_t>(numbers[0]) - 1];
        return Judgement{choice.right, choice.meaning};
    }
    const std::size_t wanted = question.kind == AnswerKind::point ? 2 : 1;
    if (numbers.size() != wanted)
        return Status::usage(wanted == 2 ? "give two numbers, such as -0.5, 0.25"
                                         : "give a number, such as 0.5");
    double square = 0;
    for (std::size_t k = 0; k < wanted; ++k)
        square += (numbers[k] - question.answer[k]) * (numbers[k] - question.answer[k]);
    // The last digit of a decimal is no reason to be wrong.
    const double slack = 1e-9 * (1 + std::fabs(question.answer[0]) + std::fabs(question.answer[1]));
    const auto value = [&](const std::string& name) {
        return numbers[name == "y" ? wanted - 1 : 0];
    };
    if (std::sqrt(square) <= question.tolerance + slack ||
        (question.within && holds(*question.within, value)))
        return Judgement{true, question.praise};
    for (const Question::Meaning& meaning : question.meanings)
        if (holds(meaning.when, value)) return Judgement{false, meaning.text};
    return Judgement{false, ""};
}

}  // namespace versorium
