// SPDX-License-Identifier: MIT
#include "lesson/lesson.h"

#include <algorithm>

#include "base/embedded.h"
#include "lesson/observables.h"
#include "lesson/stage.h"

namespace versorium {
namespace {

// Characters of UTF-8.
std::size_t lengthOf(const std::string& text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
        return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
    }));
}

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
    return parseLessonHead(file->text, file->name);
}

std::vector<std::string> faultsOf(const Lesson& lesson) {
    std::vector<std::string> faults;
    const auto tooLong = [&](int line, const std::string& text, std::size_t most) {
        if (lengthOf(text) > most)
            faults.push_back(atLine(line) + "\"" + text + "\" has more than " +
                             std::to_string(most) + " characters, too many for a phone");
    };
    tooLong(2, lesson.title, kTitleCharacters);
    for (const LessonStep& step : lesson.steps) {
        tooLong(step.line, step.title, kTitleCharacters);
        const std::size_t words = splitWords(plainText(step.prose)).size();
        if (words > kMostWords)
            faults.push_back(atLine(step.line) + "the text of this step has " +
                             std::to_string(words) + " words, more than " +
                             std::to_string(kMostWords));
        if (step.question)
            for (const Question::Place& place : step.question->places)
                tooLong(step.line, place.text, kChoiceCharacters);
        if (step.question)
            for (const Question::Choice& choice : step.question->choices) {
                tooLong(step.line, choice.text, kChoiceCharacters);
                if (!choice.right && choice.meaning.empty())
                    faults.push_back(atLine(step.line) + "the wrong answer \"" + choice.text +
                                     "\" does not say what it would have meant (\"=> …\")");
            }
        if (!step.goal) continue;
        const auto reached = [&](const Workspace& state) {
            return holds(step.goal->when,
                         [&](const std::string& name) { return observe(state, name); });
        };
        if (reached(step.stage))
            faults.push_back(atLine(step.line) + "the goal \"" + step.goal->when.text +
                             "\" holds from the beginning");
        if (!step.solution)
            faults.push_back(atLine(step.line) + "the goal has no ```solution");
        else if (!reached(*step.solution))
            faults.push_back(atLine(step.line) + "its solution does not reach the goal \"" +
                             step.goal->when.text + "\"");
    }
    return faults;
}

}  // namespace versorium
