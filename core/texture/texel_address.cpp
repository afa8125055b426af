// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/texel_address.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <vector>

namespace trixel {
namespace {

template <class T>
std::optional<T> numberOf(std::string_view text)
{
    T value{};
    const char* end = text.data() + text.size();
    const auto [stop, problem] = std::from_chars(text.data(), end, value);
    return problem == std::errc() && stop == end ? std::optional(value) : std::nullopt;
}

std::vector<std::string_view> separated(std::string_view text)
{
    std::vector<std::string_view> parts;
    for (std::size_t comma = text.find(','); comma != text.npos; comma = text.find(',')) {
        parts.push_back(text.substr(0, comma));
        text.remove_prefix(comma + 1);
    }
    parts.push_back(text);
    return parts;
}

tl::unexpected<Error> expected(std::string what, std::string_view found)
{
    return contentsError("Expected " + what + ", found '" + std::string(found) + "'.");
}

std::string nameOf(FaceId face)
{
    return "face " + std::to_string(indexOf(face));
}

Result<FaceId> parseFace(std::string_view text, const WalkedSurface& surface)
{
    const std::uint32_t count = surface.texels.faceCount();
    const auto number = numberOf<std::uint32_t>(text);
    if (!number || *number >= count) {
        return count == 0 ? expected("a face, but there are none", text)
                          : expected("a face from 0 to " + std::to_string(count - 1), text);
    }
    return faceId(*number);
}

Result<TexelCoord> parseIndex(std::string_view text, FaceId face, Level level)
{
    const auto number = numberOf<std::uint32_t>(text);
    if (!number || *number >= level.texelCount()) {
        return expected("an index from 0 to " + std::to_string(level.texelCount() - 1) + " in " +
                            nameOf(face),
                        text);
    }
    return texelAt(level, static_cast<TexelIndex>(*number));
}

Result<TexelCoord> parseCoord(std::string_view text, FaceId face, Level level)
{
    const std::vector<std::string_view> parts = separated(text);
    const bool upper = parts.back() == "upper";
    if (parts.size() != 3 || (!upper && parts.back() != "lower")) {
        return expected("i,j,lower or i,j,upper", text);
    }
    const std::uint16_t nowhere = 0xFFFF; // no face is as fine
    const TexelCoord texel{numberOf<std::uint16_t>(parts[0]).value_or(nowhere),
                           numberOf<std::uint16_t>(parts[1]).value_or(nowhere),
                           upper ? TexelHalf::Upper : TexelHalf::Lower};
    if (!isValid(level, texel)) {
        const std::uint32_t most = level.resolution() - 1; // i + j of a lower texel
        return upper && most == 0
                   ? expected("a lower texel, the only one of " + nameOf(face), text)
                   : expected(std::string(parts.back()) + " texels with i + j of at most " +
                                  std::to_string(upper ? most - 1 : most) + " in " + nameOf(face),
                              text);
    }
    return texel;
}

Result<TexelCoord> parsePoint(std::string_view text, Level level)
{
    const std::vector<std::string_view> parts = separated(text);
    const auto u = numberOf<double>(parts[0]);
    const auto v = parts.size() == 2 ? numberOf<double>(parts[1]) : std::nullopt;
    if (!u || !v || !(*u >= 0 && *v >= 0 && *u + *v <= 1)) {
        return expected("u,v with u, v and 1 - u - v from 0 to 1", text);
    }
    return texelAt(level, glm::dvec2(*u, *v));
}

} // namespace

Result<TexelPlace> parseTexelAddress(std::string_view text, const WalkedSurface& surface)
{
    std::string packed(text);
    std::erase(packed, ' ');
    const std::string_view address = packed;
    const std::size_t mark = address.find_first_of(":@");
    const auto face = parseFace(address.substr(0, mark), surface);
    if (!face) {
        return tl::unexpected(face.error());
    }
    if (mark == address.npos) {
        return TexelPlace{*face, texelAt(surface.level(*face), TexelIndex{})};
    }
    const Level level = surface.level(*face);
    const std::string_view rest = address.substr(mark + 1);
    const auto texel = address[mark] == '@'          ? parsePoint(rest, level)
                       : rest.find(',') != rest.npos ? parseCoord(rest, *face, level)
                                                     : parseIndex(rest, *face, level);
    return texel.map([&](const TexelCoord& found) { return TexelPlace{*face, found}; });
}

std::string toText(const TexelPlace& place)
{
    return std::to_string(indexOf(place.face)) + ':' + std::to_string(place.texel.i) + ',' +
           std::to_string(place.texel.j) +
           (place.texel.half == TexelHalf::Lower ? ",lower" : ",upper");
}

} // namespace trixel
