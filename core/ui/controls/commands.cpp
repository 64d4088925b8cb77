// SPDX-License-Identifier: MIT
// Everything that can be done, once: for the keys, for the search and for the list of keys.
#include <algorithm>
#include <cctype>

#include "imgui.h"
#include "plate/plate_picture.h"
#include "render/movie.h"
#include "ui/controls/access.h"
#include "ui/controls/commands.h"
#include "ui/session/context.h"
#include "ui/session/ensemble_change.h"
#include "ui/session/open_file.h"
#include "ui/session/planar_change.h"
#include "ui/session/root_edit.h"
#include "ui/session/shape_change.h"
#include "ui/widgets/help.h"
#include "ui/widgets/keys.h"
#include "ui/widgets/panel_parts.h"

namespace versorium {
namespace {

// What may be had where things are locked: it changes nothing, or only what a lock watches over.
constexpr const char* kHarmless[] = {
    "undo",       "redo",         "view.home",     "view.zoom.in", "view.zoom.out",
    "view.back",  "view.forward", "view.maximise", "fullscreen",   "orbit.forward",
    "orbit.back", "plot.series",  "plot.web",      "plot.diagram", "theme.next",
    "lessons",    "lesson.next",  "lesson.back",   "lesson.reset", "keys"};

constexpr double kAnimationStep = 1.0 / 120;  // rounds

// Presets that show a set of parameters.
const std::vector<std::string>& setPresets() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> found;
        for (const std::string& name : presetNames()) {
            const Expected<Scene> scene = presetNamed(name);
            if (scene && showsParameters(*scene) && scene->slice.axes.size() > 1)
                found.push_back(name);
        }
        return found;
    }();
    return names;
}

std::string lower(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

// Every word of the question stands in the name.
bool matches(const std::string& name, const std::string& question) {
    const std::string whole = lower(name);
    std::size_t at = 0;
    const std::string words = lower(question);
    while (at < words.size()) {
        const std::size_t end = std::min(words.find(' ', at), words.size());
        if (whole.find(words.substr(at, end - at)) == std::string::npos) return false;
        at = end + 1;
    }
    return true;
}

void nextPaletteOf(StudioContext& context) {
    const std::vector<std::string> names = paletteNames();
    std::string& now = context.workspace.view().colour.palette;
    context.workspace.view().colour.ownPalette = nullptr;
    const auto found = std::find(names.begin(), names.end(), now);
    now = found == names.end() || found + 1 == names.end() ? names.front() : *(found + 1);
    context.touch();
}

// Arrows pan; with Shift they nudge the point by a pixel's worth.
void nudge(StudioContext& context) {
    const auto pressed = [](ImGuiKey key) { return ImGui::IsKeyPressed(key, true) ? 1 : 0; };
    const int right = pressed(ImGuiKey_RightArrow) - pressed(ImGuiKey_LeftArrow);
    const int up = pressed(ImGuiKey_UpArrow) - pressed(ImGuiKey_DownArrow);
    if (right == 0 && up == 0) return;
    const bool shift = ImGui::GetIO().KeyShift;
    if (!shift) return context.pan(context.workspace.focused, 0.1 * right, 0.1 * up);
    const auto view = static_cast<std::size_t>(context.workspace.focused);
    const ViewState& state = context.views[view];
    // The shorter side shows the slice's height.
    const double pixel =
        context.workspace.view().slice.height /
        std::max(1.0f, std::min(state.high.x - state.low.x, state.high.y - state.low.y));
    const auto marker = markerOf(context.workspace, view);
    moveMarker(context.workspace, view, marker[0] + right * pixel, marker[1] + up * pixel);
    context.touch();
}

}  // namespace

