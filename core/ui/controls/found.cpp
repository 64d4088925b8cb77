// SPDX-License-Identifier: MIT
// What Find offers beside the table of commands: all that has a name and can be opened.
#include "plate/plate_picture.h"
#include "render/movie.h"
#include "ui/controls/access.h"
#include "ui/controls/command_families.h"
#include "ui/session/context.h"
#include "ui/session/open_file.h"

namespace versorium {
namespace {

// A command about something that has a name, which is found by both languages.
Command opener(const std::string& id, const char* sentence, const std::string& name,
               const char* help, std::function<void()> run) {
    Command command{id, tr(sentence, {tr(std::string_view(name))}), help, {}, std::move(run)};
    command.also = name;
    return command;
}

void openPreset(StudioContext& context, const std::string& name, bool analysis) {
    Expected<Scene> scene = presetNamed(name);
    if (!scene) return context.report(scene.status());
    Workspace workspace = workspaceOf(*scene);
    if (analysis) setAnalysis(workspace);
    context.open(std::move(workspace));
}

// Presets that show a set of parameters.
const std::vector<std::string>& setPresets() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> found;
        for (const std::string& name : presetNames()) {
            const Expected<Scene> scene = presetNamed(name);
            if (scene && viewKind(*scene) == ViewKind::parameters && scene->slice.axes.size() > 1)
                found.push_back(name);
        }
        return found;
    }();
    return names;
}

void addLessons(StudioContext& context, Commands& all) {
    StudioContext* c = &context;
    for (const LessonEntry& lesson : lessonList(context))
        all.push_back(opener("lesson.open." + lesson.id, trLater("Lesson: {1}"), lesson.head.title,
                             trLater("Opens this lesson where you left it."),
                             [c, id = lesson.id] { c->report(openLesson(*c, id, {})); }));
}

void addScenes(StudioContext& context, Commands& all) {
    StudioContext* c = &context;
    for (const std::string& name : presetNames())
        all.push_back(opener("preset." + name, trLater("Preset: {1}"), name,
                             trLater("Opens a scene of the program's own."),
                             [c, name] { openPreset(*c, name, false); }));
    for (const std::string& name : setPresets())
        all.push_back(opener("analysis." + name, trLater("Analysis: {1}"), name,
                             trLater("The set of this preset with four places in it."),
                             [c, name] { openPreset(*c, name, true); }));
    for (const std::string& name : animationNames())
        all.push_back(opener("motion.open." + name, trLater("Motion: {1}"), name,
                             trLater("Opens a motion of the program's own and plays it."),
                             [c, name] {
                                 Expected<Movie> movie = animationNamed(name);
                                 if (!movie) return c->report(movie.status());
                                 c->openMotion(std::move(movie->animation));
                                 c->player.play(true);
                             }));
    int place = 0;
    for (const Gallery::Entry& entry : context.gallery.recent())
        all.push_back(opener("recent." + std::to_string(++place), trLater("Recent: {1}"),
                             shownTitle(entry), trLater("Opens a scene that you had open before."),
                             [c, link = entry.link] {
                                 Expected<Workspace> workspace = workspaceFromLink(link);
                                 if (!workspace) return c->report(workspace.status());
                                 c->open(std::move(*workspace));
                             }));
}

void addMaps(StudioContext& context, Commands& all) {
    StudioContext* c = &context;
    for (const MapKernels& map : catalogue()) {
        const std::string name(map.info.name);
        all.push_back(opener("map." + name, trLater("Map: {1}"),
                             tr(map.info.title) + "  (" + name + ")",
                             trLater("This map with its own parameters, at its home."),
                             [c, name] { c->newMap(name); }));
    }
}

void addPlates(StudioContext& context, Commands& all) {
    StudioContext* c = &context;
    for (const std::string& name : plateNames()) {
        all.push_back(opener("plate.open." + name, trLater("Plate: {1}, its first panel"), name,
                             trLater("Opens the first picture of a figure plate."), [c, name] {
                                 const Expected<PlateDocument> plate = plateNamed(name);
                                 if (!plate) return c->report(plate.status());
                                 c->report(openPlate(*c, name, *plate));
                             }));
        all.push_back(opener("plate.export." + name, trLater("Export the plate {1}"), name,
                             trLater("Opens the export with this figure plate chosen."), [c, name] {
                                 c->exporting.plate = true;
                                 c->exporting.motion = false;
                                 c->exporting.builtIn = name;
                                 c->dialogs.exporting = true;
                             }));
    }
}

void addFormulas(StudioContext& context, const std::string& question, Commands& all) {
    StudioContext* c = &context;
    const char* help = trLater("Iterates this formula as a map.");
    if (const std::optional<std::string> typed = formulaIn(question))
        all.push_back({"formula.typed", tr("Formula: {1}", {question}), help, {}, [c, typed] {
                           c->formula.open = true;
                           c->report(applyFormula(*c, *typed));
                       }});
    all.push_back({"formula.edit",
                   trLater("Type a formula of your own"),
                   trLater("z is complex, q a quaternion, x real, x' and y' are of the plane."),
                   {},
                   [c] { editFormula(*c); }});
    for (const SavedFormula& one : context.formulas.all())
        all.push_back({"formula." + one.name,
                       tr("Formula: {1}", {one.name + "  (" + one.text + ")"}),
                       help,
                       {},
                       [c, text = one.text] { c->report(applyFormula(*c, text)); }});
}

}  // namespace

std::vector<Command> findable(StudioContext& context, const std::string& question) {
    if (isRestricted(context)) return commandsOf(context);
    Commands all;
    addLessons(context, all);
    addScenes(context, all);
    addMaps(context, all);
    for (Command& command : commandsOf(context)) all.push_back(std::move(command));
    addPlates(context, all);
    addFormulas(context, question, all);
    return all;
}

}  // namespace versorium
