// SPDX-License-Identifier: MIT
// The core's C interface for JavaScript. Scenes go in as JSON text, buffers come back. Every call
// returns 0, or the number of an ErrorKind with a message. What a call leaves in its instance stays
// until the next call on it. One thread at a time may use an instance.
#include <emscripten/emscripten.h>

#include <string_view>

#include "io/npy.h"
#include "render/picture.h"

namespace {

using namespace versorium;

struct Instance {
    CpuRenderer renderer;
    int threads = 0;
    std::vector<unsigned char> bytes;
    std::string message;

    int done(Expected<std::vector<unsigned char>> result) {
        bytes.clear();
        message.clear();
        if (result)
            bytes = std::move(*result);
        else
            message = result.status().message();
        return static_cast<int>(result.status().kind());
    }
};

struct Opened {
    Scene scene;
    PictureOptions options;
};

// A scene, or a document with a scene; sizes of 0 leave the document's own.
Expected<Opened> open(const char* text, int width, int height) {
    const std::string_view view(text);
    Expected<Document> document =
        documentFromBytes({reinterpret_cast<const unsigned char*>(view.data()), view.size()});
    if (!document) return document.status();
    if (document->kind != DocumentKind::scene)
        return Status::data("this is a " + std::string(wordOf(document->kind)) + ", not a scene");
    Expected<Scene> scene = sceneWithAssets(document->body, document->assets);
    if (!scene) return scene.status();
    Expected<PictureOptions> options = pictureOptions(*document);
    if (!options) return options.status();
    if (width != 0 || height != 0) options->size = {width, height};
    return Opened{std::move(*scene), *options};
}

Expected<std::vector<unsigned char>> render(Instance& instance, const char* text, int width,
                                            int height) {
    Expected<Opened> opened = open(text, width, height);
    if (!opened) return opened.status();
    Job job(instance.threads);
    return renderPicture(instance.renderer, opened->scene, opened->options, job);
}

Expected<std::vector<unsigned char>> measure(Instance& instance, const char* text,
                                             const char* field, int width, int height) {
    const FieldInfo* info = findField(field);
    if (!info) return Status::usage("no field is named \"" + std::string(field) + "\"");
    Expected<Opened> opened = open(text, width, height);
    if (!opened) return opened.status();
    const PictureOptions& options = opened->options;
    Job job(instance.threads);
    std::vector<Raster<double>> rasters;
    const RenderOptions how{options.flavour, options.shortcuts, 1};
    if (Status status = instance.renderer.measure(
            opened->scene, pictureSize(opened->scene, options), {info->field}, how, job, rasters);
        !status.ok())
        return status;
    return writeNpy(rasters.front());
}

// The scene of a preset, every default explicit.
Expected<std::vector<unsigned char>> preset(const char* name) {
    Expected<Scene> scene = presetNamed(name);
    if (!scene) return scene.status();
    const std::string text = printJson(sceneToJson(*scene));
    return std::vector<unsigned char>(text.begin(), text.end());
}

}  // namespace

extern "C" {

// threads: 0 means one for each processor; without threads in the build it means nothing.
EMSCRIPTEN_KEEPALIVE Instance* versorium_open(int threads) {
    auto* instance = new Instance;
    instance->threads = threads;
    return instance;
}
EMSCRIPTEN_KEEPALIVE void versorium_close(Instance* instance) { delete instance; }

// Leaves a PNG that carries the scene.
EMSCRIPTEN_KEEPALIVE int versorium_render(Instance* instance, const char* scene, int width,
                                          int height) {
    return instance->done(render(*instance, scene, width, height));
}
// Leaves a field as .npy: float64, (height, width) or (height, width, channels).
EMSCRIPTEN_KEEPALIVE int versorium_measure(Instance* instance, const char* scene, const char* field,
                                           int width, int height) {
    return instance->done(measure(*instance, scene, field, width, height));
}
// Leaves the JSON of a preset.
EMSCRIPTEN_KEEPALIVE int versorium_preset(Instance* instance, const char* name) {
    return instance->done(preset(name));
}

EMSCRIPTEN_KEEPALIVE const unsigned char* versorium_bytes(const Instance* instance) {
    return instance->bytes.data();
}
EMSCRIPTEN_KEEPALIVE int versorium_size(const Instance* instance) {
    return static_cast<int>(instance->bytes.size());
}
EMSCRIPTEN_KEEPALIVE const char* versorium_message(const Instance* instance) {
    return instance->message.c_str();
}

}  // extern "C"
