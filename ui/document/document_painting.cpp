// SPDX-License-Identifier: GPL-3.0-or-later
//
// Strokes and fills of the active layer.
#include "ui/document/behind_stroke.h"
#include "ui/document/document.h"
#include "ui/document/layer_paint.h"

#include <utility>

namespace trixel::ui {

namespace {

/// Faces that take longer to fill than the window may be held up: about 4 ms.
constexpr std::size_t kFacesBehind = 20'000;

QString fillText(std::size_t faces)
{
    return faces == 1 ? Document::tr("Fill face")
                      : Document::tr("Fill %n faces", nullptr, static_cast<int>(faces));
}

} // namespace

QString Document::strokeText(const Brush& brush)
{
    return brush.blend == BlendMode::Erase ? tr("Erase stroke") : tr("Brush stroke");
}

void Document::tellColor(const Brush& brush)
{
    if (brush.blend != BlendMode::Erase) {
        emit colorUsed(brush.color);
    }
}

void Document::beginStroke(const Brush& brush,
                           StrokePace pace,
                           std::shared_ptr<const LimitMesh> limit)
{
    if (!isOpen()) {
        return;
    }
    endStroke();
    if (const Status valid = validate(brush); !valid) {
        emit notice(QString::fromStdString(valid.error().message));
        return;
    }
    if (!mayPaint()) {
        return;
    }
    KeptStroke stroke{brush, pace, std::move(limit), m_activeLayer, {}};
    if (isSettling()) {
        m_kept = std::move(stroke);
    } else {
        start(stroke);
    }
}

/// Complains where nothing of it could be seen.
bool Document::mayPaint()
{
    if (!isHidden(layers(), m_activeLayer)) {
        return true;
    }
    emit notice(tr("%1 is hidden: show it to paint on it.")
                    .arg(QString::fromStdString(layers().settings(m_activeLayer).name)));
    return false;
}

TexelStore& Document::painted(LayerId layer)
{
    return paintedTexels(m_project.layers, layer, m_project.texels);
}

void Document::start(const KeptStroke& stroke)
{
    m_brush = stroke.brush;
    m_strokeLayer = stroke.layer;
    if (stroke.pace == StrokePace::Behind && !stroke.limit) {
        watch(std::make_unique<BehindStroke>(m_project.surface,
                                             Layered{m_project.texels, m_project.layers},
                                             m_strokeLayer,
                                             m_brush,
                                             m_fill,
                                             m_strokeThread));
    } else {
        m_stroke.emplace(m_project.surface,
                         m_brush,
                         groundOf(m_strokeLayer, m_fill),
                         Threads::all(),
                         stroke.limit);
    }
}

void Document::extendStroke(const StrokeSample& sample)
{
    if (m_kept) {
        m_kept->samples.emplace_back(sample);
    } else {
        extend(sample);
    }
}

void Document::extend(const StrokeSample& sample)
{
    if (m_behind && !m_behind->hasEnded()) {
        const std::vector<PlacedDab> dabs = m_behind->add(sample);
        if (!dabs.empty() && isPaintShown(layers(), m_strokeLayer, m_brush.blend)) {
            emit dabsPlaced(m_brush, dabs);
        }
    }
    if (!m_stroke) {
        return;
    }
    std::vector<TouchedRect> rects = m_stroke->add(sample, painted(m_strokeLayer));
    if (!rects.empty()) {
        emit changed({showPaint(layers(), std::move(rects), m_project.texels)});
    }
}

void Document::liftStroke()
{
    if (m_kept) {
        m_kept->samples.emplace_back();
    } else if (m_behind && !m_behind->hasEnded()) {
        m_behind->lift();
    } else if (m_stroke) {
        m_stroke->lift();
    }
}

void Document::endStroke()
{
    if (m_kept) {
        const KeptStroke kept = *std::exchange(m_kept, {});
        wait(strokeText(kept.brush), [this, kept] {
            play(kept);
            finish();
        });
    } else {
        finish();
    }
}

void Document::finish()
{
    endBehind();
    if (!m_stroke) {
        return;
    }
    LayerPatch applied = finishStroke();
    const bool isEmpty = applied.texels.isEmpty();
    push(std::move(applied), strokeText(m_brush));
    if (!isEmpty) {
        tellColor(m_brush);
    }
}

/// There is one, painted at once.
LayerPatch Document::finishStroke()
{
    LayerPatch patch{m_strokeLayer, m_stroke->finish(painted(m_strokeLayer))};
    m_stroke.reset();
    showCollapsed(layers(), patch, m_project.texels);
    return patch;
}

void Document::cancelStroke()
{
    m_kept.reset();
    if (m_behind && !m_behind->hasEnded()) {
        dropBehind();
    }
    if (!m_stroke) {
        return;
    }
    LayerPatch patch = finishStroke();
    if (!patch.texels.isEmpty()) {
        swapPatch(patch);
    }
}

void Document::fillFaces(std::span<const FaceId> faces, const std::array<float, 4>& color)
{
    if (!isOpen() || faces.empty()) {
        return;
    }
    endStroke();
    if (!mayPaint()) {
        return;
    }
    const LayerId layer = m_activeLayer;
    std::vector<FaceId> chosen(faces.begin(), faces.end());
    if (isSettling()) {
        const QString text = fillText(chosen.size());
        wait(text,
             [this, chosen = std::move(chosen), color, layer] { fill(chosen, color, layer); });
    } else {
        fill(chosen, color, layer);
    }
}

void Document::fill(const std::vector<FaceId>& faces,
                    const std::array<float, 4>& color,
                    LayerId layer)
{
    const std::vector<std::byte> texel = filledTexel(texels().format(), layer, color);
    const QString text = fillText(faces.size());
    if (faces.size() >= kFacesBehind) {
        const Layered before{m_project.texels, m_project.layers};
        watch(std::make_unique<BehindStroke>(before, layer, faces, texel, m_strokeThread));
        beginPending(text);
        if (isPaintShown(layers(), layer, BlendMode::Normal)) {
            emit fillPlaced(faces, color);
        }
        emit colorUsed(color);
        return;
    }
    LayerPatch patch{layer, trixel::fillFaces(painted(layer), faces, texel)};
    if (patch.texels.isEmpty()) {
        return;
    }
    std::vector<TouchedRect> rects = wholeFaces(texels(), patch.texels.faces());
    rects = showPaint(layers(), std::move(rects), m_project.texels);
    emit changed(changeOf(std::move(rects), texels()));
    push(std::move(patch), text);
    emit colorUsed(color);
}

} // namespace trixel::ui
