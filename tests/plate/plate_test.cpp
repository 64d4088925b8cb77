// SPDX-License-Identifier: MIT
#include "plate/plate.h"

#include <gtest/gtest.h>

#include <cmath>

#include "plate/caption.h"

namespace versorium {
namespace {

// What a renderer would find out about the scenes of these tests: of the one with N iterations the
// N-th of these objects.
std::vector<Json>& said() {
    static std::vector<Json> all;
    return all;
}
const Json& saidOf(const Scene& scene) {
    return said()[static_cast<std::size_t>(scene.iterations)];
}

PanelSource fakeSource() {
    PanelSource source;
    source.describe = [](const Scene& shown) -> Expected<PanelInfo> {
        const Json& scene = saidOf(shown);
        if (scene.contains("fault")) return Status::data("scene.fault: as asked for");
        PanelInfo info;
        const auto number = [&](const char* key, double otherwise) {
            return scene.contains(key) ? scene[key].get<double>() : otherwise;
        };
        info.aspect = number("aspect", 1);
        const std::string name = scene.contains("axis") ? scene["axis"].get<std::string>() : "Re c";
        info.x = AxisInfo{name, number("low", -2), number("high", 1)};
        info.y = AxisInfo{name, number("low", -2), number("high", 1)};
        if (scene.contains("perspective")) info.x.reset(), info.y.reset();
        if (scene.contains("bar"))
            info.bar = ColourBar{"a quantity with a rather long name, \\hat{r}^{α}",
                                 {*fromWord<ScaleKind>(scene["bar"].get<std::string>()),
                                  number("bar_low", 1e-7), number("bar_high", 1e7)},
                                 *paletteNamed("versorium")};
        info.versorKey = scene.contains("versor");
        if (scene.contains("legend"))
            for (const char* text : {"inside", "outside, after a very long and winding explanation",
                                     "never", "undecided"})
                info.legend.push_back({Colour{}, text});
        info.description = "A fake picture.";
        info.facts = {{"alpha", "6"}, {"iterations", "10^{7}"}};
        return info;
    };
    source.draw = [](const Scene&, Size size, double) -> Expected<Raster<float>> {
        return Raster<float>(size, 4, 0.5F);
    };
    source.describeDiagram = [describe = source.describe](const Scene& scene,
                                                          const DiagramPlot& plot) {
        Expected<PanelInfo> info = describe(scene);
        if (info) info->aspect = plot.aspect, info->x->low = plot.from, info->x->high = plot.to;
        return info;
    };
    source.drawDiagram = [](const Scene&, const DiagramPlot&,
                            Size size) -> Expected<DiagramPicture> {
        // The left half has period 1, the right half none.
        DiagramPicture picture{Raster<float>(size, 1, 1.0F), {}};
        for (int x = 0; x < size.width; ++x) picture.periods.push_back(2 * x < size.width ? 1 : 0);
        return picture;
    };
    source.overlay = [](const Scene&,
                        const PlateOverlay& overlay) -> Expected<std::vector<OverlayPart>> {
        if (overlay.criticalSet) return Status::usage("no critical set here");
        // A line across the picture, and its middle.
        return std::vector<OverlayPart>{{"a curve", false, {{{-2, -0.5}, {1, -0.5}}}},
                                        {"a point", true, {{{-0.5, 0.5}}}}};
    };
    source.locate = [](const Scene&, const Scene& place) -> Expected<std::array<double, 2>> {
        const Json& other = saidOf(place);
        if (!other.contains("at")) return Status::data("it lies nowhere");
        return std::array<double, 2>{other["at"][0].get<double>(), other["at"][1].get<double>()};
    };
    return source;
}

// Scenes that are not whole say what the fake source shall say of them.
Plate readPlate(const std::string& text) {
    auto json = parseJson(text);
    EXPECT_TRUE(json.ok()) << json.status().message();
    for (Json& panel : (*json)["panels"]) {
        if (!panel.contains("scene") || panel["scene"].contains("versorium")) continue;
        said().push_back(panel["scene"]);
        panel["scene"] = Json{{"iterations", said().size() - 1}};
    }
    const auto plate = plateFromJson(*json);
    EXPECT_TRUE(plate.ok()) << plate.status().message();
    return plate.ok() ? *plate : Plate{};
}

// Plates with all that can be in the way of something else.
std::vector<Plate> samplePlates() {
    const std::string caption =
        R"("caption": "\\bold{Plate.} \\hat{r} = e^{α(φ−β)}, α = {alpha}, N = {a.iterations}; see what stands where, and with which number.", "note": "versorium plate test · scene embedded in this file",)";
    const char* const panels[] = {
        R"({"title": "one", "scene": {"bar": "log", "legend": 1}},
           {"title": "a title that is much longer than its picture is wide", "scene": {"versor": 1}},
           {"scene": {"bar": "linear", "versor": 1, "low": -0.74364388703, "high": -0.74364388702}})",
        R"({"span": 2, "title": "large", "scene": {"bar": "truncated_log", "bar_low": -8, "bar_high": 8}},
           {"scene": {"low": -1e-300, "high": 1e300}}, {"scene": {"low": -98765432, "high": 98765432}},
           {"scene": {"low": 1e-12, "high": 2e-12, "axis": "a long name of an axis, coefficient b_{1}^{g}"}},
           {"scene": {"low": 100000, "high": 100001, "aspect": 2.7}})",
        R"({"scene": {"perspective": 1, "aspect": 0.3}}, {"scene": {"aspect": 6, "bar": "sqrt"}})",
        R"({"scene": {"low": 0.5, "high": 0.5, "bar": "cyclic", "bar_low": 0, "bar_high": 6.283185307179586}},
           {"kind": "plot", "title": "plot", "plot": {"x": {"name": "β^{2}", "low": 0.001, "high": 1000000},
            "y": {"name": "‖f‖", "scale": "log"}, "lines": [
             {"name": "first", "x": [0, 1, 2, 1e7], "y": [1, 1e-9, 1e9, 3]},
             {"name": "second line with a long name", "style": "both", "x": [0, 5e5], "y": [3, -4]},
             {"name": "third", "style": "points", "x": [0, 1e6], "y": [1, 2]}]}})"};
    std::vector<Plate> plates;
    for (const char* list : panels)
        for (const char* columns : {"0", "1", "3", "4"})
            plates.push_back(readPlate(
                R"({"version": 1, "title": "A plate of \\hat{f} = \\hat{r}·d with a title that wraps when the paper is narrow", )" +
                caption + R"("columns": )" + columns + R"(, "panels": [)" + list + "]}"));
    return plates;
}

