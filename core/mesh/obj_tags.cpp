// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/obj_tags.h"

#include "core/mesh/crease_edges.h"

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <string>

namespace trixel {

namespace {

/// How many arguments of each kind follow.
struct TagCounts
{
    std::int64_t integers = 0;
    std::int64_t numbers = 0;
    std::int64_t words = 0;

    bool operator==(const TagCounts&) const = default;
};

constexpr TagCounts kCrease{2, 1, 0};
constexpr TagCounts kCorner{1, 1, 0};

bool isName(std::string_view word)
{
    return !word.empty() && std::ranges::all_of(word, [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
    });
}

Result<TagCounts> readCounts(TextScanner& scanner)
{
    constexpr const char* kWhat = "how much follows, such as '2/1/0'";
    scanner.atLineEnd(); // to the next word
    const TextScanner start = scanner;
    std::array<std::int64_t, 3> counts{};
    for (std::size_t k = 0; k < counts.size(); ++k) {
        const bool isApart = k == 0 || scanner.skipCharacter('/');
        const auto count = isApart ? scanner.integerPart() : std::nullopt;
        if (!count || *count < 0) {
            return TextScanner(start).expected(kWhat);
        }
        counts[k] = *count;
    }
    if (!scanner.atWordEnd()) {
        return TextScanner(start).expected(kWhat);
    }
    return TagCounts{counts[0], counts[1], counts[2]};
}

Result<std::uint32_t> readVertex(TextScanner& scanner, std::int64_t vertexCount)
{
    const std::string range =
        vertexCount > 0
            ? "a vertex in 0 to " + std::to_string(vertexCount - 1) + " (tags count from 0)"
            : "a vertex (the file has none)";
    scanner.atLineEnd();
    const TextScanner start = scanner;
    const auto vertex = scanner.integer();
    if (!vertex || *vertex < 0 || *vertex >= vertexCount) {
        return TextScanner(start).expected(range);
    }
    return static_cast<std::uint32_t>(*vertex);
}

Result<float> readSharpness(TextScanner& scanner)
{
    scanner.atLineEnd();
    const TextScanner start = scanner;
    const auto sharpness = scanner.finiteFloat();
    if (!sharpness || *sharpness < 0) {
        return TextScanner(start).expected("a sharpness of 0 or more");
    }
    return std::min(*sharpness, kSharp);
}

Status checkLineEnds(TextScanner& scanner)
{
    return scanner.atLineEnd() ? Status() : scanner.expected("the end of the line");
}

Status readCrease(TextScanner& scanner, std::int64_t vertexCount, ObjTags& tags)
{
    const std::size_t line = scanner.line();
    Crease crease;
    for (std::uint32_t* end : {&crease.from, &crease.to}) {
        const auto vertex = readVertex(scanner, vertexCount);
        if (!vertex) {
            return tl::unexpected(vertex.error());
        }
        *end = *vertex;
    }
    const auto sharpness = readSharpness(scanner);
    if (!sharpness) {
        return tl::unexpected(sharpness.error());
    }
    crease.sharpness = *sharpness;
    tags.sharpness.creases.push_back(crease);
    tags.creaseLines.push_back(line);
    return checkLineEnds(scanner);
}

Status readCorner(TextScanner& scanner, std::int64_t vertexCount, ObjTags& tags)
{
    const auto vertex = readVertex(scanner, vertexCount);
    if (!vertex) {
        return tl::unexpected(vertex.error());
    }
    const auto sharpness = readSharpness(scanner);
    if (!sharpness) {
        return tl::unexpected(sharpness.error());
    }
    tags.sharpness.vertices.push_back({*vertex, *sharpness});
    return checkLineEnds(scanner);
}

Status skipArguments(TextScanner& scanner, const TagCounts& counts)
{
    const std::int64_t total = counts.integers + counts.numbers + counts.words; // each <= 2^62 / 4
    for (std::int64_t k = 0; k < total; ++k) {
        if (scanner.word().empty()) {
            return scanner.expected(std::to_string(total) + " arguments", std::to_string(k));
        }
    }
    return checkLineEnds(scanner);
}

/// Of those equal by `key` the last one stays; ascending by it.
template <class Sharp, class Key>
void keepLast(std::vector<Sharp>& all, Key key)
{
    std::ranges::stable_sort(all, {}, key);
    const auto repeated = [&](const Sharp& sharp) {
        const Sharp* const next = &sharp + 1;
        return next != all.data() + all.size() &&
               std::invoke(key, *next) == std::invoke(key, sharp);
    };
    std::vector<Sharp> kept;
    std::ranges::copy_if(all, std::back_inserter(kept), [&](const Sharp& sharp) {
        return !repeated(sharp) && sharp.sharpness > 0;
    });
    all = std::move(kept);
}

} // namespace

Status readObjTag(TextScanner& scanner, std::int64_t vertexCount, ObjTags& tags)
{
    TextScanner start = scanner;
    const std::string_view name = scanner.word();
    if (!isName(name)) {
        return start.expected("the name of a tag such as 'crease'");
    }
    scanner.atLineEnd();
    TextScanner atCounts = scanner;
    const auto counts = readCounts(scanner);
    if (!counts) {
        return tl::unexpected(counts.error());
    }
    if (name == "crease") {
        return *counts == kCrease ? readCrease(scanner, vertexCount, tags)
                                  : atCounts.expected("'2/1/0' (an edge and its sharpness)");
    }
    if (name == "corner") {
        return *counts == kCorner ? readCorner(scanner, vertexCount, tags)
                                  : atCounts.expected("'1/1/0' (a vertex and its sharpness)");
    }
    return skipArguments(scanner, *counts);
}

Result<Sharpness> gatherTags(const TriangleMesh& mesh, std::span<const ObjTags> parts)
{
    Sharpness all;
    std::vector<std::size_t> lines;
    for (const auto& [sharpness, creaseLines] : parts) {
        all.creases.insert(all.creases.end(), sharpness.creases.begin(), sharpness.creases.end());
        all.vertices.insert(
            all.vertices.end(), sharpness.vertices.begin(), sharpness.vertices.end());
        lines.insert(lines.end(), creaseLines.begin(), creaseLines.end());
    }
    if (const auto astray = firstOffEdges(mesh, all.creases)) {
        const Crease& crease = all.creases[*astray];
        return contentsError("line " + std::to_string(lines[*astray]) +
                             ": expected a crease along an edge, but vertices " +
                             std::to_string(crease.from) + " and " + std::to_string(crease.to) +
                             " share none");
    }
    for (Crease& crease : all.creases) {
        crease = {
            std::min(crease.from, crease.to), std::max(crease.from, crease.to), crease.sharpness};
    }
    keepLast(all.creases, [](const Crease& c) { return std::array{c.from, c.to}; });
    keepLast(all.vertices, &SharpVertex::vertex);
    return all;
}

} // namespace trixel
