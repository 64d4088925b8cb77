// SPDX-License-Identifier: MIT
#include "io/root_files.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "base/json.h"
#include "io/byte_reader.h"
#include "io/text_scanner.h"

namespace versorium {
namespace {

using Coefficient = std::array<double, 4>;

constexpr double kLargest = 1e100;  // keeps products and logarithms of differences finite

Status countFault(const std::string& what, std::int64_t count, std::size_t remaining) {
    return Status::data("the root file claims " + std::to_string(count) + " " + what + ", but " +
                        std::to_string(remaining) + " bytes follow; it is cut short or no .p4d");
}

// The count of a block whose items take `size` bytes, checked against the bytes that are there.
Expected<std::size_t> readCount(ByteReader& reader, const std::string& what, std::size_t size) {
    if (reader.remaining() < 4)
        return Status::data("the root file ends where the number of " + what + " should stand");
    const std::int64_t count = reader.read<std::int32_t>();
    if (count < 0 || static_cast<std::uint64_t>(count) > reader.remaining() / size)
        return countFault(what, count, reader.remaining());
    return static_cast<std::size_t>(count);
}

bool usable(double value) { return std::abs(value) <= kLargest; }

Status checkRoots(const RootList& list) {
    if (list.roots.empty())
        return Status::data("the list of roots is empty; it needs at least one");
    if (!usable(list.scale)) return Status::data("the scale of the powers is not a usable number");
    for (std::size_t i = 0; i < list.roots.size(); ++i) {
        bool fine = usable(list.roots[i].power);
        for (double component : list.roots[i].q) fine = fine && usable(component);
        if (!fine)
            return Status::data("root " + std::to_string(i + 1) +
                                " has a component or power that is not a number below 1e100");
    }
    return {};
}

// Hamilton's product.
Coefficient multiply(const Coefficient& a, const Coefficient& b) {
    return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
            a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
            a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
            a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]};
}

std::vector<Coefficient> coefficientsOf(const RootList& list) {
    std::vector<Coefficient> polynomial{{1, 0, 0, 0}};
    for (const RootList::Root& root : list.roots) {
        std::vector<Coefficient> next(polynomial.size() + 1, Coefficient{});
        for (std::size_t i = 0; i < polynomial.size(); ++i) {
            const Coefficient product = multiply(root.q, polynomial[i]);
            for (std::size_t k = 0; k < 4; ++k) {
                next[i + 1][k] += polynomial[i][k];
                next[i][k] -= product[k];
            }
        }
        polynomial = std::move(next);
    }
    return polynomial;
}

std::vector<Coefficient> derivativeOf(const std::vector<Coefficient>& polynomial) {
    std::vector<Coefficient> derivative;
    for (std::size_t i = 1; i < polynomial.size(); ++i) {
        derivative.push_back(polynomial[i]);
        for (double& component : derivative.back()) component *= static_cast<double>(i);
    }
    return derivative;
}

void appendBlock(std::vector<unsigned char>& bytes, const std::vector<Coefficient>& block) {
    appendLittleEndian(bytes, static_cast<std::int32_t>(block.size()));
    for (const Coefficient& item : block)
        for (double component : item) appendLittleEndian(bytes, component);
}

}  // namespace

