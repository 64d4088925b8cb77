// SPDX-License-Identifier: MIT
#include "render/movie.h"

#include "base/embedded_json.h"
#include "io/zip.h"
#include "scene/parts.h"

namespace versorium {
namespace {

constexpr std::string_view kAnimations = "animations/";

}  // namespace

std::vector<std::string> animationNames() { return embeddedJsonNames(kAnimations); }

Expected<Movie> animationNamed(const std::string& name) {
    const Json json = embeddedJson(kAnimations, name);
    if (json.is_null())
        return Status::usage("no animation is named \"" + name +
                             "\"; there are: " + embeddedJsonList(kAnimations));
    Expected<Document> document = documentFromJson(json);
    if (!document) return document.status().in("animation " + name);
    Expected<Movie> movie = movieFromDocument(*document);
    return movie ? std::move(movie) : movie.status().in("animation " + name);
}

Expected<Movie> movieFromDocument(const Document& document) {
    if (document.kind != DocumentKind::animation)
        return Status::data("an animation is expected, and this is a " +
                            std::string(wordOf(document.kind)));
    Expected<Animation> animation = animationFromJson(document.body);
    if (!animation) return animation.status();
    takeAssets(animation->scene, document.assets);
    Expected<PictureOptions> options = pictureOptions(document);
    if (!options) return options.status();
    return Movie{std::move(*animation), *options};
}

Document documentOfMovie(const Movie& movie) {
    Document document = pictureDocument(movie.animation.scene, movie.options);
    document.kind = DocumentKind::animation;
    Animation bare = movie.animation;
    bare.scene.assets.clear();
    document.body = animationToJson(bare);
    return document;
}

std::string frameName(int frame) {
    const std::string digits = std::to_string(frame + 1);
    return "frame-" + std::string(digits.size() < 5 ? 5 - digits.size() : 0, '0') + digits + ".png";
}

Document frameDocument(const Movie& movie, int frame) {
    return pictureDocument(frameOf(movie.animation, frame), movie.options);
}

Expected<std::vector<unsigned char>> renderFrame(CpuRenderer& renderer, const Movie& movie,
                                                 int frame, Job& job) {
    return renderPicture(renderer, frameOf(movie.animation, frame), movie.options, job);
}

Expected<std::vector<unsigned char>> renderArchive(CpuRenderer& renderer, const Movie& movie,
                                                   Job& job) {
    const int frames = movie.animation.motion.frames();
    ZipWriter archive;
    const std::string text = printJson(documentToJson(documentOfMovie(movie)));
    Status status = archive.add("animation.json",
                                {reinterpret_cast<const unsigned char*>(text.data()), text.size()});
    for (int frame = 0; frame < frames && status.ok(); ++frame) {
        job.setPart(1.0 * frame / frames, 1.0 * (frame + 1) / frames);
        Expected<std::vector<unsigned char>> png = renderFrame(renderer, movie, frame, job);
        status = png ? archive.add(frameName(frame), *png) : png.status();
    }
    if (!status.ok()) return status;
    return archive.finish();
}

}  // namespace versorium