std::vector<Command> commandsOf(StudioContext& context) {
    StudioContext* c = &context;
    const auto focused = [c] { return c->workspace.focused; };
    std::vector<Command> all = {
        {"undo", trLater("Undo"), {"Z", true}, [c] { c->undo(); }},
        {"redo", trLater("Redo"), {"Z", true, true}, [c] { c->redo(); }},
        {"find",
         trLater("Find a map, a preset or a command"),
         {"K", true},
         [c] { c->searchOpen = true; }},
        {"open",
         trLater("Open a scene, a picture, a mesh, an image or a palette"),
         {"O", true},
         [c] { c->chooseFile(); }},
        {"paste", trLater("Open what is on the clipboard"), {"V", true}, [c] { c->paste(); }},
        {"gallery",
         trLater("Presets and recent scenes as pictures"),
         {"G", true},
         [c] { c->galleryOpen = true; }},
        {"export.dialog",
         trLater("Export a picture or a plate"),
         {"E", true},
         [c] { c->exportOpen = true; }},
        {"copy.image",
         trLater("Copy the marked view as an image"),
         {"I", true},
         [c] { c->copyImage(); }},
        {"copy.link", trLater("Copy a link to what is shown"), {"L", true}, [c] { c->copyLink(); }},
        {"save", trLater("Save the scene as a file"), {"S", true}, [c] { c->saveScene(); }},
        {"view.home", trLater("Home"), {"Home"}, [c, focused] { c->home(focused()); }},
        {"view.back",
         trLater("Back to the place before"),
         {"Backspace"},
         [c, focused] { c->revisit(focused(), -1); }},
        {"view.forward",
         trLater("Forward again"),
         {"Backspace", false, true},
         [c, focused] { c->revisit(focused(), 1); }},
        {"view.zoom.in",
         trLater("Zoom in"),
         {"+"},
         [c, focused] {
             const auto& centre = c->workspace.view().slice.centre;
             c->zoom(focused(), 0.8, centre[0], centre.size() > 1 ? centre[1] : 0, true);
         }},
        {"view.zoom.out",
         trLater("Zoom out"),
         {"-"},
         [c, focused] {
             const auto& centre = c->workspace.view().slice.centre;
             c->zoom(focused(), 1.25, centre[0], centre.size() > 1 ? centre[1] : 0, true);
         }},
        {"view.maximise",
         trLater("Fill the window with the marked view, or not"),
         {"F"},
         [c] {
             c->workspace.maximised = !c->workspace.maximised;
             c->touch();
         }},
        {"fullscreen",
         trLater("Fill the screen, or not"),
         {"F", false, true},
         [c] {
             if (!c->host.toggleFullscreen())
                 c->say("The screen cannot be filled from here: the desktop's own keys may do it");
         }},
        {"views.one", trLater("One view"), {}, [c] { setViewCount(c->workspace, 1), c->touch(); }},
        {"views.two", trLater("Two views"), {}, [c] { setViewCount(c->workspace, 2), c->touch(); }},
        {"views.four",
         trLater("Four views"),
         {},
         [c] { setViewCount(c->workspace, 4), c->touch(); }},
        {"views.analysis",
         trLater("Analysis: one set of parameters, and the starting points of four places in it"),
         {"N"},
         [c] {
             if (!setAnalysis(c->workspace))
                 return c->say("This map has no two parameters that could be the axes of a set");
             c->touch();
         }},
        {"views.bands",
         trLater("Bands beside smooth colours: A eqs 14 and 15"),
         {},
         [c] {
             Scene scene = c->workspace.view();
             setViewCount(c->workspace, 2);
             scene.colour.rule = ColourRule::gradient;
             scene.colour.smoothing = Smoothing::none;
             c->workspace.views[0] = scene;
             scene.colour.smoothing = Smoothing::ratio;
             c->workspace.views[1] = std::move(scene);
             c->touch();
         }},
        {"orbit.forward", trLater("One step on along the orbit"), {"."}, [c] { c->stepOrbit(1); }},
        {"orbit.back", trLater("One step back along the orbit"), {","}, [c] { c->stepOrbit(-1); }},
        {"arrows",
         trLater("Arrows from points x to f(x), or none"),
         {"A"},
         [c] {
             c->workspace.arrows = !c->workspace.arrows;
             c->touch();
         }},
        {"plot.series", trLater("The orbit as a time series"), {}, [c] { c->show(Strip::series); }},
        {"plot.web",
         trLater("The orbit as a web, where the map has a real line"),
         {},
         [c] { c->show(Strip::web); }},
        {"plot.diagram",
         trLater("Bifurcation diagram: the attractor against one parameter"),
         {},
         [c] { c->show(Strip::diagram); }},
        {"cycles",
         trLater("Fixed points and cycles, or none"),
         {},
         [c] { c->workspace.study.cycles = !c->workspace.study.cycles, c->touch(); }},
        {"manifolds",
         trLater("Manifolds of saddles, or none"),
         {},
         [c] {
             c->workspace.study.manifolds = !c->workspace.study.manifolds;
             c->workspace.study.cycles |= c->workspace.study.manifolds;
             c->touch();
         }},
        {"critical.curve",
         trLater("Critical curve det J = 0, or none"),
         {"C"},
         [c] { c->workspace.study.criticalCurve = !c->workspace.study.criticalCurve, c->touch(); }},
        {"roots.show",
         trLater("Roots and poles in the views, or none"),
         {"V"},
         [c] { c->workspace.showRoots = !c->workspace.showRoots, c->touch(); }},
        {"roots.add",
         trLater("Add a root of the versor at the orbit's point"),
         {},
         [c] { addRootAtPoint(*c); }},
        {"roots.remove",
         trLater("Take the chosen root away"),
         {"Delete"},
         [c] {
             if (c->circles.chosen >= 0)
                 removeCircle(*c, c->circles.chosen);
             else
                 removeChosenRoot(*c);
         },
         [c] {
             // Stops of a palette are taken away by the same key, with the pointer over them.
             return c->probe.view >= 0 &&
                    (c->circles.chosen >= 0 || isRoot(c->workspace, c->versor.chosen));
         }},
        {"versor.product",
         trLater("Versor d from the product over its roots"),
         {},
         [c] { takeRootSum(c->workspace, false), c->touch(); }},
        {"versor.sum",
         trLater("Versor d from the sum over its roots"),
         {},
         [c] { takeRootSum(c->workspace, true), c->touch(); }},
        {"versor.candidates",
         trLater("Candidates for the versor d: a sheet to pick from"),
         {"S"},
         [c] { openContactSheet(*c, c->versor.draw.seed); }},
        {"roots.random",
         trLater("Roots at random: the next seed"),
         {"S", false, true},
         [c] { drawRoots(*c, c->versor.draw.seed == 2147483647 ? 0 : c->versor.draw.seed + 1); }},
        {"circles.drop",
         trLater("Drop a circle around 0, through the pointer or the orbit's point"),
         {"O"},
         [c] { dropCircle(*c); }},
        {"circles.clear",
         trLater("Take the circles away"),
         {},
         [c] { c->workspace.circles.clear(), c->circles.chosen = -1, c->touch(); }},
        {"basins",
         trLater("Basins: where capture or escape is certain, or none"),
         {"B"},
         [c] { c->workspace.basins = !c->workspace.basins, c->touch(); }},
        {"as.complex",
         trLater("The same pictures as a complex map"),
         {},
         [c] { showAsComplexMap(*c); }},
        {"as.planar",
         trLater("The same pictures as a planar system"),
         {},
         [c] { showAsPlanarSystem(*c); }},
        {"draw.outline",
         trLater("Draw the outline of a shape"),
         {"D"},
         [c] { chooseTool(*c, Drawing::Tool::outline); }},
        {"paint.alpha", trLater("Paint α"), {}, [c] { chooseTool(*c, Drawing::Tool::alpha); }},
        {"paint.beta", trLater("Paint β"), {}, [c] { chooseTool(*c, Drawing::Tool::beta); }},
        {"views.modulus",
         trLater("Modulus, versor, log-modulus and members side by side: S Fig 2"),
         {"M"},
         [c] { showModulusAndVersor(*c); }},
        {"views.printed",
         trLater("S eq 2 as it is printed, φ + β, beside φ − β"),
         {},
         [c] { showAsPrinted(*c); }},
        {"animation.play",
         trLater("Play or pause the animation"),
         {"Space"},
         [c] {
             if (c->animation.number.empty())
                 c->say("Choose a number first: the triangle beside it");
             else
                 c->animation.running = !c->animation.running;
             c->host.wake();
         }},
        {"animation.step",
         trLater("One step of the animation"),
         {"Space", false, true},
         [c] {
             c->animation.running = false;
             if (c->animation.number.empty())
                 c->say("Choose a number first: the triangle beside it");
             else
                 c->advanceAnimation(kAnimationStep);
         }},
        {"motion.record",
         trLater("Record what is moved, or stop recording"),
         {"R"},
         [c] { c->record(!c->player.recording); }},
        {"motion.play",
         trLater("Play the motion, or pause it"),
         {"R", false, true},
         [c] { c->play(!c->player.playing); }},
        {"motion.key.set",
         trLater("Set a key frame of the motion here"),
         {"K"},
         [c] { c->setKey(); }},
        {"motion.key.remove",
         trLater("Take the chosen key frame away"),
         {},
         [c] { c->removeKey(); }},
        {"motion.save", trLater("Save the motion as a file"), {}, [c] { c->saveMotion(); }},
        {"motion.clear",
         trLater("Take the motion away"),
         {},
         [c] {
             c->player = {};
             c->workspace.motion = {};
             c->touch();
         }},
        {"pins.clear",
         trLater("Take the pins away"),
         {},
         [c] { c->workspace.pins.clear(), c->touch(); }},
        {"palette.next", trLater("Next palette"), {"P"}, [c] { nextPaletteOf(*c); }},
        {"theme.next",
         trLater("Dark, light or projector colours"),
         {"T"},
         [c] {
             c->theme = (c->theme + 1) % themes().size();
             c->host.store("theme", themes()[c->theme].name);
             c->fontsChanged = true;
             c->host.wake();
         }},
        {"renderer.next",
         trLater("Who draws: automatic, graphics processor or processor"),
         {"G"},
         [c] { c->nextRenderer(); }},
        {"lessons",
         trLater("Lessons, or none"),
         {"L"},
         [c] {
             c->lessons.open = !c->lessons.open;
             c->host.wake();
         }},
        {"lesson.next",
         trLater("Lesson: next step"),
         {"Page Down"},
         [c] {
             if (c->lessons.now) goToStep(*c, c->lessons.now->session.at() + 1);
         }},
        {"lesson.back",
         trLater("Lesson: step before"),
         {"Page Up"},
         [c] {
             if (c->lessons.now && c->lessons.now->session.at() > 0)
                 goToStep(*c, c->lessons.now->session.at() - 1);
         }},
        {"lesson.reset", trLater("Lesson: reset the step"), {}, [c] { resetStep(*c); }},
        {"teacher.link",
         trLater("A teacher's link to this lesson or view"),
         {},
         [c] { openTeacherDialog(*c); }},
        {"keys", trLater("The list of keys"), {"?"}, [c] { c->keysOpen = !c->keysOpen; }},
    };
    for (Command& command : ensembleCommands(context)) all.push_back(std::move(command));
    for (int k = 0; k < kMostViews; ++k)
        all.push_back({"view.focus." + std::to_string(k + 1),
                       tr("Mark view {1}", {std::to_string(k + 1)}),
                       {std::to_string(k + 1)},
                       [c, k] {
                           if (k < static_cast<int>(c->workspace.views.size())) c->mark(k);
                       }});
    for (const Language& language : languages())
        all.push_back({"language." + language.id,
                       tr("Language: {1}", {language.name}),
                       {},
                       [c, id = language.id] { c->speak(id); }});
    for (Command& command : all)
        command.harmless = command.id.starts_with("language.") ||
                           std::any_of(std::begin(kHarmless), std::end(kHarmless),
                                       [&](const char* id) { return command.id == id; });
    if (isRestricted(context))
        std::erase_if(all, [](const Command& command) { return !command.harmless; });
    return all;
}

