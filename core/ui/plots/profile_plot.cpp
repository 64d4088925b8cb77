// SPDX-License-Identifier: MIT
// The strip's radial profile (S Fig 8 bottom): the mean of φ over the circle or sphere of radius r
// against r, with r̂ of that mean, the line r̂ = r, and the radii where capture and escape are sure
// whatever the versor is.
#include <algorithm>
#include <cmath>

#include "render/shape_profile.h"
#include "ui/plots/plots.h"
#include "ui/session/context.h"
#include "ui/widgets/help.h"

namespace versorium {
namespace {

// How finely it is sampled: at once, and then from frame to frame while everything stands still.
struct Fineness {
    int radii, points, outwardRadii, outwardPoints;
};
constexpr Fineness kLevels[] = {{65, 256, 129, 128}, {129, 1024, 513, 256}, {257, 2048, 1025, 512}};
constexpr int kLevelCount = 3;
constexpr double kBudget = 0.03;  // seconds of a frame for a finer one
// Where others keep the CPU busy a finer one may come in time at the next attempt.
constexpr double kAgain = 0.3;
constexpr int kMostTries = 4;

// On this thread; cancelled between two radii once its time is over.
class FrameJob : public Job {
  public:
    explicit FrameJob(const Host& host) : Job(1), host_(host), begin_(host.now()) {
        onProgress = [this](double) {
            if (host_.now() - begin_ > kBudget) cancel();
        };
    }

