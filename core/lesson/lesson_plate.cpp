// SPDX-License-Identifier: MIT
#include "lesson/lesson_plate.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "i18n/language.h"
#include "lesson/measures.h"
#include "lesson/plate_marks.h"
#include "plate/markup.h"
#include "render/system_of.h"
#include "workspace/diagram.h"
#include "workspace/export_document.h"

namespace versorium {
namespace {

std::string markupOf(const std::vector<MarkdownBlock>& blocks) {
    std::string text;
    for (const MarkdownBlock& block : blocks) {
        if (!text.empty()) text += "\\par ";
        if (block.kind == MarkdownBlock::Kind::item)
            text += block.number > 0 ? "(" + std::to_string(block.number) + ") " : "· ";
        for (const TextRun& run : block.runs) {
            const std::string plain = escapeMarkup(run.text);
            text += run.strong ? "\\bold{" + plain + "}" : plain;
        }
    }
    return text;
}

// Of a map of the line.
std::vector<double> orbitValues(const Workspace& workspace) {
    std::vector<double> values;
    for (const auto& state : orbitNow(workspace, workspace.orbitSteps))
        if (std::isfinite(state[0])) values.push_back(state[0]);
    return values;
}

// The orbit of a map of the line as a time series.
LinePlot seriesOf(const Workspace& workspace, const Words& words) {
    LinePlot plot;
    plot.aspect = 2;
    plot.x.name = words.tr("step");
    plot.y.name = stateComponent(mapOf(workspace.views[0]).info, 0);
    PlotLine line;
    line.style = "both";
    for (const double value : orbitValues(workspace)) {
        line.x.push_back(static_cast<double>(line.x.size()));
        line.y.push_back(value);
    }
    plot.lines.push_back(std::move(line));
    return plot;
}

// The same as a web between the graph of the map and the diagonal.
LinePlot webOf(const Workspace& workspace, const Words& words) {
    constexpr int kGraph = 200;
    const std::string x = stateComponent(mapOf(workspace.views[0]).info, 0);
    LinePlot plot;
    plot.aspect = 1;
    plot.x.name = x;
    plot.y.name = x + "′";
    const std::vector<double> orbit = orbitValues(workspace);
    double low = 0, high = 1;
    for (const double value : orbit) low = std::min(low, value), high = std::max(high, value);
    PlotLine graph, web;
    const Scene scene = orbitScene(workspace);
    const std::optional<OrbitProgram> program = programNow(scene);
    std::vector<double> start = scene.slice.centre;
    for (int k = 0; program && k <= kGraph; ++k) {
        start[0] = low + (high - low) * k / kGraph;
        const auto one = orbitOf(*program, start.data(), 1);
        if (one.size() < 2) continue;
        graph.x.push_back(one[0][0]);
        graph.y.push_back(one[1][0]);
    }
    for (std::size_t k = 0; k + 1 < orbit.size(); ++k) {
        web.x.insert(web.x.end(), {orbit[k], orbit[k]});
        web.y.insert(web.y.end(), {k == 0 ? low : orbit[k], orbit[k + 1]});
    }
    plot.lines = {{"\\italic{f}", "line", graph.x, graph.y},
                  {"", "line", {low, high}, {low, high}},
                  {words.tr("orbit"), "line", web.x, web.y}};
    return plot;
}

void makeDiagram(const Workspace& workspace, PlatePanel& panel) {
    const Workspace::Diagram diagram = diagramOf(workspace);
    Scene scene = diagramScene(workspace);
    if (scene.criticalStart) {
        // No axis may run through a start that is solved for.
        scene.slice = {};
        scene.slice.axes.push_back({{{diagram.number, 1.0}}});
        scene.slice.centre.push_back(sharedNumber(workspace, diagram.number));
        scene.slice.centreLow.push_back(0);
    }
    panel.kind = PanelKind::diagram;
    panel.scene = scene;
    panel.diagram.parameter = diagram.number;
    panel.diagram.from = diagram.left;
    panel.diagram.to = diagram.right;
    Binder binder;
    Job job(1);
    const Expected<OrbitProgram> program =
        programAlong(binder, scene, {{{diagram.number, 1.0}}}, job);
    if (!program) return;
    DiagramOptions options{.left = diagram.left, .right = diagram.right};
    fitDiagramHeight(*program, options);
    panel.diagram.low = options.low;
    panel.diagram.high = options.high;
}

// What stands below the views, where a figure can show it.
std::optional<PlatePanel> stripPanel(const Workspace& workspace, const Plate& plate) {
    const Words words(plate.language);
    const MapKernels& map = mapOf(workspace.views[0]);
    PlatePanel panel;
    panel.name = static_cast<char>('a' + plate.panels.size());
    switch (workspace.plot) {
        case PlotPanel::series:
        case PlotPanel::web: {
            // Orbits in the plane are seen in the views themselves.
            if (map.dimension != 1 || !programNow(orbitScene(workspace))) return {};
            panel.kind = PanelKind::plot;
            const bool web = workspace.plot == PlotPanel::web;
            panel.title =
                web ? words.tr("The orbit as a web") : words.tr("The orbit, step by step");
            panel.plot = web ? webOf(workspace, words) : seriesOf(workspace, words);
            return panel;
        }
        case PlotPanel::diagram:
            if (diagramNumber(workspace).empty()) return {};
            panel.title = words.tr("Bifurcation diagram");
            makeDiagram(workspace, panel);
            return panel;
        case PlotPanel::profile:
            if (!map.info.field) return {};
            panel.kind = PanelKind::profile;
            panel.title = words.tr("Mean of φ over the radius");
            panel.scene = workspace.views[workspace.speaker()];
            return panel;
        default:
            return {};
    }
}

}  // namespace

PlateDocument plateOfStep(const Lesson& lesson, std::size_t step) {
    return plateOfStep(lesson, step, lesson.steps[step].stage);
}

PlateDocument plateOfStep(const Lesson& lesson, std::size_t step, const Workspace& shown) {
    const LessonStep& what = lesson.steps[step];
    const std::vector<double> aspects(shown.views.size(), 1.0);
    PlateDocument document = plateOfViews(shown, aspects, !shown.maximised, lesson.language);
    document.plate.title = escapeMarkup(what.title);
    document.plate.caption = markupOf(what.prose);
    if (what.question)
        document.plate.caption += "\\par \\bold{" + escapeMarkup(what.question->prompt) + "}";
    if (what.goal) document.plate.caption += "\\par \\bold{" + escapeMarkup(what.goal->text) + "}";
    document.plate.note = "Versorium · " + escapeMarkup(lesson.title) + ", " +
                          std::to_string(step + 1) + " / " + std::to_string(lesson.steps.size());
    // A picture of orbits says little without the number of their steps.
    document.plate.note += " · N = ";
    std::set<int> said;
    for (const Scene& scene : shown.views)
        if (said.insert(scene.iterations).second)
            document.plate.note += (said.size() > 1 ? ", " : "") + std::to_string(scene.iterations);
    if (std::optional<PlatePanel> strip = stripPanel(shown, document.plate))
        document.plate.panels.push_back(std::move(*strip));
    // Where the numbers of the other views lie, where they can be marked.
    std::vector<PlatePanel>& panels = document.plate.panels;
    for (std::size_t k = 0; k < shown.views.size(); ++k)
        if (!shown.maximised && traitsOf(shown.views[k]).pins)
            for (std::size_t other = 0; other < shown.views.size(); ++other)
                if (viewKind(shown.views[other]) != viewKind(shown.views[k]))
                    panels[k].marks.push_back({panels[other].name, ""});
    if (!shown.maximised) markPanels(shown, document.plate);
    return document;
}

}  // namespace versorium