class EveryPlate : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Widths, EveryPlate, testing::Values(60.0, 89.0, 120.0, 178.0, 300.0));

TEST_P(EveryPlate, NothingOverlapsNothingIsClippedEveryLetterIsLegible) {
    for (const Plate& plate : samplePlates())
        for (const double dotsPerInch : {72.0, 150.0}) {
            const PlateOptions options{.widthMillimetres = GetParam(), .dotsPerInch = dotsPerInch};
            const auto picture = layoutPlate(plate, options, fakeSource());
            ASSERT_TRUE(picture.ok()) << picture.status().message();
            EXPECT_EQ(picture->pixels.width(),
                      static_cast<int>(std::floor(GetParam() * dotsPerInch / 25.4 + 0.5)));
            const Box page{0, 0, double(picture->pixels.width()), double(picture->pixels.height())};
            const auto& boxes = picture->boxes;
            for (std::size_t i = 0; i < boxes.size(); ++i) {
                const Box& box = boxes[i].box;
                EXPECT_TRUE(box.left >= page.left && box.top >= page.top &&
                            box.right <= page.right && box.bottom <= page.bottom)
                    << boxes[i].name << " leaves the page at " << GetParam() << " mm, "
                    << dotsPerInch << " dpi";
                EXPECT_TRUE(boxes[i].pointSize == 0 || boxes[i].pointSize >= 6 - 1e-9)
                    << boxes[i].name;
                for (std::size_t k = 0; k < i; ++k)
                    EXPECT_FALSE(overlap(box, boxes[k].box))
                        << boxes[i].name << " over " << boxes[k].name << " at " << GetParam()
                        << " mm, " << dotsPerInch << " dpi, " << plate.panels.size()
                        << " panels in " << plate.columns << " columns";
            }
        }
}

TEST(Plate, SameInputSamePixels) {
    const Plate plate = samplePlates()[0];
    const auto one = layoutPlate(plate, {}, fakeSource());
    const auto two = layoutPlate(plate, {}, fakeSource());
    EXPECT_EQ(one->pixels.values(), two->pixels.values());
}

