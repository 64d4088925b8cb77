// SPDX-License-Identifier: MIT
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <mutex>

#include "commands/commands.h"
#include "io/files.h"
#include "io/text_scanner.h"

namespace versorium {

CLI::App* CommandLine::add(const std::string& name, const std::string& help,
                           const std::string& examples) {
    CLI::App* command = app.add_subcommand(name, help);
    command->footer("Examples:\n" + examples);
    return command;
}

struct ProgressLine::State {
    using Clock = std::chrono::steady_clock;
    std::mutex mutex;
    std::string what;
    Clock::time_point start = Clock::now(), shown = start;
    bool drawn = false;
    bool plain = false;  // NO_COLOR: no escape sequences

    void show(double progress) {
        const std::lock_guard lock(mutex);
        const auto now = Clock::now();
        if (now - shown < std::chrono::milliseconds(100)) return;
        shown = now;
        const double seconds = std::chrono::duration<double>(now - start).count();
        const double left = progress > 0 ? seconds * (1 - progress) / progress : 0;
        std::fprintf(stderr, "\r%s %3.0f %%, %.0f s left  %s", what.c_str(), 100 * progress, left,
                     plain ? "" : "\033[K");
        drawn = true;
    }
};

ProgressLine::ProgressLine(Job& job, std::string what) {
    sayWarnings(job);
    if (!isatty(STDERR_FILENO)) return;
    state_ = std::make_shared<State>();
    state_->what = std::move(what);
    state_->plain = std::getenv("NO_COLOR") != nullptr;
    job.onProgress = [state = state_](double progress) { state->show(progress); };
}

ProgressLine::~ProgressLine() {
    if (state_ && state_->drawn) std::fprintf(stderr, state_->plain ? "\n" : "\r\033[K");
}

void sayWarnings(Job& job) {
    job.onWarning = [](const std::string& text) {
        std::fprintf(stderr, "versorium: warning: %s\n", text.c_str());
    };
}

void reportWarnings(const Job& job, Json& report) {
    if (const auto warnings = job.warnings(); !warnings.empty()) report["warnings"] = warnings;
}

Status print(const std::string& text) { return writeFileAtomically("-", text); }

Expected<Size> parseSize(const std::string& text) {
    const std::size_t cross = text.find_first_of("xX");
    std::optional<std::int64_t> width, height;
    if (cross != std::string::npos) {
        width = parseInteger(text.substr(0, cross));
        height = parseInteger(text.substr(cross + 1));
    }
    if (!width || !height)
        return Status::usage("--size " + text +
                             ": WIDTHxHEIGHT in pixels is expected, such as "
                             "1200x800");
    if (*width < 1 || *height < 1 || *width > kMostPixels || *height > kMostPixels)
        return Status::usage("--size " + text + ": each side must be 1 to " +
                             std::to_string(kMostPixels) + " pixels");
    return Size{static_cast<int>(*width), static_cast<int>(*height)};
}

Expected<Flavour> parseFlavour(const std::string& text) {
    if (text == "exact") return Flavour::exact;
    if (text == "fast") return Flavour::fast;
    return Status::usage("--flavour " + text + ": exact or fast is expected");
}

}  // namespace versorium