Expected<RootList> readRootsBinary(std::span<const unsigned char> bytes) {
    ByteReader reader(bytes);
    const std::int64_t claimed = reader.read<std::int32_t>();
    if (reader.failed()) return Status::data("the root file is shorter than its first number");
    // A root takes 32 bytes in the fourth block and 8 among the powers.
    if (claimed < 1 || static_cast<std::uint64_t>(claimed) > reader.remaining() / 40)
        return countFault("roots", claimed, reader.remaining());
    const auto count = static_cast<std::size_t>(claimed);
    if (count > kRootCount)
        return Status::data("the root file has " + std::to_string(count) + " roots; at most " +
                            std::to_string(kRootCount) + " are read");
    struct Block {
        const char* name;
        std::size_t count;
    };
    const Block blocks[] = {{"coefficients", count + 1},
                            {"first derivatives", count},
                            {"second derivatives", count - 1},
                            {"roots", count}};
    for (const Block& block : blocks) {
        const Expected<std::size_t> found = readCount(reader, block.name, 32);
        if (!found) return found.status();
        if (*found != block.count)
            return Status::data("the root file claims " + std::to_string(count) +
                                " roots, but lists " + std::to_string(*found) + " " + block.name +
                                " instead of " + std::to_string(block.count));
        if (&block != &blocks[3]) reader.skip(*found * 32);
    }
    RootList list;
    list.roots.resize(count);
    for (RootList::Root& root : list.roots)
        for (double& component : root.q) component = reader.read<double>();
    const Expected<std::size_t> powers = readCount(reader, "powers", 8);
    if (!powers) return powers.status();
    if (*powers != count)
        return Status::data("the root file has " + std::to_string(count) + " roots, but " +
                            std::to_string(*powers) + " powers");
    for (RootList::Root& root : list.roots) root.power = reader.read<double>();
    list.scale = reader.read<double>();
    if (reader.failed()) return Status::data("the root file ends before the scale of its powers");
    if (const Status status = checkRoots(list); !status.ok()) return status;
    return list;
}

Expected<RootList> readRootsJson(std::string_view text) {
    const Expected<Json> json = parseJson(text);
    if (!json) return json.status();
    RootList list;
    ObjectReader reader(*json, "");
    reader.number("scale", list.scale, -kLargest, kLargest);
    const Json* roots = reader.child("roots");
    if (roots == nullptr || !roots->is_array())
        reader.fail("roots", "a list of {\"q\": [w, x, y, z], \"power\": p} must stand here");
    if (Status status = reader.finish(); !status.ok()) return status;
    if (roots->size() > kRootCount)
        return Status::data("roots: there are " + std::to_string(roots->size()) +
                            " of them; at most " + std::to_string(kRootCount) + " are read");
    for (std::size_t i = 0; i < roots->size(); ++i) {
        const std::string path = "roots[" + std::to_string(i) + "]";
        ObjectReader item((*roots)[i], path);
        RootList::Root root;
        std::vector<double> q;
        item.numbers("q", q, 1, 4).number("power", root.power, -kLargest, kLargest);
        if (!item.has("q")) item.fail("q", "the root's components [w, x, y, z] are missing");
        if (Status status = item.finish(); !status.ok()) return status;
        std::copy(q.begin(), q.end(), root.q.begin());
        list.roots.push_back(root);
    }
    if (const Status status = checkRoots(list); !status.ok()) return status;
    return list;
}

Expected<RootList> readRoots(std::span<const unsigned char> bytes) {
    bytes = bytes.subspan(bytes.size() - withoutMark(textOf(bytes)).size());
    for (unsigned char byte : bytes) {
        if (byte == ' ' || byte == '\t' || byte == '\r' || byte == '\n') continue;
        if (byte != '{') break;
        // A .p4d of 123 roots begins with '{' too, followed by zeros, which no JSON holds.
        if (bytes.size() >= 4 && bytes[0] == '{' && bytes[1] == 0) break;
        return readRootsJson({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    }
    return readRootsBinary(bytes);
}

std::vector<unsigned char> writeRootsBinary(const RootList& list) {
    std::vector<unsigned char> bytes;
    const std::vector<Coefficient> polynomial = coefficientsOf(list);
    const std::vector<Coefficient> first = derivativeOf(polynomial);
    std::vector<Coefficient> roots;
    for (const RootList::Root& root : list.roots) roots.push_back(root.q);
    const auto count = static_cast<std::int32_t>(list.roots.size());
    appendLittleEndian(bytes, count);
    appendBlock(bytes, polynomial);
    appendBlock(bytes, first);
    appendBlock(bytes, derivativeOf(first));
    appendBlock(bytes, roots);
    appendLittleEndian(bytes, count);
    for (const RootList::Root& root : list.roots) appendLittleEndian(bytes, root.power);
    appendLittleEndian(bytes, list.scale);
    return bytes;
}

std::string writeRootsJson(const RootList& list) {
    Json json;
    json["roots"] = Json::array();
    for (const RootList::Root& root : list.roots) {
        Json item;
        item["q"] = root.q;
        item["power"] = root.power;
        json["roots"].push_back(std::move(item));
    }
    json["scale"] = list.scale;
    return printJson(json);
}

}  // namespace versorium
