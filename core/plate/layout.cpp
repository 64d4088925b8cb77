// SPDX-License-Identifier: MIT
// The page: title, grid of panels, caption and note, one below the other.
#include <algorithm>
#include <cmath>
#include <deque>

#include "plate/caption.h"
#include "plate/panel_grid.h"
#include "plate/plate.h"

namespace versorium {
namespace {

// Narrower pictures, in millimetres, go to fewer columns: in a single column and on a whole page.
constexpr double kLeastNarrow = 20, kLeastWide = 26;

int wishedColumns(const Plate& plate) {
    const int count = static_cast<int>(plate.panels.size());
    if (plate.columns > 0) return std::min(plate.columns, 6);
    int cells = 0;
    for (const PlatePanel& panel : plate.panels) cells += panel.span * panel.span;
    return count <= 3 ? count : cells == 4 ? 2 : 3;
}

PanelContent sceneContent(const PlatePanel& panel, const PanelInfo& info, const Words& words) {
    PanelContent content;
    content.words = words;
    content.aspect = std::clamp(info.aspect, 0.05, 20.0);
    const auto axis = [](const AxisInfo& from, const std::string& label) {
        return PanelAxis{label.empty() ? from.name : label,
                         {ScaleKind::linear, from.low, from.high}};
    };
    if (panel.axes && info.x) content.x = axis(*info.x, panel.xLabel);
    if (panel.axes && info.y) content.y = axis(*info.y, panel.yLabel);
    if (!panel.keys) return content;
    content.bar = info.bar;
    if (content.bar && !panel.barLabel.empty()) content.bar->name = panel.barLabel;
    content.versorKey = info.versorKey;
    for (const LegendEntry& entry : info.legend)
        content.legend.push_back({.colour = entry.colour, .line = {}, .text = entry.text});
    return content;
}

class Composer {
  public:
    Composer(const Plate& plate, const PlateOptions& options, const PanelSource& source,
             const Theme& theme)
        : plate_(plate),
          options_(options),
          source_(source),
          theme_(theme),
          words_(plate.language),
          m_(metricsFor(options.widthMillimetres, options.dotsPerInch)) {}

    Expected<PlatePicture> compose() {
        if (Status status = describe(); !status.ok()) return status;
        if (Status status = overlay(); !status.ok()) return status;
        if (Status status = placeMarks(); !status.ok()) return status;
        if (Status status = substitute(); !status.ok()) return status;
        width_ = std::floor(options_.widthMillimetres * m_.millimetre + 0.5);
        margin_ = std::floor(m_.margin);
        const double inner = width_ - 2 * margin_;
        Sheet page;
        double y = margin_;
        if (options_.title)
            y = place(page, "title", title_, Face::serif, m_.title, theme_.text, y, 0.9 * m_.title);
        const PanelGrid grid = chooseGrid(inner);
        const double gridLeft =
            margin_ + std::floor(0.5 * std::max(0.0, inner - grid.columns.total()));
        const double gridTop = y;
        for (std::size_t i = 0; i < plate_.panels.size(); ++i) {
            const Point at = grid.cornerOf(i);
            page.add(grid.sheets[i], gridLeft + at.x, gridTop + at.y, plate_.panels[i].name + "/");
        }
        y = gridTop + grid.rows.total();
        if (options_.caption) {
            y = place(page, "caption", caption_, Face::serif, m_.caption, theme_.text,
                      y + 1.4 * m_.caption, 0);
            y = place(page, "note", note_, Face::mono, m_.note, theme_.secondary,
                      y + (note_.empty() ? 0 : 0.9 * m_.note), 0);
        }
        const double height = std::ceil(std::max(y, page.extent().bottom) + margin_);
        if (width_ * height > kPlatePixelLimit)
            return Status::usage(
                "the plate would have " + std::to_string(static_cast<long long>(width_ * height)) +
                " pixels, more than " + std::to_string(static_cast<long long>(kPlatePixelLimit)) +
                ": choose fewer dots per inch or a smaller width");
        Canvas canvas({static_cast<int>(width_), static_cast<int>(height)}, theme_.background);
        if (Status status = drawScenes(canvas, grid, gridLeft, gridTop); !status.ok())
            return status;
        page.draw(canvas);
        return PlatePicture{canvas.encode(), options_.dotsPerInch, plainText(caption_),
                            alternative(), page.boxes()};
    }

