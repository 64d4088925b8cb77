// SPDX-License-Identifier: MIT
// Lessons in the studio: steps, what a learner may change, and what a teacher's link locks.
#include "ui/session/lessons.h"
#include "ui/controls/commands.h"
#include "ui/dialogs/dialogs.h"
#include "ui/lesson/lesson_pane.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "headless_gui.h"
#include "ui/controls/access.h"
#include "ui/controls/controls.h"
#include "ui/session/open_file.h"
#include "ui/session/values.h"
#include "ui/studio.h"

namespace versorium {
namespace {

const std::string kFirst = "1-orbits";

std::string valueOf(StudioContext& context, const std::string& id) {
    for (const Control& control : controlsOf(context))
        if (control.id == id) return control.value;
    return "none";
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

// Goes to the first step that has a question, or a goal.
template <class T>
void goToFirst(StudioContext& context, std::optional<T> LessonStep::*task) {
    const std::vector<LessonStep>& steps = context.lessons.now->session.lesson().steps;
    const auto found = std::find_if(steps.begin(), steps.end(), [&](const LessonStep& step) {
        return (step.*task).has_value();
    });
    ASSERT_NE(found, steps.end());
    goToStep(context, static_cast<std::size_t>(found - steps.begin()));
}

// A lesson may name no control that the studio does not have in that step.
TEST(EveryLesson, NamesControlsThatThereAre) {
    for (const std::string& id : lessonIds())
        for (const char* language : {"en", "es"}) {
            const Expected<Lesson> lesson = lessonNamed(id, language);
            ASSERT_TRUE(lesson) << lesson.status().message();
            for (const LessonStep& step : lesson->steps) {
                SilentHost host;
                HeadlessGui gui;
                StudioContext context(host);
                context.openStage(step.stage);
                const std::vector<Control> controls = controlsOf(context);
                const MapInfo& info = mapOf(context.workspace.views[0]).info;
                for (const std::string& name : step.controls)
                    EXPECT_TRUE(std::any_of(controls.begin(), controls.end(),
                                            [&](const Control& control) {
                                                return namesControl(info, name, control.id);
                                            }))
                        << id << "." << language << ", line " << step.line
                        << ": there is no control \"" << name << "\"";
            }
        }
}

TEST(Lessons, AreDrawnInThePaneStepByStep) {
    SilentHost host;
    HeadlessGui gui({340, 900});
    StudioContext context(host);
    const auto pane = [&] { drawLessonPane(context); };
    context.lessons.open = true;
    for (int k = 0; k < 3; ++k) gui.frame(pane);
    ASSERT_EQ(lessonList(context).size(), lessonIds().size());
    // What the list reads by itself is what the lesson says.
    for (const LessonEntry& entry : lessonList(context)) {
        const Expected<Lesson> lesson = lessonNamed(entry.id, "en");
        ASSERT_TRUE(lesson);
        EXPECT_EQ(entry.head.title, lesson->title);
        EXPECT_EQ(entry.head.level, lesson->level);
        EXPECT_EQ(entry.head.minutes, lesson->minutes);
        EXPECT_EQ(entry.head.steps, lesson->steps.size());
        EXPECT_EQ(entry.done, 0u);
    }
    for (const std::string& id : lessonIds()) {
        ASSERT_TRUE(openLesson(context, id, 0).ok());
        for (std::size_t k = 0; k < context.lessons.now->left.size(); ++k) {
            goToStep(context, k);
            for (int frame = 0; frame < 2; ++frame) gui.frame(pane);
            EXPECT_EQ(context.lessons.now->session.at(), k);
        }
    }
}

TEST(Lessons, TheLearnerWandersAndComesBackAndResetIsTheTeachers) {
    SilentHost host;
    HeadlessGui gui;
    StudioContext context(host);
    ASSERT_TRUE(openLesson(context, kFirst, 0).ok());
    const Json teachers = workspaceToJson(context.workspace);
    ASSERT_TRUE(setControl(context, "r", "3.5"));
    const Json learners = workspaceToJson(context.workspace);
    EXPECT_TRUE(stepNamesControls(context));
    EXPECT_TRUE(isOpenInStep(context, "r"));
    EXPECT_FALSE(isOpenInStep(context, "iterations"));
    context.newMap("quadratic");
    EXPECT_TRUE(context.lessons.now->wandering());
    EXPECT_TRUE(isOpenInStep(context, "iterations"));
    backToStep(context);
    EXPECT_EQ(workspaceToJson(context.workspace), learners);
    resetStep(context);
    EXPECT_EQ(workspaceToJson(context.workspace), teachers);
    // Undo brings back what reset took.
    context.record();
    context.undo();
    EXPECT_EQ(workspaceToJson(context.workspace), learners);
    // Another step, and back: as the learner left it.
    goToStep(context, 1);
    goToStep(context, 0);
    EXPECT_EQ(workspaceToJson(context.workspace), learners);
}

TEST(Lessons, AreKeptFromOneStartToTheNext) {
    SilentHost host;
    HeadlessGui gui;
    {
        StudioContext context(host);
        ASSERT_TRUE(openLesson(context, kFirst, {}).ok());
        goToFirst(context, &LessonStep::question);
        commitAnswer(context, "nonsense");
        EXPECT_FALSE(context.lessons.now->problem.empty());
        commitAnswer(context, rightAnswer(*context.lessons.now->session.step().question));
        EXPECT_TRUE(context.lessons.now->session.state().right);
        EXPECT_TRUE(lessonDo(context, "answers", "json"));
        EXPECT_FALSE(lessonDo(context, "dance", ""));
    }
    StudioContext later(host);
    ASSERT_TRUE(openLesson(later, kFirst, {}).ok());
    EXPECT_TRUE(later.lessons.now->session.state().right);
    closeLesson(later);
    EXPECT_GE(lessonList(later)[0].done, 1u);
    later.host.store("lesson-1-orbits", "{broken");
    ASSERT_TRUE(openLesson(later, kFirst, {}).ok()) << "what is kept may be damaged";
}

TEST(Lessons, AGoalLightsUpTheMomentTheStateSatisfiesIt) {
    SilentHost host;
    HeadlessGui gui;
    StudioContext context(host);
    ASSERT_TRUE(openLesson(context, kFirst, {}).ok());
    goToFirst(context, &LessonStep::goal);
    host.time += 1;
    noteGoal(context);
    EXPECT_FALSE(context.lessons.now->session.state().reached);
    context.edit([&](Workspace& w) { w = *context.lessons.now->session.step().solution; });
    host.time += 1;
    noteGoal(context);
    EXPECT_TRUE(context.lessons.now->session.state().reached);
    EXPECT_TRUE(contains(context.notices.last(), "Goal reached"));
}

TEST(Lessons, ForeignOnesOpenAsFilesAndFaultsNameTheirLine) {
    SilentHost host;
    HeadlessGui gui;
    StudioContext context(host);
    const std::string good = "---\ntitle: Mine\nlevel: any\nminutes: 5\n---\n\n## One\n\nText.\n";
    const auto open = [&](const std::string& text) {
        return openBytes(context, "mine.en.md",
                         {reinterpret_cast<const unsigned char*>(text.data()), text.size()});
    };
    ASSERT_TRUE(open(good).ok());
    EXPECT_EQ(context.lessons.now->session.lesson().title, "Mine");
    const Status bad = open(good + "\n```scene\nnonsense: 1\n```\n");
    EXPECT_TRUE(contains(bad.message(), "line 12")) << bad.message();
    EXPECT_EQ(context.lessons.now->session.lesson().title, "Mine") << "nothing is lost";
}

TEST(TeacherLink, LocksWhateverHandWouldChange) {
    SilentHost host;
    HeadlessGui gui;
    Studio studio(host);
    StudioContext context(host);
    const Expected<TeacherLink> link = parseTeacherLink(
        "lesson=1-orbits&step=1&rest=hidden&open=r&locked=iterations&theme=projector");
    ASSERT_TRUE(link);
    ASSERT_TRUE(followTeacherLink(context, *link).ok());
    EXPECT_EQ(themes()[context.theme].name, "projector");
    const Json teachers = workspaceToJson(context.workspace);
    EXPECT_EQ(valueOf(context, "samples"), "none") << "hidden";
    EXPECT_FALSE(setControl(context, "iterations", "7"));
    EXPECT_FALSE(setControl(context, "map", "x"));
    // By any other way: it is taken back.
    context.edit([&](Workspace& w) { w.views[0].iterations = 7; });
    keepLocks(context);
    EXPECT_EQ(workspaceToJson(context.workspace), teachers);
    context.newMap("quadratic");
    keepLocks(context);
    EXPECT_EQ(workspaceToJson(context.workspace), teachers);
    EXPECT_TRUE(contains(context.notices.last(), "locked"));
    // What is open is the learner's.
    ASSERT_TRUE(setControl(context, "r", "3.3"));
    keepLocks(context);
    EXPECT_EQ(valueOf(context, "r"), "3.3");
    resetStep(context);
    keepLocks(context);
    EXPECT_EQ(workspaceToJson(context.workspace), teachers);
    EXPECT_FALSE(openText(context, "v1:abc").ok());
    for (const Command& command : commandsOf(context)) EXPECT_TRUE(command.harmless);
}

TEST(TeacherLink, IsMadeInItsDialog) {
    class Online : public SilentHost {
        std::string publicAddress() const override { return "https://example.org/v/"; }
    };
    Online host;
    HeadlessGui gui;
    StudioContext context(host);
    ASSERT_TRUE(openLesson(context, kFirst, 1).ok());
    context.dialogs.teacher = true;
    context.panels.of<TeacherDialog>().link.byStep = true;
    context.panels.of<TeacherDialog>().link.rest = Access::hidden;
    for (int k = 0; k < 3; ++k) gui.frame([&] { drawDialogs(context); });
    copyTeacherLink(context, false);
    EXPECT_EQ(host.copied, "https://example.org/v/#lesson=1-orbits&step=2&rest=step");
    copyTeacherLink(context, true);
    EXPECT_TRUE(contains(host.copied, "<iframe src=\"https://example.org/v/#lesson=1-orbits&amp;"));
}

TEST(Lessons, TellAPageWhatTheyShow) {
    SilentHost host;
    HeadlessGui gui;
    StudioContext context(host);
    EXPECT_EQ(parseJson(lessonText(context))->at("open"), false);
    ASSERT_TRUE(lessonDo(context, "list", ""));
    EXPECT_EQ(parseJson(lessonText(context))->at("lessons").size(), lessonIds().size());
    ASSERT_TRUE(lessonDo(context, "open", kFirst));
    Json state = *parseJson(lessonText(context));
    EXPECT_EQ(state["lesson"]["at"], 0);
    EXPECT_FALSE(state["step"]["prose"].empty());
    EXPECT_FALSE(state["step"].contains("reveal"));
    ASSERT_TRUE(lessonDo(context, "next", ""));
    EXPECT_EQ(parseJson(lessonText(context))->at("lesson")["at"], 1);
    ASSERT_TRUE(lessonDo(context, "all", ""));
    ASSERT_TRUE(lessonDo(context, "close", ""));
    EXPECT_EQ(parseJson(lessonText(context))->at("open"), false);
}

}  // namespace
}  // namespace versorium
