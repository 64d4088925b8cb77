// SPDX-License-Identifier: MIT
// Prints the SHA-256 of all fields and of the PNG of every preset, and of every built-in plate,
// each small. The test runs the native and the WebAssembly program and compares what they print.
#include <cstdio>

#include "base/hash.h"
#include "io/npy.h"
#include "plate/plate_picture.h"
#include "render/picture.h"

namespace versorium {
namespace {

bool fail(const Status& status) {
    std::fprintf(stderr, "%s\n", status.message().c_str());
    return false;
}

bool printPreset(CpuRenderer& renderer, const std::string& name, Job& job) {
    Expected<Scene> scene = presetNamed(name);
    if (!scene) return fail(scene.status());
    const PictureOptions options{.size = {48, 36}};
    std::vector<FieldName> names;
    for (const FieldInfo& field : allFields()) names.push_back(field.field);
    std::vector<Raster<double>> rasters;
    if (Status status = renderer.measure(*scene, options.size, names, {}, job, rasters);
        !status.ok())
        return fail(status);
    for (std::size_t i = 0; i < names.size(); ++i)
        std::printf("%s %s %s\n", name.c_str(), std::string(infoOf(names[i]).name).c_str(),
                    sha256(writeNpy(rasters[i])).c_str());
    Expected<std::vector<unsigned char>> png = renderPicture(renderer, *scene, options, job);
    if (!png) return fail(png.status());
    std::printf("%s PNG %s\n", name.c_str(), sha256(*png).c_str());
    return true;
}

bool printPlate(CpuRenderer& renderer, const std::string& name, Job& job) {
    Expected<PlateDocument> plate = plateNamed(name);
    if (!plate) return fail(plate.status());
    plate->options.widthMillimetres = 89;
    plate->options.dotsPerInch = 60;
    for (const char* set : {"samples=1", "iterations=60"})
        if (Status status = assign(*plate, *parseAssignment(set)); !status.ok())
            return fail(status);
    Expected<PlateFile> file = renderPlate(renderer, *plate, job);
    if (!file) return fail(file.status());
    std::printf("plate %s PNG %s\n", name.c_str(), sha256(file->png).c_str());
    return true;
}

}  // namespace
}  // namespace versorium

int main() {
    using namespace versorium;
    CpuRenderer renderer;
    Job job(2);
    bool good = true;
    for (const std::string& name : presetNames()) good = printPreset(renderer, name, job) && good;
    for (const std::string& name : plateNames()) good = printPlate(renderer, name, job) && good;
    return good ? 0 : 1;
}
