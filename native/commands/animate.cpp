// SPDX-License-Identifier: MIT
// animate: a motion as numbered pictures, as one archive of them, or as a film made by ffmpeg.
#include <spawn.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "commands/commands.h"
#include "io/files.h"
#include "io/known_formats.h"
#include "io/png.h"
#include "render/movie.h"

extern char** environ;

namespace versorium {
namespace {

constexpr const char* kEncoder = "ffmpeg";
constexpr std::array<const char*, 6> kFilms = {".mp4", ".webm", ".mkv", ".mov", ".gif", ".avi"};

struct AnimateRequest {
    std::string file, output, size;
    double framesPerSecond = 0;
    bool json = false, keepFrames = false;
};

bool isFilm(const std::string& name) {
    for (const char* ending : kFilms)
        if (hasEnding(name, {ending})) return true;
    return false;
}

// The program's path, looked up as a shell does; empty where it is not installed.
std::string installed(const std::string& program) {
    const char* path = std::getenv("PATH");
    std::string rest = path ? path : "";
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find(':'), rest.size());
        const std::string candidate = rest.substr(0, end) + "/" + program;
        if (end > 0 && access(candidate.c_str(), X_OK) == 0) return candidate;
        rest.erase(0, end + 1);
    }
    return {};
}

Status run(std::vector<std::string> words) {
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    pid_t child = 0;
    if (const int error =
            posix_spawn(&child, words[0].c_str(), nullptr, nullptr, arguments.data(), environ);
        error != 0)
        return Status::inputOutput(words[0] + ": " + std::strerror(error));
    int state = 0;
    while (waitpid(child, &state, 0) < 0)
        if (errno != EINTR) return Status::inputOutput(words[0] + ": " + std::strerror(errno));
    if (WIFEXITED(state) && WEXITSTATUS(state) == 0) return {};
    return Status::inputOutput(words[0] + " failed" +
                               (WIFEXITED(state)
                                    ? " with exit code " + std::to_string(WEXITSTATUS(state))
                                    : std::string()) +
                               "; the pictures are kept");
}

Status makeFolder(const std::string& path) {
    if (mkdir(path.c_str(), 0777) == 0) return {};
    struct stat found {};
    if (errno == EEXIST && stat(path.c_str(), &found) == 0 && S_ISDIR(found.st_mode)) return {};
    return Status::inputOutput(
        path + ": " +
        (errno == EEXIST ? "is a file, and a folder is needed" : std::strerror(errno)));
}

// A whole picture of this very frame is there already.
bool isThere(const std::string& path, const Document& document) {
    if (access(path.c_str(), R_OK) != 0) return false;
    const Expected<Bytes> bytes = readFile(path);
    if (!bytes) return false;
    const Expected<std::vector<PngText>> texts = decodePngText(*bytes);
    const std::string wanted = printJson(documentToJson(document));
    return texts && texts->size() == 1 && (*texts)[0].text == wanted;
}

// The numbered pictures of the folder; those that are there already are kept.
Status writeFrames(const Movie& movie, const std::string& folder, int threads, Json& report) {
    if (Status status = makeFolder(folder); !status.ok()) return status;
    const int frames = movie.animation.motion.frames();
    Job job(threads);
    const ProgressLine progress(job, std::to_string(frames) + " pictures");
    CpuRenderer renderer;
    int kept = 0;
    for (int frame = 0; frame < frames; ++frame) {
        const std::string path = folder + "/" + frameName(frame);
        if (isThere(path, frameDocument(movie, frame))) {
            ++kept;
            continue;
        }
        job.setPart(1.0 * frame / frames, 1.0 * (frame + 1) / frames);
        Expected<std::vector<unsigned char>> png = renderFrame(renderer, movie, frame, job);
        if (!png) return png.status();
        if (Status status = writeFileAtomically(path, *png); !status.ok()) return status;
    }
    report["frames"] = frames;
    report["kept"] = kept;
    return {};
}

void removeFrames(const std::string& folder, int frames) {
    for (int frame = 0; frame < frames; ++frame) unlink((folder + "/" + frameName(frame)).c_str());
    rmdir(folder.c_str());
}

