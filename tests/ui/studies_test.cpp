// SPDX-License-Identifier: MIT
// Panels of planar systems and of sets of parameters: what they find is compared with closed forms,
// and real pointers do the work.
#include "ui/session/studies.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "base/embedded.h"
#include "io/document.h"
#include "render/system_of.h"
#include "ui/controls/commands.h"
#include "ui/controls/controls.h"
#include "ui/headless_gui.h"
#include "ui/plots/plots.h"
#include "ui/session/open_file.h"
#include "ui/session/planar_change.h"

namespace versorium {
namespace {

Workspace ofPreset(const char* name) {
    const Expected<Scene> scene = presetNamed(name);
    EXPECT_TRUE(scene.ok()) << name;
    return workspaceOf(*scene);
}

// With nothing moving and nothing left to be recorded.
struct StillStudio {
    SilentHost host;
    StudioContext context{host};
    explicit StillStudio(const char* preset) {
        host.still = true;
        context.open(ofPreset(preset));
        rest();
    }
    void rest() {
        context.player.animation.running = false;
        context.record();
    }
};

std::string axesOf(const Workspace& workspace) {
    const int view = viewOfKind(workspace, ViewKind::parameters);
    if (view < 0) return "none";
    const auto& axes = workspace.views[static_cast<std::size_t>(view)].slice.axes;
    return axes[0].terms[0].first + " " + axes[1].terms[0].first;
}

// Presses where ImGui says that an item of this name is, found by sweeping the pointer.
void click(HeadlessGui& gui, const std::function<void()>& panel, ImVec2 at, int button = 0) {
    ImGuiIO& io = ImGui::GetIO();
    io.AddMousePosEvent(at.x, at.y);
    gui.frame(panel);
    gui.frame(panel);
    io.AddMouseButtonEvent(button, true);
    gui.frame(panel);
    io.AddMouseButtonEvent(button, false);
    gui.frame(panel);
}

TEST(PlanarPanel, TwoClicksOnCoefficientsMakeThemTheAxes) {
    StillStudio studio("planar-set");
    StudioContext& context = studio.context;
    EXPECT_EQ(axesOf(context.workspace), "g.d h.d");
    nextAxis(context, "g.b1");
    EXPECT_EQ(axesOf(context.workspace), "g.b1 h.d");
    nextAxis(context, "h.a1");
    EXPECT_EQ(axesOf(context.workspace), "g.b1 h.a1");
    EXPECT_STREQ(axisSign(context.workspace, "g.b1"), "→");
    EXPECT_STREQ(axisSign(context.workspace, "h.a1"), "↑");
    EXPECT_STREQ(axisSign(context.workspace, "g.d"), "");
    // The older one goes.
    nextAxis(context, "g.c4");
    EXPECT_EQ(axesOf(context.workspace), "g.c4 h.a1");
    context.undo();
    EXPECT_EQ(axesOf(context.workspace), "g.d h.d");
}

// All 435 pairs of the 30 coefficients, from a workspace without any view of parameters.
TEST(PlanarPanel, AnyPairOfCoefficientsGivesASet) {
    Workspace only = ofPreset("planar");
    only.focused = 1;
    setViewCount(only, 1);
    ASSERT_EQ(viewKind(only.views[0]), ViewKind::startingPoints);
    Binder binder;
    for (int a = 0; a < 30; ++a)
        for (int b = 0; b < a; ++b) {
            Workspace workspace = only;
            const MapInfo& info = mapOf(only.views[0]).info;
            const std::string first = parameterComponent(info, a);
            const std::string second = parameterComponent(info, b);
            makeAxis(workspace, 0, first);
            makeAxis(workspace, 1, second);
            ASSERT_EQ(axesOf(workspace), first + " " + second);
            // The ring lies where the numbers are.
            const auto marker = markerOf(workspace, 0);
            EXPECT_EQ(marker[0], sharedNumber(workspace, first));
            EXPECT_EQ(marker[1], sharedNumber(workspace, second));
            Job job(1);
            ASSERT_TRUE(binder.bind(workspace.views[0], job).ok());
        }
}

TEST(PlanarPanel, PlacesOfAnAnalysisKeepNumbersOnItsAxesOnly) {
    Workspace workspace = ofPreset("planar-set");
    ASSERT_TRUE(setAnalysis(workspace));
    workspace.focused = 2;
    makeAxis(workspace, 0, "g.b1");
    const double d = workspace.views[2].parameters.at("g.d")[0];
    for (const Scene& scene : workspace.views) EXPECT_EQ(scene.parameters.at("g.d")[0], d);
    EXPECT_NE(workspace.views[1].parameters.at("h.d"), workspace.views[2].parameters.at("h.d"));
}

// A drag with the pointer in a cell sets the coefficient; the button before it makes the axis.
TEST(PlanarPanel, CellsAreDraggedAndNamesAreClicked) {
    StillStudio studio("planar-set");
    StudioContext& context = studio.context;
    HeadlessGui gui({330, 1500});
    const auto panel = [&] { drawPlanarPanel(context); };
    for (int k = 0; k < 3; ++k) gui.frame(panel);
    bool axis = false, dragged = false;
    for (float y = 30; y < 400 && !(axis && dragged); y += 7) {
        if (!axis) {
            const std::string before = axesOf(context.workspace);
            click(gui, panel, {20, y});
            axis = axesOf(context.workspace) != before;
            if (ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup))
                click(gui, panel, {325, 1490});
        }
        const Json before = workspaceToJson(context.workspace)["views"][0];
        const std::vector<double> old = context.workspace.views[0].parameters.at("g.a1");
        ImGuiIO& io = ImGui::GetIO();
        io.AddMousePosEvent(65, y);
        gui.frame(panel);
        io.AddMouseButtonEvent(0, true);
        gui.frame(panel);
        for (int k = 1; k < 12; ++k) {
            io.AddMousePosEvent(65.0f + 10.0f * static_cast<float>(k), y);
            gui.frame(panel);
        }
        io.AddMouseButtonEvent(0, false);
        gui.frame(panel);
        dragged = dragged || context.workspace.views[0].parameters.at("g.a1") != old;
    }
    EXPECT_TRUE(axis);
    EXPECT_TRUE(dragged);
}

// One step of the planar system is one of the complex map, and the way back gives the same numbers.
TEST(PlanarChange, GoesToTheComplexMapAndBack) {
    const std::pair<const char*, const char*> cases[] = {
        {"planar-set", "quadratic"}, {"planar-cubic", "cubic"}, {"planar-quartic", "power"}};
    for (const auto& [preset, map] : cases) {
        StillStudio studio(preset);
        StudioContext& context = studio.context;
        const PlanarNumbers numbers = planarNumbersOf(context.workspace.views[0]);
        const std::optional<System> planar = shownSystem(context);
        ASSERT_TRUE(planar && hasComplexForm(context)) << preset;
        double before[2] = {0.3, -0.2}, after[2] = {0.3, -0.2};
        planar->step(before);
        const Workspace old = context.workspace;
        showAsComplexMap(context);
        EXPECT_EQ(context.workspace.views[0].map, map);
        const std::optional<System> complex = shownSystem(context);
        ASSERT_TRUE(complex);
        complex->step(after);
        // Operations in another order.
        EXPECT_NEAR(after[0], before[0], 1e-14) << preset;
        EXPECT_NEAR(after[1], before[1], 1e-14) << preset;
        EXPECT_EQ(context.workspace.views[1].slice.height, old.views[1].slice.height);
        EXPECT_EQ(markerOf(context.workspace, 1), markerOf(old, 1));
        showAsPlanarSystem(context);
        EXPECT_EQ(context.workspace.views[0].map, "planar");
        const PlanarNumbers again = planarNumbersOf(context.workspace.views[0]);
        for (std::size_t k = 0; k < numbers.size(); ++k)
            EXPECT_NEAR(again[k], numbers[k], 1e-12) << preset << " " << k;
        EXPECT_TRUE(hasComplexForm(context)) << preset;
    }
    StillStudio henon("henon");
    EXPECT_FALSE(hasComplexForm(henon.context));
    showAsComplexMap(henon.context);
    EXPECT_EQ(henon.context.workspace.views[0].map, "planar");
}

TEST(PlanarChange, ReadsPolynomialsOffFormulas) {
    StillStudio studio("mandelbrot");
    StudioContext& context = studio.context;
    ASSERT_TRUE(applyFormula(context, "2*z^4 - (1 + 3i)*z^3 + z/4 + c; c = 0.5 - 0.25i").ok());
    context.edit([&](Workspace& w) { setSharedNumber(w, "c.re", 0.5); });
    context.edit([&](Workspace& w) { setSharedNumber(w, "c.im", -0.25); });
    const auto polynomial = polynomialOf(context);
    ASSERT_TRUE(polynomial);
    const ComplexPolynomial expected{{{{0.5, -0.25}, {0.25, 0}, {0, 0}, {-1, -3}, {2, 0}}}};
    EXPECT_EQ(*polynomial, expected);
    showAsPlanarSystem(context);
    EXPECT_EQ(complexPolynomialOf(planarNumbersOf(context.workspace.views[0])), expected);
    // A quadratic that is not monic goes to a formula and comes back.
    showAsComplexMap(context);
    EXPECT_EQ(polynomialOf(context), expected);
    for (const char* other : {"sin(z) + c", "z^5 + c", "conj(z)^2 + c", "1/z + c"}) {
        ASSERT_TRUE(applyFormula(context, other).ok());
        EXPECT_FALSE(polynomialOf(context)) << other;
    }
}

// Hénon, a = 1.4, b = 0.3: x = a - x² + b x, both saddles.
TEST(CyclesPanel, OfHenonAreListedDrawnAndClicked) {
    StillStudio studio("henon-set");
    StudioContext& context = studio.context;
    context.edit([&](Workspace& w) { setSharedNumber(w, "g.d", 1.4); });
    context.edit([&](Workspace& w) { setSharedNumber(w, "g.b1", 0.3); });
    context.edit(
        [&](Workspace& w) { w.study = {.cycles = true, .mostPeriod = 2, .manifolds = true}; });
    studio.rest();
    for (int k = 0; k < 40; ++k) studyCycles(context);
    const CycleStudy& study = context.studies.cycles;
    EXPECT_TRUE(study.finished);
    ASSERT_EQ(study.cycles.size(), 3u);
    const double root = (-0.7 + std::sqrt(0.49 + 5.6)) / 2;
    EXPECT_NEAR(study.cycles[1].points[0][0], root, 1e-12);
    for (int k = 0; k < 3; ++k)
        EXPECT_EQ(study.cycles[static_cast<std::size_t>(k)].kind, CycleKind::saddle);
    EXPECT_GE(study.manifolds.size(), 2u);
    // A click on each row of the list: the start goes to the first point of a cycle.
    HeadlessGui gui({330, 300});
    const auto panel = [&] { drawCycleControls(context); };
    std::vector<double> seen;
    for (float y = 90; y < 280; y += 5) {
        click(gui, panel, {150, y});
        if (seen.empty() || seen.back() != context.workspace.point[0])
            seen.push_back(context.workspace.point[0]);
        studio.rest();
    }
    int hit = 0;
    for (const PeriodicCycle& cycle : study.cycles)
        hit += static_cast<int>(std::count(seen.begin(), seen.end(), cycle.points[0][0]));
    EXPECT_GE(hit, 3);
}

// x = r x (1 - x) at 1 - 1/r with the multiplier 2 - r, on the line.
TEST(CyclesPanel, OfTheLogisticMapToo) {
    StillStudio studio("logistic");
    StudioContext& context = studio.context;
    context.edit([&](Workspace& w) { setSharedNumber(w, "r", 3.25); });
    context.edit([&](Workspace& w) { w.study.cycles = true; });
    studio.rest();
    for (int k = 0; k < 20; ++k) studyCycles(context);
    bool found = false;
    for (const PeriodicCycle& cycle : context.studies.cycles.cycles)
        if (cycle.period == 1 && std::abs(cycle.points[0][0] - (1 - 1 / 3.25)) < 1e-12) {
            found = true;
            ASSERT_TRUE(cycle.multiplier);
            EXPECT_NEAR(cycle.multiplier->real(), 2 - 3.25, 1e-12);
        }
    EXPECT_TRUE(found);
}

TEST(CriticalStart, IsDraggedAndPutOntoTheCurve) {
    StillStudio studio("nearly-complex");
    StudioContext& context = studio.context;
    HeadlessGui gui({600, 600});
    const Workspace& workspace = context.workspace;
    const int parameters = viewOfKind(workspace, ViewKind::parameters);
    ASSERT_EQ(parameters, 0);
    context.edit([](Workspace& w) {
        w.views[0].criticalStart.reset();
        w.views[0].start = {0.5, 0.5};
        w.point = {-0.8, -0.8};
    });
    studio.rest();
    const auto view = [&] { drawView(context, 1, {0, 0}, {600, 600}); };
    for (int k = 0; k < 3; ++k) gui.frame(view);
    const double unit = 600 / workspace.views[1].slice.height;
    const auto& centre = workspace.views[1].slice.centre;
    const auto place = [&](double x, double y) {
        return ImVec2(static_cast<float>(300 + (x - centre[0]) * unit),
                      static_cast<float>(300 - (y - centre[1]) * unit));
    };
    const ImVec2 from = place(0.5, 0.5), to = place(0.9, 0.2);
    ImGuiIO& io = ImGui::GetIO();
    io.AddMousePosEvent(from.x, from.y);
    gui.frame(view);
    io.AddMouseButtonEvent(0, true);
    gui.frame(view);
    io.AddMousePosEvent(to.x, to.y);
    gui.frame(view);
    io.AddMouseButtonEvent(0, false);
    gui.frame(view);
    // Within a pixel.
    EXPECT_NEAR(workspace.views[0].start[0], 0.9, 1.5 / unit);
    EXPECT_NEAR(workspace.views[0].start[1], 0.2, 1.5 / unit);
    EXPECT_EQ(workspace.point, (std::vector<double>{-0.8, -0.8}));
    // Alt and a click, with the curve drawn: det J = 0 there.
    context.edit([](Workspace& w) { w.study.criticalCurve = true; });
    studio.rest();
    io.AddKeyEvent(ImGuiMod_Alt, true);
    click(gui, view, place(0.3, 0.3));
    io.AddKeyEvent(ImGuiMod_Alt, false);
    gui.frame(view);
    const std::optional<System> system = shownSystem(context);
    ASSERT_TRUE(system);
    EXPECT_NEAR(system->determinant(workspace.views[0].start.data()), 0, 1e-9);
    // Without the curve it sets the second start.
    context.edit([](Workspace& w) { w.study.criticalCurve = false; });
    studio.rest();
    io.AddKeyEvent(ImGuiMod_Alt, true);
    click(gui, view, place(-0.5, 0.5));
    io.AddKeyEvent(ImGuiMod_Alt, false);
    gui.frame(view);
    ASSERT_EQ(workspace.compared.size(), 2u);
    EXPECT_NEAR(workspace.compared[0], -0.5, 1.5 / unit);
}

TEST(CriticalStart, TheBadgeSaysWhatTheSetIs) {
    const std::pair<const char*, CatalogueAnswer> cases[] = {
        {"mandelbrot", CatalogueAnswer::onlyCriticalOrbit},
        {"planar-set", CatalogueAnswer::onlyCriticalOrbit},
        {"henon-set", CatalogueAnswer::noCriticalPoint},
        {"not-critical", CatalogueAnswer::notCritical}};
    for (const auto& [preset, answer] : cases) {
        StillStudio studio(preset);
        const int view = viewOfKind(studio.context.workspace, ViewKind::parameters);
        ASSERT_GE(view, 0) << preset;
        const CatalogueBadge* badge = studyBadge(studio.context, view);
        ASSERT_NE(badge, nullptr) << preset;
        EXPECT_EQ(badge->answer, answer) << preset << ": " << badge->sentence;
    }
}

// The line is dragged: the number follows, and the period is that of the map.
TEST(Diagram, IsFilledDraggedAndZoomed) {
    StillStudio studio("logistic");
    StudioContext& context = studio.context;
    HeadlessGui gui({900, 300});
    context.edit([&](Workspace& w) { w.plot = PlotPanel::diagram; });
    context.edit([&](Workspace& w) { w.diagram = {"r", 2.5, 4}; });
    const auto strip = [&] { drawPlot(context); };
    for (int k = 0; k < 400 && (!context.studies.diagram.diagram ||
                                context.studies.diagram.filled <
                                    context.studies.diagram.diagram->visits.size().width);
         ++k)
        gui.frame(strip);
    const DiagramStudy& study = context.studies.diagram;
    ASSERT_TRUE(study.diagram);
    const auto width = static_cast<double>(study.diagram->visits.size().width);
    ASSERT_EQ(study.filled, width);
    const auto period = [&](double r) {
        return study.diagram->periods[static_cast<std::size_t>((r - 2.5) / 1.5 * width)];
    };
    EXPECT_EQ(period(2.9), 1);
    EXPECT_EQ(period(3.2), 2);
    EXPECT_EQ(period(3.5), 4);
    EXPECT_EQ(period(3.835), 3);
    click(gui, strip, {450, 200});
    const double middle = sharedNumber(context.workspace, "r");
    EXPECT_NEAR(middle, 3.25, 0.02);
    ImGui::GetIO().AddMousePosEvent(450, 200);
    gui.frame(strip);
    ImGui::GetIO().AddMouseWheelEvent(0, 3);
    gui.frame(strip);
    const Workspace::Diagram& diagram = context.workspace.diagram;
    EXPECT_NEAR(diagram.right - diagram.left, 1.5 * std::pow(0.8, 3), 1e-9);
    EXPECT_LT(diagram.left, middle);
    EXPECT_GT(diagram.right, middle);
    fitDiagram(context);
    EXPECT_EQ(diagram.number, "r");
}

TEST(Diagram, OfAPlateOpensWithItsStrip) {
    StillStudio studio("mandelbrot");
    const auto bytes = embedded("plates/bifurcation-diagram.json");
    ASSERT_FALSE(bytes.empty());
    const Expected<Json> plate =
        parseJson({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    ASSERT_TRUE(plate);
    const std::string text = printJson(
        documentToJson(Document{.kind = DocumentKind::plate, .body = *plate, .assets = {}}));
    const Status status = openText(studio.context, text);
    ASSERT_TRUE(status.ok()) << status.message();
    EXPECT_EQ(studio.context.workspace.views[0].map, "logistic");
    EXPECT_EQ(studio.context.workspace.diagram, (Workspace::Diagram{"r", 2.8, 4}));
    EXPECT_EQ(studio.context.workspace.plot, PlotPanel::diagram);
}

TEST(Studies, TravelInALinkAndRefuseWhatIsWrong) {
    Workspace workspace = ofPreset("henon");
    workspace.study = {true, 5, true, true};
    workspace.compared = {0.25, -0.5};
    workspace.diagram = {"g.d", -1, 2};
    const Expected<std::string> link = workspaceToLink(workspace);
    ASSERT_TRUE(link);
    const Expected<Workspace> again = workspaceFromLink(*link);
    ASSERT_TRUE(again) << again.status().message();
    EXPECT_EQ(again->study, workspace.study);
    EXPECT_EQ(again->compared, workspace.compared);
    EXPECT_EQ(again->diagram, workspace.diagram);
    const Json good = workspaceToJson(workspace);
    const std::pair<const char*, Json> wrong[] = {
        {"study", {{"most_period", 13}}},
        {"study", {{"most_period", 0}}},
        {"study", {{"unknown", 1}}},
        {"compared", {1}},
        {"compared", "here"},
        {"diagram", {{"number", "p.x"}, {"range", {0, 1}}}},
        {"diagram", {{"number", "nothing"}, {"range", {0, 1}}}},
        {"diagram", {{"number", "g.d"}, {"range", {1, 0}}}},
        {"diagram", {{"number", "g.d"}}}};
    for (const auto& [key, value] : wrong) {
        Json json = good;
        json[key] = value;
        EXPECT_FALSE(workspaceFromJson(json).ok()) << key << " " << value.dump();
    }
}

TEST(Studies, CommandsAndControlsReachThem) {
    StillStudio studio("henon");
    StudioContext& context = studio.context;
    EXPECT_TRUE(runCommand(context, "cycles"));
    EXPECT_TRUE(runCommand(context, "critical.curve"));
    EXPECT_TRUE(runCommand(context, "plot.diagram"));
    EXPECT_TRUE(context.workspace.study.cycles && context.workspace.study.criticalCurve);
    EXPECT_EQ(context.workspace.plot, PlotPanel::diagram);
    EXPECT_TRUE(setControl(context, "study.most_period", "7"));
    EXPECT_EQ(context.workspace.study.mostPeriod, 7);
    EXPECT_FALSE(setControl(context, "study.most_period", "13"));
    EXPECT_TRUE(setControl(context, "diagram number", "h.a1"));
    EXPECT_EQ(context.workspace.diagram.number, "h.a1");
    EXPECT_TRUE(setControl(context, "compared", "on"));
    EXPECT_TRUE(setControl(context, "second 1", "0.125"));
    EXPECT_EQ(context.workspace.compared[1], 0.125);
    EXPECT_EQ(comparedOrbit(context).front()[1], 0.125);
    context.focus(0);
    EXPECT_TRUE(setControl(context, "start 0", "0.75"));
    EXPECT_EQ(context.workspace.views[0].start[0], 0.75);
}

}  // namespace
}  // namespace versorium
