// SPDX-License-Identifier: MIT
#pragma once
// What a picture carries and what can be opened: a scene, a plate or an animation, with how it is
// rendered. As JSON this is {"document": 1, "kind": "scene" | "plate" | "animation", "body": …,
// "assets": …, "render": …}; one of these alone is a document as well. In a PNG it is the text
// "versorium".

#include <span>
#include <string>
#include <vector>

#include "base/json.h"
#include "base/words.h"
#include "scene/scene.h"

namespace versorium {

inline constexpr const char* kDocumentKeyword = "versorium";
inline constexpr std::size_t kDocumentBytes = std::size_t{64} << 20;

enum class DocumentKind { scene, plate, animation };
template <>
struct EnumWords<DocumentKind> {
    static constexpr std::array<std::string_view, 3> table{"scene", "plate", "animation"};
};

struct Document {
    DocumentKind kind = DocumentKind::scene;
    Json body;  // one of these, without assets
    Assets assets;
    Json render = Json::object();  // the options that made the picture
    std::string note = {};         // what was left out of another program's file, as a sentence
};

Json documentToJson(const Document& document);
Expected<Document> documentFromJson(const Json& json);

// A JSON file, a PNG that carries a document, or another program's view (io/foreign_views.h); "-"
// is standard input.
Expected<Document> readDocument(const std::string& path);
Expected<Document> documentFromBytes(std::span<const unsigned char> bytes);

// The scene of a scene document, or of one panel, with those of the document's assets that it
// names: panels of a plate do not share what they do not use.
Expected<Scene> sceneWithAssets(const Json& scene, const Assets& assets);
// Adds those of the scene's assets that something in it names.
void addAssets(const Scene& scene, Assets& assets);

// --set key=value. A key is a path of the scene ("colour.palette"), the last part of one
// ("palette", "height"), or a number's or parameter's name ("c", "c.re", "roots[0].power"). `shape`
// and lists of roots also take files, and so does `palette` (io/palette_files.h). The key `layer`
// adds an image: a file, "leaf" or a colour.
struct Assignment {
    std::string key, value;
};
Expected<Assignment> parseAssignment(const std::string& text);
bool knowsKey(const Scene& scene, const std::string& key);
Status assign(Scene& scene, const Assignment& assignment);

}  // namespace versorium
