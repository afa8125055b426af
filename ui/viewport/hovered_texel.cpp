// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/hovered_texel.h"

#include "core/texture/mips.h"

namespace trixel::ui {

std::vector<float>
ShownTexels::values(const TexelStore& store, FaceId face, int levelsDropped, TexelIndex index)
{
    const TexelFormat& format = store.format();
    std::vector<float> result(format.channels);
    if (levelsDropped == 0) {
        decode(format.type, store.face(face).texel(indexOf(index)), result);
        return result;
    }
    if (!m_reduced || m_reduced->face != face || m_reduced->levelsDropped != levelsDropped) {
        m_reduced = {face, levelsDropped, reduced(format, store.face(face), levelsDropped)};
    }
    decode(format.type, m_reduced->texels.texel(indexOf(index)), result);
    return result;
}

HoveredTexel describeTexel(const TriangleMesh& mesh,
                           const TexelStore& store,
                           ShownTexels& shown,
                           const SurfacePoint& point,
                           const PixelRay& ray,
                           int levelsDropped)
{
    HoveredTexel hovered;
    hovered.point = point;
    hovered.level = store.face(point.face).level().coarser(levelsDropped);
    hovered.texel = texelAt(hovered.level, glm::dvec2(point.uv));
    hovered.index = texelIndex(hovered.level, hovered.texel);
    hovered.pixel = packedPixel(hovered.level, hovered.texel);
    hovered.values = shown.values(store, point.face, levelsDropped, hovered.index);
    const auto faceCorners = mesh.corners(point.face);
    hovered.footprint = screenFootprint(ray, faceCorners);
    hovered.ellipse = ellipseOf(hovered.footprint, faceCorners);
    return hovered;
}

} // namespace trixel::ui
