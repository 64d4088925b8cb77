// SPDX-License-Identifier: MIT
#pragma once
// Property: one value of a document, described once: where it stands, what it may be, what it is
// called, and how it is read and set. Readers, writers, the schema, --set, the controls of the
// studio, help, animation and locks all walk tables of properties (scene/properties.h).
//
// A property belongs to an owner: a Scene, one of its parts (a Layer), a workspace, the studio.
// Values pass as JSON: a number, true or false, a text, or a list.

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/json.h"
#include "base/words.h"
#include "i18n/language.h"

namespace versorium {

enum class ValueKind {
    number,
    whole,    // a number without a fraction
    toggle,   // true or false
    word,     // one of `words`
    colour,   // [r, g, b, a] in sRGB from 0 to 1, or a text "#rrggbb"
    text,     // any text
    numbers,  // a list of numbers
    other,    // a structure of its own, such as a list of roots
    group,    // an object whose members are properties
};
template <>
struct EnumWords<ValueKind> {
    static constexpr std::array<std::string_view, 9> table{
        "number", "whole", "toggle", "word", "colour", "text", "numbers", "other", "group"};
};

// What is known of a value, whoever owns it.
struct ValueInfo {
    std::string path = {};        // "colour.rule"; its last part is its short name
    std::string_view alias = {};  // another name that files and links of older versions use
    ValueKind kind = ValueKind::other;
    std::string_view label = {};  // in English, and help in one or two sentences
    std::string_view help = {};
    std::string_view unit = {};            // empty: none
    double low = 0, high = 0;              // of a number: both are allowed
    double sliderLow = 0, sliderHigh = 0;  // where a slider runs; equal: there is none
    double step = 0;                       // of one key stroke; 0: a part of the slider
    bool logarithmic = false;              // the slider
    std::size_t least = 0, most = 0;       // of a list: how many
    std::vector<std::string> words = {};   // an empty word is the default of `unsaid`
    std::string_view unsaid = {};          // what the empty word is called
    bool shared = false;                   // the views of a workspace have it in common
    bool moves = false;                    // may be animated and recorded

    // Whether a user means this value: its path, the last part of it, or its alias.
    bool isCalled(std::string_view name) const;
    std::string_view shortName() const;
};

template <class Owner>
struct Property : ValueInfo {
    std::function<Json(const Owner&)> get = {};
    // Faults begin with `path`. The owner is unchanged where it fails.
    std::function<Status(Owner&, const Json&, const std::string& path)> set = {};
    std::function<bool(const Owner&)> applies = {};    // to this owner at all; empty: always
    std::function<bool(const Owner&)> shownWhen = {};  // whether it matters now; empty: always
    std::function<bool(const Owner&)> omitted = {};    // not written, since it says nothing
    // What it is made of: the members of a group, the items of a list, the components of a number.
    std::function<std::vector<Property>(const Owner&)> parts = {};
    std::optional<Json> home = {};  // its default, where that does not depend on the owner

