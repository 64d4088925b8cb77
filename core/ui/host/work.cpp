// SPDX-License-Identifier: MIT
#include "ui/host/work.h"

#include "i18n/language.h"
#include "scene/parts.h"
#include "workspace/workspace.h"

namespace versorium {
namespace {

constexpr int kThumbnailPlace = kMostViews, kGridPlace = kMostViews + 1;
static_assert(kWorkPlaces == kGridPlace + 1);
constexpr int kMostSide = 1 << 20;

void jobToJson(const PictureJob& job, Json& json) {
    json["kind"] = "picture";
    json["view"] = job.view;
    json["width"] = job.size.width;
    json["height"] = job.size.height;
    json["samples"] = job.samples;
    json["portion"] = job.portion;
    json["least"] = job.least;
}
void jobToJson(const ThumbnailJob& job, Json& json) {
    json["kind"] = "thumbnail";
    json["width"] = job.size.width;
    json["height"] = job.size.height;
    json["samples"] = job.samples;
    json["portion"] = job.portion;
}
void jobToJson(const GridJob&, Json& json) { json["kind"] = "grid"; }

void readSize(ObjectReader& reader, Size& size) {
    reader.integer("width", size.width, 0, kMostSide).integer("height", size.height, 0, kMostSide);
}

WorkJob readJob(ObjectReader& reader, const std::string& kind) {
    if (kind == "grid") return GridJob{};
    if (kind == "thumbnail") {
        ThumbnailJob job;
        readSize(reader, job.size);
        reader.integer("samples", job.samples, 1, kMostSamples)
            .number("portion", job.portion, 0, 1e6);
        return job;
    }
    PictureJob job;
    readSize(reader, job.size);
    reader.integer("view", job.view, 0, kMostViews - 1)
        .integer("samples", job.samples, 1, kMostSamples)
        .number("portion", job.portion, 0, 1e6)
        .integer("least", job.least, 0, 1 << 30);
    return job;
}

WorkResult readResult(ObjectReader& reader, const std::string& kind) {
    if (kind == "grid") return GridResult{};
    if (kind == "thumbnail") {
        ThumbnailResult result;
        readSize(reader, result.size);
        return result;
    }
    PictureResult result;
    readSize(reader, result.size);
    reader.integer("view", result.view, 0, kMostViews - 1)
        .number("seconds", result.seconds, 0, 1e9)
        .integer("members", result.members, 0, 1 << 30)
        .boolean("recoloured", result.recoloured)
        .boolean("kept", result.kept);
    return result;
}

std::string readKind(ObjectReader& reader) {
    std::string kind = "picture";
    reader.word("kind", kind, {"picture", "thumbnail", "grid"});
    return kind;
}

void readId(ObjectReader& reader, std::uint64_t& id) {
    double number = 0;
    reader.number("id", number, 0, 9007199254740992.0);
    id = static_cast<std::uint64_t>(number);
}

std::vector<std::string> readNames(ObjectReader& reader, const char* key) {
    std::vector<std::string> names;
    const Json* found = reader.child(key);
    if (!found) return names;
    if (!found->is_array()) reader.fail(key, trLater("a list of names is expected"));
    for (const Json& name : *found)
        if (name.is_string()) names.push_back(name.get<std::string>());
    return names;
}

// Whether so many bytes are the whole of it. Of an averaged map there may be no picture yet.
bool fits(const WorkResult& result, std::size_t bytes) {
    const auto pixels = [](Size size) {
        return 4 * static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
    };
    if (const auto* picture = std::get_if<PictureResult>(&result))
        return bytes == pixels(picture->size) || (picture->members > 0 && bytes == 0);
    if (const auto* thumbnail = std::get_if<ThumbnailResult>(&result))
        return bytes == pixels(thumbnail->size);
    return bytes > 0;
}

}  // namespace

int placeOf(const WorkJob& job) {
    if (const auto* picture = std::get_if<PictureJob>(&job)) return picture->view;
    return std::holds_alternative<GridJob>(job) ? kGridPlace : kThumbnailPlace;
}

double costOf(const WorkJob& job) {
    const auto samples = [](const auto& one) {
        return 1.0 * one.size.width * one.size.height * one.samples * one.samples;
    };
    if (const auto* picture = std::get_if<PictureJob>(&job)) return samples(*picture);
    if (const auto* thumbnail = std::get_if<ThumbnailJob>(&job)) return samples(*thumbnail);
    return 0;
}

WorkRequest requestOf(std::uint64_t id, const Scene& scene, WorkJob job) {
    WorkRequest request{id, sceneBody(scene).dump(), {}, std::move(job)};
    for (const std::string& hash : namedAssets(scene))
        if (const auto found = scene.assets.find(hash); found != scene.assets.end())
            request.assets.insert(*found);
    return request;
}

WorkAnswer answerTo(std::uint64_t id, const WorkJob& job) {
    WorkAnswer answer{.id = id};
    if (const auto* picture = std::get_if<PictureJob>(&job))
        answer.result = PictureResult{.view = picture->view, .size = picture->size};
    else if (const auto* thumbnail = std::get_if<ThumbnailJob>(&job))
        answer.result = ThumbnailResult{.size = thumbnail->size};
    else
        answer.result = GridResult{};
    return answer;
}

std::vector<unsigned char>& bytesOf(WorkResult& result) {
    if (auto* picture = std::get_if<PictureResult>(&result)) return picture->rgba;
    if (auto* thumbnail = std::get_if<ThumbnailResult>(&result)) return thumbnail->rgba;
    return std::get<GridResult>(result).bytes;
}

std::string requestHead(const WorkRequest& request) {
    Json json{{"id", request.id}};
    std::visit([&](const auto& job) { jobToJson(job, json); }, request.job);
    json["assets"] = Json::array();
    for (const auto& [hash, asset] : request.assets) json["assets"].push_back(hash);
    // For those that order jobs and do not compute them.
    json["place"] = placeOf(request.job);
    json["cost"] = costOf(request.job);
    return json.dump();
}

Expected<WorkRequest> requestFromHead(const std::string& head, std::string scene) {
    const Expected<Json> json = parseJson(head);
    if (!json) return json.status();
    ObjectReader reader(*json, "");
    WorkRequest request;
    request.scene = std::move(scene);
    readId(reader, request.id);
    request.job = readJob(reader, readKind(reader));
    for (std::string& hash : readNames(reader, "assets")) request.assets[std::move(hash)] = nullptr;
    for (const char* others : {"place", "cost"}) reader.child(others);
    if (Status status = reader.finish(); !status.ok()) return status;
    return request;
}

std::string answerHead(const WorkAnswer& answer) {
    Json json{{"id", answer.id}, {"message", answer.message}};
    json["missing"] = Json::array();
    for (const std::string& hash : answer.missing) json["missing"].push_back(hash);
    if (const auto* picture = std::get_if<PictureResult>(&answer.result)) {
        json["kind"] = "picture";
        json["view"] = picture->view;
        json["width"] = picture->size.width;
        json["height"] = picture->size.height;
        json["seconds"] = picture->seconds;
        json["members"] = picture->members;
        json["recoloured"] = picture->recoloured;
        json["kept"] = picture->kept;
    } else if (const auto* thumbnail = std::get_if<ThumbnailResult>(&answer.result)) {
        json["kind"] = "thumbnail";
        json["width"] = thumbnail->size.width;
        json["height"] = thumbnail->size.height;
    } else {
        json["kind"] = "grid";
    }
    return json.dump();
}

Expected<WorkAnswer> answerFromHead(const std::string& head, std::vector<unsigned char> bytes) {
    const Expected<Json> json = parseJson(head);
    if (!json) return json.status();
    ObjectReader reader(*json, "");
    WorkAnswer answer;
    readId(reader, answer.id);
    reader.text("message", answer.message);
    answer.missing = readNames(reader, "missing");
    answer.result = readResult(reader, readKind(reader));
    if (Status status = reader.finish(); !status.ok()) return status;
    if (answer.message.empty() && !fits(answer.result, bytes.size())) {
        answer.message = trLater("the picture did not arrive");
        bytes.clear();
    }
    bytesOf(answer.result) = std::move(bytes);
    return answer;
}

}  // namespace versorium
