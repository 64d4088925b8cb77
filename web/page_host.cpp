// SPDX-License-Identifier: MIT
#include "page_host.h"

#include <emscripten/emscripten.h>

#include <cstdlib>
#include <utility>

// clang-format off
EM_JS(void, page_js_wake, (), { Module.page.wake(); });
EM_JS(void, page_js_wake_after, (double seconds), { Module.page.wakeAfter(seconds); });
EM_JS(void, page_js_copy, (const char* text), { Module.page.copy(UTF8ToString(text)); });
EM_JS(void, page_js_work,
      (const char* head, const char* scene), {
    Module.page.work(UTF8ToString(head), UTF8ToString(scene));
});
EM_JS(void, page_js_export, (const char* document, const char* name, int copy, const char* assets), {
    Module.page.startExport(UTF8ToString(document), UTF8ToString(name), copy !== 0,
                            UTF8ToString(assets).split(" ").filter(Boolean));
});
EM_JS(int, page_js_makes_films, (), { return Module.page.makesFilms() ? 1 : 0; });
EM_JS(void, page_js_cancel_export, (), { Module.page.cancelExport(); });
EM_JS(int, page_js_save, (const char* name, const unsigned char* bytes, int size), {
    return Module.page.save(UTF8ToString(name), HEAPU8.slice(bytes, bytes + size)) ? 1 : 0;
});
EM_JS(void, page_js_choose_file, (), { Module.page.chooseFile(); });
// These return a text that the caller frees.
EM_JS(char*, page_js_address, (), { return Module.page.give(Module.page.address()); });
EM_JS(char*, page_js_stored, (const char* name), {
    return Module.page.give(Module.page.stored(UTF8ToString(name)));
});
EM_JS(void, page_js_store, (const char* name, const char* text), {
    Module.page.store(UTF8ToString(name), UTF8ToString(text));
});
EM_JS(void, page_js_fragment, (const char* text), { Module.page.setFragment(UTF8ToString(text)); });
EM_JS(char*, page_js_language, (), { return Module.page.give(Module.page.language()); });
EM_JS(int, page_js_fullscreen, (), { return Module.page.fullscreen() ? 1 : 0; });
EM_JS(int, page_js_reduced_motion, (), { return Module.page.reducedMotion() ? 1 : 0; });
EM_JS(void, page_js_announce, (const char* text), { Module.page.announce(UTF8ToString(text)); });
// clang-format on

namespace versorium {
namespace {

std::string taken(char* text) {
    if (!text) return {};
    std::string result = text;
    std::free(text);
    return result;
}

}  // namespace

double PageHost::now() const { return emscripten_get_now() / 1000; }
void PageHost::wake() { page_js_wake(); }
void PageHost::wakeAfter(double seconds) { page_js_wake_after(seconds); }

void PageHost::setClipboard(const std::string& text) {
    clipboard_ = text;
    page_js_copy(text.c_str());
}

void PageHost::requestWork(WorkRequest request) {
    assets_[static_cast<std::size_t>(placeOf(request.job))] = request.assets;
    page_js_work(requestHead(request).c_str(), request.scene.c_str());
}

const Asset* PageHost::asset(const std::string& hash) const {
    for (const Assets& assets : assets_)
        if (const auto found = assets.find(hash); found != assets.end()) return found->second.get();
    return nullptr;
}

std::optional<WorkAnswer> PageHost::takeAnswer() {
    if (answers_.empty()) return std::nullopt;
    WorkAnswer answer = std::move(answers_.front());
    answers_.pop_front();
    return answer;
}

void PageHost::startExport(ExportRequest request) {
    exported_.reset();
    progress_ = 0;
    std::string hashes;
    for (const auto& [hash, asset] : request.assets) hashes += hash + " ";
    assets_.back() = std::move(request.assets);
    page_js_export(request.document.c_str(), request.name.c_str(), request.toClipboard ? 1 : 0,
                   hashes.c_str());
}

bool PageHost::makesFilms() const { return page_js_makes_films() != 0; }

void PageHost::cancelExport() {
    if (progress_ < 0) return;
    page_js_cancel_export();
    exportEnded(Status::cancelled());
}

std::optional<Expected<std::string>> PageHost::takeExport() {
    return std::exchange(exported_, std::nullopt);
}

void PageHost::exportEnded(Expected<std::string> outcome) {
    progress_ = -1;
    exported_ = std::move(outcome);
}

Expected<std::string> PageHost::saveFile(const std::string& name,
                                         std::span<const unsigned char> bytes) {
    if (!page_js_save(name.c_str(), bytes.data(), static_cast<int>(bytes.size())))
        return Status::inputOutput(name + ": the browser did not take the file");
    return name + ", among your downloads";
}

bool PageHost::chooseFile() {
    page_js_choose_file();
    return true;
}

std::string PageHost::publicAddress() const { return taken(page_js_address()); }
void PageHost::setFragment(const std::string& fragment) { page_js_fragment(fragment.c_str()); }

std::string PageHost::stored(const std::string& name) {
    return taken(page_js_stored(name.c_str()));
}
void PageHost::store(const std::string& name, const std::string& text) {
    page_js_store(name.c_str(), text.c_str());
}

std::string PageHost::preferredLanguage() const { return taken(page_js_language()); }
bool PageHost::toggleFullscreen() { return page_js_fullscreen() != 0; }
bool PageHost::reducedMotion() const { return page_js_reduced_motion() != 0; }
void PageHost::announce(const std::string& text) { page_js_announce(text.c_str()); }

}  // namespace versorium
