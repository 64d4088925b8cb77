// SPDX-License-Identifier: MIT
#pragma once
// Plates as documents: the built-in ones, values set by name, and the PNG that carries its plate.

#include "io/document.h"
#include "plate/plate.h"
#include "render/cpu/cpu_renderer.h"

namespace versorium {

// A plate and how it is to be made.
struct PlateDocument {
    Plate plate;
    PlateOptions options;
};

std::vector<std::string> plateNames();
Expected<PlateDocument> plateNamed(const std::string& name);
Expected<PlateDocument> plateFromDocument(const Document& document);

// The document that makes it again: what its PNG carries.
Document documentOfPlate(const PlateDocument& plate);

// A bare key reaches every panel whose scene has it, "b.alpha" the panel named b. A key that none
// has is ErrorKind::usage.
Status assign(PlateDocument& plate, const Assignment& assignment);

struct PlateFile {
    std::vector<unsigned char> png;
    std::string text;  // caption and alternative text
};
Expected<PlateFile> renderPlate(CpuRenderer& renderer, const PlateDocument& plate, Job& job);

}  // namespace versorium
