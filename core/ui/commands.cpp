// SPDX-License-Identifier: MIT
// Everything that can be done, once: for the keys, for the search and for the list of keys.
#include <algorithm>
#include <cctype>

#include "imgui.h"
#include "render/renderer.h"
#include "ui/context.h"

namespace versorium {
namespace {

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
    const auto found = std::find(names.begin(), names.end(), now);
    now = found == names.end() || found + 1 == names.end() ? names.front() : *(found + 1);
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
        {"Export the marked view as a PNG", "Ctrl E", [c] { c->exportOpen = true; }},
        {"Copy a link to what is shown", "Ctrl L", [c] { c->copyLink(); }},
        {"Save the scene as a file", "Ctrl S", [c] { c->saveScene(); }},
        {"Home", "Home", [c, focused] { c->home(focused()); }},
        {"Back to the place before", "Backspace", [c, focused] { c->revisit(focused(), -1); }},
        {"Forward again", "Shift Backspace", [c, focused] { c->revisit(focused(), 1); }},
        {"Zoom in", "+",
         [c, focused] {
             const auto& centre = c->workspace.view().slice.centre;
             c->zoom(focused(), 0.8, centre[0], centre.size() > 1 ? centre[1] : 0);
         }},
        {"Zoom out", "-",
         [c, focused] {
             const auto& centre = c->workspace.view().slice.centre;
             c->zoom(focused(), 1.25, centre[0], centre.size() > 1 ? centre[1] : 0);
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
        {"One step more of the orbit", ".",
         [c] {
             c->workspace.orbitSteps = std::min(1000, c->workspace.orbitSteps + 1);
             c->touch();
         }},
        {"One step less of the orbit", ",",
         [c] {
             c->workspace.orbitSteps = std::max(0, c->workspace.orbitSteps - 1);
             c->touch();
         }},
        {"Play or pause the animation", "Space",
         [c] {
             if (c->animation.number.empty())
                 c->say("Choose a number first: the triangle beside a parameter");
             else
                 c->animation.running = !c->animation.running;
             c->host.wake();
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
        {"The list of keys", "?", [c] { c->keysOpen = !c->keysOpen; }},
    };
    for (int k = 0; k < kMostViews; ++k)
        all.push_back({"Mark view " + std::to_string(k + 1), std::to_string(k + 1), [c, k] {
                           if (k < static_cast<int>(c->workspace.views.size()))
                               c->workspace.focused = k;
                       }});
    return all;
}

void handleKeys(StudioContext& context) {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.WantTextInput) return;
    const bool command = io.KeyCtrl || io.KeySuper;
    const auto run = [&](const char* keys) {
        for (const Command& entry : commandsOf(context))
            if (entry.keys == keys) return entry.run();
    };
    const auto pressed = [](ImGuiKey key, bool repeat = false) {
        return ImGui::IsKeyPressed(key, repeat);
    };
    if (command) {
        if (pressed(ImGuiKey_Z, true)) run(io.KeyShift ? "Shift Ctrl Z" : "Ctrl Z");
        if (pressed(ImGuiKey_Y, true)) run("Shift Ctrl Z");
        if (pressed(ImGuiKey_K)) run("Ctrl K");
        if (pressed(ImGuiKey_E)) run("Ctrl E");
        if (pressed(ImGuiKey_L)) run("Ctrl L");
        if (pressed(ImGuiKey_S)) run("Ctrl S");
        return;
    }
    if (context.searchOpen || context.exportOpen) return;
    if (pressed(ImGuiKey_Home)) run("Home");
    if (pressed(ImGuiKey_Backspace)) run(io.KeyShift ? "Shift Backspace" : "Backspace");
    if (pressed(ImGuiKey_F)) run(io.KeyShift ? "Shift F" : "F");
    if (pressed(ImGuiKey_P)) run("P");
    if (pressed(ImGuiKey_T)) run("T");
    if (pressed(ImGuiKey_G)) run("G");
    if (pressed(ImGuiKey_Space)) run("Space");
    if (pressed(ImGuiKey_Period, true)) run(".");
    if (pressed(ImGuiKey_Comma, true)) run(",");
    if (pressed(ImGuiKey_Equal, true) || pressed(ImGuiKey_KeypadAdd, true)) run("+");
    if (pressed(ImGuiKey_Minus, true) || pressed(ImGuiKey_KeypadSubtract, true)) run("-");
    if (pressed(ImGuiKey_Slash) && io.KeyShift) run("?");
    for (int k = 0; k < kMostViews; ++k)
        if (pressed(static_cast<ImGuiKey>(ImGuiKey_1 + k))) run(std::to_string(k + 1).c_str());
    // Arrows pan; with Shift they nudge the point by a pixel's worth.
    const int right = pressed(ImGuiKey_RightArrow, true) - pressed(ImGuiKey_LeftArrow, true);
    const int up = pressed(ImGuiKey_UpArrow, true) - pressed(ImGuiKey_DownArrow, true);
    if (right == 0 && up == 0) return;
    if (!io.KeyShift) return context.pan(context.workspace.focused, 0.1 * right, 0.1 * up);
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

namespace {

void drawSearch(StudioContext& context) {
    static char question[128];
    if (context.searchOpen && !ImGui::IsPopupOpen("Find")) {
        question[0] = 0;
        ImGui::OpenPopup("Find");
    }
    const ImGuiViewport& screen = *ImGui::GetMainViewport();
    ImGui::SetNextWindowPos({screen.GetCenter().x, screen.Pos.y + screen.Size.y * 0.12f},
                            ImGuiCond_Always, {0.5f, 0});
    ImGui::SetNextWindowSize(
        {std::min(620.0f * context.scale, screen.Size.x * 0.94f), screen.Size.y * 0.62f});
    if (!ImGui::BeginPopupModal("Find", &context.searchOpen, ImGuiWindowFlags_NoResize)) return;
    if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-1);
    const bool enter =
        ImGui::InputTextWithHint("##question", "a map, a preset, a command", question,
                                 sizeof question, ImGuiInputTextFlags_EnterReturnsTrue);
    std::vector<Command> entries;
    for (const std::string& name : presetNames())
        entries.push_back({"Preset: " + name, "", [&context, name] {
                               Expected<Scene> scene = presetNamed(name);
                               if (!scene) return context.report(scene.status());
                               context.open(workspaceOf(*scene));
                           }});
    for (const MapKernels& map : catalogue()) {
        const std::string name(map.info.name);
        entries.push_back({"Map: " + std::string(map.info.title) + "  (" + name + ")", "",
                           [&context, name] { context.newMap(name); }});
    }
    for (Command& command : commandsOf(context)) entries.push_back(std::move(command));
    const Command* chosen = nullptr;
    bool first = true;
    ImGui::BeginChild("entries");
    for (const Command& entry : entries) {
        if (!matches(entry.name, question)) continue;
        const bool picked = ImGui::Selectable(entry.name.c_str(), first && question[0] != 0);
        if (!entry.keys.empty()) {
            ImGui::SameLine(ImGui::GetContentRegionAvail().x - ImGui::GetFontSize() * 6);
            ImGui::TextDisabled("%s", entry.keys.c_str());
        }
        if (picked || (enter && first)) chosen = &entry;
        first = false;
    }
    if (first) ImGui::TextDisabled("Nothing has this name.");
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
    if (ImGui::Begin("Keys", &context.keysOpen,
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse)) {
        if (ImGui::BeginTable("keys", 2)) {
            const auto row = [](const char* keys, const char* name) {
                ImGui::TableNextRow();
                ImGui::TableNextColumn();
                ImGui::TextUnformatted(keys);
                ImGui::TableNextColumn();
                ImGui::TextUnformatted(name);
            };
            for (const Command& command : commandsOf(context))
                if (!command.keys.empty()) row(command.keys.c_str(), command.name.c_str());
            row("arrows", "Pan; with Shift: move the point by a pixel");
            row("drag, wheel", "Pan, zoom at the pointer");
            row("right drag", "Zoom to a box");
            row("Ctrl click", "Put the point here");
            row("Shift click", "Pin these parameters");
            ImGui::EndTable();
        }
        if (ImGui::IsKeyPressed(ImGuiKey_Escape)) context.keysOpen = false;
    }
    ImGui::End();
}

void drawExport(StudioContext& context) {
    if (context.exportOpen && !ImGui::IsPopupOpen("Export")) ImGui::OpenPopup("Export");
    ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Always, {0.5f, 0.5f});
    if (!ImGui::BeginPopupModal("Export", &context.exportOpen, ImGuiWindowFlags_AlwaysAutoResize))
        return;
    const double progress = context.host.exportProgress();
    ImGui::TextUnformatted(
        "A PNG of the marked view that carries its scene: it can be opened again.");
    ImGui::BeginDisabled(progress >= 0);
    ImGui::InputInt("pixels wide", &context.exportWidth, 100, 1000);
    context.exportWidth = std::clamp(context.exportWidth, 16, kMostPixels);
    int samples = context.workspace.view().samples;
    if (ImGui::SliderInt("samples along a pixel", &samples, 1, kMostSamples)) {
        context.workspace.view().samples = samples;
        context.touch();
    }
    if (ImGui::Button("Export")) context.startExport();
    ImGui::EndDisabled();
    ImGui::SameLine();
    if (progress >= 0) {
        ImGui::ProgressBar(static_cast<float>(progress), {ImGui::GetFontSize() * 10, 0});
        ImGui::SameLine();
        if (ImGui::Button("Cancel")) context.host.cancelExport();
    } else if (ImGui::Button("Close") || ImGui::IsKeyPressed(ImGuiKey_Escape)) {
        context.exportOpen = false;
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
}

}  // namespace

void drawDialogs(StudioContext& context) {
    drawSearch(context);
    drawKeys(context);
    drawExport(context);
}

}  // namespace versorium
