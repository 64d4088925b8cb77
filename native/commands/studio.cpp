// SPDX-License-Identifier: MIT
#include "../window.h"
#include "commands.h"

namespace versorium {

void addStudioCommand(CommandLine& line) {
    line.action = [] { return runStudio({}); };
    CLI::App* command = line.add("studio", "Opens the studio, the window to explore in",
                                 "versorium studio\nversorium studio julia\nversorium studio "
                                 "figure.png\nversorium studio '#v1:…'\nversorium studio "
                                 "3-mandelbrot\nversorium studio 'z^3 - a*z + c'");
    auto options = std::make_shared<WindowOptions>();
    command->add_option(
        "scene", options->open,
        "a preset, a lesson, a scene or a PNG that carries one, a link, or a formula");
    command->add_option("--screenshot", options->screenshot,
                        "write the window as a PNG once its pictures are finished, and end");
    auto size = std::make_shared<std::string>("1280x800");
    command->add_option("--size", *size, "of the window")->capture_default_str();
    line.run(command, [options, size]() -> Status {
        const Expected<Size> parsed = parseSize(*size);
        if (!parsed) return parsed.status();
        options->width = parsed->width;
        options->height = parsed->height;
        return runStudio(*options);
    });
}

}  // namespace versorium
