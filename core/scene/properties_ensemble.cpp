// SPDX-License-Identifier: MIT
// What varies in an ensemble, as properties.
#include "scene/properties.h"

namespace versorium {
namespace {

// Null, or an object.
Property<EnsembleSpec> rootsProperty() {
    Property<EnsembleSpec> roots{{.path = "roots",
                                  .kind = ValueKind::group,
                                  .label = trLater("random roots"),
                                  .help = trLater("A list of roots, and so the versor, that is "
                                                  "drawn anew for each set; or null.")}};
    roots.get = [](const EnsembleSpec& ensemble) {
        return ensemble.roots ? writeObject(*ensemble.roots, ensembleRootsTable()) : Json(nullptr);
    };
    roots.set = [](EnsembleSpec& ensemble, const Json& json, const std::string& path) -> Status {
        if (json.is_null()) {
            ensemble.roots.reset();
            return {};
        }
        EnsembleRoots next;
        if (Status status = readObject(next, ensembleRootsTable(), json, path); !status.ok())
            return status;
        ensemble.roots = next;
        return {};
    };
    roots.parts = [](const EnsembleSpec& ensemble) -> PropertyTable<EnsembleSpec> {
        if (!ensemble.roots) return {};
        return liftedTable<EnsembleSpec, EnsembleRoots>(
            ensembleRootsTable(), "roots",
            [](EnsembleSpec& owner) -> EnsembleRoots& { return *owner.roots; }, false);
    };
    roots.home = Json(nullptr);
    return roots;
}

constexpr double kFarthestNumber = 1e150;

ValueInfo bound(const char* path, const char* label) {
    return {.path = path,
            .label = label,
            .help = trLater("A number of the map, drawn evenly from a range for each set."),
            .low = -kFarthestNumber,
            .high = kFarthestNumber,
            .step = 0.1};
}

ValueInfo nameInfo(const char* help) {
    return {.path = "name", .label = trLater("number"), .help = help};
}

const PropertyTable<EnsembleRange>& rangeTable() {
    static const PropertyTable<EnsembleRange> table{
        textOf(&EnsembleRange::name,
               nameInfo(trLater("Which number is drawn, by its name, such as alpha or c.re."))),
        numberOf(&EnsembleRange::from, bound("from", trLater("from"))),
        numberOf(&EnsembleRange::to, bound("to", trLater("to"))),
    };
    return table;
}

const PropertyTable<EnsembleDisc>& discTable() {
    static const PropertyTable<EnsembleDisc> table = [] {
        const char* help =
            trLater("A complex number of the map, drawn evenly from a disc for each set.");
        Property<EnsembleDisc> centre{{.path = "center",
                                       .kind = ValueKind::numbers,
                                       .label = trLater("centre"),
                                       .help = help,
                                       .least = 2,
                                       .most = 2}};
        centre.get = [](const EnsembleDisc& disc) {
            return numbersToJson({disc.centreRe, disc.centreIm});
        };
        centre.set = [](EnsembleDisc& disc, const Json& json, const std::string& path) -> Status {
            std::vector<double> read;
            if (Status status = readNumbers(json, 2, 2, read); !status.ok()) return status.in(path);
            disc.centreRe = read[0], disc.centreIm = read[1];
            return {};
        };
        const ValueInfo part{.help = help,
                             .low = -kFarthestNumber,
                             .high = kFarthestNumber,
                             .sliderLow = -2,
                             .sliderHigh = 2,
                             .step = 0.01};
        ValueInfo re = part, im = part;
        re.label = trLater("centre re");
        im.label = trLater("centre im");
        return PropertyTable<EnsembleDisc>{
            textOf(&EnsembleDisc::name,
                   nameInfo(trLater("Which complex number is drawn, by its name, such as c."))),
            withComponents(centre, {re, im}),
            numberOf(&EnsembleDisc::radius, {.path = "radius",
                                             .label = trLater("radius"),
                                             .help = help,
                                             .low = 0,
                                             .high = kFarthestNumber,
                                             .sliderLow = 0,
                                             .sliderHigh = 1,
                                             .step = 0.01}),
        };
    }();
    return table;
}

}  // namespace

const PropertyTable<EnsembleSpec>& ensembleTable() {
    static const PropertyTable<EnsembleSpec> table{
        wholeOf(&EnsembleSpec::count,
                {.path = "count",
                 .alias = "ensemble members",
                 .label = trLater("members"),
                 .help = trLater("How many sets are averaged. More go on from those that are "
                                 "counted."),
                 .low = 1,
                 .high = kMostMembers,
                 .sliderLow = 1,
                 .sliderHigh = 100000,
                 .step = 100,
                 .logarithmic = true}),
        wholeOf(&EnsembleSpec::seed,
                {.path = "seed",
                 .alias = "ensemble seed",
                 .label = trLater("seed"),
                 .help = trLater("Another seed is another sample; the same one gives the same "
                                 "bits."),
                 .low = 0,
                 .high = 2147483647,
                 .sliderLow = 0,
                 .sliderHigh = 1000,
                 .step = 1}),
        wordOfEnum(&EnsembleSpec::set,
                   {.path = "set",
                    .alias = "ensemble set",
                    .label = trLater("set"),
                    .help = trLater("The set that is averaged. membership: what has not escaped. "
                                    "solid: what a mesh would hold.")}),
        rootsProperty(),
        listOf(&EnsembleSpec::ranges, rangeTable,
               {.path = "ranges",
                .label = trLater("ranges"),
                .help = trLater("Numbers by name, each drawn evenly between from and to."),
                .most = kMostEnsembleNumbers}),
        listOf(&EnsembleSpec::discs, discTable,
               {.path = "discs",
                .label = trLater("discs"),
                .help = trLater("Complex numbers by name, each drawn evenly from a disc."),
                .most = kMostEnsembleNumbers}),
    };
    return table;
}

}  // namespace versorium