    bool isWritten(const Owner& owner) const {
        return (!applies || applies(owner)) && !(omitted && omitted(owner));
    }
};

// "colour.rule" of "colour" and "rule".
std::string joined(const std::string& path, const std::string& key);

// ---- makers: a member of the owner becomes a property
// --------------------------------------------

template <class Owner>
Property<Owner> numberOf(double Owner::*member, ValueInfo info) {
    info.kind = ValueKind::number;
    return {info, [member](const Owner& owner) { return Json(owner.*member); },
            [member, low = info.low, high = info.high](Owner& owner, const Json& json,
                                                       const std::string& path) {
                return readNumber(json, low, high, owner.*member).in(path);
            }};
}

template <class Owner>
Property<Owner> wholeOf(int Owner::*member, ValueInfo info) {
    info.kind = ValueKind::whole;
    return {info, [member](const Owner& owner) { return Json(owner.*member); },
            [member, low = static_cast<int>(info.low), high = static_cast<int>(info.high)](
                Owner& owner, const Json& json, const std::string& path) {
                return readWhole(json, low, high, owner.*member).in(path);
            }};
}

template <class Owner>
Property<Owner> toggleOf(bool Owner::*member, ValueInfo info) {
    info.kind = ValueKind::toggle;
    return {info, [member](const Owner& owner) { return Json(owner.*member); },
            [member](Owner& owner, const Json& json, const std::string& path) {
                return readToggle(json, owner.*member).in(path);
            }};
}

template <class Owner>
Property<Owner> textOf(std::string Owner::*member, ValueInfo info) {
    info.kind = ValueKind::text;
    return {info, [member](const Owner& owner) { return Json(owner.*member); },
            [member](Owner& owner, const Json& json, const std::string& path) {
                return readText(json, owner.*member).in(path);
            }};
}

template <class Owner>
Property<Owner> numbersOf(std::vector<double> Owner::*member, ValueInfo info) {
    info.kind = ValueKind::numbers;
    return {info, [member](const Owner& owner) { return numbersToJson(owner.*member); },
            [member, least = info.least, most = info.most](Owner& owner, const Json& json,
                                                           const std::string& path) {
                return readNumbers(json, least, most, owner.*member).in(path);
            }};
}

template <class Owner, Worded E>
Property<Owner> wordOfEnum(E Owner::*member, ValueInfo info) {
    info.kind = ValueKind::word;
    info.words = wordsOf<E>();
    return {info, [member](const Owner& owner) { return Json(std::string(wordOf(owner.*member))); },
            [member](Owner& owner, const Json& json, const std::string& path) {
                std::string word;
                const Status status = readWord(json, wordsOf<E>(), word);
                if (status.ok()) owner.*member = *fromWord<E>(word);
                return status.in(path);
            }};
}

// Nothing chosen is the empty word.
template <class Owner, Worded E>
Property<Owner> wordOfEnum(std::optional<E> Owner::*member, ValueInfo info) {
    info.kind = ValueKind::word;
    info.words = wordsOf<E>();
    info.words.insert(info.words.begin(), "");
    return {info, [member](const Owner& owner) { return Json(std::string(wordOf(owner.*member))); },
            [member, words = info.words](Owner& owner, const Json& json, const std::string& path) {
                std::string word;
                const Status status = readWord(json, words, word);
                if (status.ok()) owner.*member = fromWord<E>(word);
                return status.in(path);
            }};
}

// The numbers of a list as properties of their own: "slice.center[0]". In an ordered pair the one
// that is set takes the other along.
template <class Owner>
Property<Owner> withComponents(Property<Owner> list, std::vector<ValueInfo> infos,
                               bool ordered = false) {
    list.parts = [get = list.get, set = list.set, path = list.path, infos,
                  ordered](const Owner& owner) {
        std::vector<Property<Owner>> all;
        const std::size_t count = std::min(infos.size(), get(owner).size());
        for (std::size_t k = 0; k < count; ++k) {
            ValueInfo info = infos[k];
            info.path = path + "[" + std::to_string(k) + "]";
            if (info.kind != ValueKind::whole) info.kind = ValueKind::number;
            Property<Owner> one{info};
            one.get = [get, k](const Owner& of) { return get(of)[k]; };
            one.set = [get, set, k, ordered, info](Owner& of, const Json& json,
                                                   const std::string& at) {
                double value = 0;
                if (Status status = readNumber(json, info.low, info.high, value); !status.ok())
                    return status.in(at);
                Json next = get(of);
                next[k] = json;
                if (ordered && k == 0 && next[1].template get<double>() < value) next[1] = json;
                if (ordered && k == 1 && next[0].template get<double>() > value) next[0] = json;
                return set(of, next, at);
            };
            all.push_back(std::move(one));
        }
        return all;
    };
    return list;
}

// ---- walking tables
// ------------------------------------------------------------------------------

template <class Owner>
using PropertyTable = std::vector<Property<Owner>>;

// Reads every property of the table that the object has; other keys are the reader's to refuse.
template <class Owner>
void readProperties(ObjectReader& reader, Owner& owner, const PropertyTable<Owner>& table) {
    for (const Property<Owner>& property : table)
        if (const Json* found = reader.child(property.path.c_str()); found && property.set)
            reader.fail(property.set(owner, *found, reader.pathOf(property.path.c_str())));
}

// Strict: keys that the table does not have are refused.
template <class Owner>
Status readObject(Owner& owner, const PropertyTable<Owner>& table, const Json& json,
                  const std::string& path) {
    ObjectReader reader(json, path);
    readProperties(reader, owner, table);
    return reader.finish();
}

// `everything`: also what would be left out.
template <class Owner>
void writeProperties(const Owner& owner, const PropertyTable<Owner>& table, Json& json,
                     bool everything = false) {
    for (const Property<Owner>& property : table)
        if (everything ? !property.applies || property.applies(owner) : property.isWritten(owner))
            json[property.path] = property.get(owner);
}

template <class Owner>
Json writeObject(const Owner& owner, const PropertyTable<Owner>& table) {
    Json json = Json::object();
    writeProperties(owner, table, json);
    return json;
}

// A property of a part as one of the owner: `part` finds the part, which is there.
template <class Owner, class Part>
Property<Owner> lifted(const Property<Part>& property, const std::string& path,
                       std::function<Part&(Owner&)> part, bool shared) {
    Property<Owner> result{static_cast<const ValueInfo&>(property)};
    result.path = path;
    result.shared = shared;
    const auto of = [part](const Owner& owner) -> const Part& {
        return part(const_cast<Owner&>(owner));  // only looked at
    };
    result.get = [get = property.get, of](const Owner& owner) { return get(of(owner)); };
    result.set = [set = property.set, part](Owner& owner, const Json& json, const std::string& at) {
        return set(part(owner), json, at);
    };
    if (property.applies)
        result.applies = [applies = property.applies, of](const Owner& owner) {
            return applies(of(owner));
        };
    if (property.shownWhen)
        result.shownWhen = [shown = property.shownWhen, of](const Owner& owner) {
            return shown(of(owner));
        };
    if (property.parts)
        result.parts = [property, of, part, path, shared](const Owner& owner) {
            std::vector<Property<Owner>> all;
            for (const Property<Part>& one : property.parts(of(owner)))
                all.push_back(lifted<Owner, Part>(one, path + one.path.substr(property.path.size()),
                                                  part, shared));
            return all;
        };
    // An item of a list has no default of its own.
    const bool item = property.path.find('[') != std::string::npos;
    result.home = property.home;
    if (!result.home && !item) result.home = property.get(Part{});
    return result;
}

template <class Owner, class Part>
std::vector<Property<Owner>> liftedTable(const PropertyTable<Part>& table, const std::string& path,
                                         std::function<Part&(Owner&)> part, bool shared) {
    std::vector<Property<Owner>> all;
    for (const Property<Part>& property : table)
        all.push_back(lifted<Owner, Part>(property, joined(path, property.path), part, shared));
    return all;
}

// A part with a table of its own.
template <class Owner, class Part>
Property<Owner> groupOf(Part Owner::*member, const PropertyTable<Part>& (*table)(),
                        ValueInfo info) {
    info.kind = ValueKind::group;
    Property<Owner> group{info};
    group.get = [member, table](const Owner& owner) { return writeObject(owner.*member, table()); };
    group.set = [member, table](Owner& owner, const Json& json, const std::string& path) {
        Part next = owner.*member;
        const Status status = readObject(next, table(), json, path);
        if (status.ok()) owner.*member = std::move(next);
        return status;
    };
    group.parts = [member, table, info](const Owner&) {
        return liftedTable<Owner, Part>(
            table(), info.path, [member](Owner& owner) -> Part& { return owner.*member; },
            info.shared);
    };
    return group;
}

// A list of parts with one table for all; at most info.most of them.
template <class Owner, class Part>
Property<Owner> listOf(std::vector<Part> Owner::*member, const PropertyTable<Part>& (*table)(),
                       ValueInfo info) {
    info.kind = ValueKind::group;
    Property<Owner> list{info};
    list.get = [member, table](const Owner& owner) {
        Json json = Json::array();
        for (const Part& part : owner.*member) json.push_back(writeObject(part, table()));
        return json;
    };
    list.set = [member, table, most = info.most](Owner& owner, const Json& json,
                                                 const std::string& path) {
        if (!json.is_array() || json.size() > most)
            return Status::data(path + ": a list of at most " + std::to_string(most) +
                                " is expected");
        std::vector<Part> next(json.size());
        for (std::size_t k = 0; k < next.size(); ++k)
            if (Status status =
                    readObject(next[k], table(), json[k], path + "[" + std::to_string(k) + "]");
                !status.ok())
                return status;
        owner.*member = std::move(next);
        return Status();
    };
    list.parts = [member, table, info](const Owner& owner) {
        std::vector<Property<Owner>> all;
        for (std::size_t k = 0; k < (owner.*member).size(); ++k)
            for (Property<Owner>& one : liftedTable<Owner, Part>(
                     table(), info.path + "[" + std::to_string(k) + "]",
                     [member, k](Owner& owner) -> Part& { return (owner.*member)[k]; },
                     info.shared))
                all.push_back(std::move(one));
        return all;
    };
    return list;
}

// The table with all parts, and theirs, each behind what it is a part of; only what applies, or,
// for `shown`, what matters now.
template <class Owner>
void spread(const Owner& owner, const PropertyTable<Owner>& table, PropertyTable<Owner>& all,
            bool shown = false) {
    for (const Property<Owner>& property : table) {
        if (property.applies && !property.applies(owner)) continue;
        if (shown && property.shownWhen && !property.shownWhen(owner)) continue;
        all.push_back(property);
        if (property.parts) spread(owner, property.parts(owner), all, shown);
    }
}

}  // namespace versorium