TEST(Plate, ThemesDifferAndTextStandsOut) {
    const Plate plate = samplePlates()[0];
    for (const char* theme : {"paper", "slide"}) {
        const auto picture = layoutPlate(plate, {.dotsPerInch = 100, .theme = theme}, fakeSource());
        ASSERT_TRUE(picture.ok());
        const int corner = picture->pixels.at(0, 0, 0);
        EXPECT_EQ(corner, theme == std::string("paper") ? 255 : 15);
    }
    EXPECT_FALSE(layoutPlate(plate, {.theme = "neon"}, fakeSource()).ok());
}

TEST(Plate, TitleAndCaptionCanBeLeftOut) {
    const Plate plate = samplePlates()[0];
    const auto whole = layoutPlate(plate, {.dotsPerInch = 100}, fakeSource());
    const auto bare =
        layoutPlate(plate, {.dotsPerInch = 100, .title = false, .caption = false}, fakeSource());
    EXPECT_LT(bare->pixels.height(), whole->pixels.height());
    for (const PlateBox& box : bare->boxes)
        EXPECT_TRUE(box.name != "title" && box.name != "caption" && box.name != "note");
    // The texts come along all the same.
    EXPECT_EQ(bare->captionText,
              "Plate. r\u0302 = e^(α(φ−β)), α = 6, N = 10^7; see what stands where, and with which "
              "number.");
    EXPECT_NE(bare->alternativeText.find("3 panels. (a) one. A fake picture. (b)"),
              std::string::npos);
}

TEST(Plate, PicturesHaveTheAspectOfTheirScene) {
    Plate plate =
        readPlate(R"({"panels": [{"scene": {"aspect": 1.5}}, {"scene": {"aspect": 0.8}}]})");
    PanelSource source = fakeSource();
    std::vector<Size> sizes;
    source.draw = [&](const Scene&, Size size, double line) -> Expected<Raster<float>> {
        sizes.push_back(size);
        EXPECT_EQ(line, 2);  // half a point at 300 dpi
        return Raster<float>(size, 4);
    };
    ASSERT_TRUE(layoutPlate(plate, {}, source).ok());
    // Whole pixels: half a pixel in height.
    EXPECT_NEAR(sizes[0].width / 1.5, sizes[0].height, 0.51);
    EXPECT_NEAR(sizes[1].width / 0.8, sizes[1].height, 1.3);
}

Plate markedPlate(const char* at) {
    return readPlate(std::string(R"({"panels": [{"scene": {}, "marks": [{"of": "b", "label": "b"},
        {"of": "c"}]}, {"scene": {"at": )") +
                     at + R"(}, "title": "one"}, {"scene": {"at": [0.5, -1.5]}}]})");
}
const Box* boxNamed(const PlatePicture& picture, const std::string& name) {
    for (const PlateBox& box : picture.boxes)
        if (box.name == name) return &box.box;
    return nullptr;
}

// A mark stands where the other panel's parameters are, in the colour of the sign in its heading.
TEST(Plate, MarksStandForOtherPanels) {
    const auto with = layoutPlate(markedPlate("[-1.25, 0.25]"), {}, fakeSource());
    const auto other = layoutPlate(markedPlate("[0.25, 0.25]"), {}, fakeSource());
    ASSERT_TRUE(with.ok() && other.ok()) << with.status().message();
    const Box* frame = boxNamed(*with, "a/picture");
    ASSERT_TRUE(frame && boxNamed(*with, "b/sign") && boxNamed(*with, "c/sign"));
    EXPECT_EQ(boxNamed(*with, "a/sign"), nullptr);
    const auto pixel = [&](double x, double y) {
        std::array<int, 3> rgb;
        for (int k = 0; k < 3; ++k)
            rgb[static_cast<std::size_t>(k)] =
                with->pixels.at(static_cast<int>(x), static_cast<int>(y), k);
        return rgb;
    };
    // The axes of the fake scene run from -2 to 1.
    const auto at = [&](double x, double y) {
        return pixel(frame->left + (x + 2) / 3 * frame->width(),
                     frame->bottom - (y + 2) / 3 * frame->height());
    };
    const Box* sign = boxNamed(*with, "b/sign");
    const auto colour = pixel(sign->left + sign->width() / 2, sign->top + sign->height() / 2);
    EXPECT_EQ(at(-1.25, 0.25), colour);
    EXPECT_NE(at(0.25, 0.25), colour);
    EXPECT_NE(at(0.5, -1.5), colour);
    EXPECT_NE(at(0.5, -1.5), at(0, 0.9));
    EXPECT_NE(with->pixels.values(), other->pixels.values());
    EXPECT_NE(with->alternativeText.find("Marked: (b) at (-1.25, 0.25), (c) at (0.5, -1.5)."),
              std::string::npos);
    const auto lost = layoutPlate(readPlate(R"({"panels": [{"scene": {}, "marks": [{"of": "b"}]},
        {"scene": {}}]})"),
                                  {}, fakeSource());
    EXPECT_EQ(lost.status().message(), "panel a: mark of b: it lies nowhere");
}

