// SPDX-License-Identifier: MIT
#include "lesson/lesson.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "base/embedded.h"
#include "base/text.h"
#include "lesson/observables.h"
#include "lesson/stage.h"

namespace versorium {
namespace {

std::string at(int line) { return "line " + std::to_string(line) + ": "; }

std::vector<std::string> split(const std::string& text) {
    std::vector<std::string> words;
    std::string word;
    for (const char c : text + " ") {
        if (c != ' ' && c != ',' && c != '\n' && c != '\r' && c != '\t') {
            word += c;
        } else if (!word.empty()) {
            words.push_back(word);
            word.clear();
        }
    }
    return words;
}

// Characters of UTF-8.
std::size_t lengthOf(const std::string& text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
        return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
    }));
}

bool isAnswerName(const std::string& name) {
    return name == "answer" || name == "x" || name == "y";
}

class Reader {
  public:
    Reader(std::string_view text, const std::string& name) : text_(text) {
        // "orbit.en.md"
        const std::size_t slash = name.find_last_of("/\\");
        std::string base = slash == std::string::npos ? name : name.substr(slash + 1);
        if (base.ends_with(".md")) base.resize(base.size() - 3);
        const std::size_t dot = base.rfind('.');
        lesson_.id = base.substr(0, dot);
        lesson_.language = dot == std::string::npos ? "en" : base.substr(dot + 1);
    }

    Expected<Lesson> read() {
        Status status = readAll();
        if (!status.ok()) return status;
        return std::move(lesson_);
    }

    Expected<LessonHead> readHead() {
        int line = 1;
        if (Status status = readFront(line); !status.ok()) return status;
        constexpr std::string_view kStep = "\n## ";
        std::size_t steps = text_.starts_with(kStep.substr(1));
        for (std::size_t at = text_.find(kStep); at != std::string_view::npos;
             at = text_.find(kStep, at + 1))
            ++steps;
        return LessonHead{lesson_.title, lesson_.level, lesson_.minutes, steps};
    }

  private:
    std::string_view text_;
    Lesson lesson_;
    std::optional<Workspace> stage_;  // of the step before

    Status readAll() {
        int line = 1;
        if (Status status = readFront(line); !status.ok()) return status;
        Expected<std::vector<MarkdownBlock>> blocks = parseMarkdown(text_, line);
        if (!blocks) return blocks.status();
        for (MarkdownBlock& block : *blocks)
            if (Status status = take(std::move(block)); !status.ok()) return status;
        if (lesson_.steps.empty())
            return Status::data("there are no steps: each begins with \"## \" and its title");
        return endStep();
    }

