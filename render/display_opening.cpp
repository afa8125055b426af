// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bases on their way to the card, part by part.
#include "core/base/check.h"
#include "render/display_blocks.h"

#include <algorithm>
#include <utility>

namespace trixel::render {

void DisplayBlocks::opensAnew()
{
    m_opens = true;
    ++m_openingNumber;
}

std::function<PreparedOpening(CardOpening)> DisplayBlocks::preparer() const
{
    const auto maxElements = m_isOpen ? std::nullopt : std::optional(m_maxElements);
    return [kind = m_kind, maxElements](CardOpening opening) {
        return PreparedOpening::of(kind, std::move(opening), maxElements);
    };
}

bool DisplayBlocks::canOpen(const PreparedOpening& prepared) const
{
    const bool isPossible =
        m_isOpen ? prepared.opening.faces.size() == m_faces.size()
                 : prepared.fresh.has_value() && prepared.fresh->maxElements == m_maxElements;
    return m_opens && !m_opening && isPossible;
}

void DisplayBlocks::open(PreparedOpening prepared)
{
    check(canOpen(prepared), "an opening that is possible");
    m_opens = prepared.opening.form != m_form;
    const bool isFresh = !m_isOpen;
    if (isFresh) {
        openFresh(std::move(*prepared.fresh));
    }
    m_again.clear();
    m_isAgain.clear();
    m_writes.clear();
    m_bytes.clear();
    m_noMean = std::move(prepared.hasNoMean);
    m_means = std::move(prepared.noMeans);
    m_nextMean = 0;
    m_opening = Opening{std::move(prepared.opening), isFresh};
}

void DisplayBlocks::openFresh(FreshBlocks fresh)
{
    const std::size_t count = fresh.faces.size();
    m_blocks = std::move(fresh.blocks);
    m_room = fresh.room;
    m_faces = std::move(fresh.faces);
    ++m_generation;
    m_inFlight.assign(count, 0);
    m_hasOldBase.assign(count, false);
    m_elementsInFlight = 0;
    m_plan = {};
    m_plan.wanted.assign(count, m_followsView ? 0 : Level::kMax);
    m_nextMake = 0;
    m_nextSpare = 0;
}

void DisplayBlocks::openAgain(std::size_t face)
{
    const CardOpening& made = m_opening->made;
    if (made.isConstant(face)) {
        release(faceId(face), false);
    } else if (m_faces[face].level() > 0) {
        m_faces[face].shown |= FaceOnCard::kStale;
    }
    show(faceId(face), CardOpening::level(made.faces[face]), made.isConstant(face));
    if (m_inFlight[face] != 0) {
        m_inFlight[face] |= kTouchedInFlight; // of what was before
    }
}

/// Of a buffer of its own bases come first: what is shown meanwhile takes room, too.
DisplayUpdate DisplayBlocks::nextBases(std::size_t mostFaces)
{
    Opening& opening = *m_opening;
    const std::size_t begin = opening.nextFace;
    const std::size_t end = std::min(m_faces.size(), begin + mostFaces);
    for (std::size_t f = begin; f < end && !opening.isFresh; ++f) {
        openAgain(f);
    }
    DisplayUpdate update = gathered();
    update.fresh = opening.isFresh && !opening.isBegun;
    update.isPart = opening.isFresh && end < m_faces.size();
    if (opening.isFresh && m_isShown) {
        update.capacity = m_blocks.baseElements();
    }
    if (begin < end) {
        const std::uint32_t size = elementsOf(m_kind, Level());
        const std::size_t bytes = size * m_form.elementBytes();
        const auto from = opening.made.bases.begin();
        update.texels.insert(update.texels.begin(),
                             {static_cast<std::uint32_t>(begin * size),
                              static_cast<std::uint32_t>((end - begin) * size)});
        update.bytes.insert(update.bytes.begin(),
                            from + static_cast<std::ptrdiff_t>(begin * bytes),
                            from + static_cast<std::ptrdiff_t>(end * bytes));
    }
    opening.isBegun = true;
    opening.nextFace = end;
    if (end == m_faces.size()) {
        opened();
    }
    return update;
}

void DisplayBlocks::opened()
{
    m_opening.reset();
    m_isOpen = true;
    m_isShown = true;
    m_plans = true;
}

} // namespace trixel::render
