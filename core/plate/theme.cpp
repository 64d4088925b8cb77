// SPDX-License-Identifier: MIT
#include "plate/theme.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace versorium {

Expected<Theme> themeNamed(std::string_view name) {
    const auto rgb = colourFromRgb;
    static const Theme kThemes[] = {{"paper",
                                     rgb(0xffffff),
                                     rgb(0x15171a),
                                     rgb(0x5b6470),
                                     rgb(0x2c3138),
                                     {rgb(0x0072b2), rgb(0xc44e00), rgb(0x00795a), rgb(0x9b3c78),
                                      rgb(0x7a5c00), rgb(0x2c3138)}},
                                    {"slide",
                                     rgb(0x0f1115),
                                     rgb(0xe7e9ee),
                                     rgb(0x9aa3b2),
                                     rgb(0xb9c0cc),
                                     {rgb(0x56b4e9), rgb(0xe69f00), rgb(0x35c9a2), rgb(0xe39bc6),
                                      rgb(0xf0e442), rgb(0xe7e9ee)}}};
    for (const Theme& theme : kThemes)
        if (name == theme.name) return theme;
    return Status::usage("no theme is called \"" + std::string(name.substr(0, 60)) +
                         "\"; there are: paper, slide");
}

Metrics metricsFor(double widthMillimetres, double dotsPerInch) {
    const double page = std::clamp((widthMillimetres - 89) / 89, 0.0, 1.0);
    const double enlarge = std::max(1.0, widthMillimetres / 178);
    Metrics m;
    m.point = dotsPerInch / 72;
    m.millimetre = dotsPerInch / 25.4;
    const auto type = [&](double narrow, double wide) {
        return m.point * enlarge * (narrow + page * (wide - narrow));
    };
    m.smallest = 6 * m.point;
    m.title = type(10, 12);
    m.header = type(7.5, 8.5);
    m.label = type(7, 7.8);
    m.tick = type(6.3, 6.8);
    m.caption = type(7.5, 8.6);
    m.note = type(6, 6.2);
    m.margin = type(5, 9);
    m.columnGap = type(6, 11);
    m.rowGap = type(10, 13);
    m.lineWidth = std::max(1.0, std::floor(0.5 * m.point * enlarge + 0.5));
    m.plotLine = 1.1 * m.point * enlarge;
    m.tickLength = std::floor(type(2.2, 2.8) + 0.5);
    m.tickGap = type(1.4, 1.8);
    m.barWidth = std::floor(type(5.5, 7.5) + 0.5);
    return m;
}

}  // namespace versorium
