// SPDX-License-Identifier: MIT
// The studio in a page. page.mjs calls page_start() once and page_frame() for every frame; a worker
// of the page runs the same program and calls only what stands in page_worker.cpp.
#include <emscripten/emscripten.h>
#include <emscripten/html5.h>

#include <algorithm>
#include <optional>

#include "i18n/language.h"
#include "imgui.h"
#include "page_host.h"
#include "page_input.h"
#include "ui/backend/gl_canvas.h"
#include "ui/backend/software_canvas.h"
#include "ui/studio.h"

// clang-format off
EM_JS(void, page_js_cursor, (int cursor), { Module.page.cursor(cursor); });
EM_JS(void, page_js_typing, (int wanted), { Module.page.typing(wanted !== 0); });
EM_JS(void, page_js_show, (const unsigned char* rgba, int width, int height), {
    Module.page.show(HEAPU8.subarray(rgba, rgba + 4 * width * height), width, height);
});
// clang-format on

namespace {

using namespace versorium;

// Frames after the last event: ImGui needs up to three until hover and focus stand still.
constexpr int kSettle = 4;

struct Page {
    PageHost host;
    Studio studio{host};
    // One of them: the second where there is no WebGL 2.
    std::optional<GlCanvas> graphics;
    std::optional<SoftwareCanvas> processor;
    float scale = 0;  // that letters were loaded for
    int settle = kSettle;
    int frames = 0;
    int cursor = -1;
    bool typing = false;
    bool lost = false;
    double last = 0;                      // seconds, of the frame before
    std::vector<unsigned char> incoming;  // of an answer
    std::string text;                     // the last one that JavaScript was given
};

// There is none in a worker.
Page* page = nullptr;

const char* kept(std::string text) {
    page->text = std::move(text);
    return page->text.c_str();
}

void setClipboardText(void*, const char* text) { page->host.setClipboard(text); }
const char* clipboardText(void*) { return kept(page->host.clipboard()); }

bool openContext() {
    EmscriptenWebGLContextAttributes attributes;
    emscripten_webgl_init_context_attributes(&attributes);
    attributes.majorVersion = 2;
    attributes.alpha = false;
    attributes.depth = false;
    attributes.antialias = false;
    const EMSCRIPTEN_WEBGL_CONTEXT_HANDLE context =
        emscripten_webgl_create_context("#canvas", &attributes);
    if (context <= 0 || emscripten_webgl_make_context_current(context) != EMSCRIPTEN_RESULT_SUCCESS)
        return false;
    // The device's name: whether it is one, or a driver that computes in software.
    emscripten_webgl_enable_extension(context, "WEBGL_debug_renderer_info");
    return true;
}

void tellPage() {
    const ImGuiIO& io = ImGui::GetIO();
    const int cursor = ImGui::GetMouseCursor();
    if (cursor != page->cursor) page_js_cursor(cursor);
    if (io.WantTextInput != page->typing) page_js_typing(io.WantTextInput);
    page->cursor = cursor;
    page->typing = io.WantTextInput;
}

void takeFonts() {
    if (page->graphics) page->graphics->takeFonts();
    if (page->processor) page->processor->takeFonts();
}

void draw(int width, int height) {
    ImGuiIO& io = ImGui::GetIO();
    const double now = page->host.now();
    io.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
    io.DeltaTime = static_cast<float>(std::clamp(now - page->last, 1e-4, 0.1));
    page->last = now;
    ImGui::NewFrame();
    page->studio.frame();
    ImGui::Render();
    ++page->frames;
    if (page->graphics) return page->graphics->draw(*ImGui::GetDrawData(), {width, height});
    page->processor->draw(*ImGui::GetDrawData(), {width, height});
    page_js_show(page->processor->rgba().data(), width, height);
}

}  // namespace

