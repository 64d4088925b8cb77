// SPDX-License-Identifier: MIT
#pragma once
// What the studio has computed beside itself, and what comes back. Whoever computes may stand in
// another process: a scene goes as JSON without its assets, which go by their SHA-256, each of them
// once.

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "base/status.h"
#include "image/raster.h"
#include "scene/scene.h"

namespace versorium {

// The picture of a view, as it comes.
struct PictureJob {
    int view = 0;
    Size size{0, 0};  // in pixels
    int samples = 1;  // along each side of a pixel
    // Of an averaged map (render/cpu/averaged_maps.h): members are counted for about so many
    // seconds, on from what was counted before; a picture of fewer than `least` of them is not
    // wanted. 0: all members are counted, as for an export.
    double portion = 0;
    int least = 0;
};
// A small picture, for the gallery and for candidates. It is made when nothing else waits.
struct ThumbnailJob {
    Size size{0, 0};
    int samples = 2;
    double portion = 0;  // as above
};
// The distance grid of the scene's shape.
struct GridJob {};
using WorkJob = std::variant<PictureJob, ThumbnailJob, GridJob>;

// Where a job waits: a new one takes the place of the one before it, which is given up.
int placeOf(const WorkJob& job);
inline constexpr int kWorkPlaces = 7;
// How much it is, in samples.
double costOf(const WorkJob& job);

struct WorkRequest {
    std::uint64_t id = 0;  // comes back with the answer
    std::string scene;     // its body as JSON
    Assets assets;         // of those that it names; null where only the name has come
    WorkJob job;
};
WorkRequest requestOf(std::uint64_t id, const Scene& scene, WorkJob job);

struct PictureResult {
    int view = 0;
    Size size{0, 0};
    // sRGB, straight alpha, row 0 on top; empty where fewer than `least` members are counted.
    std::vector<unsigned char> rgba = {};
    double seconds = 0;       // that it took
    int members = 0;          // that an averaged map has counted; 0 for other pictures
    bool recoloured = false;  // nothing was measured for it: its time says nothing of others
    bool kept = false;        // other colours of it will measure nothing
};
struct ThumbnailResult {
    Size size{0, 0};
    std::vector<unsigned char> rgba = {};
};
struct GridResult {
    std::vector<unsigned char> bytes = {};  // io/grid_files.h, packGrid
};
using WorkResult = std::variant<PictureResult, ThumbnailResult, GridResult>;

struct WorkAnswer {
    std::uint64_t id = 0;
    WorkResult result = {};    // of the kind that was asked for
    std::string message = {};  // why there is none; empty where there is one
    // Assets that whoever computes has not, or no longer: they are wanted, and the request again.
    std::vector<std::string> missing = {};
};
// No result yet: of the kind, and for the view, of the job.
WorkAnswer answerTo(std::uint64_t id, const WorkJob& job);

// For another process: everything but the scene's text, and everything but the bytes.
std::string requestHead(const WorkRequest& request);
Expected<WorkRequest> requestFromHead(const std::string& head, std::string scene);
std::string answerHead(const WorkAnswer& answer);
Expected<WorkAnswer> answerFromHead(const std::string& head, std::vector<unsigned char> bytes);
// The pixels, or the grid.
std::vector<unsigned char>& bytesOf(WorkResult& result);

}  // namespace versorium
