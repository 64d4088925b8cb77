// SPDX-License-Identifier: MIT
#pragma once
// A palette is a curve through colour space: stops at positions in [0, 1], joined by straight lines
// in OKLab (equal steps look equal) or in linear light. Four kinds:
//   sequential   lightness rises or falls all along: for quantities with a least value
//   diverging    two arms meet at a neutral middle: for quantities with a meaningful zero
//   cyclic       the end is the beginning: for angles
//   qualitative  separate colours without order: for names
// A palette also says how the interior of a set and undefined values (NaN) look.

#include <string>
#include <string_view>
#include <vector>

#include "base/json.h"
#include "colour/srgb.h"

namespace versorium {

enum class PaletteKind { sequential, diverging, cyclic, qualitative };
enum class PaletteSpace { oklab, linear };

struct PaletteStop {
    double position = 0;  // in [0, 1], not falling from stop to stop
    Colour colour;
};

class Palette {
  public:
    static constexpr std::size_t kStopLimit = 1024;

    Palette() = default;
    // Fails with ErrorKind::data: no or too many stops, positions that fall or leave [0, 1], a
    // first position other than 0 or a last one other than 1, a cycle that does not close.
    static Expected<Palette> make(std::string name, PaletteKind kind, PaletteSpace space,
                                  std::vector<PaletteStop> stops);

    // The colour at a position; positions beyond the ends take the ends' colour, on a cyclic
    // palette they wrap around; NaN gives `undefined`.
    Colour at(double position) const;
    // The i-th colour of a qualitative palette, again from the first one after the last.
    Colour entry(std::size_t index) const;

    const std::string& name() const { return name_; }
    PaletteKind kind() const { return kind_; }
    PaletteSpace space() const { return space_; }
    const std::vector<PaletteStop>& stops() const { return stops_; }

    Colour interior = colourFromRgb(0x0a0b0f);   // points of the set: below L* 5
    Colour undefined = colourFromRgb(0x808080);  // NaN

  private:
    std::string name_;
    PaletteKind kind_ = PaletteKind::sequential;
    PaletteSpace space_ = PaletteSpace::oklab;
    std::vector<PaletteStop> stops_;
    // The stops in the space of interpolation: OKLab or linear RGB, and alpha.
    struct Node {
        double position, x, y, z, alpha;
    };
    std::vector<Node> nodes_;
};

const char* wordOf(PaletteKind kind);

// {"name", "kind", "space", "interior", "undefined", "stops": [{"position", "colour"}, …]}, where
// the stops may also be a plain list of colours at equal distances.
Expected<Palette> paletteFromJson(const Json& value, const std::string& path = "");
Json paletteToJson(const Palette& palette);

// The built-in palettes, by name. `versorium` is the default.
std::vector<std::string> paletteNames();
// Fails with ErrorKind::usage and the list of names.
Expected<Palette> paletteNamed(std::string_view name);

}  // namespace versorium
