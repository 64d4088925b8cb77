// SPDX-License-Identifier: MIT
// The lessons that the program carries, in all languages: each can be taken, and translations
// differ in their texts alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "lesson/lesson.h"
#include "lesson/observables.h"
#include "plate/font.h"

namespace versorium {
namespace {

const char* const kLanguages[] = {"en", "es"};

Lesson lessonIn(const std::string& id, const std::string& language) {
    Expected<Lesson> lesson = lessonNamed(id, language);
    EXPECT_TRUE(lesson) << id << ": " << lesson.status().message();
    return lesson ? std::move(*lesson) : Lesson();
}

std::string place(const Lesson& lesson, std::size_t step) {
    return lesson.id + "." + lesson.language + ", step " + std::to_string(step + 1);
}

// Of well-formed UTF-8, as the Markdown reader leaves it.
std::vector<char32_t> lettersOf(const std::string& text) {
    std::vector<char32_t> letters;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x80)
            letters.push_back(byte);
        else if (byte < 0xC0)
            letters.back() = letters.back() << 6 | (byte & 0x3F);
        else
            letters.push_back(byte & (byte < 0xE0 ? 0x1F : byte < 0xF0 ? 0x0F : 0x07));
    }
    return letters;
}

// Everything that a learner may read.
std::vector<std::string> textsOf(const Lesson& lesson) {
    std::vector<std::string> texts{lesson.title, lesson.level};
    for (const LessonStep& step : lesson.steps) {
        texts.insert(texts.end(), {step.title, plainText(step.prose), plainText(step.reveal)});
        for (const auto& hint : step.hints) texts.push_back(plainText(hint));
        for (const auto& note : step.notes) texts.push_back(plainText(note));
        if (step.goal) texts.insert(texts.end(), {step.goal->text, step.goal->praise});
        if (!step.question) continue;
        texts.insert(texts.end(), {step.question->prompt, step.question->praise});
        for (const auto& choice : step.question->choices)
            texts.insert(texts.end(), {choice.text, choice.meaning});
        for (const auto& named : step.question->places) texts.push_back(named.text);
        for (const auto& meaning : step.question->meanings) texts.push_back(meaning.text);
    }
    return texts;
}

TEST(EmbeddedLessons, AreEightInTeachingOrder) {
    const std::vector<std::string> expected{"1-orbits", "2-julia",  "3-mandelbrot", "4-planes",
                                            "5-roots",  "6-versor", "7-shape",      "8-chance"};
    EXPECT_EQ(lessonIds(), expected);
}

TEST(EmbeddedLessons, HaveNoFaultsInAnyLanguage) {
    for (const std::string& id : lessonIds())
        for (const char* language : kLanguages) {
            const Lesson lesson = lessonIn(id, language);
            EXPECT_EQ(lesson.language, language) << id << " is not translated";
            for (const std::string& fault : faultsOf(lesson))
                ADD_FAILURE() << id << "." << language << ".md, " << fault;
        }
}

// Predict, commit, reveal, and do: a lesson that only tells is none.
TEST(EmbeddedLessons, AskAndLetTheLearnerDo) {
    for (const std::string& id : lessonIds()) {
        const Lesson lesson = lessonIn(id, "en");
        EXPECT_GE(lesson.steps.size(), 5u) << id;
        EXPECT_LE(lesson.steps.size(), 8u) << id;
        EXPECT_GE(lesson.minutes, 5) << id;
        EXPECT_LE(lesson.minutes, 10) << id;
        int questions = 0, goals = 0;
        for (std::size_t k = 0; k < lesson.steps.size(); ++k) {
            const LessonStep& step = lesson.steps[k];
            questions += step.question.has_value();
            goals += step.goal.has_value();
            if (step.question || step.goal) {
                EXPECT_GE(step.hints.size(), 2u) << place(lesson, k);
            }
            if (step.question) {
                EXPECT_FALSE(step.reveal.empty()) << place(lesson, k);
            }
        }
        EXPECT_GE(questions, 2) << id;
        EXPECT_GE(goals, 2) << id;
        // The last step leaves something open.
        EXPECT_NE(plainText(lesson.steps.back().prose).find('?'), std::string::npos) << id;
    }
}

// What a reveal shows must not reach the goal that is still to be reached by hand.
TEST(EmbeddedLessons, RevealsLeaveGoalsToTheLearner) {
    for (const std::string& id : lessonIds()) {
        const Lesson lesson = lessonIn(id, "en");
        for (std::size_t k = 0; k < lesson.steps.size(); ++k) {
            const LessonStep& step = lesson.steps[k];
            if (!step.goal || !step.revealStage) continue;
            const bool reached = holds(step.goal->when, [&](const std::string& name) {
                return observe(*step.revealStage, name);
            });
            EXPECT_FALSE(reached) << place(lesson, k);
        }
    }
}

TEST(EmbeddedLessons, JudgeTheirOwnAnswersAsRight) {
    for (const std::string& id : lessonIds()) {
        const Lesson lesson = lessonIn(id, "en");
        for (std::size_t k = 0; k < lesson.steps.size(); ++k) {
            if (!lesson.steps[k].question) continue;
            const Question& question = *lesson.steps[k].question;
            if (question.kind == AnswerKind::choice) continue;
            std::string answer = std::to_string(question.answer[0]);
            if (question.kind == AnswerKind::point)
                answer += ", " + std::to_string(question.answer[1]);
            const Expected<Judgement> judgement = judge(question, answer);
            ASSERT_TRUE(judgement) << place(lesson, k);
            EXPECT_TRUE(judgement->right) << place(lesson, k) << ": " << answer;
            EXPECT_FALSE(judgement->text.empty()) << place(lesson, k) << " does not say why";
        }
    }
}