extern "C" {

// 0 where the browser gives no WebGL 2: the CPU then draws, and page.show() takes the pixels.
EMSCRIPTEN_KEEPALIVE int page_start(int apple) {
    const bool openGl = openContext();
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.BackendPlatformName = "page";
    io.BackendFlags |= ImGuiBackendFlags_HasMouseCursors;
    io.ConfigMacOSXBehaviors = apple != 0;
    io.SetClipboardTextFn = setClipboardText;
    io.GetClipboardTextFn = clipboardText;
    page = new Page;
    if (openGl)
        page->graphics.emplace();
    else
        page->processor.emplace();
    return openGl ? 1 : 0;
}

// Draws. Returns 0 when it may rest until the next event, 1 to be called for the next frame, 2 to
// be called again in a moment.
EMSCRIPTEN_KEEPALIVE int page_frame(int width, int height, float scale) {
    if (page->lost || width < 1 || height < 1) return 0;
    if (scale != page->scale || page->studio.wantsPrepare()) {
        page->studio.prepare(scale);
        page->scale = scale;
        takeFonts();
        page->settle = kSettle;
    }
    if (takeInput()) page->settle = kSettle;
    draw(width, height);
    tellPage();
    if (page->settle > 0) --page->settle;
    if (page->settle > 0 || page->studio.busy()) return 1;
    return page->typing ? 2 : 0;  // the text cursor blinks
}
EMSCRIPTEN_KEEPALIVE void page_wake() { page->settle = kSettle; }

// What was made in a lost context is let go while it is lost: the one that is restored would take
// the old names for another's and report an error.
EMSCRIPTEN_KEEPALIVE void page_context_lost() {
    page->lost = true;
    if (page->graphics) page->graphics->contextLost();
    page->studio.contextLost();
}
EMSCRIPTEN_KEEPALIVE void page_context_restored() {
    page->lost = false;
    takeFonts();
    page->settle = kSettle;
}

// An answer of a worker: its bytes are written to where page_answer_begin points.
EMSCRIPTEN_KEEPALIVE unsigned char* page_answer_begin(int size) {
    page->incoming.resize(static_cast<std::size_t>(size));
    return page->incoming.data();
}
EMSCRIPTEN_KEEPALIVE void page_answer_end(const char* head) {
    page->settle = kSettle;
    if (Expected<WorkAnswer> answer = answerFromHead(head, std::move(page->incoming)))
        page->host.answer(std::move(*answer));
    page->incoming.clear();
}
// What a request gets whose worker broke.
EMSCRIPTEN_KEEPALIVE void page_work_failed(const char* head, const char* message) {
    page->settle = kSettle;
    const Expected<WorkRequest> request = requestFromHead(head, "");
    if (!request) return;
    WorkAnswer answer = answerTo(request->id, request->job);
    answer.message = message;
    page->host.answer(std::move(answer));
}

// An asset that a worker has not; null where nobody wants it any more.
EMSCRIPTEN_KEEPALIVE const unsigned char* page_asset(const char* hash) {
    const Asset* asset = page->host.asset(hash);
    return asset ? asset->bytes.data() : nullptr;
}
EMSCRIPTEN_KEEPALIVE int page_asset_size(const char* hash) {
    const Asset* asset = page->host.asset(hash);
    return asset ? static_cast<int>(asset->bytes.size()) : 0;
}
EMSCRIPTEN_KEEPALIVE const char* page_asset_name(const char* hash) {
    const Asset* asset = page->host.asset(hash);
    return kept(asset ? asset->name : std::string());
}

EMSCRIPTEN_KEEPALIVE void page_export_progress(double progress) {
    page->host.exportMoved(progress);
}
EMSCRIPTEN_KEEPALIVE void page_export_end(int made, const char* text) {
    if (made)
        page->host.exportEnded(std::string(text));
    else
        page->host.exportEnded(Status::inputOutput(text));
    page->settle = kSettle;
}

EMSCRIPTEN_KEEPALIVE void page_paste(const char* text) { page->host.pasted(text); }

// These return why it failed, or nothing.
EMSCRIPTEN_KEEPALIVE const char* page_open(const char* name, const unsigned char* bytes, int size) {
    page->settle = kSettle;
    return kept(
        trMessage(page->studio.openBytes(name, {bytes, static_cast<std::size_t>(size)}).message()));
}
EMSCRIPTEN_KEEPALIVE const char* page_open_fragment(const char* fragment) {
    page->settle = kSettle;
    return kept(trMessage(page->studio.openFragment(fragment).message()));
}

// Two fingers of a touch screen, in pixels of the canvas; 0 where they are on no view.
EMSCRIPTEN_KEEPALIVE int page_pinch(float x0, float y0, float x1, float y1, double factor) {
    page->settle = kSettle;
    return page->studio.pinch(x0, y0, x1, y1, factor) ? 1 : 0;
}

// JSON: ui/controls/controls.h.
EMSCRIPTEN_KEEPALIVE const char* page_controls() { return kept(page->studio.controls()); }
EMSCRIPTEN_KEEPALIVE int page_set_control(const char* id, const char* value) {
    page->settle = kSettle;
    return page->studio.setControl(id, value) ? 1 : 0;
}
EMSCRIPTEN_KEEPALIVE void page_mark_view(int view) {
    page->settle = kSettle;
    page->studio.focusView(view);
}

// The lesson's pane, as JSON and by its buttons: ui/session/lessons.h.
EMSCRIPTEN_KEEPALIVE const char* page_lesson() { return kept(page->studio.lesson()); }
EMSCRIPTEN_KEEPALIVE int page_lesson_do(const char* action, const char* value) {
    page->settle = kSettle;
    return page->studio.lessonDo(action, value) ? 1 : 0;
}
EMSCRIPTEN_KEEPALIVE const char* page_lesson_ring() { return kept(page->studio.lessonRing()); }

// What the page itself says, in the language of the studio.
EMSCRIPTEN_KEEPALIVE const char* page_tr(const char* english) {
    return kept(tr(std::string_view(english)));
}

EMSCRIPTEN_KEEPALIVE const char* page_fragment() { return kept(page->studio.fragment()); }
EMSCRIPTEN_KEEPALIVE int page_frames_drawn() { return page->frames; }
EMSCRIPTEN_KEEPALIVE int page_typing() { return page->typing ? 1 : 0; }
EMSCRIPTEN_KEEPALIVE int page_finished() { return page->studio.finished() ? 1 : 0; }
EMSCRIPTEN_KEEPALIVE void page_stop() { page->studio.stopAnimation(); }
EMSCRIPTEN_KEEPALIVE int page_pictures_taken() { return page->studio.pictures(); }

}  // extern "C"
