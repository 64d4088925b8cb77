// SPDX-License-Identifier: MIT
// Plates, animations and what surrounds them in files.
#include <cstddef>
#include <string>

#include "io/document.h"
#include "plate/plate_picture.h"
#include "render/movie.h"
#include "render/picture.h"

using namespace versorium;

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    const Expected<Document> document = documentFromBytes({data, size});
    if (!document) {
        if (document.status().message().empty()) __builtin_trap();
        return 0;
    }
    (void)pictureOptions(*document);
    (void)sceneWithAssets(document->body, document->assets);
    (void)plateFromDocument(*document);
    (void)movieFromDocument(*document);
    if (!documentFromJson(documentToJson(*document))) __builtin_trap();
    return 0;
}
