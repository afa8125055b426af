// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/inspection.h"

#include "core/texture/texel_address.h"
#include "ui/document/document.h"

#include <algorithm>

namespace trixel::ui {

Inspection::Inspection(Document& document, QObject* parent)
    : QObject(parent)
    , m_document(document)
{
    connect(&document, &Document::opened, this, [this] {
        m_walk.reset();
        look({}, false, false);
    });
    connect(&document, &Document::changed, this, &Inspection::takeChange);
}

WalkedSurface Inspection::surface() const
{
    check(m_document.isOpen(), "a surface to walk over");
    return {m_document.surface()->adjacency(), m_document.texels(), m_levelsDropped};
}

void Inspection::setLevelsDropped(int levels)
{
    if (m_levelsDropped != levels) {
        m_levelsDropped = levels;
        takeLevels();
    }
}

void Inspection::pointAt(FaceId face, glm::vec2 uv)
{
    if (!m_isHeld && exists(face)) {
        look(at(face, uv), true, false);
    }
}

void Inspection::pointAt(const TexelPlace& place)
{
    if (!m_isHeld && exists(place.face)) {
        look(at(place), true, false);
    }
}

void Inspection::pointAway()
{
    look(m_texel, false, m_isHeld);
}

void Inspection::hold(FaceId face, glm::vec2 uv)
{
    if (exists(face)) {
        const InspectedTexel texel = at(face, uv);
        m_walk.emplace(texel.place);
        look(texel, m_isPointedAt, true);
    }
}

void Inspection::hold(const TexelPlace& place)
{
    if (exists(place.face)) {
        m_walk.emplace(place);
        look(at(place), m_isPointedAt, true);
    }
}

void Inspection::hold()
{
    if (m_texel && !m_isHeld) {
        hold(m_texel->place.face, m_texel->uv);
    }
}

void Inspection::letGo()
{
    m_walk.reset();
    look(m_texel, m_isPointedAt, false);
}

bool Inspection::step(Step step)
{
    hold();
    if (!m_walk) {
        return false;
    }
    const WalkedSurface walked = surface();
    const bool moved = step == Step::Right   ? m_walk->right(walked)
                       : step == Step::Left  ? m_walk->left(walked)
                       : step == Step::Ahead ? m_walk->ahead(walked)
                                             : m_walk->back(walked);
    if (moved) {
        look(at(m_walk->place()), m_isPointedAt, true);
        emit wentTo();
    }
    return moved;
}

Status Inspection::goTo(std::string_view address)
{
    if (!m_document.isOpen()) {
        return contentsError("Nothing is open to go to a texel of.");
    }
    const auto place = parseTexelAddress(address, surface());
    if (!place) {
        return tl::unexpected(place.error());
    }
    hold(*place);
    emit wentTo();
    return {};
}

bool Inspection::exists(FaceId face) const
{
    return m_document.isOpen() && indexOf(face) < m_document.texels().faceCount();
}

InspectedTexel Inspection::at(FaceId face, glm::vec2 uv) const
{
    const Level level = surface().level(face);
    return {{face, texelAt(level, glm::dvec2(uv))}, level, uv};
}

InspectedTexel Inspection::at(const TexelPlace& place) const
{
    const Level level = surface().level(place.face);
    return {place, level, glm::vec2(centroid(level, place.texel))};
}

void Inspection::look(const std::optional<InspectedTexel>& texel, bool pointedAt, bool held)
{
    const bool heldBefore = isHeld();
    const bool same =
        texel == m_texel && held == heldBefore && (pointedAt || held) == isPointedAt();
    m_texel = texel;
    m_isPointedAt = pointedAt;
    m_isHeld = held;
    if (same) {
        return;
    }
    emit changed();
    if (held != heldBefore) {
        emit heldChanged(held);
    }
}

void Inspection::takeChange(const Change& change)
{
    if (!m_texel) {
        return;
    }
    if (change.rects
            .empty()) { // levels may differ, which listeners must not find out by themselves
        takeLevels();
        return;
    }
    const auto touches = [this](const TouchedRect& rect) {
        return rect.face == m_texel->place.face;
    };
    if (std::ranges::any_of(change.rects, touches)) {
        emit changed();
    }
}

/// The point stays; the texel is the one that holds it now.
void Inspection::takeLevels()
{
    if (!m_texel || !exists(m_texel->place.face)) {
        return;
    }
    m_texel = at(m_texel->place.face, m_texel->uv);
    if (m_isHeld) {
        m_walk.emplace(m_texel->place);
    }
    emit changed();
}

} // namespace trixel::ui
