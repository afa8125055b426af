// SPDX-License-Identifier: GPL-3.0-or-later
//
// All that can be said of one texel, and how it is written for people and for programs.
#pragma once

#include "core/texture/texel_neighbours.h"
#include "core/texture/texel_walk.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace trixel {

/// What a view makes of a texel's values.
struct TexelDisplay
{
    std::vector<float> values;           ///< one a channel: 0 is shown black, 1 white
    std::array<std::uint8_t, 4> color{}; ///< R G B A on the screen
    bool operator==(const TexelDisplay&) const = default;
};

/// One texel as a surface is looked at, some levels coarser or none.
struct TexelReport
{
    TexelPlace place;
    Level level;           ///< as looked at
    int levelsDropped = 0; ///< by so many the face itself is finer
    TexelIndex index{};
    PackedPixel pixel;
    glm::dvec2 uv{0}; ///< the point looked at; w = 1 - u - v
    TexelFormat format;
    /// The bytes of the texel, as its face stores or would store it; none while they are not known.
    std::vector<std::byte> stored;
    std::vector<float> values; ///< the same as numbers, one a channel (`decode`)
    std::array<std::optional<TexelsAcross>, 3> neighbours; ///< across its edges; none: a border

    // What only a mesh or a view knows.
    std::optional<std::uint32_t> polygon; ///< of the mesh file, that the face was cut from
    std::optional<glm::vec3> position;    ///< of the point, in world units
    std::optional<TexelDisplay> display;

    double w() const { return 1 - uv.x - uv.y; }
};

/// \param place   a texel of the surface (checked)
/// \param uv      a point of the face
/// \param stored  the bytes of the texel, where they are known; else they are read or reduced
TexelReport describe(const WalkedSurface& surface,
                     const TexelPlace& place,
                     glm::dvec2 uv,
                     std::span<const std::byte> stored = {});

/// The same of a texel whose bytes are not known yet: reads nothing.
TexelReport describePlace(const WalkedSurface& surface, const TexelPlace& place, glm::dvec2 uv);

/// Numbers as the type stores them, separated by two spaces: whole ones for the integer types,
/// else seven digits; the first few of many channels, and how many there are.
std::string storedText(TexelType type, std::span<const float> values);

/// Two digits a byte in storage order, channels separated by a space: "c8 00 ff".
std::string hexText(const TexelFormat& format, std::span<const std::byte> stored);

/// "7:3,1,lower", "7:4,0,lower to 7:7,0,lower (4)", "border".
std::string neighbourText(const std::optional<TexelsAcross>& neighbour);

/// One property of a texel in words.
struct ReportLine
{
    std::string name; ///< "Stored at"
    std::string value;
};

/// Address, Face, Level, Texel, Stored at, u v w, Position, Stored, Bytes, Shown, Colour, Edge 0 to
/// Edge 2; without those that are not known.
std::vector<ReportLine> linesOf(const TexelReport& report);

/// "Face: 12" and so on: `linesOf`, each ended.
std::string toText(const TexelReport& report);

/// The stored bytes: `hexText`.
std::string toHex(const TexelReport& report);

/// Every field as one JSON object; numbers of half and float texels with nine digits, so that they
/// are read back as they were, and what is no number as "nan", "inf" or "-inf".
std::string toJson(const TexelReport& report);

} // namespace trixel
