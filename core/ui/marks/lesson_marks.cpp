// SPDX-License-Identifier: MIT
// A point that the learner answered, and the right one once it is revealed, side by side.
#include "ui/marks/mark.h"

namespace versorium {
namespace {

void drawLessonMarks(const ViewFrame& frame) {
    const Lessons& lessons = frame.context.lessons;
    if (!lessons.now || lessons.now->wandering()) return;
    const LessonSession& session = lessons.now->session;
    const std::optional<Question>& question = session.step().question;
    if (!question || question->kind != AnswerKind::point || question->view != frame.view) return;
    const float scale = frame.scale();
    const auto mark = [&](double x, double y, MarkShape shape, const char* word, ImU32 colour) {
        const ScreenPoint at = frame.plane.at(x, y);
        drawMark(frame.list(), at, 10 * scale, shape, colour);
        drawText(frame.list(), {at.x + 14 * scale, at.y - 8 * scale}, colour, word);
    };
    const std::vector<double> answer = answerNumbers(session.state().answer);
    if (answer.size() == 2)
        mark(answer[0], answer[1], MarkShape::diamond, tr("your answer"), pinColour(3));
    if (session.state().revealed && !session.state().right)
        mark(question->answer[0], question->answer[1], MarkShape::square, tr("the answer"),
             pinColour(1));
}

}  // namespace

const Mark lessonMark{.draw = drawLessonMarks};

}  // namespace versorium
