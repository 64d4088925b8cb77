// SPDX-License-Identifier: MIT
#include "ui/session/lessons.h"

#include <algorithm>
#include <cctype>

#include "lesson/lesson_plate.h"
#include "lesson/stage.h"
#include "ui/session/context.h"
#include "ui/session/values.h"

namespace versorium {
namespace {

constexpr double kNoteEvery = 0.2;  // seconds

// Under which progress is kept: what may name a file.
std::string keptAs(const std::string& id, bool own) {
    std::string name = own ? "lesson-" : "lesson-file-";
    for (const char c : id) name += std::isalnum(static_cast<unsigned char>(c)) ? c : '-';
    return name;
}

std::string keptAs(const OpenLesson& lesson) {
    return keptAs(lesson.session.lesson().id, lesson.own);
}

void keep(StudioContext& context) {
    const OpenLesson& lesson = *context.lessons.now;
    context.host.store(keptAs(lesson), lesson.session.progress().dump());
    context.lessons.list.clear();
    context.host.wake();
}

void resume(StudioContext& context, OpenLesson& lesson) {
    const std::string stored = context.host.stored(keptAs(lesson));
    if (stored.empty()) return;
    const Expected<Json> json = parseJson(stored);
    // What cannot be read any more is as good as none: the lesson begins anew.
    if (json) (void)lesson.session.resume(*json);
}

void showState(StudioContext& context, Workspace state) {
    OpenLesson& lesson = *context.lessons.now;
    lesson.waiting.reset();
    lesson.revealShown = false;
    context.openStage(std::move(state));
}

// The learner's state of this step, as it is now, to come back to.
void keepState(StudioContext& context) {
    OpenLesson& lesson = *context.lessons.now;
    lesson.left[lesson.session.at()] = lesson.waiting ? *lesson.waiting : context.workspace;
}

void enter(StudioContext& context) {
    OpenLesson& lesson = *context.lessons.now;
    lesson.typed = lesson.session.state().answer;
    lesson.problem.clear();
    const auto& left = lesson.left[lesson.session.at()];
    showState(context, left ? *left : lesson.session.step().stage);
    keep(context);
    context.host.announce(tr("Step {1} of {2}: {3}",
                             {std::to_string(lesson.session.at() + 1),
                              std::to_string(lesson.left.size()), lesson.session.step().title}));
}

void begin(StudioContext& context, Lesson read, bool own, std::optional<std::size_t> step) {
    if (context.lessons.now) closeLesson(context);
    OpenLesson lesson(std::move(read));
    lesson.own = own;
    resume(context, lesson);
    if (step) lesson.session.goTo(*step);
    context.lessons.now = std::move(lesson);
    context.lessons.open = true;
    enter(context);
}

}  // namespace

const std::vector<LessonEntry>& lessonList(StudioContext& context) {
    std::vector<LessonEntry>& list = context.lessons.list;
    if (!list.empty() && context.lessons.listLanguage == languageNow().id) return list;
    list.clear();
    context.lessons.listLanguage = languageNow().id;
    for (const std::string& id : lessonIds()) {
        Expected<LessonHead> head = lessonHead(id, languageNow().id);
        if (!head) continue;
        LessonEntry entry{id, std::move(*head)};
        const Expected<Json> progress = parseJson(context.host.stored(keptAs(id, true)));
        if (progress && progress->is_object() && progress->contains("done") &&
            progress->at("done").is_number_unsigned())
            entry.done = std::min(progress->at("done").get<std::size_t>(), entry.head.steps);
        list.push_back(std::move(entry));
    }
    return list;
}

Status openLesson(StudioContext& context, const std::string& id, std::optional<std::size_t> step) {
    Expected<Lesson> lesson = lessonNamed(id, languageNow().id);
    if (!lesson) return lesson.status();
    begin(context, std::move(*lesson), true, step);
    return {};
}

Status openLessonFile(StudioContext& context, const std::string& name, const std::string& text) {
    Expected<Lesson> lesson = parseLesson(text, name);
    if (!lesson) return lesson.status();
    begin(context, std::move(*lesson), false, {});
    return {};
}

void closeLesson(StudioContext& context) {
    if (context.lessons.now) keep(context);
    context.lessons.now.reset();
    context.host.wake();
}

void translateLesson(StudioContext& context) {
    if (!context.lessons.now || !context.lessons.now->own) return;
    OpenLesson& lesson = *context.lessons.now;
    if (lesson.session.lesson().language == languageNow().id) return;
    Expected<Lesson> other = lessonNamed(lesson.session.lesson().id, languageNow().id);
    if (other) lesson.session.translate(std::move(*other));
}

void leaveStep(StudioContext& context) {
    if (!context.lessons.now || context.lessons.now->wandering()) return;
    context.lessons.now->waiting = context.workspace;
    context.host.wake();
}

void backToStep(StudioContext& context) {
    if (!context.lessons.now || !context.lessons.now->wandering()) return;
    showState(context, Workspace(*context.lessons.now->waiting));
}

void goToStep(StudioContext& context, std::size_t step) {
    if (!context.lessons.now || step >= context.lessons.now->left.size()) return;
    keepState(context);
    context.lessons.now->session.goTo(step);
    enter(context);
}

void resetStep(StudioContext& context) {
    if (!context.lessons.now && context.teacher && context.teacher->view) {
        context.openStage(*context.teacher->view);
        return context.say("The view is as the teacher set it up");
    }
    if (!context.lessons.now) return;
    showState(context, context.lessons.now->session.step().stage);
    context.say("The step is as the teacher set it up");
}

void beginLessonAgain(StudioContext& context) {
    if (!context.lessons.now) return;
    OpenLesson& lesson = *context.lessons.now;
    lesson.session.beginAgain();
    lesson.left.assign(lesson.left.size(), {});
    enter(context);
}

namespace {

// Why an answer is none.
const char* wantedOf(const Question& question) {
    if (question.kind == AnswerKind::choice) return trLater("Choose one of the answers.");
    return question.kind == AnswerKind::number ? trLater("Give a number, such as 0.5.")
                                               : trLater("Give two numbers, such as -0.5, 0.25.");
}

}  // namespace

void commitAnswer(StudioContext& context, const std::string& answer) {
    if (!context.lessons.now || !context.lessons.now->session.step().question) return;
    OpenLesson& lesson = *context.lessons.now;
    const Expected<Judgement> judged = lesson.session.commit(answer);
    lesson.problem = judged ? "" : wantedOf(*lesson.session.step().question);
    if (!judged) {
        context.host.announce(tr(lesson.problem.c_str()));
        return context.host.wake();
    }
    lesson.typed = answer;
    keep(context);
    context.host.announce(std::string(judged->right ? tr("Right.") : tr("Not yet.")) + " " +
                          judged->text);
}

void showHint(StudioContext& context) {
    if (!context.lessons.now || !context.lessons.now->session.canHint()) return;
    context.lessons.now->session.hint();
    keep(context);
}

void showAnswer(StudioContext& context) {
    if (!context.lessons.now || !context.lessons.now->session.canReveal()) return;
    context.lessons.now->session.reveal();
    keep(context);
}

void toggleReveal(StudioContext& context) {
    if (!context.lessons.now) return;
    OpenLesson& lesson = *context.lessons.now;
    if (lesson.revealShown) return backToStep(context);
    if (!lesson.session.step().revealStage || !lesson.session.state().revealed) return;
    leaveStep(context);
    context.openStage(*lesson.session.step().revealStage);
    lesson.revealShown = true;
}

std::string ringAnswer(StudioContext& context) {
    if (!context.lessons.now || !context.lessons.now->session.step().question) return {};
    const OpenLesson& lesson = *context.lessons.now;
    const auto view = std::min(static_cast<std::size_t>(lesson.session.step().question->view),
                               context.workspace.views.size() - 1);
    const auto marker = markerOf(context.workspace, view);
    return formatNumber(marker[0], 6) + ", " + formatNumber(marker[1], 6);
}

void noteGoal(StudioContext& context) {
    if (!context.lessons.now || context.lessons.now->wandering()) return;
    OpenLesson& lesson = *context.lessons.now;
    const std::optional<Goal>& goal = lesson.session.step().goal;
    if (!goal || lesson.session.state().reached || lesson.noted == context.revision()) return;
    const double now = context.host.now();
    if (now - lesson.notedAt < kNoteEvery) return context.host.wakeAfter(kNoteEvery);
    lesson.noted = context.revision();
    lesson.notedAt = now;
    if (!lesson.session.note(context.workspace)) return;
    keep(context);
    context.say(std::string(tr("Goal reached.")) + " " + goal->praise);
}

void saveAnswers(StudioContext& context, bool asJson) {
    if (!context.lessons.now) return;
    const LessonSession& session = context.lessons.now->session;
    const Json answers = session.answers();
    const std::string text = asJson ? printJson(answers) : answersAsText(session);
    const Expected<std::string> path =
        context.host.saveFile(session.lesson().id + (asJson ? "-answers.json" : "-answers.txt"),
                              {reinterpret_cast<const unsigned char*>(text.data()), text.size()});
    if (!path) return context.report(path.status());
    context.say(tr("Saved: {1}", {*path}));
}

void exportStep(StudioContext& context) {
    if (!context.lessons.now) return;
    const LessonSession& session = context.lessons.now->session;
    const Document document =
        documentOfPlate(plateOfStep(session.lesson(), session.at(), context.workspace));
    context.copying = false;
    context.host.startExport({printJson(documentToJson(document)),
                              session.lesson().id + "-" + std::to_string(session.at() + 1) + ".png",
                              false});
    context.host.wake();
}

bool stepNamesControls(const StudioContext& context) {
    return context.lessons.now && !context.lessons.now->wandering() &&
           !context.lessons.now->session.step().controls.empty();
}

bool isOpenInStep(StudioContext& context, const std::string& id) {
    if (!stepNamesControls(context)) return true;
    const auto& names = context.lessons.now->session.step().controls;
    return std::any_of(names.begin(), names.end(), [&](const std::string& name) {
        return namesControl(mapOf(context.workspace.views[0]).info, name, id);
    });
}

}  // namespace versorium
