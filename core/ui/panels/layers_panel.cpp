// SPDX-License-Identifier: MIT
// Images behind and in front of the marked view's fractal.
#include <algorithm>

#include "ui/session/context.h"
#include "ui/widgets/help.h"
#include "ui/widgets/number_field.h"

namespace versorium {
namespace {

// What a layer is called: the leaf, a colour, or the file's own name.
std::string nameOf(const Scene& scene, const Layer& layer) {
    const std::string& source = layer.sources[0];
    std::string name = tr(std::string_view(source));
    if (source.starts_with("asset:")) {
        const auto asset = scene.assets.find(source.substr(6));
        name = asset == scene.assets.end() ? tr("an image that is missing") : asset->second->name;
    }
    if (layer.sources.size() > 1)
        name = tr("{1} and {2} more", {name, std::to_string(layer.sources.size() - 1)});
    return name;
}

bool layerControls(StudioContext& context, std::size_t k, Layer& layer) {
    const std::string id = "layers[" + std::to_string(k) + "]";
    bool changed = false;
    const auto number = [&](const char* part, const char* label, double& value, NumberLook look) {
        look.help = helpOf("layer " + std::string(part));
        changed |= numberField(context, id + "." + part, label, value, look);
    };
    number("x", "to the right", layer.x, {.low = -1, .high = 1, .home = 0});
    number("y", "up", layer.y, {.low = -1, .high = 1, .home = 0});
    number("scale", "size", layer.scale, {.low = 0.1, .high = 4, .home = 1, .logarithmic = true});
    number("opacity", "opacity", layer.opacity, {.low = 0, .high = 1, .home = 1});
    if (layer.sources.size() > 1)
        number("frame", "frame", layer.frame,
               {.low = 0, .high = static_cast<double>(layer.sources.size() - 1), .home = 0});
    layer.scale = std::clamp(layer.scale, 1e-3, 1000.0);
    layer.opacity = std::clamp(layer.opacity, 0.0, 1.0);
    layer.x = std::clamp(layer.x, -100.0, 100.0);
    layer.y = std::clamp(layer.y, -100.0, 100.0);
    changed |= ImGui::Checkbox(tr("in front"), &layer.front);
    explain("layer front");
    return changed;
}

}  // namespace

void drawLayers(StudioContext& context) {
    Scene& scene = context.workspace.view();
    bool changed = false;
    int removed = -1;
    for (std::size_t k = 0; k < scene.layers.size(); ++k) {
        ImGui::PushID(static_cast<int>(k));
        const bool open = ImGui::TreeNodeEx("layer", ImGuiTreeNodeFlags_AllowOverlap, "%s",
                                            nameOf(scene, scene.layers[k]).c_str());
        explain("layer");
        ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::GetFontSize() * 1.6f);
        if (ImGui::SmallButton("×")) removed = static_cast<int>(k);
        explain("layer remove");
        if (open) {
            changed |= layerControls(context, k, scene.layers[k]);
            ImGui::TreePop();
        }
        ImGui::PopID();
    }
    if (removed >= 0) {
        scene.layers.erase(scene.layers.begin() + removed);
        dropUnnamedAssets(context.workspace);
        changed = true;
    }
    if (scene.layers.size() < kMostLayers) {
        if (ImGui::Button(tr("Leaf"))) {
            scene.layers.push_back({});
            changed = true;
        }
        explain("layer leaf");
        ImGui::SameLine();
        if (ImGui::Button(tr("White"))) {
            scene.layers.insert(scene.layers.begin(), Layer{.sources = {"#ffffff"}});
            changed = true;
        }
        explain("layer white");
        ImGui::SameLine();
        if (ImGui::Button(tr("Image …"))) {
            context.imagesAreLayers = true;
            context.chooseFile();
        }
        explain("layer image");
        ImGui::Checkbox(tr("opened images lie behind"), &context.imagesAreLayers);
        explain("layer drop");
    }
    if (!scene.layers.empty() && scene.colour.rule != "gradient")
        ImGui::TextDisabled("%s", tr("Colours of the gradient rule let images through."));
    if (changed) context.touch();
}

}  // namespace versorium