TEST(Plate, CurvesAndPointsLieOverTheirScene) {
    const Plate plate = readPlate(R"({"panels": [{"scene": {}, "overlay": {"cycles": 2}}]})");
    const auto picture = layoutPlate(plate, {}, fakeSource());
    ASSERT_TRUE(picture.ok()) << picture.status().message();
    const auto bare =
        layoutPlate(readPlate(R"({"panels": [{"scene": {}, "keys": false}]})"), {}, fakeSource());
    const Box* frame = boxNamed(*picture, "a/picture");
    const auto pixel = [&](double x, double y, int k) {
        return picture->pixels.at(static_cast<int>(frame->left + x * frame->width()),
                                  static_cast<int>(frame->bottom - y * frame->height()), k);
    };
    // The fake picture is grey: what is not lies over it.
    const auto coloured = [&](double x, double y) { return pixel(x, y, 0) != pixel(x, y, 2); };
    EXPECT_TRUE(coloured(0.3, 0.5));
    EXPECT_TRUE(coloured(0.5, 2.5 / 3));
    EXPECT_FALSE(coloured(0.3, 0.7));
    EXPECT_NE(boxNamed(*picture, "a/swatch 2"), nullptr);
    EXPECT_NE(picture->alternativeText.find("Over it: a curve, a point."), std::string::npos);
    EXPECT_EQ(bare->alternativeText.find("Over it"), std::string::npos);
    const auto refused =
        layoutPlate(readPlate(R"({"panels": [{"scene": {}, "overlay": {"critical_set": true}}]})"),
                    {}, fakeSource());
    EXPECT_EQ(refused.status().message(), "panel a: overlay: no critical set here");
}

TEST(Plate, DiagramsAreInkInTheColoursOfPeriods) {
    const Plate plate = readPlate(R"({"panels": [{"kind": "diagram", "scene": {},
        "diagram": {"parameter": "r", "from": 3, "to": 4, "aspect": 2, "periods": [1, 3]}}]})");
    const auto picture = layoutPlate(plate, {}, fakeSource());
    ASSERT_TRUE(picture.ok()) << picture.status().message();
    const Box* frame = boxNamed(*picture, "a/picture");
    EXPECT_NEAR(frame->width() / frame->height(), 2, 0.02);
    EXPECT_NE(boxNamed(*picture, "a/swatch 3"), nullptr);  // two periods and "other"
    const Box* swatch = boxNamed(*picture, "a/swatch 1");
    const auto red = [&](double x, double y) {
        return picture->pixels.at(static_cast<int>(x), static_cast<int>(y), 0);
    };
    const double y = (frame->top + frame->bottom) / 2;
    EXPECT_EQ(red(frame->left + 0.25 * frame->width(), y),
              red((swatch->left + swatch->right) / 2, (swatch->top + swatch->bottom) / 2));
    EXPECT_NE(red(frame->left + 0.25 * frame->width(), y),
              red(frame->left + 0.75 * frame->width(), y));
}

TEST(Plate, GoesThroughJsonUnchanged) {
    std::vector<Plate> plates = samplePlates();
    plates.push_back(markedPlate("[0, 0]"));
    plates.push_back(readPlate(R"({"panels": [{"scene": {}, "overlay": {"cycles": 3,
        "manifolds": 2, "length": 1.5, "critical_set": true}}]})"));
    plates.push_back(readPlate(R"({"panels": [{"kind": "diagram", "scene": {"alpha": 2},
        "diagram": {"parameter": "r", "from": 3, "to": 4, "periods": [2, 1]}}]})"));
    for (const Plate& plate : plates) {
        const std::string text = printJson(plateToJson(plate));
        EXPECT_EQ(printJson(plateToJson(readPlate(text))), text);
    }
}

