// SPDX-License-Identifier: MIT
// Images behind and in front of the focused view's fractal.
#include <algorithm>

#include "ui/panels/number_field.h"
#include "ui/panels/panels.h"
#include "ui/panels/value_widgets.h"
#include "ui/session/context.h"
#include "ui/session/open_file.h"
#include "ui/widgets/help.h"

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

}  // namespace

void drawLayers(StudioContext& context) {
    const Scene& scene = context.workspace.view();
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
            drawGroup(context, "layers[" + std::to_string(k) + "]");
            ImGui::TreePop();
        }
        ImGui::PopID();
    }
    if (removed >= 0)
        context.edit([&](Workspace& w) {
            w.view().layers.erase(w.view().layers.begin() + removed);
            dropUnnamedAssets(w);
        });
    if (scene.layers.size() < kMostLayers) {
        if (ImGui::Button(tr("Leaf")))
            context.edit([](Workspace& w) { addBuiltInLayer(w.view(), true); });
        explain("layer leaf");
        ImGui::SameLine();
        if (ImGui::Button(tr("White")))
            context.edit([](Workspace& w) { addBuiltInLayer(w.view(), false); });
        explain("layer white");
        ImGui::SameLine();
        if (ImGui::Button(tr("Image …"))) {
            context.imagesAreLayers = true;
            context.chooseFile();
        }
        explain("layer image");
        drawValue(context, "images_are_layers");
    }
    if (!scene.layers.empty() && scene.colour.rule != ColourRule::gradient)
        ImGui::TextDisabled("%s", tr("Colours of the gradient rule let images through."));
}

}  // namespace versorium
