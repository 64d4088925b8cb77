// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>

#include "io/document.h"
#include "io/png.h"
#include "plate/plate_picture.h"
#include "render/bind.h"
#include "ui/dialogs/dialogs.h"
#include "ui/headless_gui.h"
#include "ui/host/worker.h"
#include "ui/session/open_file.h"

namespace versorium {
namespace {

std::span<const unsigned char> bytesOf(const std::string& text) {
    return {reinterpret_cast<const unsigned char*>(text.data()), text.size()};
}

// A tetrahedron.
const std::string kMesh =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

std::vector<unsigned char> image() {
    Raster<unsigned char> pixels({16, 16}, 3);
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x)
            for (int c = 0; c < 3; ++c)
                pixels.at(x, y, c) = (x - 8) * (x - 8) + (y - 8) * (y - 8) < 30 ? 0 : 255;
    return *encodePng(pixels);
}

TEST(Open, AMeshAndAnImageBecomeTheShape) {
    for (const bool mesh : {true, false})
        for (const bool takesOne : {true, false}) {
            SilentHost host;
            StudioContext context(host);
            if (takesOne) context.newMap("shape-modulus-power");
            const std::vector<unsigned char> picture = image();
            const std::string name = mesh ? "tetra.OBJ" : "disc.png";
            const Status status =
                openBytes(context, "/some/where/" + name,
                          mesh ? bytesOf(kMesh) : std::span<const unsigned char>(picture));
            ASSERT_TRUE(status.ok()) << status.message();
            EXPECT_EQ(context.workspace.views[0].map,
                      takesOne ? "shape-modulus-power" : "shape-modulus");
            EXPECT_NE(context.notices.last().find(name), std::string::npos)
                << context.notices.last();
            // The scene holds all it needs, in every view, there and back.
            for (const Scene& scene : context.workspace.views) {
                const Expected<Scene> again = sceneFromJson(sceneToJson(scene));
                ASSERT_TRUE(again.ok()) << again.status().message();
                Binder binder;
                Job job;
                const Expected<OrbitProgram> program = binder.bind(*again, job);
                EXPECT_TRUE(program.ok()) << program.status().message();
            }
            EXPECT_TRUE(workspaceFromJson(workspaceToJson(context.workspace)).ok());
            context.undo();
            EXPECT_EQ(context.workspace.views[0].map,
                      takesOne ? "shape-modulus-power" : "quadratic");
        }
}

// Orbit and probe wait for the shape's grid, which is made beside the studio.
TEST(Open, AMeshComesAsAGridFromTheHost) {
    SilentHost host;
    StudioContext context(host);
    const std::string mesh =
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
    ASSERT_TRUE(openBytes(context, "tetra.obj",
                          {reinterpret_cast<const unsigned char*>(mesh.data()), mesh.size()})
                    .ok());
    EXPECT_EQ(context.bound.orbitProgram(), nullptr);
    EXPECT_EQ(context.bound.program(0), nullptr);
    ASSERT_EQ(host.requests.size(), 1u) << "one request for all views";
    EXPECT_TRUE(std::holds_alternative<GridJob>(host.requests[0].job));
    Worker worker;
    Job job(1);
    WorkAnswer answer = compute(worker, host.requests[0], job);
    EXPECT_EQ(answer.message, "");
    context.takeGrid(answer);
    const OrbitProgram* program = context.bound.orbitProgram();
    ASSERT_NE(program, nullptr);
    const std::vector<double>& values = program->field->grid()->values;
    EXPECT_LT(*std::min_element(values.begin(), values.end()), 0);
    EXPECT_GT(program->field->at(3.0, 0.0, 0.0), 1);
    EXPECT_GT(context.bound.orbit().size(), 1u);
    context.bound.program(0);
    EXPECT_EQ(host.requests.size(), 1u);
    // Another resolution is another grid; one that cannot be made is asked for once.
    context.edit([&](Workspace& w) {
        for (Scene& scene : w.views) scene.shape.resolution = 20;
    });
    EXPECT_EQ(context.bound.orbitProgram(), nullptr);
    ASSERT_EQ(host.requests.size(), 2u);
    answer = answerTo(host.requests[1].id, GridJob{});
    answer.message = "no";
    context.takeGrid(answer);
    EXPECT_EQ(context.bound.orbitProgram(), nullptr);
    EXPECT_EQ(host.requests.size(), 2u);
}

TEST(Open, APaletteBecomesTheMarkedViewsOwn) {
    SilentHost host;
    StudioContext context(host);
    const std::string text =
        R"({"name": "mine", "kind": "sequential", "stops": ["#000000", "#ff0000"]})";
    ASSERT_TRUE(openBytes(context, "mine.json", bytesOf(text)).ok());
    EXPECT_EQ(context.workspace.view().colour.palette, "mine");
    EXPECT_FALSE(context.workspace.view().colour.ownPalette.is_null());
    EXPECT_TRUE(workspaceFromJson(workspaceToJson(context.workspace)).ok());
    // What the editor copies is what can be pasted.
    Workspace before = context.workspace;
    context.newMap("newton");
    host.copied = printJson(before.view().colour.ownPalette);
    context.paste();
    EXPECT_EQ(context.workspace.view().colour.ownPalette, before.view().colour.ownPalette);
}

TEST(Open, LinksScenesPlatesAndRootsAreToldApart) {
    SilentHost host;
    StudioContext context(host);
    const Workspace newton = workspaceOf(*presetNamed("newton"));
    ASSERT_TRUE(
        openText(context, "  https://example.org/x#" + *workspaceToLink(newton) + "\n").ok());
    EXPECT_EQ(context.workspace.views[0].map, "newton");
    ASSERT_TRUE(openText(context, sceneToJson(*presetNamed("logistic")).dump()).ok());
    EXPECT_EQ(context.workspace.views[0].map, "logistic");
    const PlateDocument plate = *plateNamed("quadratic");
    ASSERT_TRUE(openText(context, plateToJson(plate.plate).dump()).ok());
    EXPECT_EQ(context.workspace.views[0].map, "quadratic");
    const std::string roots =
        R"({"roots": [{"q": [0, 1, 0, 0]}, {"q": [1, 0, 0, 0], "power": 2}]})";
    EXPECT_FALSE(openText(context, roots).ok());
    context.newMap("newton");
    ASSERT_TRUE(openText(context, roots).ok());
    EXPECT_EQ(context.workspace.views[1].lists.begin()->second.roots.size(), 2u);
}

TEST(Open, WhatIsNothingIsRefusedAndChangesNothing) {
    SilentHost host;
    StudioContext context(host);
    const Json before = workspaceToJson(context.workspace);
    const std::pair<const char*, std::string> wrong[] = {{"a.json", "{"},
                                                         {"a.json", "{\"map\": \"none\"}"},
                                                         {"a.obj", "nothing"},
                                                         {"a.ply", "ply\nwhat"},
                                                         {"a.stl", "solid"},
                                                         {"a.f3d", "1234"},
                                                         {"a.jpg", "JFIF"},
                                                         {"a.png", "\x89PNG\r\n"},
                                                         {"a.p4d", "...."},
                                                         {"a.unknown", "hello"},
                                                         {"", ""},
                                                         {"a.json", R"({"stops": [1, 2]})"}};
    for (const auto& [name, text] : wrong) {
        const Status status = openBytes(context, name, bytesOf(text));
        EXPECT_FALSE(status.ok()) << name << ": " << text;
        EXPECT_FALSE(status.message().empty());
    }
    for (const char* text : {"", "  \n", "hello", "v1:AAAA", "/no/such/file"})
        EXPECT_FALSE(openText(context, text).ok()) << text;
    EXPECT_EQ(workspaceToJson(context.workspace), before);
}

class FolderHost : public SilentHost {
  public:
    Expected<Folder> listFolder(const std::string& path) override {
        if (path == "/a/b") return Folder{"/a/b", {{"..", true}, {"x.json", false}}};
        if (path.empty() || path == "/a" || path == "/a/b/..")
            return Folder{"/a", {{"b", true}, {"notes.txt", false}, {"y.json", false}}};
        return Status::inputOutput("no");
    }
    Expected<std::vector<unsigned char>> readFile(const std::string& path) override {
        read = path;
        const std::string text = sceneToJson(*presetNamed("logistic")).dump();
        return std::vector<unsigned char>(text.begin(), text.end());
    }
    std::string read;
};

TEST(Open, TheListOfFilesGoesByKeys) {
    FolderHost host;
    HeadlessGui gui;
    StudioContext context(host);
    const auto dialog = [&] { drawOpenFile(context); };
    const auto press = [&](ImGuiKey key) {
        ImGui::GetIO().AddKeyEvent(key, true);
        gui.frame(dialog);
        ImGui::GetIO().AddKeyEvent(key, false);
        gui.frame(dialog);
    };
    context.chooseFile();
    for (int k = 0; k < 3; ++k) gui.frame(dialog);
    // What cannot be opened is not offered.
    ASSERT_EQ(context.panels.of<FileList>().folder.entries.size(), 2u);
    press(ImGuiKey_Enter);
    EXPECT_EQ(context.panels.of<FileList>().folder.path, "/a/b");
    press(ImGuiKey_DownArrow);
    press(ImGuiKey_Enter);
    EXPECT_EQ(host.read, "/a/b/x.json");
    EXPECT_FALSE(context.dialogs.files);
    EXPECT_EQ(context.workspace.views[0].map, "logistic");
}

}  // namespace
}  // namespace versorium