// ffmpeg writes beside the film, which appears only when it is whole.
Status encode(const Movie& movie, const std::string& encoder, const std::string& folder,
              const std::string& film) {
    const std::size_t dot = film.rfind('.');
    const std::string partial = film.substr(0, dot) + ".partial" + film.substr(dot);
    std::vector<std::string> words{encoder,
                                   "-nostdin",
                                   "-loglevel",
                                   "error",
                                   "-y",
                                   "-framerate",
                                   formatNumber(movie.animation.motion.framesPerSecond),
                                   "-start_number",
                                   "1",
                                   "-i",
                                   folder + "/frame-%05d.png"};
    if (hasEnding(film, {".mp4", ".mov", ".mkv"}))
        for (const char* word : {"-c:v", "libx264", "-preset", "slow", "-crf", "16"})
            words.emplace_back(word);
    // Colour at half the resolution needs sides that are even.
    if (!hasEnding(film, {".gif"}))
        for (const char* word : {"-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p"})
            words.emplace_back(word);
    words.push_back(partial);
    if (Status status = run(words); !status.ok()) {
        unlink(partial.c_str());
        return status;
    }
    if (std::rename(partial.c_str(), film.c_str()) != 0)
        return Status::inputOutput(film + ": " + std::strerror(errno));
    return {};
}

Expected<Movie> movieOf(const AnimateRequest& request) {
    const bool file = request.file == "-" || request.file.find('/') != std::string::npos ||
                      hasEnding(request.file, {".json", ".png"});
    if (!file) return animationNamed(request.file);
    Expected<Document> document = readDocument(request.file);
    if (!document) return document.status();
    if (document->kind != DocumentKind::animation)
        return Status::data(request.file + ": this is a " + std::string(wordOf(document->kind)) +
                            "; an animation has \"keys\": record one in the studio with R");
    Expected<Movie> movie = movieFromDocument(*document);
    return movie ? std::move(movie) : movie.status().in(request.file);
}

Expected<Movie> openMovie(const AnimateRequest& request) {
    Expected<Movie> movie = movieOf(request);
    if (!movie) return movie.status();
    if (request.framesPerSecond > 0)
        movie->animation.motion.framesPerSecond = request.framesPerSecond;
    if (!request.size.empty()) {
        Expected<Size> size = parseSize(request.size);
        if (!size) return size.status();
        movie->options.size = *size;
    }
    return movie;
}

Status animate(const AnimateRequest& request, int threads) {
    const bool film = isFilm(request.output), archive = hasEnding(request.output, {".zip"});
    Expected<Movie> movie = openMovie(request);
    if (!movie) return movie.status();
    const Size size = pictureSize(movie->animation.scene, movie->options);
    if (Status status = checkSize(movie->animation.scene, size); !status.ok()) return status;
    const std::string encoder = film ? installed(kEncoder) : "";
    if (film && encoder.empty())
        return Status::usage(request.output +
                             ": films are made by ffmpeg, which is not installed. Install the "
                             "package ffmpeg, or give a folder for numbered pictures (-o frames) "
                             "or an archive (-o frames.zip)");
    Json report{{"output", request.output}, {"width", size.width}, {"height", size.height}};
    if (archive) {
        Job job(threads);
        const ProgressLine progress(job,
                                    std::to_string(movie->animation.motion.frames()) + " pictures");
        CpuRenderer renderer;
        Expected<std::vector<unsigned char>> bytes = renderArchive(renderer, *movie, job);
        if (!bytes) return bytes.status();
        report["frames"] = movie->animation.motion.frames();
        if (Status status = writeFileAtomically(request.output, *bytes); !status.ok())
            return status;
    } else {
        const std::string folder = film ? request.output + ".frames" : request.output;
        if (Status status = writeFrames(*movie, folder, threads, report); !status.ok())
            return status;
        if (film) {
            if (Status status = encode(*movie, encoder, folder, request.output); !status.ok())
                return status;
            if (!request.keepFrames) removeFrames(folder, movie->animation.motion.frames());
        }
    }
    return request.json ? print(printJson(report)) : Status{};
}

}  // namespace

void addAnimateCommand(CommandLine& line) {
    CLI::App* command =
        line.add("animate", "Render an animation to numbered pictures or to a film.",
                 "  versorium animate leaf -o leaf.mp4\n"
                 "  versorium animate motion.json -o frames\n"
                 "  versorium animate motion.json -o motion.mp4 --size 1920x1080 --fps 60\n"
                 "  versorium animate motion.json -o frames.zip\n"
                 "Pictures that are there already are kept: a run that was stopped goes on.\n");
    const auto request = std::make_shared<AnimateRequest>();
    command->add_option("FILE", request->file, "name, animation file, or -")->required();
    command
        ->add_option("-o,--output", request->output,
                     "folder for PNGs, archive (.zip), or film (.mp4, .webm, .gif: needs ffmpeg)")
        ->required();
    command->add_option("--size", request->size, "WIDTHxHEIGHT in pixels");
    command->add_option("--fps", request->framesPerSecond, "frames per second")
        ->check(CLI::Range(1.0, 240.0));
    command->add_flag("--keep-frames", request->keepFrames, "keep the pictures beside a film");
    command->add_flag("--json", request->json, "report as JSON");
    line.run(command, [request, &line] { return animate(*request, line.threads); });
}

}  // namespace versorium
