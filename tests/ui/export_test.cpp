// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "io/image_files.h"
#include "plate/plate_picture.h"
#include "render/picture.h"
#include "ui/headless_gui.h"
#include "ui/host/worker.h"

namespace versorium {
namespace {

using Bytes = std::vector<unsigned char>;

Workspace coarse(const char* preset) {
    Workspace workspace = workspaceOf(*presetNamed(preset));
    for (Scene& scene : workspace.views) {
        scene.samples = 1;
        scene.iterations = 60;
    }
    return workspace;
}

Expected<Bytes> made(const Workspace& workspace, const ExportOptions& options, Job& job) {
    const Expected<Document> document = exportDocument(workspace, {0.8, 1.2}, options);
    if (!document) return document.status();
    CpuRenderer renderer;
    return computeExport(renderer, {printJson(documentToJson(*document)), "x.png", false}, job);
}

// The command line, given the exported file, makes the same bytes again.
TEST(Export, APlateIsWhatTheCommandLineMakesOfIt) {
    for (const bool all : {false, true}) {
        ExportOptions options;
        options.plate = true;
        options.allViews = all;
        options.millimetres = 89;
        options.dotsPerInch = 100;
        Job job;
        const Expected<Bytes> png = made(coarse("mandelbrot"), options, job);
        ASSERT_TRUE(png.ok()) << png.status().message();
        const Expected<Document> carried = documentFromBytes(*png);
        ASSERT_TRUE(carried.ok());
        EXPECT_EQ(carried->kind, DocumentKind::plate);
        const Expected<PlateDocument> plate = plateFromDocument(*carried);
        ASSERT_TRUE(plate.ok()) << plate.status().message();
        EXPECT_EQ(plate->plate.panels.size(), all ? 2u : 1u);
        CpuRenderer renderer;
        const Expected<PlateFile> again = renderPlate(renderer, *plate, job);
        ASSERT_TRUE(again.ok());
        EXPECT_TRUE(again->png == *png);
    }
}

TEST(Export, APlateCanBeMadeOfEveryPreset) {
    for (const std::string& name : presetNames()) {
        ExportOptions options;
        options.plate = options.allViews = true;
        options.millimetres = 178;
        const Expected<Document> document =
            exportDocument(workspaceOf(*presetNamed(name)), {1, 1.5}, options);
        ASSERT_TRUE(document.ok()) << name;
        const Expected<PlateDocument> plate = plateFromDocument(*document);
        EXPECT_TRUE(plate.ok()) << name << ": " << plate.status().message();
    }
}

TEST(Export, ABarePictureKeepsItsAlpha) {
    Workspace workspace = coarse("mandelbrot");
    Colouring& colour = workspace.view().colour;
    colour.rule = ColourRule::gradient;
    colour.escaped.start.a = colour.escaped.finish.a = 0.25;
    ExportOptions options;
    options.width = 40;
    Job job;
    const Expected<Bytes> png = made(workspace, options, job);
    ASSERT_TRUE(png.ok()) << png.status().message();
    const Expected<Raster<unsigned char>> pixels = readImage(*png);
    ASSERT_TRUE(pixels.ok());
    EXPECT_EQ(pixels->size().width, 40);
    EXPECT_EQ(pixels->size().height, 50);
    // The corner is far outside of the set: a quarter of 255 is 63.75.
    EXPECT_EQ(pixels->at(0, 0, 3), 64);
}

TEST(Export, WhatIsCancelledSaysSo) {
    Job job;
    job.cancel();
    ExportOptions options;
    options.width = 64;
    for (const bool plate : {false, true}) {
        options.plate = plate;
        const Expected<Bytes> png = made(coarse("mandelbrot"), options, job);
        ASSERT_FALSE(png.ok());
        EXPECT_EQ(png.status().kind(), ErrorKind::cancelled) << png.status().message();
    }
    SilentHost host;
    StudioContext context(host);
    host.outcome = Status::cancelled();
    context.takeExport();
    EXPECT_EQ(context.notices.last(), "The export was cancelled; nothing was written");
}

TEST(Export, IsAskedForAsTheDialogSays) {
    SilentHost host;
    StudioContext context(host);
    context.copyImage();
    ASSERT_EQ(host.exports.size(), 1u);
    EXPECT_TRUE(host.exports[0].toClipboard);
    context.exporting.plate = true;
    context.startExport();
    ASSERT_EQ(host.exports.size(), 2u);
    EXPECT_FALSE(host.exports[1].toClipboard);
    EXPECT_EQ(host.exports[1].name, "quadratic-plate.png");
    context.exporting.dotsPerInch = 2400;
    context.exporting.millimetres = 2000;
    context.startExport();
    EXPECT_EQ(host.exports.size(), 2u);
    EXPECT_NE(context.notices.last().find("too large"), std::string::npos);
}

}  // namespace
}  // namespace versorium