    // The lines between --- and ---.
    Status readFront(int& line) {
        if (!text_.starts_with("---\n") && !text_.starts_with("---\r\n"))
            return Status::data(at(1) +
                                "a lesson begins with ---, then title, level and minutes, "
                                "then --- again");
        const std::size_t begin = text_.find('\n') + 1;
        const std::size_t end = text_.find("\n---", begin - 1);
        if (end == std::string_view::npos) return Status::data(at(1) + "the second --- is missing");
        const std::string front(text_.substr(begin, end > begin ? end - begin : 0));
        Expected<std::vector<StageLine>> lines = readLines(front, 2);
        if (!lines) return lines.status();
        for (const StageLine& entry : *lines) {
            if (entry.key == "title") {
                lesson_.title = entry.value;
            } else if (entry.key == "level") {
                lesson_.level = entry.value;
            } else if (entry.key == "minutes") {
                const std::vector<double> minutes = numbersOf(entry.value);
                if (minutes.size() != 1 || !(minutes[0] >= 1 && minutes[0] <= 600))
                    return Status::data(at(entry.line) + "minutes must be a number from 1 to 600");
                lesson_.minutes = static_cast<int>(minutes[0]);
            } else if (entry.key == "rows") {
                lesson_.rows = split(entry.value);
            } else {
                return Status::data(at(entry.line) + "\"" + entry.key +
                                    "\" is none of title, level, minutes and rows");
            }
        }
        if (lesson_.title.empty()) return Status::data(at(1) + "title is missing");
        if (lesson_.minutes == 0) return Status::data(at(1) + "minutes is missing");
        std::size_t rest = text_.find('\n', end + 1);
        rest = rest == std::string_view::npos ? text_.size() : rest + 1;
        line += static_cast<int>(
            std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(rest), '\n'));
        text_ = text_.substr(rest);
        return {};
    }

    LessonStep& step() { return lesson_.steps.back(); }

    Status take(MarkdownBlock block) {
        if (block.kind == MarkdownBlock::Kind::heading) {
            if (block.level != 2)
                return Status::data(at(block.line) + "a step begins with \"## \" and its title");
            if (!lesson_.steps.empty())
                if (Status status = endStep(); !status.ok()) return status;
            if (lesson_.steps.size() == kMostLessonSteps)
                return Status::data(at(block.line) + "there are more than " +
                                    std::to_string(kMostLessonSteps) + " steps");
            LessonStep next;
            next.title = plainText(block);
            next.line = block.line;
            next.stage = stage_ ? *stage_ : workspaceOf(*presetNamed("mandelbrot"));
            lesson_.steps.push_back(std::move(next));
            return {};
        }
        if (lesson_.steps.empty())
            return Status::data(at(block.line) + "text stands before the first step (\"## …\")");
        if (block.kind != MarkdownBlock::Kind::fence) {
            step().prose.push_back(std::move(block));
            return {};
        }
        return takeFence(block);
    }

    Status takeFence(const MarkdownBlock& block) {
        const std::string kind = trimmed(block.info);
        // The lines of a fence begin below its own.
        const int first = block.line + 1;
        if (kind == "scene") {
            if (Status status = stageInto(block.text, first, step().stage); !status.ok())
                return status;
            stage_ = step().stage;
            return {};
        }
        if (kind == "controls") {
            Expected<std::vector<std::string>> names = linesOf(block.text, first);
            if (!names) return names.status();
            step().controls = std::move(*names);
            return {};
        }
        if (kind == "ask") return takeQuestion(block.text, first);
        if (kind == "goal") return takeGoal(block.text, first);
        if (kind == "solution") {
            Workspace solved = step().stage;
            if (Status status = stageInto(block.text, first, solved); !status.ok()) return status;
            step().solution = std::move(solved);
            return {};
        }
        if (kind == "reveal scene") {
            Workspace shown = step().stage;
            if (Status status = stageInto(block.text, first, shown); !status.ok()) return status;
            step().revealStage = std::move(shown);
            return {};
        }
        if (kind == "reveal" || kind == "hint" || kind == "note") {
            Expected<std::vector<MarkdownBlock>> blocks = parseMarkdown(block.text, first);
            if (!blocks) return blocks.status();
            for (const MarkdownBlock& inner : *blocks)
                if (inner.kind == MarkdownBlock::Kind::fence)
                    return Status::data(at(inner.line) + "a " + kind + " holds text alone");
            if (kind == "reveal") {
                step().reveal = std::move(*blocks);
            } else if (kind == "hint") {
                if (step().hints.size() == kMostHints)
                    return Status::data(at(block.line) + "there are more than eight hints");
                step().hints.push_back(std::move(*blocks));
            } else {
                step().notes.push_back(std::move(*blocks));
            }
            return {};
        }
        return Status::data(at(block.line) + "```" + kind +
                            " is none of scene, controls, ask, goal, solution, reveal, reveal "
                            "scene, hint and note");
    }

    Status stageInto(const std::string& text, int first, Workspace& stage) {
        const Expected<std::vector<StageLine>> lines = readLines(text, first);
        if (!lines) return lines.status();
        Expected<Workspace> next = changed(stage, *lines);
        if (!next) return next.status();
        stage = std::move(*next);
        return {};
    }

    // Names, one to a line; ids of controls may have spaces.
    static Expected<std::vector<std::string>> linesOf(const std::string& text, int first) {
        std::vector<std::string> names;
        for (std::size_t begin = 0; begin < text.size(); ++first) {
            const std::size_t end = std::min(text.find('\n', begin), text.size());
            const std::string name = trimmed(text.substr(begin, end - begin));
            begin = end + 1;
            if (name.empty()) continue;
            if (names.size() == kMostControls)
                return Status::data(at(first) + "there are more than " +
                                    std::to_string(kMostControls) + " controls");
            names.push_back(name);
        }
        return names;
    }

    // A point's line: "- words => x, y".
    static Status placeOf(const std::string& line, int number, Question& question) {
        const std::size_t arrow = line.find("=>");
        const std::vector<double> place =
            arrow == std::string::npos ? std::vector<double>() : numbersOf(line.substr(arrow + 2));
        if (place.size() != 2)
            return Status::data(at(number) + "a place of a point is \"- words => x, y\"");
        question.places.push_back({trimmed(line.substr(1, arrow - 1)), place[0], place[1]});
        return {};
    }

    // A choice's line: "- text => what it means", "+ text" where it is right.
    static Question::Choice choiceOf(const std::string& line) {
        Question::Choice choice;
        choice.right = line[0] == '+';
        const std::size_t arrow = line.find("=>");
        choice.text = trimmed(line.substr(1, arrow == std::string::npos ? arrow : arrow - 1));
        if (arrow != std::string::npos) choice.meaning = trimmed(line.substr(arrow + 2));
        return choice;
    }

    Status takeQuestion(const std::string& text, int first) {
        if (step().question) return Status::data(at(first - 1) + "a step has one ask at most");
        Question question;
        const bool ofPlaces = trimmed(text).starts_with("point");
        std::string keyed;  // the other lines, with choices left blank so that lines still count
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
        Expected<std::vector<StageLine>> lines = readLines(keyed, first);
        if (!lines) return lines.status();
        bool answered = false;
        for (const StageLine& line : *lines) {
            const std::string where = at(line.line);
            if (line.key == "choice" || line.key == "number" || line.key == "point") {
                question.kind = line.key == "choice"   ? AnswerKind::choice
                                : line.key == "number" ? AnswerKind::number
                                                       : AnswerKind::point;
                question.prompt = line.value;
            } else if (line.key == "answer") {
                const std::vector<double> numbers = numbersOf(line.value);
                const std::size_t wanted = question.kind == AnswerKind::point ? 2 : 1;
                if (numbers.size() != wanted)
                    return Status::data(where + "answer must be " +
                                        (wanted == 2 ? "two numbers" : "a number"));
                std::copy(numbers.begin(), numbers.end(), question.answer);
                answered = true;
            } else if (line.key == "tolerance") {
                const std::vector<double> numbers = numbersOf(line.value);
                if (numbers.size() != 1 || !(numbers[0] >= 0))
                    return Status::data(where + "tolerance must be a number that is not negative");
                question.tolerance = numbers[0];
            } else if (line.key == "within") {
                Expected<Condition> within = parseCondition(line.value, isAnswerName);
                if (!within) return Status::data(where + within.status().message());
                question.within = std::move(*within);
            } else if (line.key == "view") {
                if (line.value != "left" && line.value != "right")
                    return Status::data(where + "view must be left or right");
                question.view = line.value == "right" ? 1 : 0;
            } else if (line.key == "right") {
                question.praise = line.value;
            } else if (line.key.starts_with("when ")) {
                Expected<Condition> when =
                    parseCondition(trimmed(line.key.substr(5)), isAnswerName);
                if (!when) return Status::data(where + when.status().message());
                question.meanings.push_back({std::move(*when), line.value});
            } else {
                return Status::data(where + "\"" + line.key +
                                    "\" is none of choice, number, point, answer, tolerance, "
                                    "within, view, right and when …");
            }
        }
        if (question.prompt.empty())
            return Status::data(at(first - 1) +
                                "ask begins with choice, number or point and the question");
        if (std::max(question.choices.size(), question.places.size()) > kMostChoices)
            return Status::data(at(first - 1) + "there are more than eight choices");
        if (question.kind == AnswerKind::choice) {
            const auto right = std::count_if(question.choices.begin(), question.choices.end(),
                                             [](const auto& choice) { return choice.right; });
            if (question.choices.size() < 2 || right == 0)
                return Status::data(at(first - 1) +
                                    "a choice has 2 to 8 lines \"- text => meaning\", and \"+\" "
                                    "before one that is right");
        } else if (!answered) {
            return Status::data(at(first - 1) + "answer is missing");
        }
        step().question = std::move(question);
        return {};
    }

    Status takeGoal(const std::string& text, int first) {
        const Expected<std::vector<StageLine>> lines = readLines(text, first);
        if (!lines) return lines.status();
        Goal goal;
        for (const StageLine& line : *lines) {
            if (line.key == "when") {
                const Workspace& stage = step().stage;
                Expected<Condition> when = parseCondition(
                    line.value, [&](const std::string& name) { return isObservable(stage, name); });
                if (!when)
                    return Status::data(at(line.line) + when.status().message() + "; there are " +
                                        observableNames(stage));
                goal.when = std::move(*when);
            } else if (line.key == "reach") {
                goal.text = line.value;
            } else if (line.key == "right") {
                goal.praise = line.value;
            } else {
                return Status::data(at(line.line) + "\"" + line.key +
                                    "\" is none of when, reach and right");
            }
        }
        if (goal.when.text.empty() || goal.text.empty())
            return Status::data(at(first - 1) +
                                "a goal has \"when: condition\" and \"reach: text\"");
        step().goal = std::move(goal);
        return {};
    }

    Status endStep() {
        if (step().prose.empty()) return Status::data(at(step().line) + "this step has no text");
        if (!step().reveal.empty() && !step().question)
            return Status::data(at(step().line) + "a reveal needs an ask to be revealed after");
        stage_ = step().stage;
        return {};
    }
};