// A point can be answered in words: one place is right, and the wrong ones say what they mean.
TEST(EmbeddedLessons, NamePlacesOfPoints) {
    int points = 0;
    for (const std::string& id : lessonIds()) {
        const Lesson lesson = lessonIn(id, "en");
        for (std::size_t k = 0; k < lesson.steps.size(); ++k) {
            if (!lesson.steps[k].question) continue;
            const Question& question = *lesson.steps[k].question;
            if (question.kind != AnswerKind::point) continue;
            ++points;
            int right = 0;
            for (const Question::Place& named : question.places) {
                const Expected<Judgement> judgement =
                    judge(question, std::to_string(named.x) + ", " + std::to_string(named.y));
                ASSERT_TRUE(judgement) << place(lesson, k);
                right += judgement->right;
                EXPECT_FALSE(judgement->text.empty()) << place(lesson, k) << ": " << named.text;
            }
            EXPECT_EQ(right, 1) << place(lesson, k);
            EXPECT_GE(question.places.size(), 3u) << place(lesson, k);
        }
    }
    EXPECT_GT(points, 0);
}

void expectSameQuestion(const Question& one, const Question& other, const std::string& where) {
    EXPECT_EQ(one.kind, other.kind) << where;
    EXPECT_EQ(one.answer[0], other.answer[0]) << where;
    EXPECT_EQ(one.answer[1], other.answer[1]) << where;
    EXPECT_EQ(one.tolerance, other.tolerance) << where;
    EXPECT_EQ(one.view, other.view) << where;
    EXPECT_EQ(one.praise.empty(), other.praise.empty()) << where;
    ASSERT_EQ(one.choices.size(), other.choices.size()) << where;
    for (std::size_t i = 0; i < one.choices.size(); ++i)
        EXPECT_EQ(one.choices[i].right, other.choices[i].right) << where;
    ASSERT_EQ(one.places.size(), other.places.size()) << where;
    for (std::size_t i = 0; i < one.places.size(); ++i) {
        EXPECT_EQ(one.places[i].x, other.places[i].x) << where;
        EXPECT_EQ(one.places[i].y, other.places[i].y) << where;
    }
    ASSERT_EQ(one.meanings.size(), other.meanings.size()) << where;
    for (std::size_t i = 0; i < one.meanings.size(); ++i)
        EXPECT_EQ(one.meanings[i].when.text, other.meanings[i].when.text) << where;
}

Json stateOf(const std::optional<Workspace>& stage) {
    return stage ? workspaceToJson(*stage) : Json();
}

TEST(EmbeddedLessons, DifferBetweenLanguagesInTheirTextsAlone) {
    for (const std::string& id : lessonIds()) {
        const Lesson one = lessonIn(id, "en"), other = lessonIn(id, "es");
        EXPECT_EQ(one.minutes, other.minutes) << id;
        EXPECT_EQ(one.rows, other.rows) << id;
        ASSERT_EQ(one.steps.size(), other.steps.size()) << id;
        for (std::size_t k = 0; k < one.steps.size(); ++k) {
            const LessonStep &a = one.steps[k], &b = other.steps[k];
            const std::string where = place(other, k);
            EXPECT_NE(a.title, b.title) << where << " is not translated";
            EXPECT_EQ(a.prose.size(), b.prose.size()) << where;
            EXPECT_EQ(workspaceToJson(a.stage), workspaceToJson(b.stage)) << where;
            EXPECT_EQ(stateOf(a.solution), stateOf(b.solution)) << where;
            EXPECT_EQ(stateOf(a.revealStage), stateOf(b.revealStage)) << where;
            EXPECT_EQ(a.controls, b.controls) << where;
            EXPECT_EQ(a.hints.size(), b.hints.size()) << where;
            EXPECT_EQ(a.notes.size(), b.notes.size()) << where;
            EXPECT_EQ(a.reveal.size(), b.reveal.size()) << where;
            ASSERT_EQ(a.goal.has_value(), b.goal.has_value()) << where;
            if (a.goal) {
                EXPECT_EQ(a.goal->when.text, b.goal->when.text) << where;
            }
            ASSERT_EQ(a.question.has_value(), b.question.has_value()) << where;
            if (a.question) expectSameQuestion(*a.question, *b.question, where);
        }
    }
}

// Letters that the fonts were cut without would stand as a replacement sign on plates.
TEST(EmbeddedLessons, AreWrittenInLettersThatPlatesHave) {
    const auto same = [](const Glyph& a, const Glyph& b) {
        return a.face == b.face && a.index == b.index;
    };
    const Glyph missing = glyphOf(Face::serif, U'\uFFFD');
    for (const std::string& id : lessonIds())
        for (const char* language : kLanguages) {
            std::set<char32_t> letters;
            for (const std::string& text : textsOf(lessonIn(id, language)))
                for (const char32_t letter : lettersOf(text)) letters.insert(letter);
            for (const char32_t letter : letters)
                EXPECT_FALSE(same(glyphOf(Face::serif, letter), missing))
                    << id << "." << language << ": U+" << std::hex << static_cast<unsigned>(letter);
        }
}

}  // namespace
}  // namespace versorium
