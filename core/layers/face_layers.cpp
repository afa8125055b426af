// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/face_layers.h"

#include "core/texture/texel_codec.h"

#include <algorithm>
#include <array>
#include <utility>

namespace trixel {

namespace {

float coverageOfTexel(const TexelFormat& layer, std::span<const std::byte> texel)
{
    std::array<float, 1> coverage{};
    decode(layer.type, texel.last(byteSize(layer.type)), coverage);
    return coverage[0];
}

/// Whether a face of one value leaves nothing of what lies below it.
bool hidesAll(const Layer& layer, const FaceTexels& face)
{
    return face.isConstant() && layer.settings.blend == LayerBlend::Normal &&
           layer.settings.opacity >= 1.0F &&
           coverageOfTexel(layer.texels.format(), face.bytes()) >= 1.0F;
}

/// \param channels  of the layer
template <TexelType kType>
bool coversAnyOf(std::span<const std::byte> texels, std::size_t channels)
{
    using Codec = TexelCodec<kType>;
    using Stored = typename Codec::Stored;
    const std::size_t count = texels.size() / sizeof(Stored) / channels;
    for (std::size_t k = 0; k < count; ++k) {
        const auto coverage = loadStored<Stored>(texels.data(), k * channels + channels - 1);
        if (Codec::decoded(coverage) > 0.0F) {
            return true;
        }
    }
    return false;
}

bool coversAny(const TexelFormat& base, const FaceTexels& layer)
{
    return withTexelType(base.type, [&](auto type) {
        return coversAnyOf<decltype(type)::value>(layer.bytes(), std::size_t{base.channels} + 1);
    });
}

bool sameTexels(const FaceTexels& a, const FaceTexels& b)
{
    return a.sharesBytesWith(b) && a.level() == b.level(); // faces of one value share over levels
}

bool alike(const Layer& a, const Layer& b, FaceId face)
{
    return a.settings.blend == b.settings.blend && a.settings.opacity == b.settings.opacity &&
           sameTexels(a.texels.face(face), b.texels.face(face));
}

} // namespace

std::vector<const Layer*> shownLayers(const LayerStack& layers)
{
    std::vector<const Layer*> shown;
    for (const Layer& layer : layers.layers()) {
        if (layer.settings.isVisible && layer.settings.opacity > 0.0F) {
            shown.push_back(&layer);
        }
    }
    return shown;
}

bool mayCover(const Layer& layer, FaceId face)
{
    const FaceTexels& texels = layer.texels.face(face);
    return !texels.isConstant() || coverageOfTexel(layer.texels.format(), texels.bytes()) > 0.0F;
}

bool FaceLayers::isConstant() const
{
    return base.isConstant() && std::ranges::all_of(over, [](const LayerFace& face) {
               return face.texels.isConstant();
           });
}

FaceLayers layersOfFace(const TexelStore& base, std::span<const Layer* const> shown, FaceId face)
{
    FaceLayers result;
    std::size_t lowest = shown.size();
    while (lowest > 0 && result.isBase) {
        --lowest;
        const FaceTexels& texels = shown[lowest]->texels.face(face);
        if (hidesAll(*shown[lowest], texels)) {
            const auto value = texels.bytes().first(base.format().texelBytes());
            result.base = FaceTexels::constant(texels.level(), value);
            result.isBase = false;
            ++lowest;
        }
    }
    if (result.isBase) {
        result.base = base.face(face).pinned();
        result.isDamaged = result.base.isDamaged();
    }
    check(result.base.level() == base.face(face).level(), "layers of the base's levels");
    for (const Layer* layer : shown.subspan(lowest)) {
        if (mayCover(*layer, face)) {
            const LayerSettings& settings = layer->settings;
            result.over.reserve(shown.size() - lowest);
            result.over.push_back(
                {settings.blend, settings.opacity, layer->texels.face(face).pinned()});
            result.isDamaged |= result.over.back().texels.isDamaged();
        }
    }
    return result;
}

void dropUncovered(const TexelFormat& base, FaceLayers& face)
{
    std::erase_if(face.over,
                  [&](const LayerFace& layer) { return !coversAny(base, layer.texels); });
}

bool showAlike(const TexelStore& base,
               std::span<const Layer* const> shown,
               const TexelStore& otherBase,
               std::span<const Layer* const> otherShown,
               FaceId face)
{
    if (!sameTexels(base.face(face), otherBase.face(face))) {
        return false;
    }
    const auto isUncovered = [face](const Layer* layer) { return !mayCover(*layer, face); };
    auto a = shown.begin();
    auto b = otherShown.begin();
    for (;;) {
        a = std::find_if_not(a, shown.end(), isUncovered);
        b = std::find_if_not(b, otherShown.end(), isUncovered);
        if (a == shown.end() || b == otherShown.end()) {
            return a == shown.end() && b == otherShown.end();
        }
        if (!alike(**a++, **b++, face)) {
            return false;
        }
    }
}

} // namespace trixel
