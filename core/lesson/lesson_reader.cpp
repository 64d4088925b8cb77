// SPDX-License-Identifier: MIT
// A lesson is read from its Markdown.
#include <algorithm>

#include "base/text.h"
#include "io/text_scanner.h"
#include "lesson/lesson.h"
#include "lesson/observables.h"
#include "lesson/stage.h"

namespace versorium {
namespace {

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
            return Status::data(atLine(1) +
                                "a lesson begins with ---, then title, level and minutes, "
                                "then --- again");
        const std::size_t begin = text_.find('\n') + 1;
        const std::size_t end = text_.find("\n---", begin - 1);
        if (end == std::string_view::npos)
            return Status::data(atLine(1) + "the second --- is missing");
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
                    return Status::data(atLine(entry.line) +
                                        "minutes must be a number from 1 to 600");
                lesson_.minutes = static_cast<int>(minutes[0]);
            } else if (entry.key == "rows") {
                lesson_.rows = splitWords(entry.value);
            } else {
                return Status::data(atLine(entry.line) + "\"" + entry.key +
                                    "\" is none of title, level, minutes and rows");
            }
        }
        if (lesson_.title.empty()) return Status::data(atLine(1) + "title is missing");
        if (lesson_.minutes == 0) return Status::data(atLine(1) + "minutes is missing");
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
                return Status::data(atLine(block.line) +
                                    "a step begins with \"## \" and its title");
            if (!lesson_.steps.empty())
                if (Status status = endStep(); !status.ok()) return status;
            if (lesson_.steps.size() == kMostLessonSteps)
                return Status::data(atLine(block.line) + "there are more than " +
                                    std::to_string(kMostLessonSteps) + " steps");
            LessonStep next;
            next.title = plainText(block);
            next.line = block.line;
            next.stage = stage_ ? *stage_ : workspaceOf(*presetNamed("mandelbrot"));
            lesson_.steps.push_back(std::move(next));
            return {};
        }
        if (lesson_.steps.empty())
            return Status::data(atLine(block.line) +
                                "text stands before the first step (\"## …\")");
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
                    return Status::data(atLine(inner.line) + "a " + kind + " holds text alone");
            if (kind == "reveal") {
                step().reveal = std::move(*blocks);
            } else if (kind == "hint") {
                if (step().hints.size() == kMostHints)
                    return Status::data(atLine(block.line) + "there are more than eight hints");
                step().hints.push_back(std::move(*blocks));
            } else {
                step().notes.push_back(std::move(*blocks));
            }
            return {};
        }
        return Status::data(atLine(block.line) + "```" + kind +
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
                return Status::data(atLine(first) + "there are more than " +
                                    std::to_string(kMostControls) + " controls");
            names.push_back(name);
        }
        return names;
    }

    Status takeQuestion(const std::string& text, int first) {
        if (step().question) return Status::data(atLine(first - 1) + "a step has one ask at most");
        Expected<Question> question = parseQuestion(text, first);
        if (!question) return question.status();
        step().question = std::move(*question);
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
                    return Status::data(atLine(line.line) + when.status().message() +
                                        "; there are " + observableNames(stage));
                goal.when = std::move(*when);
            } else if (line.key == "reach") {
                goal.text = line.value;
            } else if (line.key == "right") {
                goal.praise = line.value;
            } else {
                return Status::data(atLine(line.line) + "\"" + line.key +
                                    "\" is none of when, reach and right");
            }
        }
        if (goal.when.text.empty() || goal.text.empty())
            return Status::data(atLine(first - 1) +
                                "a goal has \"when: condition\" and \"reach: text\"");
        step().goal = std::move(goal);
        return {};
    }

    Status endStep() {
        if (step().prose.empty())
            return Status::data(atLine(step().line) + "this step has no text");
        if (!step().reveal.empty() && !step().question)
            return Status::data(atLine(step().line) + "a reveal needs an ask to be revealed after");
        stage_ = step().stage;
        return {};
    }
};

}  // namespace

Expected<Lesson> parseLesson(std::string_view text, const std::string& name) {
    if (text.size() > kMarkdownBytes)
        return Status::data("a lesson has at most " + std::to_string(kMarkdownBytes) + " bytes");
    const std::string plain = withLineFeeds(text);
    return Reader(plain, name).read();
}

Expected<LessonHead> parseLessonHead(std::string_view text, const std::string& name) {
    const std::string plain = withLineFeeds(text);
    return Reader(plain, name).readHead();
}

}  // namespace versorium
