// SPDX-License-Identifier: MIT
#include "lesson/lesson.h"

#include <gtest/gtest.h>

#include <cmath>

#include "lesson/lesson_plate.h"
#include "lesson/observables.h"
#include "lesson/stage.h"
#include "render/cpu/cpu_renderer.h"

namespace versorium {
namespace {

const std::string kFront = "---\ntitle: A test\nlevel: any\nminutes: 3\n---\n\n";

std::string faultOf(const std::string& body) {
    const Expected<Lesson> lesson = parseLesson(kFront + body, "test.en.md");
    return lesson ? "" : lesson.status().message();
}
bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

Workspace julia() { return workspaceOf(*presetNamed("julia")); }

Expected<Workspace> after(const std::string& lines) {
    const Expected<std::vector<StageLine>> read = readLines(lines, 1);
    return read ? changed(julia(), *read) : Expected<Workspace>(read.status());
}

TEST(EveryLesson, IsWithoutFaultsAndIsDrawn) {
    ASSERT_FALSE(lessonIds().empty());
    for (const std::string& id : lessonIds()) {
        const Expected<Lesson> lesson = lessonNamed(id, "en");
        ASSERT_TRUE(lesson) << id << ": " << lesson.status().message();
        for (const std::string& fault : faultsOf(*lesson)) ADD_FAILURE() << id << ": " << fault;
#ifdef __EMSCRIPTEN__
        continue;  // the native test draws them; the bits are compared elsewhere
#endif
        CpuRenderer renderer;
        for (std::size_t k = 0; k < lesson->steps.size(); ++k) {
            PlateDocument plate = plateOfStep(*lesson, k);
            // A thousand maps are as many as fifty to the layout.
            for (PlatePanel& panel : plate.plate.panels)
                if (panel.scene.ensemble.varies()) panel.scene.ensemble.count = 50;
            plate.options.widthMillimetres = 89;
            plate.options.dotsPerInch = 72;
            Job job;
            const Expected<PlateFile> file = renderPlate(renderer, plate, job);
            EXPECT_TRUE(file) << id << ", step " << k + 1 << ": " << file.status().message();
        }
    }
}

// Whatever language the process speaks.
TEST(EveryLesson, HasPlatesInItsOwnLanguage) {
    const Expected<Lesson> lesson = lessonNamed("1-orbits", "es");
    ASSERT_TRUE(lesson) << lesson.status().message();
    CpuRenderer renderer;
    std::string all;
    for (std::size_t k = 0; k < lesson->steps.size(); ++k) {
        PlateDocument plate = plateOfStep(*lesson, k);
        EXPECT_EQ(plate.plate.language, "es");
        EXPECT_TRUE(contains(plate.plate.caption, "\\par ")) << "paragraphs stand apart";
        plate.options.widthMillimetres = 60;
        plate.options.dotsPerInch = 50;
        Job job;
        const Expected<PlateFile> file = renderPlate(renderer, plate, job);
        ASSERT_TRUE(file) << file.status().message();
        all += file->text;
    }
    for (const char* said :
         {"Parámetros", "Puntos de partida", "iteraciones", "órbita", "altura 3,2"})
        EXPECT_TRUE(contains(all, said)) << said;
    for (const char* english : {"Starting points", "iterations", "orbit,", "coloured", "panels"})
        EXPECT_FALSE(contains(all, english)) << english;
}

TEST(Lesson, SaysInWhichLineAFaultLies) {
    // Five lines of front matter and a blank one stand before the first step.
    EXPECT_EQ(faultOf("## One\n\nText.\n"), "");
    EXPECT_TRUE(contains(faultOf("## One\n\nText.\n\n```scene\nnonsense: 3\n```\n"), "line 12"));
    EXPECT_TRUE(contains(faultOf("## One\n\nText.\n\n```quiz\n```\n"), "```quiz is none of"));
    EXPECT_TRUE(contains(faultOf("## One\n\n```goal\nwhen: prettiness > 3\nreach: x\n```\n"),
                         "no number named \"prettiness\""));
    EXPECT_TRUE(contains(faultOf("## One\n\n![a](b)\n"), "images are not part of lessons"));
    EXPECT_TRUE(contains(faultOf("## One\n\n[a](https://a.b)\n"), "links are not part"));
    EXPECT_TRUE(contains(faultOf("Text before.\n"), "before the first step"));
    EXPECT_TRUE(contains(faultOf("## One\n"), "has no text"));
    EXPECT_FALSE(parseLesson("# No front\n", "a.en.md"));
    EXPECT_FALSE(parseLesson("", "a.en.md"));
    EXPECT_FALSE(parseLesson("---\n---\n", "a.en.md"));
}

TEST(Lesson, LineEndsAndAByteOrderMarkDoNotMatter) {
    const std::string body = "## One\n\nSome *prose*.\n\nMore.\n\n## Two\n\nText.\n";
    const Expected<Lesson> plain = parseLesson(kFront + body, "test.en.md");
    ASSERT_TRUE(plain) << plain.status().message();
    for (const std::string end : {"\r", "\r\n"}) {
        std::string text = "\xef\xbb\xbf";
        for (const char c : kFront + body) text += c == '\n' ? end : std::string(1, c);
        const Expected<Lesson> lesson = parseLesson(text, "test.en.md");
        ASSERT_TRUE(lesson) << lesson.status().message();
        EXPECT_EQ(lesson->title, plain->title);
        ASSERT_EQ(lesson->steps.size(), 2u);
        EXPECT_EQ(lesson->steps[0].prose.size(), plain->steps[0].prose.size());
        EXPECT_EQ(parseLessonHead(text, "test.en.md")->steps, 2u);
    }
}

TEST(Lesson, HtmlStaysText) {
    const Expected<Lesson> lesson = parseLesson(kFront + "## One\n\n<b>bold</b>\n", "t.en.md");
    ASSERT_TRUE(lesson) << lesson.status().message();
    EXPECT_EQ(plainText(lesson->steps[0].prose), "<b>bold</b>");
}

TEST(Lesson, IsFoundByItsFilesName) {
    const Expected<Lesson> lesson = parseLesson(kFront + "## One\n\nText.\n", "a/b/bulbs.es.md");
    ASSERT_TRUE(lesson);
    EXPECT_EQ(lesson->id, "bulbs");
    EXPECT_EQ(lesson->language, "es");
}

TEST(Lesson, TellsAGoalThatItsSolutionMissesOrThatHoldsAtOnce) {
    const std::string step = "## One\n\nText.\n\n```scene\npreset: logistic\nr: 2.8\n```\n\n";
    const auto faults = [&](const std::string& rest) {
        const Expected<Lesson> lesson = parseLesson(kFront + step + rest, "t.en.md");
        return lesson ? faultsOf(*lesson) : std::vector<std::string>{lesson.status().message()};
    };
    const std::string goal = "```goal\nwhen: period == 2\nreach: Two.\n```\n\n";
    EXPECT_TRUE(faults(goal + "```solution\nr: 3.2\n```\n").empty());
    EXPECT_EQ(faults(goal + "```solution\nr: 2.9\n```\n").size(), 1u);
    EXPECT_EQ(faults(goal).size(), 1u);
    EXPECT_EQ(faults("```goal\nwhen: r < 3\nreach: x\n```\n\n```solution\nr: 2\n```\n").size(), 1u);
}

TEST(Stage, ChangesWhatItNamesInAllViewsOrInOne) {
    Expected<Workspace> state = after(
        "c: -0.5 + 0.25i\npoint: 0.5, -1\niterations: 77\n"
        "right.slice.height: 0.5\norbit_steps: 9\n");
    ASSERT_TRUE(state) << state.status().message();
    ASSERT_EQ(state->views.size(), 2u);
    for (const Scene& view : state->views) {
        EXPECT_EQ(view.parameters.at("c"), (std::vector<double>{-0.5, 0.25}));
        EXPECT_EQ(view.iterations, 77);
    }
    EXPECT_EQ(state->point, (std::vector<double>{0.5, -1}));
    EXPECT_EQ(state->views[1].slice.height, 0.5);
    EXPECT_NE(state->views[0].slice.height, 0.5);
    EXPECT_EQ(state->orbitSteps, 9);
    state = after("c.im: 0.125");
    ASSERT_TRUE(state);
    EXPECT_EQ(sharedNumber(*state, "c.im"), 0.125);
    state = after("views: starts");
    ASSERT_TRUE(state);
    EXPECT_EQ(state->views.size(), 1u);
    EXPECT_EQ(viewKind(state->views[0]), ViewKind::startingPoints);
}

// As --set does: a value by its path, also a part of a list, or a member of what has no table.
TEST(Stage, TakesEveryValueByItsPath) {
    Expected<Workspace> state = after(
        "right.slice.center[0]: 0.3\ncolour.escaped.exponent: 2\nstudy.cycles: true\n"
        "study: {\"most_period\": 5}");
    ASSERT_TRUE(state) << state.status().message();
    EXPECT_EQ(state->views[1].slice.centre[0], 0.3);
    EXPECT_EQ(state->views[0].colour.escaped.exponent, 2);
    EXPECT_TRUE(state->study.cycles);
    EXPECT_EQ(state->study.mostPeriod, 5);
    state = after("map: complex-rational\nlists.roots.scale: 2\nlists.poles.scale: 3\nroots: 1 0");
    ASSERT_TRUE(state) << state.status().message();
    for (const Scene& view : state->views) {
        EXPECT_EQ(view.lists.at("roots").scale, 2);
        EXPECT_EQ(view.lists.at("poles").scale, 3);
        ASSERT_EQ(view.lists.at("roots").roots.size(), 1u);
        EXPECT_EQ(view.lists.at("roots").roots[0].q[0], 1);
    }
}

TEST(Stage, AnswersAnUnknownKeyWithTheNearestOnes) {
    for (const char* line : {"colour.pallete: dusk", "right.colour.pallete: dusk"})
        EXPECT_TRUE(contains(after(line).status().message(), "did you mean colour.palette"))
            << line;
    EXPECT_TRUE(contains(after("zzzzzzzzzzzz: 1").status().message(), "has no such key"));
    EXPECT_TRUE(contains(after("orbit_steps: 3\norbit_at: 4").status().message(), "orbit_at"));
}

TEST(Stage, RefusesWhatItCannotDo) {
    for (const char* lines :
         {"c: red", "c: 1, 2, 3", "point: 1, 2, 3", "iterations: -1", "views: 3", "preset: none",
          "circle: 1, 2, -3", "roots: 1 0", "view9.iterations: 3", "colour.palette: nowhere",
          "no colon", "pin: later"})
        EXPECT_FALSE(after(lines)) << lines;
}

TEST(Stage, ReadsNumbersAsPeopleWriteThem) {
    using V = std::vector<double>;
    EXPECT_EQ(numbersOf("3"), V{3});
    EXPECT_EQ(numbersOf("-0.12 + 0.74i"), (V{-0.12, 0.74}));
    EXPECT_EQ(numbersOf("-i"), (V{0, -1}));
    EXPECT_EQ(numbersOf("(1, -2.5)"), (V{1, -2.5}));
    for (const char* text : {"", "a", "1 2", "1 + 2", "i + i", "1,", "1, i", "inf"})
        EXPECT_TRUE(numbersOf(text).empty()) << text;
}

TEST(Condition, IsAFormulaOverWhatIsKnown) {
    const auto known = [](const std::string& name) { return name == "a" || name == "c.im"; };
    const auto value = [](const std::string& name) { return name == "a" ? 3.0 : -0.5; };
    const auto is = [&](const std::string& text) {
        const Expected<Condition> condition = parseCondition(text, known);
        EXPECT_TRUE(condition) << condition.status().message();
        return condition && holds(*condition, value);
    };
    EXPECT_TRUE(is("a == 3"));
    EXPECT_TRUE(is("a > 2 and c.im < 0"));
    EXPECT_FALSE(is("a > 2 and not c.im < 0"));
    EXPECT_TRUE(is("abs(c.im) > 1e-1 && a^2 == 9"));
    EXPECT_TRUE(is("2a == 6 and 3(1 + c.im) == 1.5"));
    for (const char* text : {"", "a", "a >", "b > 2", "a > 2 a", "a = 3", "a == 3aehr", "b (2) > 1",
                             "v0 (a) > 1", "a > β", "aβ > 1", "2ea > 1"})
        EXPECT_FALSE(parseCondition(text, known)) << text;
    const Expected<Condition> unknown = parseCondition("a < 5", known);
    EXPECT_FALSE(holds(*unknown, [](const std::string&) { return std::nan(""); }));
}

TEST(Observable, MeasuresTheOrbitOfTheStartAndOfTheCriticalPoint) {
    Workspace state = *after("c: -0.122561 + 0.744862i\npoint: 3, 0");
    EXPECT_EQ(observe(state, "critical_period"), 3);
    EXPECT_EQ(observe(state, "critical_escapes"), 0);
    EXPECT_EQ(observe(state, "escapes"), 1);
    EXPECT_EQ(observe(state, "c.im"), 0.744862);
    state = *after("c: -1\npoint: 0.1, 0\npin: now");
    EXPECT_EQ(observe(state, "period"), 2);
    EXPECT_EQ(observe(state, "pins"), 1);
    setSharedNumber(state, "c.im", 0.5);
    EXPECT_EQ(observe(state, "pin_distance"), 0.5);
    // c = 0: the unit disc, in a square of side 3.
    state = *after("c: 0\nright.slice.height: 3");
    EXPECT_NEAR(observe(state, "share"), 3.14159 / 9, 0.01);
    EXPECT_FALSE(isObservable(state, "prettiness"));
}

TEST(Question, JudgesAndSaysWhatAnAnswerWouldHaveMeant) {
    const std::string body =
        "## One\n\nText.\n\n```ask\nnumber: How many?\nanswer: 3\ntolerance: 0.5\n"
        "when answer < 3: Too few.\nright: Three.\n```\n"
        "## Two\n\nText.\n\n```ask\nchoice: Which?\n- This. => Not this.\n+ That.\n```\n"
        "## Three\n\nText.\n\n```ask\npoint: Where?\nanswer: 1, 2\ntolerance: 0.25\n"
        "when x > 5 and y < 0: Far away.\n```\n";
    const Expected<Lesson> lesson = parseLesson(kFront + body, "t.en.md");
    ASSERT_TRUE(lesson) << lesson.status().message();
    const auto said = [&](std::size_t step, const std::string& answer) {
        const Expected<Judgement> result = judge(*lesson->steps[step].question, answer);
        return result ? (result->right ? "right: " : "wrong: ") + result->text : "none";
    };
    EXPECT_EQ(said(0, "3.5"), "right: Three.");
    EXPECT_EQ(said(0, "2"), "wrong: Too few.");
    EXPECT_EQ(said(0, "4"), "wrong: ");
    EXPECT_EQ(said(0, "many"), "none");
    EXPECT_EQ(said(1, "1"), "wrong: Not this.");
    EXPECT_EQ(said(1, "2"), "right: ");
    EXPECT_EQ(said(1, "3"), "none");
    EXPECT_EQ(said(2, "1.1, 1.9"), "right: ");
    EXPECT_EQ(said(2, "9, -1"), "wrong: Far away.");
    EXPECT_EQ(said(2, "9"), "none");
}

}  // namespace
}  // namespace versorium