bool runCommand(StudioContext& context, std::string_view id) {
    for (const Command& command : commandsOf(context))
        if (command.id == id) {
            if (command.when && !command.when()) return false;
            command.run();
            return true;
        }
    return false;
}

void handleKeys(StudioContext& context) {
    if (ImGui::GetIO().WantTextInput) return;
    // Chords with the command key hold everywhere; a dialog or a tool takes the others.
    std::vector<Command> pressed;
    for (Command& command : commandsOf(context))
        if (command.chord && isPressed(command.chord)) pressed.push_back(std::move(command));
    const bool redone = isPressed({"Y", true});
    for (const Command& command : pressed)
        if (command.chord.command && (!command.when || command.when())) return command.run();
    if (redone) return void(runCommand(context, "redo"));
    const DrawingKeys drawing{.enter = ImGui::IsKeyPressed(ImGuiKey_Enter, false) ||
                                       ImGui::IsKeyPressed(ImGuiKey_KeypadEnter, false),
                              .back = ImGui::IsKeyPressed(ImGuiKey_Backspace),
                              .escape = ImGui::IsKeyPressed(ImGuiKey_Escape, false)};
    if (context.dialogOpen() || drawingKeys(context, drawing)) return;
    for (const Command& command : pressed)
        if (!command.chord.command && (!command.when || command.when())) command.run();
    nudge(context);
}