struct File {
    std::string name;
    std::string_view text;
};

// In English where there is none in that language.
Expected<File> fileOf(const std::string& id, const std::string& language) {
    for (const std::string& tried : {language, std::string("en")}) {
        const std::string name = "lessons/" + id + "." + tried + ".md";
        if (const std::string_view text = embeddedText(name); !text.empty())
            return File{name, text};
    }
    std::string all;
    for (const std::string& known : lessonIds()) all += (all.empty() ? "" : ", ") + known;
    return Status::usage("there is no lesson named \"" + id + "\"; there are " + all);
}

}  // namespace

Expected<Lesson> parseLesson(std::string_view text, const std::string& name) {
    if (text.size() > kMarkdownBytes)
        return Status::data("a lesson has at most " + std::to_string(kMarkdownBytes) + " bytes");
    return Reader(text, name).read();
}

std::vector<std::string> lessonIds() {
    std::vector<std::string> ids;
    const std::string folder = "lessons/", ending = ".en.md";
    for (const std::string_view name : embeddedNames(folder))
        if (name.ends_with(ending))
            ids.emplace_back(
                name.substr(folder.size(), name.size() - folder.size() - ending.size()));
    return ids;
}

Expected<Lesson> lessonNamed(const std::string& id, const std::string& language) {
    const Expected<File> file = fileOf(id, language);
    if (!file) return file.status();
    return parseLesson(file->text, file->name);
}

