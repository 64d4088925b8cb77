// SPDX-License-Identifier: MIT
#pragma once
// A rectangle of samples with a fixed number of channels, row after row. Row 0 is the *top* row of
// the picture; views that count upwards turn y around where pixels are made (see view/slice.h).
// Channels of one pixel lie side by side.

#include <cassert>
#include <cstddef>
#include <vector>

namespace versorium {

// Width and height in pixels.
struct Size {
    int width = 0;
    int height = 0;
    friend bool operator==(const Size&, const Size&) = default;
};

template <class T>
class Raster {
  public:
    Raster() = default;
    Raster(Size size, int channels, T fill = T{})
        : size_(size),
          channels_(channels),
          values_(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height) *
                      static_cast<std::size_t>(channels),
                  fill) {
        assert(size.width >= 0 && size.height >= 0 && channels >= 1);
    }

    Size size() const { return size_; }
    int width() const { return size_.width; }
    int height() const { return size_.height; }
    int channels() const { return channels_; }
    bool empty() const { return values_.empty(); }

    T& at(int x, int y, int channel = 0) { return values_[index(x, y, channel)]; }
    const T& at(int x, int y, int channel = 0) const { return values_[index(x, y, channel)]; }

    T* row(int y) { return values_.data() + index(0, y, 0); }
    const T* row(int y) const { return values_.data() + index(0, y, 0); }
    std::vector<T>& values() { return values_; }
    const std::vector<T>& values() const { return values_; }

  private:
    std::size_t index(int x, int y, int channel) const {
        assert(x >= 0 && x < size_.width && y >= 0 && y < size_.height && channel < channels_);
        return (static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.width) +
                static_cast<std::size_t>(x)) *
                   static_cast<std::size_t>(channels_) +
               static_cast<std::size_t>(channel);
    }

    Size size_;
    int channels_ = 1;
    std::vector<T> values_;
};

}  // namespace versorium
