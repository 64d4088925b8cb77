// SPDX-License-Identifier: MIT
// Everything that can be done, once: for the keys, for the search and for the list of keys.
#include <algorithm>
#include <cctype>

#include "imgui.h"
#include "plate/plate_picture.h"
#include "render/movie.h"
#include "ui/controls/access.h"
#include "ui/marks/root_marks.h"
#include "ui/session/context.h"
#include "ui/session/ensemble_change.h"
#include "ui/session/open_file.h"
#include "ui/session/planar_change.h"
#include "ui/session/shape_change.h"
#include "ui/widgets/help.h"
#include "ui/widgets/keys.h"
#include "ui/widgets/panel_parts.h"

namespace versorium {
namespace {

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
        {"Undo", "Ctrl Z", [c] { c->undo(); }},
        {"Redo", "Shift Ctrl Z", [c] { c->redo(); }},
        {"Find a map, a preset or a command", "Ctrl K", [c] { c->searchOpen = true; }},
        {"Open a scene, a picture, a mesh, an image or a palette", "Ctrl O",
         [c] { c->chooseFile(); }},
        {"Open what is on the clipboard", "Ctrl V", [c] { c->paste(); }},
        {"Presets and recent scenes as pictures", "Ctrl G", [c] { c->galleryOpen = true; }},
        {"Export a picture or a plate", "Ctrl E", [c] { c->exportOpen = true; }},
        {"Copy the marked view as an image", "Ctrl I", [c] { c->copyImage(); }},
        {"Copy a link to what is shown", "Ctrl L", [c] { c->copyLink(); }},
        {"Save the scene as a file", "Ctrl S", [c] { c->saveScene(); }},
        {"Home", "Home", [c, focused] { c->home(focused()); }},
        {"Back to the place before", "Backspace", [c, focused] { c->revisit(focused(), -1); }},
        {"Forward again", "Shift Backspace", [c, focused] { c->revisit(focused(), 1); }},
        {"Zoom in", "+",
         [c, focused] {
             const auto& centre = c->workspace.view().slice.centre;
             c->zoom(focused(), 0.8, centre[0], centre.size() > 1 ? centre[1] : 0, true);
         }},
        {"Zoom out", "-",
         [c, focused] {
             const auto& centre = c->workspace.view().slice.centre;
             c->zoom(focused(), 1.25, centre[0], centre.size() > 1 ? centre[1] : 0, true);
         }},
        {"Fill the window with the marked view, or not", "F",
         [c] {
             c->workspace.maximised = !c->workspace.maximised;
             c->touch();
         }},
        {"Fill the screen, or not", "Shift F",
         [c] {
             if (!c->host.toggleFullscreen())
                 c->say("The screen cannot be filled from here: the desktop's own keys may do it");
         }},
        {"One view", "", [c] { setViewCount(c->workspace, 1), c->touch(); }},
        {"Two views", "", [c] { setViewCount(c->workspace, 2), c->touch(); }},
        {"Four views", "", [c] { setViewCount(c->workspace, 4), c->touch(); }},
        {"Analysis: one set of parameters, and the starting points of four places in it", "N",
         [c] {
             if (!setAnalysis(c->workspace))
                 return c->say("This map has no two parameters that could be the axes of a set");
             c->touch();
         }},
        {"Bands beside smooth colours: A eqs 14 and 15", "",
         [c] {
             Scene scene = c->workspace.view();
             setViewCount(c->workspace, 2);
             scene.colour.rule = "gradient";
             scene.colour.smoothing = "none";
             c->workspace.views[0] = scene;
             scene.colour.smoothing = "ratio";
             c->workspace.views[1] = std::move(scene);
             c->touch();
         }},
        {"One step on along the orbit", ".", [c] { c->stepOrbit(1); }},
        {"One step back along the orbit", ",", [c] { c->stepOrbit(-1); }},
        {"Arrows from points x to f(x), or none", "A",
         [c] {
             c->workspace.arrows = !c->workspace.arrows;
             c->touch();
         }},
        {"The orbit as a time series", "", [c] { c->show(StudioContext::Strip::series); }},
        {"The orbit as a web, where the map has a real line", "",
         [c] { c->show(StudioContext::Strip::web); }},
        {"Bifurcation diagram: the attractor against one parameter", "",
         [c] { c->show(StudioContext::Strip::diagram); }},
        {"Fixed points and cycles, or none", "",
         [c] { c->workspace.study.cycles = !c->workspace.study.cycles, c->touch(); }},
        {"Manifolds of saddles, or none", "",
         [c] {
             c->workspace.study.manifolds = !c->workspace.study.manifolds;
             c->workspace.study.cycles |= c->workspace.study.manifolds;
             c->touch();
         }},
        {"Critical curve det J = 0, or none", "C",
         [c] { c->workspace.study.criticalCurve = !c->workspace.study.criticalCurve, c->touch(); }},
        {"Roots and poles in the views, or none", "V",
         [c] { c->workspace.showRoots = !c->workspace.showRoots, c->touch(); }},
        {"Add a root of the versor at the orbit's point", "", [c] { addRootAtPoint(*c); }},
        {"Take the chosen root away", "Delete", [c] { removeChosenRoot(*c); }},
        {"Versor d from the product over its roots", "",
         [c] { takeRootSum(c->workspace, false), c->touch(); }},
        {"Versor d from the sum over its roots", "",
         [c] { takeRootSum(c->workspace, true), c->touch(); }},
        {"Candidates for the versor d: a sheet to pick from", "S",
         [c] { openContactSheet(*c, c->versor.draw.seed); }},
        {"Roots at random: the next seed", "Shift S",
         [c] { drawRoots(*c, c->versor.draw.seed == 2147483647 ? 0 : c->versor.draw.seed + 1); }},
        {"Drop a circle around 0, through the pointer or the orbit's point", "O",
         [c] { dropCircle(*c); }},
        {"Take the circles away", "",
         [c] { c->workspace.circles.clear(), c->circles.chosen = -1, c->touch(); }},
        {"Basins: where capture or escape is certain, or none", "B",
         [c] { c->workspace.basins = !c->workspace.basins, c->touch(); }},
        {"The same pictures as a complex map", "", [c] { showAsComplexMap(*c); }},
        {"The same pictures as a planar system", "", [c] { showAsPlanarSystem(*c); }},
        {"Draw the outline of a shape", "D", [c] { chooseTool(*c, Drawing::Tool::outline); }},
        {"Paint α", "", [c] { chooseTool(*c, Drawing::Tool::alpha); }},
        {"Paint β", "", [c] { chooseTool(*c, Drawing::Tool::beta); }},
        {"Modulus, versor, log-modulus and members side by side: S Fig 2", "M",
         [c] { showModulusAndVersor(*c); }},
        {"S eq 2 as it is printed, φ + β, beside φ − β", "", [c] { showAsPrinted(*c); }},
        {"Play or pause the animation", "Space",
         [c] {
             if (c->animation.number.empty())
                 c->say("Choose a number first: the triangle beside it");
             else
                 c->animation.running = !c->animation.running;
             c->host.wake();
         }},
        {"One step of the animation", "Shift Space",
         [c] {
             c->animation.running = false;
             if (c->animation.number.empty())
                 c->say("Choose a number first: the triangle beside it");
             else
                 c->advanceAnimation(kAnimationStep);
         }},
        {"Record what is moved, or stop recording", "R", [c] { c->record(!c->player.recording); }},
        {"Play the motion, or pause it", "Shift R", [c] { c->play(!c->player.playing); }},
        {"Set a key frame of the motion here", "K", [c] { c->setKey(); }},
        {"Take the chosen key frame away", "", [c] { c->removeKey(); }},
        {"Save the motion as a file", "", [c] { c->saveMotion(); }},
        {"Take the motion away", "",
         [c] {
             c->player = {};
             c->workspace.motion = {};
             c->touch();
         }},
        {"Take the pins away", "", [c] { c->workspace.pins.clear(), c->touch(); }},
        {"Next palette", "P", [c] { nextPaletteOf(*c); }},
        {"Dark, light or projector colours", "T",
         [c] {
             c->theme = (c->theme + 1) % themes().size();
             c->host.store("theme", themes()[c->theme].name);
             c->fontsChanged = true;
             c->host.wake();
         }},
        {"Who draws: automatic, graphics processor or processor", "G", [c] { c->nextRenderer(); }},
        {"Lessons, or none", "L",
         [c] {
             c->lessons.open = !c->lessons.open;
             c->host.wake();
         }},
        {"Lesson: next step", "Page Down",
         [c] {
             if (c->lessons.now) goToStep(*c, c->lessons.now->session.at() + 1);
         }},
        {"Lesson: step before", "Page Up",
         [c] {
             if (c->lessons.now && c->lessons.now->session.at() > 0)
                 goToStep(*c, c->lessons.now->session.at() - 1);
         }},
        {"Lesson: reset the step", "", [c] { resetStep(*c); }},
        {"A teacher's link to this lesson or view", "", [c] { openTeacherDialog(*c); }},
        {"The list of keys", "?", [c] { c->keysOpen = !c->keysOpen; }},
    };
    for (Command& command : ensembleCommands(context)) all.push_back(std::move(command));
    for (int k = 0; k < kMostViews; ++k)
        all.push_back({"Mark view " + std::to_string(k + 1), std::to_string(k + 1),
                       [c, k] {
                           if (k < static_cast<int>(c->workspace.views.size())) c->mark(k);
                       },
                       tr("Mark view {1}", {std::to_string(k + 1)})});
    for (const Language& language : languages())
        all.push_back({"Language: " + language.name, "", [c, id = language.id] { c->speak(id); },
                       tr("Language: {1}", {language.name})});
    if (isRestricted(context))
        std::erase_if(all, [](const Command& command) { return !isHarmless(command.name); });
    return all;
}

