// SPDX-License-Identifier: MIT
// What becomes of the point under the pointer: a line for the status and a table for the inspector.
#include <algorithm>

#include "fields/dynamics.h"
#include "math/elementary.h"
#include "scene/shape_controls.h"
#include "shape/modulation.h"
#include "ui/session/shape_change.h"
#include "ui/views/view.h"
#include "ui/widgets/help.h"

namespace versorium {
namespace {

constexpr int kProbeIterations = 20000;
// What the table says of a point, in its order; a row without a value keeps its place.
constexpr const char* kRows[] = {
    trLater("becomes"),  trLater("multiplier λ"), "|λ|",
    trLater("last |z|"), trLater("versor of f"),  trLater("to the boundary")};

// As many digits as neighbouring pixels need to differ.
std::string coordinate(double value, const Viewport& place) {
    const double size = std::max(std::abs(value), place.pixel());
    const int digits = static_cast<int>(std::ceil(std::log10(size / place.pixel()))) + 1;
    return shownNumber(value, std::clamp(digits, 3, 17));
}

std::string complexText(std::complex<double> value) {
    const double tiny = 5e-7 * std::max(1.0, std::abs(value));
    if (std::abs(value.imag()) < tiny) return shownNumber(value.real(), 5);
    return shownNumber(std::abs(value.real()) < tiny ? 0 : value.real(), 5) +
           (value.imag() < 0 ? " − " : " + ") + shownNumber(std::abs(value.imag()), 5) + " i";
}

// What a shape modulus looks up there: φ, α and β where they differ over space, and r̂.
void probeShape(const Scene& scene, const OrbitProgram& program, Probe& found) {
    const std::array<double, 3> at = shapePlace(scene, program, found.u, found.v);
    const ShapeControls controls = shapeControls(scene);
    const auto number = [&](double base, const Modulation* modulation) {
        return modulation ? modulation->at(at[0], at[1], at[2], base) : base;
    };
    const double phi = program.field->at(at[0], at[1], at[2]);
    const double alpha = number(controls.alpha, program.field->alpha());
    const double beta = number(controls.beta, program.field->beta());
    const double exponent = alpha * (phi - (controls.asPrinted ? -beta : beta));
    found.rows.emplace_back(tr("distance φ"), shownNumber(phi, 4));
    if (program.field->alpha()) found.rows.emplace_back(tr("α here"), shownNumber(alpha, 4));
    if (program.field->beta()) found.rows.emplace_back(tr("β here"), shownNumber(beta, 4));
    found.rows.emplace_back(tr("modulus r̂"),
                            shownNumber(exp(std::clamp(exponent, -300.0, 300.0)), 4));
}

}  // namespace

void probe(const ViewFrame& frame) {
    StudioContext& context = frame.context;
    const Scene& scene = frame.scene();
    Probe& found = context.probe;
    const double u = frame.u(), v = frame.v();
    if (found.view == frame.view && found.u == u && found.v == v &&
        found.revision == context.revision())
        return;
    found = {};
    found.view = frame.view;
    found.u = u;
    found.v = v;
    found.revision = context.revision();
    for (std::size_t k = 0; k < 2 && k < scene.slice.axes.size(); ++k) {
        const std::string name = scene.slice.axes[k].terms[0].first;
        const std::string value = coordinate(k ? v : u, frame.plane.place);
        found.text += (k ? "   " : "") + name + " = " + value;
        found.rows.emplace_back(name, value);
    }
    std::vector<std::string> values(std::size(kRows));
    const OrbitProgram* bound = context.bound.program(frame.view);
    if (bound) {
        OrbitProgram program = *bound;
        program.iterations = std::min(program.iterations, kProbeIterations);
        const double* coordinates[3] = {&found.u, &found.v, &found.v};
        const FieldName fields[] = {FieldName::membership, FieldName::escapeStep,
                                    FieldName::squaredNorm, FieldName::versor, FieldName::distance};
        const auto measured = evaluateFields(program, 1, coordinates, fields);
        if (measured[0][0] == 1) {
            const double at[3] = {found.u, found.v, 0};
            const std::optional<Cycle> cycle = cycleOf(program, at);
            const std::string count = std::to_string(cycle ? cycle->period : program.iterations);
            values[0] =
                cycle ? tr("cycle of period {1}", {count}) : tr("stays for {1} steps", {count});
            found.text +=
                "   " + (cycle ? tr("drawn to a cycle of period {1}", {count}) : values[0]);
            if (cycle) {
                if (cycle->multiplier) values[1] = complexText(*cycle->multiplier);
                values[2] = shownNumber(cycle->modulus, 5);
                found.text += ", |λ| = " + values[2];
            }
            values[5] = tr("inside");
        } else {
            values[0] = tr("escapes at step {1}", {shownNumber(measured[1][0], 8)});
            found.text += "   " + values[0];
            if (measured[4][0] > 0) values[5] = shownNumber(measured[4][0], 3);
        }
        values[3] = shownNumber(std::sqrt(measured[2][0]), 5);
        found.text += "   |z| = " + values[3];
        for (std::size_t k = 0; k < measured[3].size(); ++k)
            values[4] += (k ? numberSeparator() : "") + shownNumber(measured[3][k], 3);
    }
    for (std::size_t k = 0; k < std::size(kRows); ++k)
        found.rows.emplace_back(tr(kRows[k]), values[k]);
    if (bound && bound->field && traitsOf(scene).shape) probeShape(scene, *bound, found);
}

void drawProbe(StudioContext& context) {
    if (context.probe.rows.empty()) return ImGui::TextDisabled("%s", tr("Point at a view."));
    if (!ImGui::BeginTable("probe", 2)) return;
    ImGui::TableSetupColumn("what", ImGuiTableColumnFlags_WidthFixed);
    ImGui::TableSetupColumn("value");
    for (const auto& [name, value] : context.probe.rows) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TextDisabled("%s", name.c_str());
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(value.empty() ? "–" : value.c_str());
    }
    ImGui::EndTable();
}

}  // namespace versorium
