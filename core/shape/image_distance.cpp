// SPDX-License-Identifier: MIT
#include "shape/image_distance.h"

#include <algorithm>
#include <limits>
#include <string>

#include "math/elementary.h"

namespace versorium {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();
constexpr std::size_t kLinesPerPart = 16;

// out(i) = min over j of in(j) + (i - j)², by the lower envelope of the parabolas. Infinite values
// have no parabola; where all are infinite, so is the result.
class Envelope {
  public:
    explicit Envelope(int length)
        : values_(static_cast<std::size_t>(length)),
          places_(static_cast<std::size_t>(length)),
          starts_(static_cast<std::size_t>(length)) {}

    // The line's values are read from and written to first[0], first[stride], …
    void transform(double* first, std::size_t stride) {
        const std::size_t length = values_.size();
        for (std::size_t i = 0; i < length; ++i) values_[i] = first[i * stride];
        std::size_t count = 0;
        for (std::size_t i = 0; i < length; ++i) {
            if (values_[i] == kFar) continue;
            double start = -kFar;
            while (count > 0) {
                start = meeting(places_[count - 1], i);
                if (start > starts_[count - 1]) break;
                --count;
                start = -kFar;
            }
            places_[count] = i;
            starts_[count++] = start;
        }
        if (count == 0) return;
        std::size_t current = 0;
        for (std::size_t i = 0; i < length; ++i) {
            const auto place = static_cast<double>(i);
            while (current + 1 < count && starts_[current + 1] < place) ++current;
            const double apart = place - static_cast<double>(places_[current]);
            first[i * stride] = values_[places_[current]] + apart * apart;
        }
    }

  private:
    // Where the parabola over the later place `b` comes below that over `a`.
    double meeting(std::size_t a, std::size_t b) const {
        const auto x = static_cast<double>(a), y = static_cast<double>(b);
        return ((values_[b] + y * y) - (values_[a] + x * x)) / (2 * (y - x));
    }

    std::vector<double> values_;
    std::vector<std::size_t> places_;
    std::vector<double> starts_;
};

// Squared distances, in pixels, of every pixel to the nearest one of the given kind.
bool squaredDistances(const Raster<unsigned char>& mask, bool inside, Job& job,
                      std::vector<double>& result) {
    const auto width = static_cast<std::size_t>(mask.width());
    const auto height = static_cast<std::size_t>(mask.height());
    result.assign(width * height, kFar);
    for (std::size_t y = 0; y < height; ++y)
        for (std::size_t x = 0; x < width; ++x)
            if ((mask.at(static_cast<int>(x), static_cast<int>(y)) != 0) == inside)
                result[y * width + x] = 0;
    const auto parts = [](std::size_t lines) {
        return (lines + kLinesPerPart - 1) / kLinesPerPart;
    };
    return job.parallelFor(parts(width), [&](std::size_t part) {
        Envelope envelope(mask.height());
        const std::size_t begin = part * kLinesPerPart;
        const std::size_t end = std::min(begin + kLinesPerPart, width);
        for (std::size_t x = begin; x < end; ++x) envelope.transform(result.data() + x, width);
    }) && job.parallelFor(parts(height), [&](std::size_t part) {
        Envelope envelope(mask.width());
        const std::size_t begin = part * kLinesPerPart;
        const std::size_t end = std::min(begin + kLinesPerPart, height);
        for (std::size_t y = begin; y < end; ++y) envelope.transform(result.data() + y * width, 1);
    });
}

Status checkMask(const Raster<unsigned char>& mask) {
    if (mask.width() < 2 || mask.height() < 2)
        return Status::data("the picture has " + std::to_string(mask.width()) + " × " +
                            std::to_string(mask.height()) +
                            " pixels; a shape needs at least 2 on each side");
    bool any = false, all = true;
    for (int y = 0; y < mask.height(); ++y)
        for (int x = 0; x < mask.width(); ++x) {
            any = any || mask.at(x, y) != 0;
            all = all && mask.at(x, y) != 0;
        }
    if (!any || all)
        return Status::data(std::string("the picture has no boundary: ") + (all ? "every" : "no") +
                            " pixel is inside the shape; choose another threshold");
    return {};
}

}  // namespace

Expected<Grid> imageDistance(const Raster<unsigned char>& mask, Job& job) {
    if (const Status status = checkMask(mask); !status.ok()) return status;
    std::vector<double> toInside, toOutside;
    if (!squaredDistances(mask, true, job, toInside) ||
        !squaredDistances(mask, false, job, toOutside))
        return Status::cancelled();
    const double pixel = 1.0 / std::max(mask.width(), mask.height());
    Grid grid;
    grid.resolution = {mask.width(), mask.height(), 1};
    grid.maximum = {0.5 * pixel * (mask.width() - 1), 0.5 * pixel * (mask.height() - 1), 0.0};
    grid.minimum = -grid.maximum;
    grid.values.resize(toInside.size());
    for (int y = 0; y < mask.height(); ++y)
        for (int x = 0; x < mask.width(); ++x) {
            const std::size_t from = grid.index(x, mask.height() - 1 - y);
            // One of the two is 0.
            const double away = sqrt(toInside[from]) - sqrt(toOutside[from]);
            grid.at(x, y) = pixel * (away > 0 ? away - 0.5 : away + 0.5);
        }
    return grid;
}

}  // namespace versorium