void handleKeys(StudioContext& context) {
    if (ImGui::GetIO().WantTextInput) return;
    const auto run = [&](const char* keys) {
        for (const Command& entry : commandsOf(context))
            if (entry.keys == keys) return entry.run();
    };
    // With the command key, Ctrl or on Apple's machines ⌘, or without it.
    const auto pressed = [](ImGuiKey key, bool command, bool repeat = false) {
        return ImGui::IsKeyPressed(key, repeat) &&
               ((modifiersOf(key) & (ImGuiMod_Ctrl | ImGuiMod_Super)) != 0) == command;
    };
    const auto shifted = [](ImGuiKey key) { return (modifiersOf(key) & ImGuiMod_Shift) != 0; };
    if (pressed(ImGuiKey_Z, true, true)) run(shifted(ImGuiKey_Z) ? "Shift Ctrl Z" : "Ctrl Z");
    if (pressed(ImGuiKey_Y, true, true)) run("Shift Ctrl Z");
    constexpr std::pair<ImGuiKey, const char*> commands[] = {
        {ImGuiKey_K, "Ctrl K"}, {ImGuiKey_G, "Ctrl G"}, {ImGuiKey_E, "Ctrl E"},
        {ImGuiKey_I, "Ctrl I"}, {ImGuiKey_L, "Ctrl L"}, {ImGuiKey_O, "Ctrl O"},
        {ImGuiKey_V, "Ctrl V"}, {ImGuiKey_S, "Ctrl S"}};
    for (const auto& [key, name] : commands)
        if (pressed(key, true)) run(name);
    if (context.dialogOpen() || drawingKeys(context)) return;
    if (pressed(ImGuiKey_D, false)) run("D");
    if (pressed(ImGuiKey_Home, false)) run("Home");
    if (pressed(ImGuiKey_Backspace, false))
        run(shifted(ImGuiKey_Backspace) ? "Shift Backspace" : "Backspace");
    if (pressed(ImGuiKey_A, false)) run("A");
    if (pressed(ImGuiKey_B, false)) run("B");
    if (pressed(ImGuiKey_C, false)) run("C");
    if (pressed(ImGuiKey_O, false)) run("O");
    if (pressed(ImGuiKey_V, false)) run("V");
    // Stops of a palette are taken away by the same key, with the pointer over them.
    if (pressed(ImGuiKey_Delete, false) && context.probe.view >= 0) {
        if (context.circles.chosen >= 0)
            removeCircle(context, context.circles.chosen);
        else if (isRoot(context.workspace, context.versor.chosen))
            removeChosenRoot(context);
    }
    if (pressed(ImGuiKey_F, false)) run(shifted(ImGuiKey_F) ? "Shift F" : "F");
    if (pressed(ImGuiKey_G, false)) run("G");
    if (pressed(ImGuiKey_M, false)) run("M");
    if (pressed(ImGuiKey_N, false)) run("N");
    if (pressed(ImGuiKey_P, false)) run("P");
    if (pressed(ImGuiKey_R, false)) run(shifted(ImGuiKey_R) ? "Shift R" : "R");
    if (pressed(ImGuiKey_K, false)) run("K");
    if (pressed(ImGuiKey_L, false)) run("L");
    if (pressed(ImGuiKey_PageDown, false)) run("Page Down");
    if (pressed(ImGuiKey_PageUp, false)) run("Page Up");
    if (pressed(ImGuiKey_S, false)) run(shifted(ImGuiKey_S) ? "Shift S" : "S");
    if (pressed(ImGuiKey_T, false)) run("T");
    if (pressed(ImGuiKey_Space, false)) run(shifted(ImGuiKey_Space) ? "Shift Space" : "Space");
    if (pressed(ImGuiKey_Period, false, true)) run(".");
    if (pressed(ImGuiKey_Comma, false, true)) run(",");
    if (pressed(ImGuiKey_Equal, false, true) || pressed(ImGuiKey_KeypadAdd, false, true)) run("+");
    if (pressed(ImGuiKey_Minus, false, true) || pressed(ImGuiKey_KeypadSubtract, false, true))
        run("-");
    if (pressed(ImGuiKey_Slash, false) && shifted(ImGuiKey_Slash)) run("?");
    for (int k = 0; k < kMostViews; ++k)
        if (pressed(static_cast<ImGuiKey>(ImGuiKey_1 + k), false))
            run(std::to_string(k + 1).c_str());
    nudge(context);
}

namespace {

// An entry of the search about something that has a name, which is found by both languages.
Command said(const char* sentence, const std::string& name, std::function<void()> run) {
    return {name, "", std::move(run), tr(sentence, {tr(std::string_view(name))})};
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
        if (!matches(title + " " + entry.name, question)) continue;
        ImGui::PushID(&entry);
        const bool picked = ImGui::Selectable(title.c_str(), first && question[0] != 0);
        explain("found");
        ImGui::PopID();
        if (!entry.keys.empty()) {
            ImGui::SameLine(ImGui::GetContentRegionAvail().x - ImGui::GetFontSize() * 6);
            ImGui::TextDisabled("%s", tr(entry.keys.c_str()));
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
                if (!command.keys.empty()) row(command.keys.c_str(), command.title().c_str());
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
