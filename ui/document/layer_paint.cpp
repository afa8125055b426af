// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/layer_paint.h"

#include "core/layers/layer_edits.h"

#include <algorithm>
#include <utility>

namespace trixel::ui {

namespace {

/// The rectangle around the runs: rows of the packed square follow each other.
TouchedRect rectAround(const TexelPatch::Texels& part, std::uint32_t side)
{
    std::uint32_t left = side;
    std::uint32_t right = 0;
    for (const TexelPatch::Run& run : part.runs) {
        const std::uint32_t x = run.first % side;
        const bool isInOneRow = x + run.count <= side;
        left = isInOneRow ? std::min(left, x) : 0;
        right = isInOneRow ? std::max(right, x + run.count) : side;
    }
    const TexelPatch::Run& last = part.runs.back();
    const std::uint32_t top = part.runs.front().first / side;
    const std::uint32_t bottom = (last.first + last.count - 1) / side + 1;
    return {part.face,
            static_cast<std::uint16_t>(left),
            static_cast<std::uint16_t>(top),
            static_cast<std::uint16_t>(right - left),
            static_cast<std::uint16_t>(bottom - top),
            false};
}

TouchedRect wholeFace(FaceId face, Level level)
{
    const auto side = static_cast<std::uint16_t>(level.resolution());
    return {face, 0, 0, side, side, true};
}

/// Whether the rest of the face looks as before, even where paint was the first on it.
bool isInPart(const TouchedRect& rect, Level level)
{
    return rect.width < level.resolution() || rect.height < level.resolution();
}

} // namespace

TexelStore& paintedTexels(LayerStack& layers, LayerId layer, TexelStore& shown)
{
    return layers.isPlain() ? shown : layers.texels(layer);
}

std::vector<TouchedRect>
showPaint(const LayerStack& layers, std::vector<TouchedRect> rects, TexelStore& shown)
{
    if (layers.isPlain()) {
        for (TouchedRect& rect : rects) {
            rect = rect.wholeFace ? wholeFace(rect.face, shown.face(rect.face).level()) : rect;
        }
        return rects;
    }
    std::vector<bool> wereConstant(rects.size());
    for (std::size_t k = 0; k < rects.size(); ++k) {
        const FaceTexels& before = shown.face(rects[k].face);
        wereConstant[k] = before.isConstant();
        rects[k].wholeFace = rects[k].wholeFace && !isInPart(rects[k], before.level());
    }
    recompose(layers, rects, shown, Threads::all());
    for (std::size_t k = 0; k < rects.size(); ++k) {
        const FaceTexels& now = shown.face(rects[k].face);
        if (now.isConstant() != wereConstant[k]) {
            rects[k] = wholeFace(rects[k].face, now.level());
        }
    }
    return rects;
}

void showCollapsed(const LayerStack& layers, const LayerPatch& applied, TexelStore& shown)
{
    if (layers.isPlain()) {
        return;
    }
    std::vector<FaceId> collapsed;
    for (const TexelPatch::Whole& whole : applied.texels.wholeFaces()) {
        if (layers.texels(applied.layer).face(whole.face).isConstant()) {
            collapsed.push_back(whole.face);
        }
    }
    recompose(layers, collapsed, shown, Threads::all());
}

std::vector<TouchedRect> rectsOf(const TexelPatch& patch, const TexelStore& texels)
{
    std::vector<TouchedRect> rects;
    rects.reserve(patch.faces().size());
    for (const TexelPatch::Texels& part : patch.texels()) {
        rects.push_back(rectAround(part, texels.face(part.face).level().resolution()));
    }
    for (const TexelPatch::Whole& part : patch.wholeFaces()) {
        rects.push_back(wholeFace(part.face, texels.face(part.face).level()));
    }
    return rects;
}

Change changeOf(std::vector<TouchedRect> rects, const TexelStore& texels)
{
    return rects.size() == texels.faceCount() ? Change() : Change{std::move(rects)};
}

std::vector<TouchedRect> wholeFaces(const TexelStore& texels, std::span<const FaceId> faces)
{
    std::vector<TouchedRect> rects;
    rects.reserve(faces.size());
    for (const FaceId face : faces) {
        rects.push_back(wholeFace(face, texels.face(face).level()));
    }
    return rects;
}

std::vector<std::byte>
filledTexel(const TexelFormat& format, LayerId layer, const std::array<float, 4>& color)
{
    std::vector<float> values(format.channels);
    for (std::size_t k = 0; k < values.size(); ++k) {
        values[k] = color[std::min<std::size_t>(k, color.size() - 1)];
    }
    std::vector<std::byte> texel(format.texelBytes());
    encode(format.type, values, texel);
    return layer == kBaseLayer ? texel : coveringTexel(format, texel);
}

Ground groundOf(LayerId layer, const std::vector<std::byte>& fill)
{
    return layer == kBaseLayer ? Ground(fill) : Ground::layer();
}

bool isPaintShown(const LayerStack& layers, LayerId layer, BlendMode blend)
{
    if (layers.isPlain()) {
        return true;
    }
    const auto visible = [](const Layer& one) { return one.settings.isVisible; };
    const auto top = std::find_if(layers.layers().rbegin(), layers.layers().rend(), visible);
    if (top == layers.layers().rend()) {
        return layer == kBaseLayer;
    }
    return blend != BlendMode::Erase && top->id == layer &&
           top->settings.blend == LayerBlend::Normal && top->settings.opacity >= 1;
}

bool isHidden(const LayerStack& layers, LayerId layer)
{
    return layer != kBaseLayer && !layers.settings(layer).isVisible;
}

std::optional<std::vector<FaceId>>
facesApart(const TexelStore& a, const TexelStore& b, std::size_t most)
{
    std::vector<FaceId> faces;
    for (std::uint32_t f = 0; f < a.faceCount(); ++f) {
        if (!a.face(faceId(f)).sharesBytesWith(b.face(faceId(f)))) {
            if (faces.size() == most) {
                return std::nullopt;
            }
            faces.push_back(faceId(f));
        }
    }
    return faces;
}

void releaseHeld(LayerStack& layers, TexelStore& shown)
{
    if (layers.isPlain()) {
        shown.releaseHeld();
        return;
    }
    TexelStore& base = layers.texels(kBaseLayer);
    std::vector<FaceId> shared; // what is one face goes on being one
    for (std::uint32_t f = 0; f < shown.faceCount(); ++f) {
        const FaceTexels& face = shown.face(faceId(f));
        if (face.isStored() && face.isLoaded() && face.sharesBytesWith(base.face(faceId(f)))) {
            shared.push_back(faceId(f));
        }
    }
    base.releaseHeld();
    for (const Layer& layer : layers.layers()) {
        layers.texels(layer.id).releaseHeld();
    }
    shown.releaseHeld();
    for (const FaceId face : shared) {
        shown.exchange(face, base.face(face));
    }
}

} // namespace trixel::ui