  private:
    Status describe() {
        for (const PlatePanel& panel : plate_.panels) {
            PanelInfo info;
            if (panel.kind == PanelKind::plot) {
                contents_.push_back(plotContent(panel.plot, words_, theme_));
                info.description = describePlot(panel.plot);
            } else if (panel.kind == PanelKind::profile) {
                auto plotted = source_.profile(panel.scene, panel.profile);
                if (!plotted) return plotted.status().in("panel " + panel.name);
                profiles_.push_back(std::move(plotted->first));
                info = std::move(plotted->second);
                contents_.push_back(plotContent(profiles_.back(), words_, theme_));
            } else {
                Expected<PanelInfo> described =
                    panel.kind == PanelKind::diagram
                        ? source_.describeDiagram(panel.scene, panel.diagram)
                        : source_.describe(panel.scene);
                if (!described) return described.status().in("panel " + panel.name);
                info = *std::move(described);
                contents_.push_back(sceneContent(panel, info, words_));
                if (panel.kind == PanelKind::diagram && panel.keys) diagramLegend(panel.diagram);
            }
            infoAxes_.emplace_back(info.x, info.y);
            facts_.push_back({panel.name, info.facts});
            descriptions_.push_back(info.description);
        }
        return {};
    }

    void diagramLegend(const DiagramPlot& diagram) {
        for (std::size_t k = 0; k < diagram.periods.size(); ++k)
            contents_.back().legend.push_back(
                {.colour = seriesLook(theme_, k).colour,
                 .line = {},
                 .text = words_.tr("period {1}", {std::to_string(diagram.periods[k])})});
        if (!diagram.periods.empty())
            contents_.back().legend.push_back(
                {.colour = theme_.text, .line = {}, .text = words_.tr("other")});
    }

    Status overlay() {
        for (std::size_t i = 0; i < plate_.panels.size(); ++i) {
            const PlatePanel& panel = plate_.panels[i];
            const auto& [x, y] = infoAxes_[i];
            if (panel.overlay.empty() || !x || !y) continue;
            Expected<std::vector<OverlayPart>> parts = source_.overlay(panel.scene, panel.overlay);
            if (!parts) return parts.status().in("panel " + panel.name + ": overlay");
            PanelContent& content = contents_[i];
            for (std::size_t k = 0; k < parts->size(); ++k) {
                const OverlayPart& part = (*parts)[k];
                PanelCurves drawn{
                    seriesLook(theme_, k), part.points, k < panel.overlay.parts.size(), {}};
                for (const auto& curve : part.curves) {
                    drawn.curves.emplace_back();
                    for (const auto& point : curve)
                        drawn.curves.back().push_back({(point[0] - x->low) / (x->high - x->low),
                                                       (point[1] - y->low) / (y->high - y->low)});
                }
                if (panel.keys) {
                    SeriesLook solid = drawn.look;
                    solid.dashes.clear();
                    content.legend.push_back({.colour = solid.colour,
                                              .line = solid,
                                              .stroke = !part.points,
                                              .points = part.points,
                                              .text = part.name});
                }
                descriptions_[i] += (k == 0 ? " " + words_.tr("Over it:") + " " : ", ") +
                                    part.name + (k + 1 == parts->size() ? "." : "");
                content.overlay.push_back(std::move(drawn));
            }
        }
        return {};
    }

