// SPDX-License-Identifier: MIT
// What a learner does in a lesson, the links of teachers, and formulas in words.
#include "lesson/session.h"

#include <gtest/gtest.h>

#include "lesson/spoken.h"
#include "lesson/stage.h"
#include "lesson/teacher_link.h"

namespace versorium {
namespace {

const std::string kLesson =
    "---\ntitle: A test\nlevel: any\nminutes: 3\n---\n\n"
    "## One\n\nText.\n\n```scene\npreset: logistic\nviews: starts\nr: 2.8\n```\n\n"
    "```ask\nnumber: How much?\nanswer: 0.25\ntolerance: 0.01\nwhen answer > 1: Too much.\n"
    "right: Indeed.\n```\n\n"
    "```hint\nFirst.\n```\n\n```hint\nSecond.\n```\n\n```reveal\nIt is 1/4.\n```\n\n"
    "## Two\n\nMore.\n\n```controls\nr\nmarked step\n```\n\n```goal\nwhen: period == 2\n"
    "reach: A cycle of two.\nright: There.\n```\n\n```solution\nr: 3.2\n```\n\n"
    "## Three\n\nEnd.\n\n```ask\npoint: Where?\nanswer: 1, 2\ntolerance: 0.1\n"
    "within: x > 10\n- in the middle => 1, 2\n- far away => 5, 5\n```\n";

LessonSession session() {
    Expected<Lesson> lesson = parseLesson(kLesson, "test.en.md");
    EXPECT_TRUE(lesson) << lesson.status().message();
    return LessonSession(std::move(*lesson));
}

TEST(LessonSession, RevealsAfterAnAnswerAndGivesHintsAfterWrongOnes) {
    LessonSession one = session();
    EXPECT_FALSE(one.canReveal());
    one.reveal();
    EXPECT_FALSE(one.state().revealed) << "nothing is shown before an answer";
    const Expected<Judgement> wrong = one.commit("2");
    ASSERT_TRUE(wrong);
    EXPECT_FALSE(wrong->right);
    EXPECT_EQ(wrong->text, "Too much.");
    EXPECT_EQ(one.state().hints, 1);
    EXPECT_FALSE(one.state().revealed);
    EXPECT_FALSE(one.done(0));
    EXPECT_EQ(one.judgement().text, "Too much.");
    EXPECT_FALSE(one.commit("a lot")) << "that is no number";
    EXPECT_EQ(one.state().attempts, 1);
    EXPECT_EQ(one.state().answer, "2");
    ASSERT_TRUE(one.commit("0.251"));
    EXPECT_TRUE(one.state().right);
    EXPECT_TRUE(one.state().revealed);
    EXPECT_TRUE(one.done(0));
    EXPECT_FALSE(one.canHint());
}

TEST(LessonSession, NotesAGoalOnceItHolds) {
    LessonSession one = session();
    one.goTo(1);
    Workspace now = one.step().stage;
    EXPECT_FALSE(one.note(now));
    EXPECT_FALSE(one.done(1));
    EXPECT_TRUE(one.note(*one.step().solution));
    EXPECT_TRUE(one.done(1));
    EXPECT_FALSE(one.note(*one.step().solution)) << "it is said once";
    // Another map has no such number: that is no goal reached, and no error.
    LessonSession other = session();
    other.goTo(1);
    EXPECT_FALSE(other.note(workspaceOf(*presetNamed("mandelbrot"))));
}

TEST(LessonSession, PointsAreAnsweredInWordsInNumbersAndByARegion) {
    LessonSession one = session();
    one.goTo(2);
    const Question& question = *one.step().question;
    ASSERT_EQ(question.places.size(), 2u);
    EXPECT_EQ(spokenAnswer(question, "1, 2"), "in the middle (1, 2)");
    EXPECT_TRUE(judge(question, "1, 2")->right);
    EXPECT_TRUE(judge(question, "1.05, 2")->right);
    EXPECT_FALSE(judge(question, "5, 5")->right);
    EXPECT_TRUE(judge(question, "11, 0")->right);
    EXPECT_EQ(rightAnswer(question), "1, 2");
    // With decimal commas, where that is clear.
    EXPECT_TRUE(judge(question, "1,05; 2")->right);
    EXPECT_TRUE(judge(question, "1,2")->right) << "two numbers";
    EXPECT_TRUE(judge(*one.lesson().steps[0].question, "0,25")->right);
    EXPECT_EQ(answerNumbers("0,5"), std::vector<double>{0.5});
    EXPECT_EQ(answerNumbers("-0,5; 2"), (std::vector<double>{-0.5, 2}));
    EXPECT_TRUE(answerNumbers("0,5,2").size() == 3);
}

TEST(LessonSession, IsKeptAndResumed) {
    LessonSession one = session();
    ASSERT_TRUE(one.commit("2"));
    one.goTo(2);
    const Json kept = one.progress();
    LessonSession again = session();
    ASSERT_TRUE(again.resume(kept).ok());
    EXPECT_EQ(again.at(), 2u);
    EXPECT_EQ(again.state(0), one.state(0));
    // Of other lessons, and damaged, it is refused, and nothing changes.
    Json other = kept;
    other["lesson"] = "another";
    EXPECT_FALSE(session().resume(other).ok());
    other = kept;
    other["steps"].erase(0);
    EXPECT_FALSE(session().resume(other).ok());
    other = kept;
    other["steps"][0]["attempts"] = -1;
    EXPECT_FALSE(again.resume(other).ok());
    EXPECT_EQ(again.at(), 2u);
    again.beginAgain();
    EXPECT_EQ(again.stepsDone(), 0u);
    const std::string text = answersAsText(one);
    EXPECT_NE(text.find("How much?"), std::string::npos);
    EXPECT_EQ(one.answers()["steps"][0]["answer"], "2");
    EXPECT_EQ(one.answers()["steps"][1]["reached"], false);
}

TEST(TeacherLink, SaysWhatItLocksAndComesBack) {
    TeacherLink link;
    link.lesson = "1-orbits";
    link.step = 2;
    link.language = "es";
    link.theme = "projector";
    link.rest = Access::locked;
    link.named = {{"marked step", Access::open}, {"r", Access::open}, {"height", Access::hidden}};
    const Expected<std::string> text = teacherLinkText(link);
    ASSERT_TRUE(text);
    EXPECT_EQ(*text,
              "lesson=1-orbits&step=3&language=es&theme=projector&rest=locked&open=marked%20step,r&"
              "hidden=height");
    EXPECT_TRUE(isTeacherLink(*text));
    const Expected<TeacherLink> again = parseTeacherLink(*text);
    ASSERT_TRUE(again) << again.status().message();
    EXPECT_EQ(again->named, link.named);
    EXPECT_EQ(again->rest, Access::locked);
    EXPECT_EQ(again->step, 2);
    EXPECT_TRUE(again->restricts());

    EXPECT_FALSE(parseTeacherLink("lesson=1-orbits")->step) << "where the learner left it";
    EXPECT_FALSE(parseTeacherLink(lessonLink("1-orbits", 3))->stays());
    EXPECT_EQ(parseTeacherLink(lessonLink("1-orbits", 3))->step, 3);

    TeacherLink view;
    view.view = workspaceOf(*presetNamed("julia"));
    const Expected<std::string> shown = teacherLinkText(view);
    ASSERT_TRUE(shown);
    const Expected<TeacherLink> read = parseTeacherLink(*shown);
    ASSERT_TRUE(read && read->view);
    EXPECT_EQ(workspaceToJson(*read->view), workspaceToJson(*view.view));
    EXPECT_FALSE(read->restricts());

    EXPECT_FALSE(isTeacherLink("v1:abc"));
    EXPECT_FALSE(isTeacherLink(""));
    EXPECT_FALSE(parseTeacherLink("lesson=nothing"));
    EXPECT_FALSE(parseTeacherLink("step=0"));
    EXPECT_FALSE(parseTeacherLink("step=99999999999999999999"));
    EXPECT_FALSE(parseTeacherLink("rest=shut"));
    EXPECT_FALSE(parseTeacherLink("rest=step"));
    EXPECT_FALSE(parseTeacherLink("view=v1:%"));
    EXPECT_FALSE(parseTeacherLink("lesson=1-orbits&nonsense=1"));
    EXPECT_FALSE(parseTeacherLink("lesson"));
}

TEST(TeacherLink, AnIframeKeepsQuotesApart) {
    const std::string frame = iframeOf("https://a.b/#lesson=x&step=2", "\"A\" <b>");
    EXPECT_NE(frame.find("src=\"https://a.b/#lesson=x&amp;step=2\""), std::string::npos);
    EXPECT_NE(frame.find("title=\"&quot;A&quot; &lt;b>\""), std::string::npos);
}

TEST(SpokenFormula, IsInWords) {
    EXPECT_EQ(spokenFormula("z² + c", "en"), "z squared plus c");
    EXPECT_EQ(spokenFormula("z → z² + c", "es"), "z va a z al cuadrado más c");
    EXPECT_EQ(spokenFormula("|z| > 2", "en"), "the modulus of z is greater than 2");
    EXPECT_EQ(spokenFormula("f(x)", "en"), "f of x");
    EXPECT_EQ(spokenFormula("r·x·(1 − x)", "en"),
              "r times x times open parenthesis 1 minus x close parenthesis");
}

TEST(SpokenFormula, IsFoundWithinProse) {
    const auto parts = spokenParts("Apply x → r·x, then look. For r = 2.8 it rests.", "en");
    ASSERT_EQ(parts.size(), 5u);
    EXPECT_EQ(parts[0].text, "Apply ");
    EXPECT_EQ(parts[1].text, "x → r·x");
    EXPECT_EQ(parts[1].spoken, "x goes to r times x");
    EXPECT_EQ(parts[2].text, ", then look. For ");
    EXPECT_EQ(parts[3].spoken, "r equals 2.8");
    EXPECT_EQ(parts[4].text, " it rests.");
    std::string whole;
    for (const SpokenPart& part : parts) whole += part.text;
    EXPECT_EQ(whole, "Apply x → r·x, then look. For r = 2.8 it rests.");
    // Words alone are none.
    EXPECT_EQ(spokenParts("A cycle of period 3.", "en").size(), 1u);
}

}  // namespace
}  // namespace versorium
