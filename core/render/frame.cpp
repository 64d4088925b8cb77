// SPDX-License-Identifier: MIT
#include "render/frame.h"

#include <string>

namespace versorium {

Status checkSize(const Scene& scene, Size size) {
    if (size.width < 1 || size.height < 1 || size.width > kMostPixels || size.height > kMostPixels)
        return Status::usage("a picture of " + std::to_string(size.width) + " x " +
                             std::to_string(size.height) + " pixels: each side must be 1 to " +
                             std::to_string(kMostPixels));
    const long long samples = 1LL * size.width * size.height * scene.samples * scene.samples;
    if (samples > kMostSamplesInAll)
        return Status::usage("the picture has " + std::to_string(samples) + " samples, more than " +
                             std::to_string(kMostSamplesInAll) +
                             "; make it smaller or take fewer samples");
    return {};
}

}  // namespace versorium
