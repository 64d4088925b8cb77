// SPDX-License-Identifier: MIT
#pragma once
// The subcommands. Each adds itself to the command line; its action returns a Status, which main
// turns into an exit code: 0, 2 usage, 65 bad data, 74 input or output.

#include <CLI/CLI.hpp>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/json.h"
#include "base/status.h"
#include "jobs/job.h"
#include "render/frame.h"

namespace versorium {

using Action = std::function<Status()>;

// What all commands share.
struct CommandLine {
    CLI::App& app;
    int threads = 0;
    Action action;  // of the subcommand that was given

    // A subcommand with its help and examples.
    CLI::App* add(const std::string& name, const std::string& help, const std::string& examples);
    void run(CLI::App* command, Action work) {
        command->callback([this, work = std::move(work)] { action = work; });
    }
};

void addListCommands(CommandLine& line);      // maps, palettes, plates, presets, schema, glsl
void addRenderCommands(CommandLine& line);    // render, plate
void addAnimateCommand(CommandLine& line);    // animate
void addMeasureCommands(CommandLine& line);   // eval, orbit
void addDynamicsCommands(CommandLine& line);  // cycles, manifolds, critical, explain
void addValuesCommand(CommandLine& line);     // values
void addShapeCommands(CommandLine& line);     // roots, profile
void addFileCommands(CommandLine& line);      // shape, scene
void addLessonCommands(CommandLine& line);    // lesson
void addStudioCommand(CommandLine& line);     // studio, also what no command means

// Shows progress with an estimate of what is left, on a terminal only.
class ProgressLine {
  public:
    explicit ProgressLine(Job& job, std::string what);
    ~ProgressLine();

  private:
    struct State;
    std::shared_ptr<State> state_;
};

// Says the job's warnings on standard error; a ProgressLine does it too.
void sayWarnings(Job& job);
// Adds "warnings" where there are any.
void reportWarnings(const Job& job, Json& report);

Status print(const std::string& text);
Expected<Size> parseSize(const std::string& text);
Expected<Flavour> parseFlavour(const std::string& text);

}  // namespace versorium
