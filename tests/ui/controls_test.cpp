// SPDX-License-Identifier: MIT
#include "ui/controls/controls.h"

#include <gtest/gtest.h>

#include <set>

namespace versorium {
namespace {

class NoHost : public Host {
  public:
    double now() const override { return 0; }
    void wake() override {}
    std::string clipboard() override { return {}; }
    void setClipboard(const std::string&) override {}
    void requestWork(WorkRequest) override {}
    std::optional<WorkAnswer> takeAnswer() override { return {}; }
    void startExport(ExportRequest) override {}
    void cancelExport() override {}
    double exportProgress() const override { return -1; }
    std::optional<Expected<std::string>> takeExport() override { return {}; }
    Expected<std::string> saveFile(const std::string& name,
                                   std::span<const unsigned char>) override {
        return name;
    }
    std::string publicAddress() const override { return {}; }
    void setFragment(const std::string&) override {}
    std::string stored(const std::string&) override { return {}; }
    void store(const std::string&, const std::string&) override {}
};

std::string valueOf(StudioContext& context, const std::string& id) {
    for (const Control& control : controlsOf(context))
        if (control.id == id) return control.value;
    return "there is none";
}

TEST(Controls, OfEveryMapHaveDistinctNamesAndTakeTheirOwnValues) {
    NoHost host;
    StudioContext context(host);
    for (const MapKernels& map : catalogue()) {
        context.newMap(std::string(map.info.name));
        std::set<std::string> ids;
        for (const Control& control : controlsOf(context)) {
            EXPECT_TRUE(ids.insert(control.id).second) << map.info.name << " " << control.id;
            EXPECT_FALSE(control.label.empty()) << control.id;
            if (control.kind == ControlKind::command || control.id == "preset") continue;
            if (control.kind == ControlKind::choice && control.value.empty()) continue;
            const Json before = workspaceToJson(context.workspace);
            if (control.id == "map") continue;
            EXPECT_TRUE(setControl(context, control.id, control.value)) << control.id;
            EXPECT_EQ(workspaceToJson(context.workspace), before) << control.id;
        }
        for (int k = 0; k < parameterSize(map.info); ++k)
            EXPECT_EQ(ids.count(parameterComponent(map.info, k)), 1u) << map.info.name;
        EXPECT_NE(describeView(context, 1).find(std::string(map.info.title)), std::string::npos);
    }
}

TEST(Controls, TakeAFormula) {
    NoHost host;
    StudioContext context(host);
    EXPECT_EQ(valueOf(context, "formula"), "");
    EXPECT_FALSE(setControl(context, "formula", "z^2 + * c"));
    EXPECT_TRUE(setControl(context, "formula", "z^3 - a*z + c; a: real = 0.5"));
    EXPECT_EQ(valueOf(context, "formula"), "z^3 - a*z + c; a: real = 0.5");
    EXPECT_EQ(valueOf(context, "a"), "0.5");
    EXPECT_TRUE(setControl(context, "a", "0.75"));
    EXPECT_EQ(sharedNumber(context.workspace, "a"), 0.75);
    EXPECT_TRUE(setControl(context, "save formula", "mine"));
    EXPECT_TRUE(setControl(context, "map", "Quadratic family (quadratic)"));
    EXPECT_TRUE(setControl(context, "saved formula", "mine"));
    EXPECT_EQ(valueOf(context, "formula"), "z^3 - a*z + c; a: real = 0.5");
}

TEST(Controls, SetWhatTheySayAndRefuseTheRest) {
    NoHost host;
    StudioContext context(host);
    EXPECT_TRUE(setControl(context, "c.re", "-0.125"));
    EXPECT_EQ(sharedNumber(context.workspace, "c.re"), -0.125);
    EXPECT_TRUE(setControl(context, "layout", "4"));
    EXPECT_EQ(context.workspace.views.size(), 4u);
    // The orbit's start is the workspace's, whatever start the view's scene has.
    context.edit([&](Workspace& w) { w.view().start = {0, 0}; });
    EXPECT_TRUE(setControl(context, "z.re", "0"));
    EXPECT_EQ(sharedNumber(context.workspace, "z.re"), 0);
    EXPECT_TRUE(setControl(context, "z.re", "0.35"));
    EXPECT_TRUE(setControl(context, "colour.reverse", "on"));
    EXPECT_TRUE(context.workspace.view().colour.reverse);
    EXPECT_TRUE(setControl(context, "colour.rule", "gradient"));
    EXPECT_TRUE(setControl(context, "colour.escaped.start", "#102030"));
    EXPECT_EQ(valueOf(context, "colour.escaped.start"), "#102030");
    EXPECT_TRUE(setControl(context, "do undo", ""));
    const Json before = workspaceToJson(context.workspace);
    for (const auto& [id, value] :
         std::vector<std::pair<std::string, std::string>>{{"c.re", "much"},
                                                          {"c.re", "nan"},
                                                          {"c.re", ""},
                                                          {"c.re", "1e300"},
                                                          {"layout", "3"},
                                                          {"iterations", "0"},
                                                          {"colour.reverse", "perhaps"},
                                                          {"none", "1"},
                                                          {"slice.height", "-1"}})
        EXPECT_FALSE(setControl(context, id, value)) << id << " " << value;
    EXPECT_EQ(workspaceToJson(context.workspace), before);
}

}  // namespace
}  // namespace versorium
