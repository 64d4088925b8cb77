// SPDX-License-Identifier: MIT
#include "ui/host/worker.h"

#include <chrono>

#include "colour/srgb.h"
#include "i18n/language.h"
#include "io/grid_files.h"
#include "plate/plate_picture.h"
#include "render/movie.h"

namespace versorium {
namespace {

using Clock = std::chrono::steady_clock;
double secondsSince(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

// What one job works with.
struct Work {
    Worker& worker;
    Scene scene;
    Job& job;
    Clock::time_point begin = Clock::now();

    // Goes on with the counts that the picture is then drawn from.
    Status count(Size size, double portion, int& members) {
        const Expected<std::shared_ptr<AveragedMap>> map = worker.averaged.of(scene, size);
        if (!map) return map.status();
        if (Status status =
                worker.averaged.count(**map, scene, portion, worker.renderer.binder(), job);
            !status.ok())
            return status;
        members = static_cast<int>((*map)->members());
        worker.renderer.useAveraged(*map);
        return {};
    }

    Status draw(Size size, std::vector<unsigned char>& rgba) {
        Frame frame;
        // Live pictures are looked at, not measured: the fast kernels draw them.
        const RenderOptions options{Flavour::fast, true, std::max(1.0, size.height / 400.0)};
        if (Status status = worker.renderer.render(scene, size, options, job, frame); !status.ok())
            return status;
        rgba = std::move(encodeSrgb(frame.colour).values());
        return {};
    }

    // Of an averaged map some members are counted first, where there is a portion.
    Status picture(Size size, int samples, double portion, int least, PictureResult& result) {
        scene.samples = samples;
        worker.renderer.useAveraged(nullptr);
        if (portion > 0 && showsEnsemble(scene)) {
            if (Status status = count(size, portion, result.members); !status.ok()) return status;
            result.seconds = secondsSince(begin);
            if (result.members < least) return {};
        }
        const long long before = worker.renderer.measurements();
        Status status = draw(size, result.rgba);
        if (result.members == 0) result.seconds = secondsSince(begin);
        result.recoloured = worker.renderer.measurements() == before;
        result.kept = worker.renderer.keptLast();
        return status;
    }

    Status run(const PictureJob& wanted, WorkResult& result) {
        return picture(wanted.size, wanted.samples, wanted.portion, wanted.least,
                       std::get<PictureResult>(result));
    }
    Status run(const ThumbnailJob& wanted, WorkResult& result) {
        PictureResult made;
        Status status = picture(wanted.size, wanted.samples, wanted.portion, 0, made);
        std::get<ThumbnailResult>(result).rgba = std::move(made.rgba);
        return status;
    }
    Status run(const GridJob&, WorkResult& result) {
        const Expected<std::shared_ptr<const Grid>> grid =
            worker.renderer.binder().grid(scene, job);
        if (!grid) return grid.status();
        std::get<GridResult>(result).bytes = packGrid(**grid);
        return {};
    }
};

Expected<Scene> sceneOf(const std::string& body, const Assets& assets) {
    const Expected<Json> json = parseJson(body);
    if (!json) return json.status();
    return sceneWithAssets(*json, assets);
}

}  // namespace

WorkAnswer compute(Worker& worker, const WorkRequest& request, Job& job) {
    WorkAnswer answer = answerTo(request.id, request.job);
    Assets assets = request.assets;
    answer.missing = worker.assets.fill(assets);
    if (!answer.missing.empty()) {
        answer.message = trLater("files of the scene are missing where it is computed");
        return answer;
    }
    Expected<Scene> scene = sceneOf(request.scene, assets);
    if (!scene) {
        answer.message = scene.status().message();
        return answer;
    }
    Work work{worker, std::move(*scene), job};
    const Status status = std::visit(
        [&](const auto& wanted) { return work.run(wanted, answer.result); }, request.job);
    if (!status.ok()) {
        answer.message = status.message();
        bytesOf(answer.result).clear();
    }
    return answer;
}

Expected<std::vector<unsigned char>> computeExport(CpuRenderer& renderer,
                                                   const ExportRequest& request, Job& job) {
    Expected<Document> document = documentFromBytes(
        {reinterpret_cast<const unsigned char*>(request.document.data()), request.document.size()});
    if (!document) return document.status();
    document->assets.insert(request.assets.begin(), request.assets.end());
    if (document->kind == DocumentKind::plate) {
        const Expected<PlateDocument> plate = plateFromDocument(*document);
        if (!plate) return plate.status();
        Expected<PlateFile> file = renderPlate(renderer, *plate, job);
        if (!file) return file.status();
        return std::move(file->png);
    }
    if (document->kind == DocumentKind::animation) {
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
