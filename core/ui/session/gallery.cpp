// SPDX-License-Identifier: MIT
#include "ui/session/gallery.h"

#include <algorithm>

#include "i18n/language.h"
#include "io/document.h"
#include "render/cpu/averaged_map.h"
#include "ui/backend/texture.h"

namespace versorium {
namespace {

constexpr const char* kStored = "recent";
constexpr const char* kDot = " · ";
// A thumbnail is not worth more; its points differ from the scene's by the last few bands.
constexpr int kMostSteps = 2000;
// Nor the members of an ensemble that are not counted by then; in seconds.
constexpr double kPortion = 0.3;

Expected<Scene> sceneOfEntry(const Gallery::Entry& entry) {
    if (!entry.preset.empty()) return presetNamed(entry.preset);
    Expected<Workspace> workspace = workspaceFromLink(entry.link);
    if (!workspace) return workspace.status();
    return workspace->view();
}

}  // namespace

std::string titleOf(const Workspace& workspace) {
    const MapInfo& info = mapOf(workspace.view()).info;
    return std::string(workspace.view().formula ? info.formula : info.title) + kDot +
           formatNumber(workspace.view().slice.height, 2);
}

std::string shownTitle(const Gallery::Entry& entry) {
    if (!entry.preset.empty()) {
        const std::string other = tr(std::string_view(entry.preset));
        return other == entry.preset ? entry.title : other;
    }
    const std::size_t height = entry.title.rfind(kDot);
    if (height == std::string::npos) return entry.title;
    return tr(std::string_view(entry.title).substr(0, height)) +
           withDecimalSign(entry.title.substr(height));
}

void Gallery::load(Host& host) {
    const std::string text = host.stored(kStored);
    std::size_t start = 0;
    while (start < text.size() && recent_.size() < kMostRecent) {
        const std::size_t end = std::min(text.find('\n', start), text.size());
        const std::string link = text.substr(start, end - start);
        start = end + 1;
        const Expected<Workspace> workspace = workspaceFromLink(link);
        if (workspace) recent_.push_back({titleOf(*workspace), {}, link});
    }
}

void Gallery::store(Host& host) const {
    std::string text;
    for (const Entry& entry : recent_) text += entry.link + "\n";
    host.store(kStored, text);
}

void Gallery::remember(Host& host, const Workspace& workspace) {
    // What is too large for a link has a file of its own.
    const Expected<std::string> link = workspaceToLink(workspace);
    if (!link) return;
    if (working_ && !recent_.empty()) recent_.erase(recent_.begin());
    std::erase_if(recent_, [&](const Entry& entry) { return entry.link == *link; });
    recent_.insert(recent_.begin(), {titleOf(workspace), {}, *link});
    if (recent_.size() > kMostRecent) recent_.resize(kMostRecent);
    working_ = true;
    store(host);
}

const std::vector<Gallery::Entry>& Gallery::presets() {
    if (presets_.empty())
        for (const std::string& name : presetNames()) {
            std::string title = name;
            std::replace(title.begin(), title.end(), '-', ' ');
            presets_.push_back({title, name, {}});
        }
    return presets_;
}

void Gallery::ask(Host& host) {
    if (!asked_.empty()) return;
    for (const std::vector<Entry>* entries : {&presets(), &recent()})
        for (const Entry& entry : *entries) {
            if (pictures_.contains(entry.key())) continue;
            Expected<Scene> scene = sceneOfEntry(entry);
            if (!scene) {
                pictures_[entry.key()] = {};
                continue;
            }
            scene->iterations = std::min(scene->iterations, kMostSteps);
            asked_ = entry.key();
            ThumbnailJob job{.size = {kWidth, kHeight}};
            if (showsEnsemble(*scene)) job.portion = kPortion;
            return host.requestWork(requestOf(++id_, *scene, job));
        }
}

void Gallery::take(WorkAnswer answer) {
    if (answer.id != id_ || asked_.empty()) return;
    Picture& picture = pictures_[asked_];
    asked_.clear();
    if (!answer.message.empty()) return;
    ThumbnailResult& made = std::get<ThumbnailResult>(answer.result);
    picture.rgba = std::move(made.rgba);
    picture.size = made.size;
}

unsigned Gallery::picture(const Entry& entry) {
    const auto found = pictures_.find(entry.key());
    if (found == pictures_.end() || found->second.rgba.empty()) return 0;
    Picture& picture = found->second;
    if (picture.texture == 0) picture.texture = putTexture(0, picture.size, picture.rgba.data());
    return picture.texture;
}

void Gallery::contextLost() {
    for (auto& [key, picture] : pictures_) picture.texture = 0;
}

}  // namespace versorium
