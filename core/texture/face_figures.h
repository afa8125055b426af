// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is to be known of every face at a glance: how large, how dense, what values.
#pragma once

#include "core/base/ids.h"
#include "core/base/level.h"
#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/triangle_mesh.h"
#include "core/texture/texel_store.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace trixel {

/// The channel that values are told of; nothing: all but the opacity.
using ChannelChoice = std::optional<std::uint16_t>;

/// The values of one face, as numbers (`decode`). NaN counts for none of them; all three are NaN
/// where nothing else is there.
struct FaceValues
{
    float lowest = 0;
    float highest = 0;
    float mean = 0;
    bool holdsNan = false;

    bool operator==(const FaceValues&) const = default;
};

/// \param channel  one of the format (checked). Of a format that is opacity alone, that is told.
FaceValues
valuesOf(const FaceTexels& texels, const TexelFormat& format, const ChannelChoice& channel);

/// Texels per world unit of length, as `planByDensity` counts them: those along an edge over the
/// root mean square of the three edges. NaN for a face of no extent.
float densityOf(const TriangleMesh& mesh, FaceId face, Level level);

/// What is told of one face.
struct FaceFigure
{
    Level level;
    bool isConstant = true;
    float density = 0;
    FaceValues values;

    bool operator==(const FaceFigure&) const = default;
};

FaceFigure figureOf(const TriangleMesh& mesh,
                    FaceId face,
                    const FaceTexels& texels,
                    const TexelFormat& format,
                    const ChannelChoice& channel);

/// The figures of all faces, an array each: 18 bytes a face. What follows from level and format is
/// worked out when asked for.
class FaceFigures
{
public:
    FaceFigures() = default;

    /// Looks at every texel once; faces that share bytes with the one before are not looked at
    /// again. Fails only when cancelled.
    /// \param channel  one of the store's format (checked)
    static Result<FaceFigures> measure(const TriangleMesh& mesh,
                                       const TexelStore& texels,
                                       const ChannelChoice& channel,
                                       Threads threads,
                                       Progress& progress);

    std::size_t faceCount() const { return m_levels.size(); }
    const TexelFormat& format() const { return m_format; }
    const ChannelChoice& channel() const { return m_channel; }

    // Of one face, which exists (not checked: for inner loops).
    Level level(FaceId face) const { return m_levels[indexOf(face)]; }
    bool isConstant(FaceId face) const { return (m_marks[indexOf(face)] & kConstant) != 0; }
    bool holdsNan(FaceId face) const { return (m_marks[indexOf(face)] & kNan) != 0; }
    float density(FaceId face) const { return m_density[indexOf(face)]; }
    float lowest(FaceId face) const { return m_lowest[indexOf(face)]; }
    float highest(FaceId face) const { return m_highest[indexOf(face)]; }
    float mean(FaceId face) const { return m_mean[indexOf(face)]; }
    /// Bytes of texels that the face keeps in memory; faces may share them.
    std::uint64_t bytes(FaceId face) const
    {
        return m_format.texelBytes() * (isConstant(face) ? 1 : level(face).texelCount());
    }

    /// Takes what was measured of one face again. The face exists (checked).
    void set(FaceId face, const FaceFigure& figure);

private:
    static constexpr std::uint8_t kConstant = 1;
    static constexpr std::uint8_t kNan = 2;

    void resize(std::size_t faceCount);
    void put(std::size_t index, const FaceFigure& figure);
    void measureRange(const TriangleMesh& mesh,
                      const TexelStore& texels,
                      std::size_t begin,
                      std::size_t end);

    TexelFormat m_format;
    ChannelChoice m_channel;
    std::vector<Level> m_levels;
    std::vector<std::uint8_t> m_marks;
    std::vector<float> m_density, m_lowest, m_highest, m_mean;
};

} // namespace trixel