  private:
    const Host& host_;
    double begin_;
};

// The text of what the profile follows from.
std::string keyOf(const Scene& scene) {
    const Json json = sceneBody(scene);
    Json key;
    for (const char* part : {"map", "parameters", "shape", "modulation", "escape_radius"})
        if (json.contains(part)) key[part] = json[part];
    return key.dump();
}

Expected<RadialProfile> sampled(const OrbitProgram& program, const Scene& scene, int level,
                                Job& job) {
    const Fineness& fine = kLevels[level];
    RadialOptions options = radialOptions(scene, program.escapeRadius);
    options.to = 1.5 * shapeReach(*program.field, options);
    options.radii = fine.radii;
    options.points = fine.points;
    options.outwardRadii = fine.outwardRadii;
    options.outwardPoints = fine.outwardPoints;
    return radialProfile(*program.field, options, job);
}

// Where r̂ of the mean goes through the line r̂ = r.
std::vector<double> crossings(const RadialProfile& profile) {
    std::vector<double> found;
    for (std::size_t i = 1; i < profile.radius.size(); ++i) {
        const double a = profile.modulus[i - 1] - profile.radius[i - 1];
        const double b = profile.modulus[i] - profile.radius[i];
        if ((a < 0) == (b < 0)) continue;
        const double part = a / (a - b);
        found.push_back(profile.radius[i - 1] + part * (profile.radius[i] - profile.radius[i - 1]));
    }
    return found;
}

// A list at a radius, between its neighbours.
double at(const RadialProfile& profile, const std::vector<double>& values, double radius) {
    const double steps = static_cast<double>(values.size() - 1);
    const double place = std::clamp(radius / profile.radius.back(), 0.0, 1.0) * steps;
    const auto i = static_cast<std::size_t>(std::min(place, steps - 1));
    const double part = place - static_cast<double>(i);
    return values[i] + part * (values[i + 1] - values[i]);
}

std::string number(double value) { return shownNumber(value, 3); }

// Where in the window a radius and a value lie.
struct Plot {
    ImVec2 low, high;
    double to, bottom, top;
    float x(double radius) const {
        return low.x + static_cast<float>(radius / to) * (high.x - low.x);
    }
    float y(double value) const {
        const double part = std::clamp((value - bottom) / (top - bottom), -1.0, 2.0);
        return high.y - static_cast<float>(part) * (high.y - low.y);
    }
    ImVec2 operator()(double radius, double value) const { return {x(radius), y(value)}; }
    // The top of the row that the numbers of the radii stand in.
    float numbers() const { return high.y - ImGui::GetTextLineHeight() - 2; }
    // The top of a row of text, from above.
    float row(int k) const {
        return low.y + 4 + static_cast<float>(k) * (ImGui::GetTextLineHeight() + 2);
    }
};

void drawCurve(ImDrawList& list, const Plot& plot, const RadialProfile& profile,
               const std::vector<double>& values, ImU32 colour) {
    std::vector<ImVec2> points;
    for (std::size_t i = 0; i < values.size(); ++i)
        points.push_back(plot(profile.radius[i], values[i]));
    list.AddPolyline(points.data(), static_cast<int>(points.size()), colour, 0, 2);
}

void drawBand(ImDrawList& list, const Plot& plot, const RadialProfile& profile, ImU32 colour) {
    // Smooth edges would show between the pieces.
    const ImDrawListFlags flags = list.Flags;
    list.Flags &= ~ImDrawListFlags_AntiAliasedFill;
    for (std::size_t i = 1; i < profile.radius.size(); ++i)
        list.AddQuadFilled(plot(profile.radius[i - 1], profile.low[i - 1]),
                           plot(profile.radius[i], profile.low[i]),
                           plot(profile.radius[i], profile.high[i]),
                           plot(profile.radius[i - 1], profile.high[i - 1]), colour);
    list.Flags = flags;
}

void drawGrid(ImDrawList& list, const Plot& plot) {
    const ImU32 line = ImGui::GetColorU32(ImGuiCol_Border);
    const ImU32 text = ImGui::GetColorU32(ImGuiCol_TextDisabled);
    list.AddLine({plot.low.x, plot.y(0)}, {plot.high.x, plot.y(0)}, line);
    // Four parts of a round length.
    const double raw = plot.to / 4;
    const double unit = std::pow(10.0, std::floor(std::log10(raw)));
    const double step = raw < 2 * unit ? unit : raw < 5 * unit ? 2 * unit : 5 * unit;
    for (double radius = step; radius < 0.97 * plot.to; radius += step) {
        const float x = plot.x(radius), y = plot.y(0);
        list.AddLine({x, y - 3}, {x, y + 3}, text);
        list.AddText({x + 3, plot.numbers()}, text, number(radius).c_str());
    }
}

// A radius beyond or within which the fate is sure.
void drawSure(ImDrawList& list, const Plot& plot, double radius, const std::string& name, int row) {
    const ImU32 colour = IM_COL32(255, 222, 110, 255);
    const float x = plot.x(radius);
    list.AddLine({x, plot.low.y}, {x, plot.numbers() - 2}, colour, 1.5f);
    const float wide = ImGui::CalcTextSize(name.c_str()).x;
    const bool right = x + wide + 8 < plot.high.x;
    drawText(list, {right ? x + 5 : x - wide - 5, plot.row(row)}, colour, name);
}

void drawKey(ImDrawList& list, ImVec2 corner, const char* name, ImU32 colour) {
    const float middle = corner.y + 0.5f * ImGui::GetTextLineHeight();
    list.AddLine({corner.x, middle}, {corner.x + 18, middle}, colour, 2);
    drawText(list, {corner.x + 24, corner.y}, ImGui::GetColorU32(ImGuiCol_Text), name);
}

}  // namespace

const ProfileStudy& studyProfile(StudioContext& context) {
    ProfileStudy& study = context.studies.profile;
    const OrbitProgram* program = context.bound.orbitProgram();
    if (!program || !program->field) {
        study = {};
        study.problem = program ? trLater("This map has no shape.")
                                : trLater("The shape is being made into a grid.");
        return study;
    }
    const Scene& scene = context.workspace.views[context.workspace.speaker()];
    if (study.revision != context.revision()) {
        study.revision = context.revision();
        std::string key = keyOf(scene);
        if (key != study.key) {
            study.key = std::move(key);
            study.level = study.tries = 0;
            study.ended = false;
            study.profile.reset();
        }
    }
    if (study.ended) return study;
    if (study.profile && !atRest(context)) {
        context.host.wakeAfter(0.1);
        return study;
    }
    // The first one is wanted at once, whatever it takes.
    Job whole(1);
    FrameJob timed(context.host);
    const bool first = !study.profile;
    Expected<RadialProfile> profile = sampled(*program, scene, study.level, first ? whole : timed);
    if (profile) {
        study.profile = std::make_shared<const RadialProfile>(std::move(*profile));
        study.problem.clear();
        ++study.level;
    } else if (profile.status().kind() != ErrorKind::cancelled) {
        study.problem = profile.status().message();
    }
    const bool cancelled = !profile && profile.status().kind() == ErrorKind::cancelled;
    study.ended = study.level == kLevelCount || (!profile && !cancelled) ||
                  (cancelled && ++study.tries == kMostTries);
    if (!study.ended) context.host.wakeAfter(cancelled ? kAgain : 0);
    return study;
}

std::string profileAt(const RadialProfile& profile, double radius) {
    const double modulus = at(profile, profile.modulus, radius);
    const std::string text = tr("r = {1}:  mean φ = {2} ({3} to {4}),  r̂ = {5}",
                                {number(radius), number(at(profile, profile.mean, radius)),
                                 number(at(profile, profile.low, radius)),
                                 number(at(profile, profile.high, radius)), number(modulus)});
    if (radius <= profile.capture) return text + tr(": stays, whatever the versor is");
    if (radius > profile.escape) return text + tr(": leaves, whatever the versor is");
    return text + (modulus < radius ? tr(" < r: tends to fall") : tr(" ≥ r: tends to rise"));
}

std::string describeProfile(StudioContext& context) {
    const ProfileStudy& study = studyProfile(context);
    if (!study.profile) return trMessage(study.problem);
    const RadialProfile& profile = *study.profile;
    std::string text = tr(
        "Radial profile: mean φ is {1} at the origin and {2} at r = {3}.",
        {number(profile.mean.front()), number(profile.mean.back()), number(profile.radius.back())});
    text += " " + (profile.capture > 0 ? tr("Orbits within {1} stay.", {number(profile.capture)})
                                       : tr("No radius is found within which all orbits stay."));
    text += " " + tr("Orbits beyond {1} leave.", {number(profile.escape)}) + " ";
    std::string places;
    for (double radius : crossings(profile))
        places += (places.empty() ? "" : numberSeparator()) + number(radius);
    return text + (places.empty() ? tr("r̂ of the mean does not meet the line r̂ = r.")
                                  : tr("r̂ of the mean equals r at {1}.", {places}));
}

void drawProfile(StudioContext& context) {
    const ProfileStudy& study = studyProfile(context);
    if (!study.profile) return ImGui::TextDisabled("%s", trMessage(study.problem).c_str());
    const RadialProfile& profile = *study.profile;
    const bool planar = mapOf(context.workspace.views[0]).info.algebra == Algebra::complex;
    ImGui::TextDisabled("%s", planar ? tr("Over circles of radius r around the origin")
                                     : tr("Over spheres of radius r around the origin"));
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 space = ImGui::GetContentRegionAvail();
    if (space.x < 60 || space.y < 30) return;
    const ImVec2 high{low.x + space.x, low.y + space.y};
    ImGui::InvisibleButton("profile plot", space);
    explain("profile plot");
    const bool hovered = ImGui::IsItemHovered();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, high, ImGui::GetColorU32(ImGuiCol_FrameBg), 6);
    const double to = profile.radius.back();
    const double least = *std::min_element(profile.low.begin(), profile.low.end());
    const double margin = 0.06 * (to - least);
    const Plot plot{{low.x + 8, low.y + 4},
                    {high.x - 8, high.y - 4},
                    to,
                    std::min(0.0, least) - margin,
                    to + margin};
    list.PushClipRect(low, high, true);
    const ImU32 mean = ImGui::GetColorU32(ImGuiCol_CheckMark);
    const ImU32 modulus = pinColour(0);
    const ImU32 diagonal = ImGui::GetColorU32(ImGuiCol_TextDisabled);
    drawGrid(list, plot);
    ImVec4 band = ImGui::GetStyleColorVec4(ImGuiCol_CheckMark);
    band.w = 0.18f;
    drawBand(list, plot, profile, ImGui::ColorConvertFloat4ToU32(band));
    list.AddLine(plot(0, 0), plot(to, to), diagonal, 1.2f);
    drawCurve(list, plot, profile, profile.modulus, modulus);
    drawCurve(list, plot, profile, profile.mean, mean);
    if (profile.capture > 0)
        drawSure(list, plot, profile.capture, tr("stays within {1}", {number(profile.capture)}), 0);
    if (profile.escape < to)
        drawSure(list, plot, profile.escape, tr("leaves beyond {1}", {number(profile.escape)}), 1);
    const float letter = ImGui::GetFontSize(), line = ImGui::GetTextLineHeight() + 2;
    ImVec2 corner{high.x - 13 * letter, plot.numbers() - 3.2f * line};
    ImVec4 ground = ImGui::GetStyleColorVec4(ImGuiCol_FrameBg);
    ground.w = 0.85f;
    list.AddRectFilled({corner.x - 6, corner.y - 4}, {high.x - 4, plot.numbers() - 2},
                       ImGui::ColorConvertFloat4ToU32(ground), 4);
    const std::pair<const char*, ImU32> keys[] = {
        {tr("mean φ, least to most"), mean}, {tr("r̂ of the mean"), modulus}, {"r̂ = r", diagonal}};
    for (const auto& [name, colour] : keys) {
        drawKey(list, corner, name, colour);
        corner.y += line;
    }
    if (hovered) {
        const float x = std::clamp(ImGui::GetIO().MousePos.x, plot.low.x, plot.high.x);
        const double radius =
            to * static_cast<double>((x - plot.low.x) / (plot.high.x - plot.low.x));
        list.AddLine({x, low.y}, {x, high.y}, diagonal, 1);
        for (const auto& [values, colour] :
             {std::pair{&profile.mean, mean}, std::pair{&profile.modulus, modulus}})
            list.AddCircleFilled(plot(radius, at(profile, *values, radius)), 4, colour);
        const std::string text = profileAt(profile, radius);
        const float wide = ImGui::CalcTextSize(text.c_str()).x;
        drawText(
            list,
            {std::clamp(x + 8, low.x + 6, std::max(low.x + 6, high.x - wide - 6)), plot.row(2)},
            ImGui::GetColorU32(ImGuiCol_Text), text);
    }
    list.PopClipRect();
}

}  // namespace versorium
