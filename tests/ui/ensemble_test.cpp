// SPDX-License-Identifier: MIT
// Averages over random maps as the studio sets them up, and the radial profile in the strip.
#include <gtest/gtest.h>

#include <cmath>

#include "fields/ensemble.h"
#include "render/cpu/cpu_renderer.h"
#include "render/shape_profile.h"
#include "scene/properties.h"
#include "ui/controls/controls.h"
#include "ui/headless_gui.h"
#include "ui/panels/panels.h"
#include "ui/plots/plots.h"
#include "ui/session/ensemble_change.h"
#include "ui/widgets/help.h"

namespace versorium {
namespace {

std::string valueOf(StudioContext& context, const std::string& id) {
    for (const Control& control : controlsOf(context))
        if (control.id == id) return control.value;
    return "missing";
}

TEST(Ensemble, OnePressAveragesOverVersorsAndUndoTakesItBack) {
    SilentHost host;
    StudioContext context(host);
    context.newMap("shape-modulus-complex-rational");
    context.record();
    const auto before = workspaceToJson(context.workspace);
    ASSERT_TRUE(setControl(context, "do average.versors", ""));
    const Scene& scene = context.workspace.view();
    ASSERT_TRUE(scene.ensemble.roots);
    EXPECT_TRUE(scene.ensemble.roots->shapeBox);
    EXPECT_EQ(scene.ensemble.count, 1000);
    EXPECT_EQ(shownAverage(scene), "mean_membership");
    EXPECT_EQ(scene.colour.palette, "viridis");
    EXPECT_FALSE(scene.colour.contours.empty());
    EXPECT_TRUE(sceneFromJson(sceneToJson(scene)).ok());
    EXPECT_NE(describeView(context, context.workspace.focused).find("of 1000 sets"),
              std::string::npos);
    // A link carries it.
    const Expected<Workspace> link = workspaceFromLink(*workspaceToLink(context.workspace));
    ASSERT_TRUE(link.ok()) << link.status().message();
    EXPECT_EQ(writeObject(link->view().ensemble, ensembleTable()),
              writeObject(scene.ensemble, ensembleTable()));
    EXPECT_EQ(link->view().colour, scene.colour);
    context.record();
    context.undo();
    EXPECT_EQ(workspaceToJson(context.workspace), before);
    context.redo();
    EXPECT_TRUE(context.workspace.view().ensemble.varies());
}

TEST(Ensemble, EveryMapCanBeAveraged) {
    for (const MapKernels& map : catalogue()) {
        Scene scene = dynamicalView(sceneOf(map));
        const Status versors = averageOverVersors(scene);
        EXPECT_EQ(versors.ok(), !map.info.lists.empty()) << map.info.name << versors.message();
        Scene other = dynamicalView(sceneOf(map));
        // A map of the line has its one parameter on an axis.
        if (map.parameters > 0 && map.dimension > 1) {
            const Status number = averageOverNumber(other);
            EXPECT_TRUE(number.ok()) << map.info.name << ": " << number.message();
            EXPECT_TRUE(other.ensemble.varies());
            const Expected<Scene> back = sceneFromJson(sceneToJson(other));
            EXPECT_TRUE(back.ok()) << map.info.name << ": " << back.status().message();
        }
    }
}

TEST(Ensemble, WhatComesOntoAnAxisIsDrawnNoLonger) {
    SilentHost host;
    StudioContext context(host);
    context.focus(1);
    ASSERT_TRUE(context.edit([](Workspace& w) { return averageOverNumber(w.view()); }).ok());
    EXPECT_EQ(context.workspace.view().ensemble.discs.size(), 1u);
    context.edit([&](Workspace& w) { setAxis(w, 0, "c.re"); });
    EXPECT_FALSE(context.workspace.view().ensemble.varies());
    EXPECT_TRUE(workspaceFromJson(workspaceToJson(context.workspace)).ok());
}

TEST(Ensemble, ControlsSetAllOfIt) {
    SilentHost host;
    StudioContext context(host);
    context.newMap("shape-modulus-complex-rational");
    EXPECT_EQ(valueOf(context, "ensemble.count"), "missing");
    ASSERT_TRUE(setControl(context, "ensemble roots", "on"));
    for (const auto& [id, value] : std::vector<std::pair<std::string, std::string>>{
             {"ensemble.count", "250"},
             {"ensemble.seed", "7"},
             {"ensemble.set", "solid"},
             {"ensemble shown", "standard error"},
             {"ensemble.roots.count[0]", "4"},
             {"ensemble.roots.count[1]", "9"},
             {"ensemble.roots.power[1]", "2"},
             {"ensemble.roots.powers", "real"},
             {"ensemble.roots.arrangement", "clustered"},
             {"ensemble.roots.clusters", "2"},
             {"ensemble.roots.region", "ball"}}) {
        EXPECT_TRUE(setControl(context, id, value)) << id;
        EXPECT_EQ(valueOf(context, id), value) << id;
    }
    EXPECT_TRUE(setControl(context, "colour.contours", "0.01 0.005"));
    EXPECT_EQ(valueOf(context, "colour.contours"), "0.005, 0.01");
    EXPECT_FALSE(setControl(context, "colour.contours", "half"));
    EXPECT_TRUE(setControl(context, "ensemble range", "alpha"));
    EXPECT_TRUE(setControl(context, "ensemble.ranges[0].to", "9.5"));
    EXPECT_TRUE(setControl(context, "ensemble disc", "shift"));
    EXPECT_TRUE(setControl(context, "ensemble.discs[0].radius", "0.25"));
    const EnsembleSpec& ensemble = context.workspace.view().ensemble;
    EXPECT_EQ(ensemble.ranges[0].to, 9.5);
    EXPECT_EQ(ensemble.discs[0].radius, 0.25);
    // Nonsense is refused and leaves everything as it was.
    setControl(context, "ensemble.roots.power[0]", "50");
    EXPECT_EQ(ensemble.roots->draw.lowPower, 1);
    EXPECT_TRUE(sceneFromJson(sceneToJson(context.workspace.view())).ok());
    EXPECT_TRUE(setControl(context, "no average", ""));
    EXPECT_FALSE(context.workspace.view().ensemble.varies());
    EXPECT_EQ(context.workspace.view().colour, sceneOf(mapOf(context.workspace.view())).colour);
}

// The panel, with the pointer on all of it, in every form that it takes.
TEST(Ensemble, ThePanelDraws) {
    SilentHost host;
    HeadlessGui gui({330, 900});
    StudioContext context(host);
    const auto panel = [&] { drawEnsemble(context); };
    gui.frame(panel);
    context.newMap("shape-modulus");
    ASSERT_TRUE(context.edit([](Workspace& w) { return averageOverVersors(w.view()); }).ok());
    context.edit([&](Workspace& w) { w.view().ensemble.roots->shapeBox = false; });
    context.edit([&](Workspace& w) {
        w.view().ensemble.roots->draw.arrangement = RootArrangement::clustered;
    });
    context.edit([&](Workspace& w) { addRange(w.view(), "alpha"); });
    const auto before = workspaceToJson(context.workspace);
    for (float y = 4; y < 900; y += 11) {
        ImGui::GetIO().AddMousePosEvent(150, y);
        gui.frame(panel);
    }
    EXPECT_GT(gui.bottom, 300);
    EXPECT_EQ(workspaceToJson(context.workspace), before) << "looking changes nothing";
}

TEST(Ensemble, TypedLevels) {
    EXPECT_EQ(*contoursFromText("0.5,0.1;  0.9"), (std::vector<double>{0.1, 0.5, 0.9}));
    EXPECT_TRUE(contoursFromText("")->empty());
    EXPECT_FALSE(contoursFromText("0.1, x").ok());
    EXPECT_FALSE(contoursFromText("nan").ok());
    for (const auto& [name, levels] : contourChoices())
        EXPECT_EQ(*contoursFromText(contourText(levels)), levels) << name;
}

// c uniform in a disc: the mean over the ensemble is the mean of pictures of its members, one by
// one, each rendered as a scene of its own.
TEST(Ensemble, TheMeanOverADiscIsTheMeanOfItsMembersPictures) {
    Scene scene = sceneOf(*findMap("quadratic"));
    scene.samples = 1;
    scene.iterations = 60;
    scene.ensemble.count = 12;
    scene.ensemble.discs.push_back({"c", -0.2, 0.6, 0.3});
    constexpr Size kSize{48, 32};
    CpuRenderer renderer;
    Job job(1);
    std::vector<Raster<double>> mean;
    ASSERT_TRUE(renderer.measure(scene, kSize, {FieldName::meanMembership}, {}, job, mean).ok());
    const OrbitProgram program = *renderer.binder().bind(scene, job);
    std::vector<double> sum(mean[0].values().size(), 0.0);
    for (std::uint64_t k = 0; k < 12; ++k) {
        OrbitProgram member = program;
        program.ensemble->choose(k, member);
        Scene one = scene;
        one.ensemble = {};
        one.escapeRadius = program.escapeRadius;
        one.parameters["c"] = {member.slice.origin[2], member.slice.origin[3]};
        EXPECT_LE(std::hypot(one.parameters["c"][0] + 0.2, one.parameters["c"][1] - 0.6), 0.3);
        std::vector<Raster<double>> picture;
        ASSERT_TRUE(renderer.measure(one, kSize, {FieldName::membership}, {}, job, picture).ok());
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += picture[0].values()[i];
    }
    int between = 0;
    for (std::size_t i = 0; i < sum.size(); ++i) {
        EXPECT_EQ(mean[0].values()[i], sum[i] / 12);
        between += sum[i] > 0 && sum[i] < 12;
    }
    EXPECT_GT(between, 50);
}

// A disc of radius a around the origin: φ = r - a on every circle, so r̂ = e^{α(r - a)} exactly.
TEST(ProfileStrip, OfADiscIsAStraightLine) {
    SilentHost host;
    HeadlessGui gui({900, 300});
    StudioContext context(host);
    context.newMap("shape-modulus-complex-rational");
    context.edit([&](Workspace& w) {
        for (Scene& scene : w.views) scene.shape.source = "sphere(0.8)";
    });
    context.edit([&](Workspace& w) { setSharedNumber(w, "alpha", 4); });
    const ProfileStudy* study = &studyProfile(context);
    ASSERT_TRUE(study->profile);
    EXPECT_FALSE(study->ended);
    // Everything stands still: finer from frame to frame.
    for (int k = 0; k < 10 && !study->ended; ++k) {
        host.time += 1;
        study = &studyProfile(context);
    }
    ASSERT_TRUE(study->ended);
    const RadialProfile& profile = *study->profile;
    EXPECT_EQ(profile.radius.size(), 257u);
    for (std::size_t i = 0; i < profile.radius.size(); ++i) {
        EXPECT_NEAR(profile.mean[i], profile.radius[i] - 0.8, 1e-12);
        EXPECT_NEAR(profile.modulus[i], std::exp(4 * (profile.radius[i] - 0.8)),
                    1e-11 * profile.modulus[i]);
        EXPECT_LE(profile.low[i], profile.mean[i] + 1e-12);
        EXPECT_GE(profile.high[i], profile.mean[i] - 1e-12);
    }
    // r = e^{4(r - 0.8)} at r = 0.049 and at 0.716: within the second orbits stay, beyond it they
    // leave, whatever the versor is. The bounds between the points of a circle cost a little.
    EXPECT_GT(profile.capture, 0.69);
    EXPECT_LE(std::exp(4 * (profile.capture - 0.8)), profile.capture);
    EXPECT_LT(profile.capture, 0.717);
    EXPECT_GT(profile.escape, 0.715);
    EXPECT_LT(profile.escape, 0.8);
    const std::string told = describeProfile(context);
    EXPECT_NE(told.find("stay"), std::string::npos);
    EXPECT_NE(profileAt(profile, 0.01).find("stays"), std::string::npos);
    EXPECT_NE(profileAt(profile, profile.radius.back()).find("leaves"), std::string::npos);

    context.edit([&](Workspace& w) { w.plot = PlotPanel::profile; });
    const auto strip = [&] { drawPlot(context); };
    for (int k = 0; k < 3; ++k) gui.frame(strip);
    ImGui::GetIO().AddMousePosEvent(450, 150);
    for (int k = 0; k < 4; ++k) gui.frame(strip);
    EXPECT_TRUE(gui.tooltipShown());
    // α changes the profile; colours do not.
    const RadialProfile* kept = context.studies.profile.profile.get();
    context.edit([&](Workspace& w) { w.view().colour.palette = "fire"; });
    EXPECT_EQ(studyProfile(context).profile.get(), kept);
    context.edit([&](Workspace& w) { setSharedNumber(w, "alpha", 6); });
    EXPECT_NEAR(studyProfile(context).profile->modulus[0], std::exp(-4.8), 1e-12);
    // A map without a shape has none.
    context.newMap("quadratic");
    gui.frame(strip);
    EXPECT_EQ(context.workspace.plot, PlotPanel::series);
    EXPECT_FALSE(studyProfile(context).profile);
}

}  // namespace
}  // namespace versorium
