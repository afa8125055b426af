// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/texture/texel_store.h"
#include "render/paint_on_card.h"
#include "render/paint_speed.h"
#include "render/renderer.h"
#include "ui/document/document.h"

#include <array>
#include <deque>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace trixel::ui {

/// Shows what a document paints behind, by the card, until texels have it; and decides which
/// strokes are worth it.
///
/// While a face has a square in the preview the card must keep its texels of before the stroke. So
/// changes are held back: what is sent comes from a store of its own (`sent`), which the faces of a
/// stroke that has settled enter some at a time, each losing its square in the frame that sends it.
/// Faces for which there was no room enter it as soon as they change.
class CardPainting
{
public:
    /// \param at       where the stroke begins
    /// \param renderer its context is current; none where nothing can be drawn
    StrokePace paceFor(render::PaintOnCard choice,
                       const Brush& brush,
                       FaceId at,
                       const Document& document,
                       render::Renderer* renderer);
    /// One sentence the first time that the card turns out not to be able to; else empty.
    QString takeNotice() { return std::exchange(m_notice, {}); }

    /// Dabs and fills that texels will have later.
    void place(const Document& document, const Brush& brush, const std::vector<PlacedDab>& dabs);
    void placeFill(const Document& document,
                   const std::vector<FaceId>& faces,
                   const std::array<float, 4>& color);
    /// The change that was placed last is in the texels, or will never be.
    void settle(const Document& document, bool isInTexels);
    /// Whether a change of the texels is held back, to be sent later.
    bool hold(const Change& change, const TexelStore& texels);

    /// What the card is to show below the preview; none where that is the document's texels.
    const TexelStore* sent() const { return m_sent ? &*m_sent : nullptr; }
    bool isShowing() const { return !m_strokes.empty(); }

    /// Whether another frame has more to do.
    bool isGivingBack() const { return !m_strokes.empty() && m_strokes.front().isSettled; }

    /// Draws what is new, and gives some faces back; their texels are then to be sent.
    /// \return  what of `sent` changed
    std::vector<TouchedRect> draw(render::Renderer& renderer, const TriangleMesh& mesh);
    /// Texels that `draw` told have been sent.
    void drawn(render::Renderer& renderer);
    /// What is shown is for nothing: strokes show when the texels have them.
    void forget();
    /// The same, and the renderer is another.
    void forgetCard()
    {
        forget();
        m_speed.reset();
    }

private:
    /// One stroke or fill, from its first dab until all its faces are given back.
    struct Shown
    {
        render::PaintPreview::Paint paint;
        TexelStore before;
        TexelStore now;                                      ///< as far as it is in the texels
        std::vector<PlacedDab> dabs;                         ///< not drawn yet
        std::vector<FaceId> fill;                            ///< not drawn yet
        std::vector<TouchedRect> changed;                    ///< not looked at yet
        std::unordered_map<std::uint32_t, TouchedRect> held; ///< by face
        bool hasBegun = false;
        bool isSettled = false;
    };

    Shown& shownFor(const Document& document, const render::PaintPreview::Paint& paint);
    void sort(Shown& shown, render::PaintPreview& preview, std::vector<TouchedRect>& rects);
    void giveBack(Shown& shown, std::vector<TouchedRect>& rects);
    bool isFaster(render::PaintPreview& preview, const TexelFormat& format);

    std::deque<Shown> m_strokes; ///< the first is shown, others wait
    std::optional<TexelStore> m_sent;
    std::vector<FaceId> m_leaving; ///< given back in this frame
    bool m_endsPreview = false;    ///< what it shows is for nothing
    bool m_isMissed = false;       ///< the stroke in progress began before the renderer was lost
    bool m_hasTold = false;        ///< that the card is not able to
    std::optional<render::PaintSpeed> m_speed;
    QString m_notice;
};

} // namespace trixel::ui
