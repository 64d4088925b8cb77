// SPDX-License-Identifier: MIT
#include "lesson/lesson_plate.h"

#include "plate/markup.h"
#include "workspace/export_document.h"

namespace versorium {
namespace {

std::string markupOf(const std::vector<MarkdownBlock>& blocks) {
    std::string text;
    for (const MarkdownBlock& block : blocks) {
        if (!text.empty()) text += " ";
        if (block.kind == MarkdownBlock::Kind::item)
            text += block.number > 0 ? "(" + std::to_string(block.number) + ") " : "· ";
        for (const TextRun& run : block.runs) {
            const std::string plain = escapeMarkup(run.text);
            text += run.strong ? "\\bold{" + plain + "}" : plain;
        }
    }
    return text;
}

}  // namespace

PlateDocument plateOfStep(const Lesson& lesson, std::size_t step) {
    return plateOfStep(lesson, step, lesson.steps[step].stage);
}

PlateDocument plateOfStep(const Lesson& lesson, std::size_t step, const Workspace& shown) {
    const LessonStep& what = lesson.steps[step];
    const std::vector<double> aspects(shown.views.size(), 1.0);
    PlateDocument document = plateOfViews(shown, aspects, !shown.maximised);
    document.plate.title = escapeMarkup(what.title);
    document.plate.caption = markupOf(what.prose);
    if (what.question)
        document.plate.caption += " \\bold{" + escapeMarkup(what.question->prompt) + "}";
    if (what.goal) document.plate.caption += " \\bold{" + escapeMarkup(what.goal->text) + "}";
    document.plate.note = "Versorium · " + escapeMarkup(lesson.title) + ", " +
                          std::to_string(step + 1) + " / " + std::to_string(lesson.steps.size());
    // Where the numbers of a plane of starting points lie among the parameters.
    std::vector<PlatePanel>& panels = document.plate.panels;
    for (std::size_t k = 0; k < panels.size(); ++k)
        if (panels.size() == shown.views.size() && showsParameters(shown.views[k]))
            for (std::size_t other = 0; other < panels.size(); ++other)
                if (!showsParameters(shown.views[other]))
                    panels[k].marks.push_back({panels[other].name, ""});
    return document;
}

}  // namespace versorium