namespace {

// An entry of the search about something that has a name, which is found by both languages.
Command said(const char* sentence, const std::string& name, std::function<void()> run) {
    Command command{"", tr(sentence, {tr(std::string_view(name))}), {}, std::move(run)};
    command.also = name;
    return command;
}

// What can be found: all that opens something, and all commands.
std::vector<Command> entriesFor(StudioContext& context, const char* question) {
    if (isRestricted(context)) return commandsOf(context);
    std::vector<Command> entries;
    for (const LessonEntry& lesson : lessonList(context))
        entries.push_back(said("Lesson: {1}", lesson.head.title, [&context, id = lesson.id] {
            context.report(openLesson(context, id, {}));
        }));
    for (const std::string& name : presetNames())
        entries.push_back(said("Preset: {1}", name, [&context, name] {
            Expected<Scene> scene = presetNamed(name);
            if (!scene) return context.report(scene.status());
            context.open(workspaceOf(*scene));
        }));
    for (const std::string& name : setPresets())
        entries.push_back(said("Analysis: {1}", name, [&context, name] {
            Expected<Scene> scene = presetNamed(name);
            if (!scene) return context.report(scene.status());
            Workspace workspace = workspaceOf(*scene);
            setAnalysis(workspace);
            context.open(std::move(workspace));
        }));
    for (const std::string& name : animationNames())
        entries.push_back(said("Motion: {1}", name, [&context, name] {
            Expected<Movie> movie = animationNamed(name);
            if (!movie) return context.report(movie.status());
            context.openMotion(std::move(movie->animation));
            context.play(true);
        }));
    for (const Gallery::Entry& entry : context.gallery.recent())
        entries.push_back(said("Recent: {1}", shownTitle(entry), [&context, link = entry.link] {
            Expected<Workspace> workspace = workspaceFromLink(link);
            if (!workspace) return context.report(workspace.status());
            context.open(std::move(*workspace));
        }));
    for (const MapKernels& map : catalogue()) {
        const std::string name(map.info.name);
        entries.push_back(said("Map: {1}", tr(map.info.title) + "  (" + name + ")",
                               [&context, name] { context.newMap(name); }));
    }
    for (Command& command : commandsOf(context)) entries.push_back(std::move(command));
    for (const std::string& name : plateNames()) {
        entries.push_back(said("Plate: {1}, its first panel", name, [&context, name] {
            const Expected<PlateDocument> plate = plateNamed(name);
            if (!plate) return context.report(plate.status());
            context.report(openPlate(context, name, *plate));
        }));
        entries.push_back(said("Export the plate {1}", name, [&context, name] {
            context.exporting.plate = true;
            context.exporting.motion = false;
            context.exporting.builtIn = name;
            context.exportOpen = true;
        }));
    }
    for (Command& command : formulaCommands(context, question))
        entries.push_back(std::move(command));
    return entries;
}

void drawSearch(StudioContext& context) {
    static char question[128];
    const std::string window = named("Find");
    if (context.searchOpen && !ImGui::IsPopupOpen(window.c_str())) {
        question[0] = 0;
        ImGui::OpenPopup(window.c_str());
    }
    const ImGuiViewport& screen = *ImGui::GetMainViewport();
    ImGui::SetNextWindowPos({screen.GetCenter().x, screen.Pos.y + screen.Size.y * 0.12f},
                            ImGuiCond_Always, {0.5f, 0});
    ImGui::SetNextWindowSize(
        {std::min(620.0f * context.scale, screen.Size.x * 0.94f), screen.Size.y * 0.62f});
    if (!ImGui::BeginPopupModal(window.c_str(), &context.searchOpen, ImGuiWindowFlags_NoResize))
        return;
    if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-1);
    const bool enter =
        ImGui::InputTextWithHint("##question", tr("a map, a preset, a command"), question,
                                 sizeof question, ImGuiInputTextFlags_EnterReturnsTrue);
    explain("question");
    const std::vector<Command> entries = entriesFor(context, question);
    const Command* chosen = nullptr;
    bool first = true;
    ImGui::BeginChild("entries");
    for (const Command& entry : entries) {
        const std::string title = entry.title();
        if (!matches(title + " " + entry.label + " " + entry.also, question)) continue;
        ImGui::PushID(&entry);
        const bool picked = ImGui::Selectable(title.c_str(), first && question[0] != 0);
        explain("found");
        ImGui::PopID();
        if (entry.chord) {
            ImGui::SameLine(ImGui::GetContentRegionAvail().x - ImGui::GetFontSize() * 6);
            ImGui::TextDisabled("%s", textOf(entry.chord).c_str());
        }
        if (picked || (enter && first)) chosen = &entry;
        first = false;
    }
    if (first) ImGui::TextDisabled("%s", tr("Nothing has this name."));
    ImGui::EndChild();
    if (chosen || ImGui::IsKeyPressed(ImGuiKey_Escape)) {
        context.searchOpen = false;
        ImGui::CloseCurrentPopup();
    }
    if (chosen) chosen->run();
    ImGui::EndPopup();
}

