// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/layer_edits.h"

#include "core/base/check.h"
#include "core/texture/level_change.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace trixel {

namespace {

/// The texels of one face that differ from others, covered, the rest uncovered.
class FaceOfPatch
{
public:
    FaceOfPatch(const TexelFormat& base, Level level)
        : m_texelBytes(layerFormat(base).texelBytes())
        , m_full(byteSize(base.type))
        , m_level(level)
        , m_texels(m_texelBytes * level.texelCount())
    {
        encode(base.type, std::array{1.0F}, m_full);
    }

    void add(std::size_t texel, std::span<const std::byte> before, std::span<const std::byte> after)
    {
        if (std::ranges::equal(before, after)) {
            return;
        }
        const auto place = std::span(m_texels).subspan(texel * m_texelBytes, m_texelBytes);
        std::ranges::copy(after, place.begin());
        std::ranges::copy(m_full, place.subspan(after.size()).begin());
    }

    FaceTexels finished() const
    {
        return FaceTexels::full(m_level, m_texelBytes, m_texels).collapsed();
    }

private:
    std::size_t m_texelBytes;
    std::vector<std::byte> m_full; ///< coverage
    Level m_level;
    std::vector<std::byte> m_texels;
};

FaceTexels
faceOfRuns(const TexelPatch::Texels& part, const FaceTexels& shown, const TexelFormat& format)
{
    FaceOfPatch face(format, shown.level());
    std::span<const std::byte> values(part.values);
    for (const TexelPatch::Run& run : part.runs) {
        for (std::uint32_t k = run.first; k < run.first + run.count; ++k) {
            face.add(k, shown.texel(k), values.first(format.texelBytes()));
            values = values.subspan(format.texelBytes());
        }
    }
    return face.finished();
}

FaceTexels faceOfWhole(const FaceTexels& next, const FaceTexels& shown, const TexelFormat& format)
{
    check(next.level() == shown.level(), "levels stay");
    if (next.isConstant() && shown.isConstant()) {
        const bool isSame = std::ranges::equal(next.bytes(), shown.bytes());
        return FaceTexels::constant(
            next.level(), isSame ? uncoveredTexel(format) : coveringTexel(format, next.bytes()));
    }
    FaceOfPatch face(format, shown.level());
    for (std::uint32_t k = 0; k < shown.level().texelCount(); ++k) {
        face.add(k, shown.texel(k), next.texel(k));
    }
    return face.finished();
}

/// \param texels  whole ones; their last value is scaled
void scaleCoverage(const TexelFormat& layer, float scale, std::span<std::byte> texels)
{
    const std::size_t bytes = byteSize(layer.type);
    std::array<float, 1> coverage{};
    for (std::size_t k = layer.texelBytes(); k <= texels.size(); k += layer.texelBytes()) {
        const auto stored = texels.subspan(k - bytes, bytes);
        decode(layer.type, stored, coverage);
        coverage[0] *= scale;
        encode(layer.type, coverage, stored);
    }
}

} // namespace

std::vector<std::byte> coveringTexel(const TexelFormat& base, std::span<const std::byte> texel)
{
    check(texel.size() == base.texelBytes(), "a texel of the base");
    std::vector<std::byte> result(texel.begin(), texel.end());
    result.resize(layerFormat(base).texelBytes());
    encode(base.type, std::array{1.0F}, std::span(result).subspan(texel.size()));
    return result;
}

TexelStore layerOfPatch(const TexelPatch& patch, const TexelStore& shown)
{
    const TexelFormat& format = shown.format();
    TexelStore layer(layerFormat(format), levelsOf(shown), uncoveredTexel(format));
    for (const TexelPatch::Texels& part : patch.texels()) {
        layer.exchange(part.face, faceOfRuns(part, shown.face(part.face).pinned(), format));
    }
    for (const TexelPatch::Whole& part : patch.wholeFaces()) {
        layer.exchange(part.face,
                       faceOfWhole(part.texels.pinned(), shown.face(part.face).pinned(), format));
    }
    return layer;
}

TexelPatch patchTo(const TexelStore& texels, const TexelStore& shown)
{
    TexelPatch patch;
    for (std::uint32_t f = 0; f < shown.faceCount(); ++f) {
        const FaceTexels& face = texels.face(faceId(f));
        if (!face.sharesBytesWith(shown.face(faceId(f))) && !(face == shown.face(faceId(f)))) {
            patch.addFace(faceId(f), face);
        }
    }
    return patch;
}

Result<TexelStore>
layerAlone(const LayerStack& layers, LayerId layer, Threads threads, Progress& progress)
{
    const TexelStore& texels = layers.texels(layer);
    if (layer == kBaseLayer || layers.settings(layer).opacity >= 1.0F) {
        return texels;
    }
    const float opacity = layers.settings(layer).opacity;
    const TexelFormat format = texels.format();
    const auto scaled = [=](const FaceTexels& face) {
        std::vector<std::byte> values(face.bytes().begin(), face.bytes().end());
        scaleCoverage(format, opacity, values);
        return face.isConstant() ? FaceTexels::constant(face.level(), values)
                                 : FaceTexels::full(face.level(), format.texelBytes(), values);
    };
    return texels.transformed(format, scaled, threads, progress);
}

} // namespace trixel
