// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which texels lie where on the graphics card and which have to be sent. Plain data, no OpenGL.
#pragma once

#include "core/paint/stroke.h"
#include "core/texture/texel_store.h"
#include "render/card_blocks.h"
#include "render/display_conversion.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

namespace trixel::render {

/// What to send to the card, in this order: room, texels, records.
struct DisplayUpdate
{
    /// Consecutive elements.
    struct Range
    {
        std::uint32_t first = 0;
        std::uint32_t count = 0;
        bool operator==(const Range&) const = default;
    };

    bool fresh = false;         ///< nothing that was on the card is needed any more
    std::uint32_t capacity = 0; ///< texels the buffer must have room for
    std::vector<Range> texels;  ///< where texels go; their bytes follow each other in `bytes`
    std::vector<std::byte> bytes;
    std::vector<Range> records; ///< faces whose records changed: read them from `records()`
};

/// Layout of the texels of a store on the graphics card. A face has a range of its own, one texel
/// long where it is constant; a face that is painted for the first time gets a new range at the
/// end, where there is room to spare. Faces are sent in order, as many at a time as the caller
/// allows, and touched texels before them.
class DisplayTexels
{
public:
    /// Starts over with a store, and its usual channels.
    /// \param mipDrop    show every face this many levels coarser (>= 0)
    /// \param maxTexels  most texels the buffer can have; levels are dropped further to fit
    void reset(const TexelStore& store, int mipDrop, std::uint32_t maxTexels);

    /// Notes that texels changed. The store must be the one of `reset`, as it is now.
    void touch(const TexelStore& store, std::span<const TouchedRect> rects);

    /// Notes that every texel may have changed. What is on the card stays until it is replaced.
    void touchAll();

    /// Sends other channels from now on, and all texels anew where they are others.
    void showChannels(const CardChannels& channels);
    const CardChannels& channels() const { return m_channels; }

    /// Converts what is to be sent next: all that was touched, then faces not sent yet until
    /// `byteBudget` is reached (at least one face).
    DisplayUpdate take(const TexelStore& store, std::size_t byteBudget);

    /// Whether `take` has something to give.
    bool hasWork() const;

    DisplayFormat format() const { return m_format; }
    std::span<const FaceRecord> records() const { return m_records; }
    /// Levels dropped in fact: the drop asked for, more if the texels would not fit.
    int levelsDropped() const { return m_drop; }
    /// Whether texels are shown coarser than asked for because they do not fit.
    bool isReduced() const { return m_drop > m_dropAsked; }
    std::uint32_t texelsUsed() const { return m_used; }

private:
    /// A rectangle of the packed square at the level shown.
    struct Rect
    {
        std::uint32_t x0 = 0, y0 = 0, x1 = 0, y1 = 0; ///< end exclusive
        bool whole = false;                           ///< every texel of the face instead
        bool moved = false;                           ///< the face has a new range
    };

    void layOut(const TexelStore& store);
    bool place(const TexelStore& store, FaceId face);
    void emitTouched(const TexelStore& store, DisplayUpdate& update);
    void emitPending(const TexelStore& store, std::size_t byteBudget, DisplayUpdate& update);
    void emitFace(const TexelStore& store, FaceId face, DisplayUpdate& update) const;
    void
    emitRect(const TexelStore& store, FaceId face, const Rect& rect, DisplayUpdate& update) const;

    DisplayFormat m_format = DisplayFormat::Rgba8;
    CardChannels m_channels{0, 1, 2, -1};
    int m_dropAsked = 0;
    int m_drop = 0;
    std::uint64_t m_maxTexels = 0;
    std::uint32_t m_capacity = 0;
    std::uint32_t m_used = 0;
    bool m_fresh = false;
    std::vector<FaceRecord> m_records;
    std::size_t m_nextFace = 0; ///< faces from here on have not been sent yet
    std::unordered_map<std::uint32_t, Rect> m_touched;
};

} // namespace trixel::render