    // Marks stand where other panels' parameters lie, in this panel and before those panels'
    // titles.
    Status placeMarks() {
        for (std::size_t i = 0; i < plate_.panels.size(); ++i) {
            const PlatePanel& panel = plate_.panels[i];
            for (std::size_t k = 0; k < panel.marks.size(); ++k) {
                const auto of = std::find_if(
                    plate_.panels.begin(), plate_.panels.end(),
                    [&](const PlatePanel& other) { return other.name == panel.marks[k].of; });
                if (of == plate_.panels.end())
                    return Status::usage("panel " + panel.name + ": no panel is named \"" +
                                         panel.marks[k].of + "\"");
                Expected<std::array<double, 2>> at = source_.locate(panel.scene, of->scene);
                if (!at) return at.status().in("panel " + panel.name + ": mark of " + of->name);
                const SeriesLook look = seriesLook(theme_, k);
                contents_[static_cast<std::size_t>(of - plate_.panels.begin())].sign = look;
                PanelContent& content = contents_[i];
                descriptions_[i] += (k == 0 ? " " + words_.tr("Marked:") + " " : ", ") +
                                    words_.tr("({1}) at ({2}, {3})",
                                              {of->name, words_.number(formatNumber((*at)[0], 6)),
                                               words_.number(formatNumber((*at)[1], 6))}) +
                                    (k + 1 == panel.marks.size() ? "." : "");
                const auto& x = infoAxes_[i].first;
                const auto& y = infoAxes_[i].second;
                if (x && y)
                    content.marks.push_back({((*at)[0] - x->low) / (x->high - x->low),
                                             ((*at)[1] - y->low) / (y->high - y->low), look,
                                             panel.marks[k].label});
            }
        }
        return {};
    }

    std::string describePlot(const LinePlot& plot) const {
        std::string text = words_.tr("Line plot of {1} against {2}", {plot.y.name, plot.x.name});
        for (std::size_t i = 0; i < plot.lines.size(); ++i)
            if (!plot.lines[i].name.empty()) text += (i == 0 ? ": " : ", ") + plot.lines[i].name;
        return plainText(text) + ".";
    }

    Status substitute() {
        const auto fill = [&](const std::string& text, const std::vector<PanelFacts>& facts,
                              std::string& out) {
            Expected<std::string> filled = substituteFacts(text, facts);
            if (!filled) return filled.status();
            out = *std::move(filled);
            return checkMarkup(out);
        };
        for (const auto& [text, out] : {std::pair{&plate_.title, &title_},
                                        {&plate_.caption, &caption_},
                                        {&plate_.note, &note_}})
            if (Status status = fill(*text, facts_, *out); !status.ok()) return status;
        for (std::size_t i = 0; i < plate_.panels.size(); ++i) {
            std::string title;
            if (Status status = fill(plate_.panels[i].title, {facts_[i]}, title); !status.ok())
                return status.in("panel " + plate_.panels[i].name);
            titles_.push_back(title);
            // A single panel needs no letter.
            if (plate_.panels.size() > 1) contents_[i].letter = "(" + plate_.panels[i].name + ")";
            contents_[i].title = title;
        }
        return {};
    }

    // Puts a text across the plate and returns where the next thing may begin.
    double place(Sheet& page, const std::string& name, const std::string& text, Face face,
                 double size, const Colour& colour, double y, double after) const {
        if (text.empty()) return y;
        const TextBlock block = layoutText(
            text, {.face = face, .size = size, .smallest = m_.smallest, .lineSpacing = 1.36},
            width_ - 2 * margin_);
        y = std::ceil(y);
        page.text(name, block, margin_, y, colour, m_.point);
        return std::ceil(y + std::max(block.height, block.ink.bottom) + after);
    }

    // The widest grid whose pictures are not too small.
    PanelGrid chooseGrid(double inner) const {
        const double page = std::clamp((options_.widthMillimetres - 89) / 89, 0.0, 1.0);
        const double least = (kLeastNarrow + page * (kLeastWide - kLeastNarrow)) * m_.millimetre;
        for (int columns = wishedColumns(plate_);; --columns) {
            int rows = 0;
            const std::vector<Cell> cells = placeCells(plate_.panels, columns, rows);
            PanelGrid grid = solveGrid(contents_, cells, columns, rows, inner, m_, theme_);
            if (columns == 1 || grid.pictureWidth >= least) return grid;
        }
    }

