// SPDX-License-Identifier: MIT
// The same context in a page, on the canvas with the id "canvas".
#include <emscripten/html5.h>

#include "headless_context.h"

namespace versorium {
namespace {

EMSCRIPTEN_WEBGL_CONTEXT_HANDLE context = 0;

}  // namespace

std::string makeHeadlessContext() {
    EmscriptenWebGLContextAttributes attributes;
    emscripten_webgl_init_context_attributes(&attributes);
    attributes.majorVersion = 2;
    context = emscripten_webgl_create_context("#canvas", &attributes);
    if (context <= 0) return "the browser gives no WebGL 2";
    emscripten_webgl_make_context_current(context);
    emscripten_webgl_enable_extension(context, "WEBGL_debug_renderer_info");
    return "";
}

void loseHeadlessContext() { emscripten_webgl_destroy_context(context); }

}  // namespace versorium
