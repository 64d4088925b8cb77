// SPDX-License-Identifier: MIT
// The versorium program: a command line over the core.
#include <algorithm>
#include <cstdio>

#include "commands/commands.h"
#include "maps/formula_map.h"

namespace {

enum ExitCode { kSuccess = 0, kUsage = 2, kData = 65, kInputOutput = 74, kCancelled = 130 };

int exitCode(const versorium::Status& status) {
    switch (status.kind()) {
        case versorium::ErrorKind::none:
            return kSuccess;
        case versorium::ErrorKind::usage:
            return kUsage;
        case versorium::ErrorKind::data:
            return kData;
        case versorium::ErrorKind::cancelled:
            return kCancelled;
        default:
            return kInputOutput;
    }
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{
        "Versorium: the dynamics of fractal maps, seen, taught and published.\n\n"
        "Without a command it opens the studio.\n\n"
        "Examples:\n"
        "  versorium studio mandelbrot\n"
        "  versorium plate quadratic -o plate.png\n"
        "  versorium render mandelbrot -o m.png --set center=-0.7436,0.1318 --set height=0.01\n"
        "  versorium scene plate.png > plate.json\n",
        "versorium"};
    app.set_version_flag("--version", std::string("versorium ") + VERSORIUM_VERSION);
    app.require_subcommand(VERSORIUM_STUDIO ? 0 : 1, 1);
    app.fallthrough();
    versorium::CommandLine line{app, 0, {}};
    app.add_option("--threads", line.threads,
                   "threads to use; 0 is one for each processor (pictures never depend on it)")
        ->check(CLI::Range(0, 1024))
        ->capture_default_str();
    versorium::addListCommands(line);
    versorium::addRenderCommands(line);
    versorium::addAnimateCommand(line);
    versorium::addMeasureCommands(line);
    versorium::addDynamicsCommands(line);
    versorium::addValuesCommand(line);
    versorium::addShapeCommands(line);
    versorium::addFileCommands(line);
    versorium::addLessonCommands(line);
#if VERSORIUM_STUDIO
    versorium::addStudioCommand(line);
#endif
    // A formula may begin with a sign, as -z^2 + c; what follows it is no option then.
    std::vector<std::string> words(argv + 1, argv + argc);
    for (std::string& word : words)
        if (word.size() > 2 && word[0] == '-' && word[1] != '-' &&
            versorium::FormulaMap::make(word))
            word.insert(word.begin(), ' ');
    std::reverse(words.begin(), words.end());
    try {
        app.parse(std::move(words));
    } catch (const CLI::ParseError& error) {
        const int code = app.exit(error);
        return code == 0 ? kSuccess : kUsage;
    }
    const versorium::Status status = line.action();
    if (!status.ok()) std::fprintf(stderr, "versorium: %s\n", status.message().c_str());
    return exitCode(status);
}