Expected<LessonHead> lessonHead(const std::string& id, const std::string& language) {
    const Expected<File> file = fileOf(id, language);
    if (!file) return file.status();
    return Reader(file->text, file->name).readHead();
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

std::vector<std::string> faultsOf(const Lesson& lesson) {
    std::vector<std::string> faults;
    const auto tooLong = [&](int line, const std::string& text, std::size_t most) {
        if (lengthOf(text) > most)
            faults.push_back(at(line) + "\"" + text + "\" has more than " + std::to_string(most) +
                             " characters, too many for a phone");
    };
    tooLong(2, lesson.title, kTitleCharacters);
    for (const LessonStep& step : lesson.steps) {
        tooLong(step.line, step.title, kTitleCharacters);
        const std::size_t words = split(plainText(step.prose)).size();
        if (words > kMostWords)
            faults.push_back(at(step.line) + "the text of this step has " + std::to_string(words) +
                             " words, more than " + std::to_string(kMostWords));
        if (step.question)
            for (const Question::Place& place : step.question->places)
                tooLong(step.line, place.text, kChoiceCharacters);
        if (step.question)
            for (const Question::Choice& choice : step.question->choices) {
                tooLong(step.line, choice.text, kChoiceCharacters);
                if (!choice.right && choice.meaning.empty())
                    faults.push_back(at(step.line) + "the wrong answer \"" + choice.text +
                                     "\" does not say what it would have meant (\"=> …\")");
            }
        if (!step.goal) continue;
        const auto reached = [&](const Workspace& state) {
            return holds(step.goal->when,
                         [&](const std::string& name) { return observe(state, name); });
        };
        if (reached(step.stage))
            faults.push_back(at(step.line) + "the goal \"" + step.goal->when.text +
                             "\" holds from the beginning");
        if (!step.solution)
            faults.push_back(at(step.line) + "the goal has no ```solution");
        else if (!reached(*step.solution))
            faults.push_back(at(step.line) + "its solution does not reach the goal \"" +
                             step.goal->when.text + "\"");
    }
    return faults;
}

}  // namespace versorium
