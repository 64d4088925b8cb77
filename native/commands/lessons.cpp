// SPDX-License-Identifier: MIT
#include <cstdio>
#include <filesystem>

#include "commands/commands.h"
#include "io/files.h"
#include "io/known_formats.h"
#include "lesson/lesson_plate.h"
#include "render/cpu/cpu_renderer.h"

namespace versorium {
namespace {

struct LessonRequest {
    std::string lesson, language = "en", output;
    double width = 178, dpi = 150;
    std::string theme = "paper";
};

bool isFile(const std::string& name) {
    return hasEnding(name, {".md"}) || name.find('/') != std::string::npos;
}

Expected<Lesson> openLesson(const LessonRequest& request) {
    if (!isFile(request.lesson)) return lessonNamed(request.lesson, request.language);
    Expected<Bytes> bytes = readFile(request.lesson);
    if (!bytes) return bytes.status();
    Expected<Lesson> lesson =
        parseLesson({reinterpret_cast<const char*>(bytes->data()), bytes->size()}, request.lesson);
    return lesson ? std::move(lesson) : lesson.status().in(request.lesson);
}

Status check(const LessonRequest& request) {
    const Expected<Lesson> lesson = openLesson(request);
    if (!lesson) return lesson.status();
    const std::vector<std::string> faults = faultsOf(*lesson);
    if (!faults.empty()) {
        std::string text = request.lesson + ": " + faults[0];
        for (std::size_t k = 1; k < faults.size(); ++k)
            text += "\n" + request.lesson + ": " + faults[k];
        return Status::data(text);
    }
    return print(request.lesson + ": \"" + lesson->title + "\", " +
                 std::to_string(lesson->steps.size()) + " steps, no faults\n");
}

Status render(const LessonRequest& request, int threads) {
    const Expected<Lesson> lesson = openLesson(request);
    if (!lesson) return lesson.status();
    std::error_code error;
    std::filesystem::create_directories(request.output, error);
    if (error) return Status::inputOutput(request.output + ": cannot be made: " + error.message());
    CpuRenderer renderer;
    for (std::size_t k = 0; k < lesson->steps.size(); ++k) {
        PlateDocument plate = plateOfStep(*lesson, k);
        plate.options.widthMillimetres = request.width;
        plate.options.dotsPerInch = request.dpi;
        plate.options.theme = request.theme;
        const std::string number = (k < 9 ? "0" : "") + std::to_string(k + 1);
        const std::string path =
            request.output + "/" + lesson->id + "-" + number + "." + lesson->language + ".png";
        Job job(threads);
        const ProgressLine progress(job, path);
        Expected<PlateFile> file = renderPlate(renderer, plate, job);
        if (!file)
            return file.status().in("step " + std::to_string(k + 1) + ", " +
                                    lesson->steps[k].title);
        if (Status status = writeFileAtomically(path, file->png); !status.ok()) return status;
        if (Status status = print(path + "\n"); !status.ok()) return status;
    }
    return {};
}

Status list(const LessonRequest& request) {
    std::string text;
    for (const std::string& id : lessonIds()) {
        const Expected<Lesson> lesson = lessonNamed(id, request.language);
        if (!lesson) return lesson.status().in(id);
        text += id + std::string(id.size() < 24 ? 24 - id.size() : 1, ' ') + lesson->title + " (" +
                std::to_string(lesson->minutes) + " min)\n";
    }
    return print(text);
}

}  // namespace

void addLessonCommands(CommandLine& line) {
    CLI::App* lesson = line.add("lesson", "List, check or draw lessons.",
                                "  versorium lesson list --language es\n"
                                "  versorium lesson check my-lesson.en.md\n"
                                "  versorium lesson render 1-orbits -o plates\n");
    lesson->require_subcommand(1);
    const auto own = std::make_shared<LessonRequest>();
    const auto language = [&](CLI::App* command) {
        command->add_option("--language", own->language, "of the program's own lessons: en or es")
            ->capture_default_str();
    };
    const auto name = [&](CLI::App* command) {
        command->add_option("LESSON", own->lesson, "name, or a Markdown file")->required();
        language(command);
    };
    CLI::App* all = lesson->add_subcommand("list", "The lessons that the program carries.");
    language(all);
    line.run(all, [own] { return list(*own); });
    CLI::App* checked = lesson->add_subcommand(
        "check", "Read a lesson and say what is wrong with it, by lines; exits with 65 if so.");
    name(checked);
    line.run(checked, [own] { return check(*own); });
    CLI::App* rendered =
        lesson->add_subcommand("render", "Draw each step as a plate: LESSON-NN.LANGUAGE.png.");
    name(rendered);
    rendered->add_option("-o,--output", own->output, "folder, made where it is missing")
        ->required();
    rendered->add_option("--width", own->width, "width in millimetres")->capture_default_str();
    rendered->add_option("--dpi", own->dpi, "pixels per inch")->capture_default_str();
    rendered->add_option("--theme", own->theme, "paper, slide or dark")->capture_default_str();
    line.run(rendered, [own, &line] { return render(*own, line.threads); });
}

}  // namespace versorium