void drawKeys(StudioContext& context) {
    if (!context.keysOpen) return;
    ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Always, {0.5f, 0.5f});
    if (ImGui::Begin(named("Keys").c_str(), &context.keysOpen,
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse)) {
        if (ImGui::BeginTable("keys", 2)) {
            const auto row = [](const char* keys, const char* name) {
                ImGui::TableNextRow();
                ImGui::TableNextColumn();
                ImGui::TextUnformatted(tr(keys));
                ImGui::TableNextColumn();
                ImGui::TextUnformatted(tr(name));
            };
            for (const Command& command : commandsOf(context))
                if (command.chord) row(textOf(command.chord).c_str(), command.title().c_str());
            row("arrows", "Pan; with Shift: move the point by a pixel");
            row("drag, wheel", "Pan, zoom at the pointer");
            row("right drag", "Zoom to a box");
            row("Ctrl click", "Put the point here");
            row("Shift click", "Pin these parameters");
            row("Alt drag", "The second start; p* beside the critical curve");
            row("double click", "Go in; where roots are shown: add a root");
            row("wheel on a root", "Its power, by 1 or with Shift by 0.1");
            ImGui::EndTable();
        }
        if (ImGui::IsKeyPressed(ImGuiKey_Escape)) context.keysOpen = false;
    }
    ImGui::End();
}

}  // namespace

void drawDialogs(StudioContext& context) {
    drawSearch(context);
    drawGallery(context);
    drawContactSheet(context);
    drawOpenFile(context);
    drawKeys(context);
    drawExport(context);
    drawTeacherDialog(context);
}

}  // namespace versorium
