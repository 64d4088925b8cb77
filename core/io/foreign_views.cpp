// SPDX-License-Identifier: MIT
#include "io/foreign_views.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "io/text_scanner.h"
#include "scene/numbers.h"

namespace versorium {
namespace {

constexpr std::size_t kForeignBytes = std::size_t{1} << 20;
constexpr int kMostForeignIterations = 10000000;

using Settings = std::map<std::string, std::string>;

// What all of these programs say of a view.
struct SharedView {
    std::string map;     // a map of the catalogue or a formula
    bool julia = false;  // a plane of starting points
    double c[2] = {0, 0};
    double centre[2] = {0, 0};
    double height = 0;
    double iterations = 0;
    std::string note;
};

// Beyond some 1e13 neighbouring pixels are the same double.
constexpr double kLeastForeignHeight = 1e-13;

Expected<ForeignView> viewOf(const SharedView& shared, const std::string& program) {
    if (!(shared.height > 0 && shared.height <= 1e6) || !std::isfinite(shared.centre[0]) ||
        !std::isfinite(shared.centre[1]))
        return Status::data("the view of " + program + " has a place or size that cannot be shown");
    Expected<Scene> scene = sceneOfMap(shared.map);
    if (!scene) return scene.status();
    if (shared.julia) {
        scene->criticalStart.reset();
        scene->slice.axes = {{.terms = {{"z.re", 1.0}}}, {.terms = {{"z.im", 1.0}}}};
        if (const auto c = scene->parameters.find("c"); c != scene->parameters.end())
            c->second = {shared.c[0], shared.c[1]};
    } else {
        scene->criticalStart = 0;
        scene->slice.axes = {{.terms = {{"c.re", 1.0}}}, {.terms = {{"c.im", 1.0}}}};
    }
    scene->slice.origin.clear();
    scene->slice.centre = {shared.centre[0], shared.centre[1]};
    scene->slice.centreLow = {0, 0};
    scene->slice.height = shared.height;
    if (shared.iterations >= 1)
        scene->iterations =
            static_cast<int>(std::min(shared.iterations, double{kMostForeignIterations}));
    std::string note =
        "Read from " + program + ": place, size and iterations; its colours were left out.";
    if (!shared.note.empty()) note += " " + shared.note;
    if (shared.height < kLeastForeignHeight)
        note += " The view is deeper than double precision shows.";
    // What the scene's own reader would refuse is refused here too.
    Expected<Scene> checked = sceneFromJson(sceneToJson(*scene));
    if (!checked) return checked.status().in("the view of " + program);
    return ForeignView{std::move(*checked), std::move(note)};
}

std::string powerFormula(std::int64_t power) {
    return power == 2 ? std::string("quadratic") : "z^" + std::to_string(power) + " + c";
}

double numberOr(const Settings& settings, const std::string& key, double otherwise) {
    const auto found = settings.find(key);
    if (found == settings.end()) return otherwise;
    return parseDecimal(found->second).value_or(otherwise);
}

Status noCounterpart(const std::string& program, const std::string& name) {
    return Status::data("the map \"" + name.substr(0, 60) + "\" of " + program +
                        " has no counterpart here; give its formula with --map");
}

// ---- XaoS: commands in parentheses, comments after a semicolon

// Each command's words after its name; strings keep their blanks.
Settings xaosCommands(std::string_view text) {
    Settings commands;
    std::vector<std::string> words;
    std::string word;
    bool quoted = false, comment = false;
    const auto end = [&] {
        if (!word.empty()) words.push_back(word);
        word.clear();
    };
    for (const char c : text) {
        if (comment) {
            comment = c != '\n' && c != '\r';
        } else if (quoted) {
            if (c == '"')
                quoted = false;
            else
                word += c;
        } else if (c == '"') {
            quoted = true;
        } else if (c == ';') {
            comment = true;
        } else if (c == '(' || c == ')') {
            end();
            if (c == ')' && !words.empty()) {
                std::string rest;
                for (std::size_t k = 1; k < words.size(); ++k)
                    rest += (k > 1 ? " " : "") + words[k];
                commands[words[0]] = rest;
            }
            words.clear();
        } else if (c == ' ' || c == '\t' || c == '\n' || c == '\r') {
            end();
        } else {
            word += c;
        }
    }
    return commands;
}

// The numbers that begin a text.
std::vector<double> numbersOf(std::string_view text, char separator = ' ') {
    std::vector<double> numbers;
    std::size_t start = 0;
    while (start <= text.size() && numbers.size() < 64) {
        const std::size_t stop = std::min(text.find(separator, start), text.size());
        const std::optional<double> number = parseDecimal(text.substr(start, stop - start));
        if (!number) break;
        numbers.push_back(*number);
        start = stop + 1;
    }
    return numbers;
}

Status xaosMap(const Settings& commands, SharedView& view) {
    const auto formula = commands.find("formula");
    std::string name = formula == commands.end() ? "'mandel" : formula->second;
    if (name.starts_with("'")) name.erase(0, 1);
    if (name == "mandel" || name == "mandel2") {
        view.map = "quadratic";
    } else if (name.size() == 7 && name.starts_with("mandel") && name[6] >= '3' && name[6] <= '9') {
        view.map = powerFormula(name[6] - '0');
    } else if (name == "burning" || name == "burningship") {
        view.map = "burning-ship";
    } else if (name == "user" && commands.contains("usrform")) {
        view.map = commands.at("usrform");
    } else {
        return noCounterpart("XaoS", name);
    }
    return {};
}

Expected<ForeignView> readXaos(std::string_view text) {
    const Settings commands = xaosCommands(text);
    SharedView view;
    if (Status status = xaosMap(commands, view); !status.ok()) return status;
    const auto place = commands.find("view");
    const std::vector<double> numbers = place == commands.end()
                                            ? std::vector<double>{-0.75, 0, 2.5, 2.5}
                                            : numbersOf(place->second);
    if (numbers.size() != 4)
        return Status::data("the view of XaoS has no four numbers: (view re im width height)");
    view.centre[0] = numbers[0];
    view.centre[1] = numbers[1];
    // The rectangle is enlarged until it fills the picture, which is taken to be 4 : 3.
    view.height = std::max(numbers[3], numbers[2] * 3 / 4);
    view.iterations = numberOr(commands, "maxiter", 0);
    const auto julia = commands.find("julia");
    view.julia = julia != commands.end() && julia->second == "#t";
    if (const auto seed = commands.find("juliaseed"); seed != commands.end()) {
        const std::vector<double> c = numbersOf(seed->second);
        if (c.size() == 2) std::copy(c.begin(), c.end(), view.c);
    }
    if (numberOr(commands, "angle", 0) != 0) view.note += "The picture's rotation was left out. ";
    if (numberOr(commands, "plane", 0) != 0) view.note += "The plane's inversion was left out. ";
    if (commands.contains("filter")) view.note += "Filters were left out. ";
    if (!view.note.empty()) view.note.pop_back();
    return viewOf(view, "XaoS");
}

// ---- Fractint and Iterated Dynamics: name { key=value … }

struct ParameterSet {
    std::string name;
    Settings settings;
    bool more = false;  // other sets follow
};

Expected<ParameterSet> firstSet(std::string_view text) {
    TextScanner scanner(text, {.continued = true});
    ParameterSet set;
    bool inside = false;
    while (scanner.nextLine()) {
        for (std::string word(scanner.word()); !word.empty(); word = scanner.word()) {
            if (word[0] == ';') break;
            const std::size_t brace = word.find('{');
            if (!inside && brace != std::string::npos) {
                inside = true;
                set.name += word.substr(0, brace);
                word.erase(0, brace + 1);
            } else if (!inside) {
                set.name += word;
                continue;
            }
            const bool ends = word.find('}') != std::string::npos;
            word = word.substr(0, word.find('}'));
            const std::size_t equals = word.find('=');
            if (equals != std::string::npos && equals > 0)
                set.settings[lowered(word.substr(0, equals))] = word.substr(equals + 1);
            if (!ends) continue;
            set.more = text.substr(scanner.offset()).find('{') != std::string_view::npos;
            return set;
        }
    }
    return Status::data("the parameter set of Fractint has no closing brace");
}

Status fractintMap(const Settings& settings, SharedView& view) {
    const auto type = settings.find("type");
    const std::string name = type == settings.end() ? "mandel" : lowered(type->second);
    const auto given = settings.find("params");
    const std::vector<double> params =
        given == settings.end() ? std::vector<double>{} : numbersOf(given->second, '/');
    const auto param = [&](std::size_t k) { return k < params.size() ? params[k] : 0.0; };
    view.julia = name == "julia" || name == "julzpower";
    if (name == "mandel" || name == "julia") {
        view.map = "quadratic";
    } else if (name == "manzpower" || name == "julzpower") {
        const double power = params.size() > 2 ? params[2] : 2;
        if (!(power >= 2 && power <= 64 && power == std::floor(power)))
            return noCounterpart("Fractint", name);
        view.map = powerFormula(static_cast<std::int64_t>(power));
    } else if (name == "burning-ship" || name == "burningship") {
        view.map = "burning-ship";
    } else {
        const auto formula = settings.find("formulaname");
        return noCounterpart("Fractint",
                             name + (formula == settings.end() ? "" : " " + formula->second));
    }
    if (view.julia) {
        view.c[0] = param(0);
        view.c[1] = param(1);
    } else if (param(0) != 0 || param(1) != 0) {
        view.note += "The orbit's perturbed start was left out. ";
    }
    return {};
}

Status fractintPlace(const Settings& settings, SharedView& view) {
    const auto magnified = settings.find("center-mag");
    const auto corners = settings.find("corners");
    if (magnified != settings.end()) {
        const std::vector<double> numbers = numbersOf(magnified->second, '/');
        if (numbers.size() < 3 || !(numbers[2] > 0))
            return Status::data("center-mag=RE/IM/MAGNIFICATION is expected in the parameter set");
        view.centre[0] = numbers[0];
        view.centre[1] = numbers[1];
        view.height = 2 / numbers[2];
        if ((numbers.size() > 3 && numbers[3] != 1) || numbers.size() > 4)
            view.note += "Stretching and rotation were left out. ";
        return {};
    }
    const std::vector<double> numbers = corners == settings.end()
                                            ? std::vector<double>{-2.5, 1.5, -1.5, 1.5}
                                            : numbersOf(corners->second, '/');
    if (numbers.size() < 4)
        return Status::data("corners=XMIN/XMAX/YMIN/YMAX is expected in the parameter set");
    view.centre[0] = (numbers[0] + numbers[1]) / 2;
    view.centre[1] = (numbers[2] + numbers[3]) / 2;
    view.height = std::abs(numbers[3] - numbers[2]);
    if (numbers.size() > 4) view.note += "Rotation was left out. ";
    return {};
}

Expected<ForeignView> readFractint(std::string_view text) {
    const Expected<ParameterSet> set = firstSet(text);
    if (!set) return set.status();
    SharedView view;
    if (Status status = fractintMap(set->settings, view); !status.ok()) return status;
    if (Status status = fractintPlace(set->settings, view); !status.ok()) return status;
    view.iterations = numberOr(set->settings, "maxiter", 150);
    if (set->more)
        view.note += "Only the first set of the file, " + set->name.substr(0, 60) + ", was read. ";
    if (!view.note.empty()) view.note.pop_back();
    return viewOf(view, "Fractint");
}

// ---- Kalles Fraktaler: lines "Key: value"

Settings kallesSettings(std::string_view text) {
    Settings settings;
    TextScanner scanner(text);
    while (scanner.nextLine()) {
        const std::string_view line = scanner.rest();
        const std::size_t colon = line.find(':');
        if (colon == std::string_view::npos) continue;
        TextScanner value(line.substr(colon + 1));
        value.nextLine();
        settings.emplace(lowered(line.substr(0, colon)), value.word());
    }
    return settings;
}

// Numbers of a thousand digits are cut to what decides a double.
std::optional<double> longDecimal(std::string_view word) {
    const std::size_t exponent = std::min(word.find_first_of("eE"), word.size());
    const std::string_view mantissa = word.substr(0, exponent);
    if (mantissa.size() < 60 || mantissa.find('.') > 40) return parseDecimal(word);
    return parseDecimal(std::string(mantissa.substr(0, 60)) + std::string(word.substr(exponent)));
}

Expected<ForeignView> readKalles(std::string_view text) {
    const Settings settings = kallesSettings(text);
    const auto number = [&](const char* key) -> std::optional<double> {
        const auto found = settings.find(key);
        return found == settings.end() ? std::nullopt : longDecimal(found->second);
    };
    const std::optional<double> re = number("re"), im = number("im"), zoom = number("zoom");
    if (!re || !im || !zoom || !(*zoom > 0))
        return Status::data("the file of Kalles Fraktaler has no Re, Im and Zoom that are numbers");
    const double type = number("fractaltype").value_or(0), power = number("power").value_or(2);
    SharedView view;
    const bool whole = power >= 2 && power <= 64 && power == std::floor(power);
    if (type == 0 && whole)
        view.map = powerFormula(static_cast<std::int64_t>(power));
    else if (type == 1 && power == 2)
        view.map = "burning-ship";
    else
        return noCounterpart(
            "Kalles Fraktaler",
            "type " + std::to_string(static_cast<int>(std::clamp(type, -1.0, 1e6))));
    view.centre[0] = *re;
    view.centre[1] = *im;
    view.height = 4 / *zoom;
    view.iterations = number("iterations").value_or(0);
    return viewOf(view, "Kalles Fraktaler");
}

enum class Program { none, xaos, fractint, kalles };

Program programOf(std::string_view text) {
    const std::string start = lowered(withoutMark(text).substr(0, 1 << 14));
    if (start.find("(initstate)") != std::string::npos ||
        (start.find("(formula '") != std::string::npos &&
         start.find("(view ") != std::string::npos))
        return Program::xaos;
    TextScanner scanner(start);
    std::size_t lines = 0;
    bool re = false, im = false, zoom = false;
    while (scanner.nextLine() && ++lines < 200) {
        const std::string_view key = scanner.word();
        re = re || key == "re:";
        im = im || key == "im:";
        zoom = zoom || key == "zoom:";
    }
    if (re && im && zoom) return Program::kalles;
    const std::size_t brace = start.find('{');
    const bool set = brace != std::string::npos && brace > 0 && start.find('"') > brace;
    const bool said = start.find("type=") != std::string::npos ||
                      start.find("center-mag=") != std::string::npos ||
                      start.find("corners=") != std::string::npos;
    return set && said ? Program::fractint : Program::none;
}

}  // namespace

bool looksLikeForeignView(std::span<const unsigned char> bytes) {
    const std::string_view text = textOf(bytes);
    return bytes.size() <= kForeignBytes && checkText(text.substr(0, 1 << 14)).ok() &&
           programOf(text) != Program::none;
}

Expected<ForeignView> readForeignView(std::span<const unsigned char> bytes) {
    const std::string_view text = withoutMark(textOf(bytes));
    if (Status status = checkText(text); !status.ok()) return status;
    switch (programOf(text)) {
        case Program::xaos:
            return readXaos(text);
        case Program::fractint:
            return readFractint(text);
        case Program::kalles:
            return readKalles(text);
        case Program::none:
            break;
    }
    return Status::data("this is no view of XaoS, Fractint or Kalles Fraktaler");
}

}  // namespace versorium
