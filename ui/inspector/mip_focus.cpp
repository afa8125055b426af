// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspector/mip_focus.h"

#include "core/lattice/texel_family.h"
#include "ui/document/document.h"

#include <algorithm>
#include <utility>

namespace trixel::ui {

namespace {

/// A pointer on its way over many faces measures none of them.
constexpr int kPauseMs = 40;

} // namespace

MipFocus::MipFocus(Document& document, Inspection& inspection, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_inspection(inspection)
{
    m_pause.setSingleShot(true);
    m_pause.setInterval(kPauseMs);
    connect(&m_pause, &QTimer::timeout, this, &MipFocus::ask);
    connect(&inspection, &Inspection::changed, this, &MipFocus::take);
    connect(&document, &Document::changed, this, [this](const Change& change) {
        const auto touches = [this](const TouchedRect& rect) { return rect.face == m_face; };
        if (change.rects.empty() || std::ranges::any_of(change.rects, touches)) {
            forget();
            take();
        }
    });
    connect(&document, &Document::opened, this, [this] {
        m_chosen.reset();
        m_pointed.reset();
        forget();
        take();
    });
    connect(&m_work,
            &MipWork::reduced,
            this,
            [this](const std::shared_ptr<const MipComparison>& levels) {
                m_levels = levels;
                emit faceChanged();
            });
    connect(&m_work, &MipWork::measured, this, [this](Level level, quint64 bytes) {
        m_bytes[static_cast<std::size_t>(level.log2())] = bytes;
        emit measured();
    });
    connect(&m_work, &MipWork::finished, this, [this] {
        m_isMeasured = true;
        emit measured();
    });
}

void MipFocus::setActive(bool active)
{
    if (active == m_isActive) {
        return;
    }
    m_isActive = active;
    if (active) {
        take();
    } else {
        forget();
    }
}

std::optional<FaceId> MipFocus::face() const
{
    const auto& texel = m_inspection.texel();
    return texel && m_document.isOpen() ? std::optional(texel->place.face) : std::nullopt;
}

const FaceTexels& MipFocus::texels() const
{
    check(face().has_value(), "a face that is looked at");
    return m_document.texels().face(*face());
}

Level MipFocus::base() const
{
    return texels().level();
}

const TexelFormat& MipFocus::format() const
{
    return m_document.texels().format();
}

Level MipFocus::shown() const
{
    check(face().has_value(), "a face that is looked at");
    return m_inspection.texel()->level;
}

std::optional<quint64> MipFocus::fileBytes(Level level) const
{
    return m_bytes[static_cast<std::size_t>(level.log2())];
}

Level MipFocus::level() const
{
    const Level wanted = m_pointed ? *m_pointed : m_chosen ? *m_chosen : shown();
    return std::min(wanted, base());
}

TexelCoord MipFocus::texel(Level level) const
{
    check(level <= base(), "a level that the face has");
    const InspectedTexel& texel = *m_inspection.texel();
    return level <= texel.level ? ancestorOf(texel.level, texel.place.texel, level)
                                : texelAt(level, glm::dvec2(texel.uv));
}

void MipFocus::choose(Level level)
{
    m_chosen = level == shown() ? std::nullopt : std::optional(level);
    emit texelChanged();
}

void MipFocus::pointAt(Level level, glm::vec2 uv)
{
    if (m_inspection.isHeld()) {
        return;
    }
    const bool isOther = m_pointed != level;
    m_pointed = level;
    const std::optional<InspectedTexel> before = m_inspection.texel();
    m_inspection.pointAt(*face(), uv);
    if (isOther && before == m_inspection.texel()) {
        emit texelChanged(); // nobody else told of it
    }
}

void MipFocus::pointAway()
{
    if (m_pointed.has_value()) {
        m_pointed.reset();
        m_inspection.pointAway();
        emit texelChanged();
    }
}

void MipFocus::hold(Level level, glm::vec2 uv)
{
    choose(level);
    m_inspection.hold(*face(), uv);
}

void MipFocus::toggleHold()
{
    if (m_inspection.isHeld()) {
        m_inspection.letGo();
    } else {
        m_inspection.hold();
    }
}

void MipFocus::letGo()
{
    m_inspection.letGo();
}

void MipFocus::take()
{
    if (!m_isActive) {
        return;
    }
    if (face() == m_face && (!m_face || base() == m_base)) {
        emit texelChanged();
        return;
    }
    forget();
    m_face = face();
    if (m_face) {
        m_base = base();
        takeTexels();
    }
    emit faceChanged();
}

void MipFocus::forget()
{
    m_work.drop();
    m_pause.stop();
    m_face.reset();
    m_levels.reset();
    m_bytes.fill(std::nullopt);
    m_isMeasured = false;
}

void MipFocus::takeTexels()
{
    if (m_base <= kFinestAtOnce || texels().isConstant()) {
        NoProgress progress;
        m_levels = std::make_shared<const MipComparison>(
            *MipComparison::build(format(), texels(), progress));
    }
    m_pause.start();
}

void MipFocus::ask()
{
    if (m_document.hasStroke()) {
        // Whoever holds its texels makes the next dab copy them.
        m_pause.start();
        return;
    }
    m_work.ask(format(), texels(), m_levels == nullptr);
}

} // namespace trixel::ui