    Status drawScenes(Canvas& canvas, const PanelGrid& grid, double left, double top) const {
        const int all = static_cast<int>(plate_.panels.size());
        for (std::size_t i = 0; i < plate_.panels.size(); ++i) {
            const PlatePanel& panel = plate_.panels[i];
            if (panel.hasScene() && panel.kind != PanelKind::profile) {
                const Expected<Raster<float>> picture =
                    panel.kind == PanelKind::diagram
                        ? drawDiagram(panel, grid.pictures[i])
                        : source_.draw(panel.scene, grid.pictures[i], m_.lineWidth);
                if (!picture) return picture.status().in("panel " + panel.name);
                if (picture->size() != grid.pictures[i] || picture->channels() != 4)
                    return Status::usage("panel " + panel.name +
                                         ": the picture has another size than the one asked for");
                const Point at = grid.cornerOf(i);
                canvas.picture(static_cast<int>(left + at.x), static_cast<int>(top + at.y),
                               *picture);
            }
            if (options_.onPanel) options_.onPanel(static_cast<int>(i) + 1, all);
        }
        return {};
    }

    // Ink in the colour of texts, or of the period of the column.
    Expected<Raster<float>> drawDiagram(const PlatePanel& panel, Size size) const {
        const DiagramPlot& diagram = panel.diagram;
        const Expected<DiagramPicture> drawn = source_.drawDiagram(panel.scene, diagram, size);
        if (!drawn) return drawn.status();
        Raster<float> picture(drawn->ink.size(), 4);
        for (int x = 0; x < picture.width(); ++x) {
            const auto known = std::find(diagram.periods.begin(), diagram.periods.end(),
                                         drawn->periods[static_cast<std::size_t>(x)]);
            const Colour colour =
                known == diagram.periods.end()
                    ? theme_.text
                    : seriesLook(theme_, static_cast<std::size_t>(known - diagram.periods.begin()))
                          .colour;
            for (int y = 0; y < picture.height(); ++y) {
                const float parts[] = {static_cast<float>(colour.r), static_cast<float>(colour.g),
                                       static_cast<float>(colour.b), drawn->ink.at(x, y)};
                for (int k = 0; k < 4; ++k) picture.at(x, y, k) = parts[k];
            }
        }
        return picture;
    }

    std::string alternative() const {
        const std::size_t count = plate_.panels.size();
        std::string text = title_.empty() ? "" : plainText(title_) + ". ";
        if (count > 1) text += words_.tr("{1} panels.", {std::to_string(count)});
        for (std::size_t i = 0; i < count; ++i) {
            if (count > 1) text += " (" + plate_.panels[i].name + ")";
            if (!titles_[i].empty()) text += " " + plainText(titles_[i]) + ".";
            if (!descriptions_[i].empty()) text += " " + descriptions_[i];
        }
        return text;
    }

    const Plate& plate_;
    const PlateOptions& options_;
    const PanelSource& source_;
    const Theme& theme_;
    Words words_;
    Metrics m_;
    double width_ = 0, margin_ = 0;
    std::deque<LinePlot> profiles_;  // contents point to them
    std::vector<PanelContent> contents_;
    std::vector<PanelFacts> facts_;
    std::vector<std::pair<std::optional<AxisInfo>, std::optional<AxisInfo>>> infoAxes_;
    std::vector<std::string> descriptions_, titles_;
    std::string title_, caption_, note_;
};

}  // namespace

Expected<PlatePicture> layoutPlate(const Plate& plate, const PlateOptions& options,
                                   const PanelSource& source) {
    if (!(options.widthMillimetres >= 60 && options.widthMillimetres <= 2000))
        return Status::usage("the width of a plate is 60 to 2000 mm");
    if (!(options.dotsPerInch >= 50 && options.dotsPerInch <= 2400))
        return Status::usage("the resolution of a plate is 50 to 2400 dots per inch");
    if (plate.panels.empty()) return Status::usage("the plate has no panels");
    const Expected<Theme> theme = themeNamed(options.theme);
    if (!theme) return theme.status();
    return Composer(plate, options, source, *theme).compose();
}

}  // namespace versorium
