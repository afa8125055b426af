// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/paint/stroke.h"

#include "core/base/check.h"
#include "core/paint/dab_painter.h"
#include "core/paint/stroke_dabs.h"

#include <optional>
#include <utility>

namespace trixel {

class Stroke::State
{
public:
    State(const std::shared_ptr<const Surface>& surface,
          const Brush& brush,
          Ground ground,
          Threads threads,
          const std::shared_ptr<const LimitMesh>& limit)
        : m_dabs(surface, brush, limit)
        , m_limit(limit)
        , m_reach(limit && !brush.paintThrough
                      ? std::make_shared<const DabReach>(surface, false, limit)
                      : nullptr)
        , m_brush(brush)
        , m_ground(std::move(ground))
        , m_threads(threads)
    {
    }

    std::vector<TouchedRect> add(const StrokeSample& sample, TexelStore& store)
    {
        const TriangleMesh& mesh = m_dabs.mesh();
        check(store.faceCount() == mesh.faceCount(), "a store of the surface's faces");
        m_dabs.add(sample, [&](const Dab& dab, std::span<const FaceId> faces) {
            painterFor(store).paint(dab, mesh, faces, store);
        });
        return m_painter ? m_painter->takeTouched() : std::vector<TouchedRect>();
    }

    void lift() { m_dabs.lift(); }

    TexelPatch finish(TexelStore& store)
    {
        if (!m_painter) {
            return {};
        }
        TexelPatch patch = m_painter->finish(store);
        patch.collapseFaces(store);
        return patch;
    }

private:
    DabPainter& painterFor(const TexelStore& store)
    {
        if (!m_painter) {
            check(m_ground.isLayer() || m_ground.fill().size() == store.format().texelBytes(),
                  "a fill of one texel");
            m_painter.emplace(strokeBlend(m_brush, store.format(), m_ground),
                              m_brush.hardness,
                              m_brush.flow,
                              m_threads,
                              m_limit ? std::optional(LimitTexels(m_limit, m_reach))
                                      : std::nullopt);
        }
        return *m_painter;
    }

    StrokeDabs m_dabs;
    std::shared_ptr<const LimitMesh> m_limit;
    std::shared_ptr<const DabReach> m_reach; ///< where texels that face away stay
    Brush m_brush;
    Ground m_ground;
    Threads m_threads;
    std::optional<DabPainter> m_painter; ///< made for the format of the first store it sees
};

Stroke::Stroke(std::shared_ptr<const Surface> surface,
               const Brush& brush,
               Ground ground,
               Threads threads,
               std::shared_ptr<const LimitMesh> limit)
{
    m_state = std::make_unique<State>(surface, brush, std::move(ground), threads, limit);
}

Stroke::~Stroke() = default;
Stroke::Stroke(Stroke&&) noexcept = default;
Stroke& Stroke::operator=(Stroke&&) noexcept = default;

std::vector<TouchedRect> Stroke::add(const StrokeSample& sample, TexelStore& store)
{
    return m_state->add(sample, store);
}

void Stroke::lift()
{
    m_state->lift();
}

TexelPatch Stroke::finish(TexelStore& store)
{
    return m_state->finish(store);
}

} // namespace trixel
