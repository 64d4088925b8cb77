// SPDX-License-Identifier: MIT
#include "ui/host/picture_worker.h"

#include <chrono>

#include "colour/srgb.h"
#include "io/grid_files.h"
#include "plate/plate_picture.h"
#include "render/movie.h"

namespace versorium {
namespace {

Expected<Scene> sceneOfText(const std::string& text) {
    Expected<Document> document =
        documentFromBytes({reinterpret_cast<const unsigned char*>(text.data()), text.size()});
    if (!document) return document.status();
    return sceneWithAssets(document->body, document->assets);
}

using Clock = std::chrono::steady_clock;
double secondsSince(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

// Goes on with the counts that the picture is then drawn from.
Status count(PictureMaker& maker, const Scene& scene, const PictureRequest& request, Job& job,
             PictureAnswer& answer) {
    const Expected<std::shared_ptr<AveragedMap>> map = maker.averaged.of(scene, request.size);
    if (!map) return map.status();
    if (Status status =
            maker.averaged.count(**map, scene, request.portion, maker.renderer.binder(), job);
        !status.ok())
        return status;
    answer.members = static_cast<int>((*map)->members());
    maker.renderer.useAveraged(*map);
    return {};
}

}  // namespace

PictureAnswer computePicture(PictureMaker& maker, const PictureRequest& request, Job& job) {
    CpuRenderer& renderer = maker.renderer;
    PictureAnswer answer;
    answer.view = request.view;
    answer.id = request.id;
    answer.size = request.size;
    const auto begin = Clock::now();
    Expected<Scene> scene = sceneOfText(request.scene);
    if (!scene) {
        answer.message = scene.status().message();
        return answer;
    }
    if (request.samples == 0) {
        const Expected<std::shared_ptr<const Grid>> grid = renderer.binder().grid(*scene, job);
        if (!grid)
            answer.message = grid.status().message();
        else
            answer.rgba = packGrid(**grid);
        return answer;
    }
    scene->samples = request.samples;
    renderer.useAveraged(nullptr);
    if (request.portion > 0 && showsEnsemble(*scene)) {
        if (Status status = count(maker, *scene, request, job, answer); !status.ok()) {
            answer.message = status.message();
            return answer;
        }
        answer.seconds = secondsSince(begin);
        if (answer.members < request.least) return answer;
    }
    Frame frame;
    // Live pictures are looked at, not measured: the fast kernels draw them.
    const RenderOptions options{Flavour::fast, true, std::max(1.0, request.size.height / 400.0)};
    if (Status status = renderer.render(*scene, request.size, options, job, frame); !status.ok()) {
        answer.message = status.message();
        return answer;
    }
    answer.rgba = std::move(encodeSrgb(frame.colour).values());
    if (answer.members == 0) answer.seconds = secondsSince(begin);
    return answer;
}

Expected<std::vector<unsigned char>> computeExport(CpuRenderer& renderer,
                                                   const ExportRequest& request, Job& job) {
    Expected<Document> document = documentFromBytes(
        {reinterpret_cast<const unsigned char*>(request.document.data()), request.document.size()});
    if (!document) return document.status();
    if (document->kind == "plate") {
        const Expected<PlateDocument> plate = plateFromDocument(*document);
        if (!plate) return plate.status();
        Expected<PlateFile> file = renderPlate(renderer, *plate, job);
        if (!file) return file.status();
        return std::move(file->png);
    }
    if (document->kind == "animation") {
        const Expected<Movie> movie = movieFromDocument(*document);
        if (!movie) return movie.status();
        return renderArchive(renderer, *movie, job);
    }
    Expected<Scene> scene = sceneWithAssets(document->body, document->assets);
    if (!scene) return scene.status();
    Expected<PictureOptions> options = pictureOptions(*document);
    if (!options) return options.status();
    return renderPicture(renderer, *scene, *options, job);
}

}  // namespace versorium