TEST(Plate, FaultsHaveTheirPath) {
    const auto fault = [](const std::string& text) {
        const auto plate = plateFromJson(*parseJson(text));
        return plate.ok() ? std::string() : plate.status().message();
    };
    EXPECT_NE(fault("{}").find("panels"), std::string::npos);
    EXPECT_NE(fault(R"({"version": 2, "panels": []})").find("newer"), std::string::npos);
    EXPECT_NE(fault(R"({"panels": [{"scene": {}}, {}]})").find("panels[1].scene"),
              std::string::npos);
    EXPECT_NE(fault(R"({"panels": [{"scene": {}}, {"scene": {"colour": {"rule": "red"}}}]})")
                  .find("panels[1].scene: colour.rule"),
              std::string::npos);
    EXPECT_NE(fault(R"({"panels": [{"scene": {}, "titel": ""}]})").find("panels[0].titel"),
              std::string::npos);
    EXPECT_NE(fault(R"({"panels": [{"scene": {}, "title": "x_{"}]})").find("panels[0].title"),
              std::string::npos);
    EXPECT_NE(fault(R"({"panels": [{"scene": {}, "name": "b"}, {"scene": {}}]})").find("taken"),
              std::string::npos);
    EXPECT_NE(fault(R"({"panels": [{"kind": "plot", "plot": {"lines": [{"x": [1], "y": []}]}}]})")
                  .find("panels[0].plot.lines[0].y"),
              std::string::npos);
    const auto diagram = [&](const std::string& text) {
        return fault(R"({"panels": [{"kind": "diagram", "scene": {}, "diagram": )" + text + "}]}");
    };
    EXPECT_NE(diagram(R"({"from": 0, "to": 1})").find("panels[0].diagram.parameter"),
              std::string::npos);
    EXPECT_NE(diagram(R"({"parameter": "r", "from": 1, "to": 1})").find("above"),
              std::string::npos);
    EXPECT_NE(diagram(R"({"parameter": "r", "periods": [0.5]})").find("whole"), std::string::npos);
    EXPECT_NE(diagram(R"({"parameter": "r", "colour": 1})").find("diagram.colour"),
              std::string::npos);
    EXPECT_NE(fault(R"({"panels": [{"scene": {}, "marks": [{"of": "z"}]}]})").find("\"z\""),
              std::string::npos);
    EXPECT_NE(fault(R"({"panels": [{"scene": {}, "marks": [{"of": "a"}]}]})").find("no other"),
              std::string::npos);
    EXPECT_NE(fault(R"({"panels": [{"scene": {}, "overlay": {"cycles": 99}}]})")
                  .find("panels[0].overlay.cycles"),
              std::string::npos);
    EXPECT_NE(fault(R"({"panels": [{"scene": {}, "diagram": {}}]})").find("diagram"),
              std::string::npos);
    std::string many = R"({"panels": [)";
    for (int i = 0; i < 27; ++i) many += std::string(i ? "," : "") + R"({"scene": {}})";
    EXPECT_NE(fault(many + "]}").find("1 to 26"), std::string::npos);
}

TEST(Plate, RefusesWhatCannotBeDrawn) {
    const Plate plate = readPlate(R"({"panels": [{"scene": {}}]})");
    for (const double width : {0.0, -1.0, 1e9, std::nan("")})
        EXPECT_FALSE(layoutPlate(plate, {.widthMillimetres = width}, fakeSource()).ok());
    for (const double dpi : {0.0, 1e9, std::nan("")})
        EXPECT_FALSE(layoutPlate(plate, {.dotsPerInch = dpi}, fakeSource()).ok());
    const auto large =
        layoutPlate(plate, {.widthMillimetres = 2000, .dotsPerInch = 2400}, fakeSource());
    EXPECT_NE(large.status().message().find("fewer dots per inch"), std::string::npos);
    const Plate faulty = readPlate(R"({"panels": [{"scene": {}}, {"scene": {"fault": 1}}]})");
    EXPECT_EQ(layoutPlate(faulty, {}, fakeSource()).status().message(),
              "panel b: scene.fault: as asked for");
}

TEST(Caption, FactsAreFilledInAndMarkupStays) {
    const std::vector<PanelFacts> facts = {{"a", {{"alpha", "6"}, {"n", "3"}}},
                                           {"b", {{"alpha", "90"}}}};
    EXPECT_EQ(*substituteFacts("α = {alpha} and {b.alpha}, x_{n}^{{n}} \\hat{n} {1}", facts),
              "α = 6 and 90, x_{n}^{3} \\hat{n} {1}");
    const auto wrong = substituteFacts("{gamma}", facts);
    EXPECT_NE(wrong.status().message().find("alpha, n"), std::string::npos);
}

}  // namespace
}  // namespace versorium
