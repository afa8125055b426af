// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/card_painting.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace trixel::ui {

namespace {

/// Dabs below are painted in a frame's time on the spot, whatever the card can do.
constexpr double kLargeDab = 200'000;
/// What is given back in a frame: texels to be read and sent, and faces.
constexpr std::size_t kTexelsAFrame = 1U << 19U;
constexpr std::size_t kFacesAFrame = 20'000;

/// About how many texels a dab covers, taken from the face it begins on.
double texelsUnder(const Brush& brush, FaceId at, const Document& document)
{
    const auto corners = document.surface()->mesh().corners(at);
    const glm::dvec3 origin(corners[0]);
    const double area = 0.5 * glm::length(glm::cross(glm::dvec3(corners[1]) - origin,
                                                     glm::dvec3(corners[2]) - origin));
    const double radius = brush.radius;
    const double texels = document.texels().face(at).level().texelCount();
    return area > 0 ? 3.14159265 * radius * radius * texels / area : 0;
}

bool isUnit(const TexelFormat& format)
{
    return format.type == TexelType::UInt8 || format.type == TexelType::UInt16;
}

void merge(std::unordered_map<std::uint32_t, TouchedRect>& held, const TouchedRect& rect)
{
    const auto [at, isNew] = held.try_emplace(static_cast<std::uint32_t>(rect.face), rect);
    if (isNew) {
        return;
    }
    TouchedRect& known = at->second;
    const int right = std::max(known.x + known.width, rect.x + rect.width);
    const int bottom = std::max(known.y + known.height, rect.y + rect.height);
    known.x = std::min(known.x, rect.x);
    known.y = std::min(known.y, rect.y);
    known.width = static_cast<std::uint16_t>(right - known.x);
    known.height = static_cast<std::uint16_t>(bottom - known.y);
    known.wholeFace = known.wholeFace || rect.wholeFace;
}

} // namespace

StrokePace CardPainting::paceFor(render::PaintOnCard choice,
                                 const Brush& brush,
                                 FaceId at,
                                 const Document& document,
                                 render::Renderer* renderer)
{
    const bool isAlways = choice == render::PaintOnCard::Always;
    const bool isLarge = isAlways || texelsUnder(brush, at, document) >= kLargeDab;
    if (choice == render::PaintOnCard::Never || renderer == nullptr || !isLarge) {
        return StrokePace::AtOnce;
    }
    const auto preview = renderer->preview();
    if (!preview) {
        if (!std::exchange(m_hasTold, true)) {
            m_notice = QCoreApplication::translate("CardPainting",
                                                   "Strokes are painted by the processor alone. %1")
                           .arg(QString::fromStdString(preview.error().message));
        }
        return StrokePace::AtOnce;
    }
    return isAlways || isFaster(**preview, document.texels().format()) ? StrokePace::Behind
                                                                       : StrokePace::AtOnce;
}

/// Measured once for a renderer, when nothing else is in the sheet.
bool CardPainting::isFaster(render::PaintPreview& preview, const TexelFormat& format)
{
    if (!m_speed && m_strokes.empty()) {
        m_speed = preview.measureSpeed(format, Threads::all());
    }
    return m_speed && m_speed->isCardFaster();
}

CardPainting::Shown& CardPainting::shownFor(const Document& document,
                                            const render::PaintPreview::Paint& paint)
{
    if (m_strokes.empty() || m_strokes.back().isSettled) {
        m_strokes.push_back({});
        m_strokes.back().paint = paint;
        m_strokes.back().before = m_strokes.back().now = document.texels();
    }
    return m_strokes.back();
}

void CardPainting::place(const Document& document,
                         const Brush& brush,
                         const std::vector<PlacedDab>& dabs)
{
    if (m_isMissed) {
        return;
    }
    const TexelFormat& format = document.texels().format();
    std::vector<PlacedDab>& fresh = shownFor(document,
                                             {strokeTarget(brush, format, document.fillTexel()),
                                              {brush.hardness, brush.flow},
                                              isUnit(format)})
                                        .dabs;
    fresh.insert(fresh.end(), dabs.begin(), dabs.end());
}

void CardPainting::placeFill(const Document& document,
                             const std::vector<FaceId>& faces,
                             const std::array<float, 4>& color)
{
    const TexelFormat& format = document.texels().format();
    Brush brush;
    brush.color = color;
    shownFor(document, {strokeTarget(brush, format, {}), {1, 1}, isUnit(format)}).fill = faces;
}

void CardPainting::settle(const Document& document, bool isInTexels)
{
    m_isMissed = false;
    if (m_strokes.empty() || m_strokes.back().isSettled) {
        return; // not shown
    }
    if (isInTexels) {
        m_strokes.back().isSettled = true;
        m_strokes.back().now = document.texels();
        return;
    }
    m_endsPreview = m_endsPreview || m_strokes.size() == 1;
    m_strokes.pop_back();
    if (m_strokes.empty()) {
        m_sent.reset();
        m_leaving.clear();
    }
}

bool CardPainting::hold(const Change& change, const TexelStore& texels)
{
    if (m_strokes.empty()) {
        return false;
    }
    if (change.rects.empty()) {
        forget(); // everything is sent anew
        return false;
    }
    Shown& shown = m_strokes.back();
    shown.now = texels;
    shown.changed.insert(shown.changed.end(), change.rects.begin(), change.rects.end());
    return true;
}

std::vector<TouchedRect> CardPainting::draw(render::Renderer& renderer, const TriangleMesh& mesh)
{
    std::vector<TouchedRect> rects;
    if (std::exchange(m_endsPreview, false) && renderer.shownPreview() != nullptr) {
        renderer.shownPreview()->end();
    }
    if (m_strokes.empty()) {
        return rects;
    }
    Shown& shown = m_strokes.front();
    const auto preview = renderer.preview();
    if (!preview) { // it was there when the stroke began
        rects = shown.changed;
        forget();
        return rects;
    }
    if (!std::exchange(shown.hasBegun, true)) {
        (*preview)->begin(mesh.faceCount(), shown.paint);
        m_sent = shown.before;
    }
    if (!shown.dabs.empty()) {
        (*preview)->add(mesh, *m_sent, std::exchange(shown.dabs, {}));
    }
    if (!shown.fill.empty()) {
        (*preview)->fill(std::exchange(shown.fill, {}));
    }
    sort(shown, **preview, rects);
    if (shown.isSettled) {
        giveBack(shown, rects);
    }
    return rects;
}

/// Changes of faces with a square are held; those of others need not wait.
void CardPainting::sort(Shown& shown,
                        render::PaintPreview& preview,
                        std::vector<TouchedRect>& rects)
{
    for (const TouchedRect& rect : std::exchange(shown.changed, {})) {
        if (preview.hasSquare(rect.face)) {
            merge(shown.held, rect);
        } else {
            m_sent->exchange(rect.face, shown.now.face(rect.face));
            rects.push_back(rect);
        }
    }
}

void CardPainting::giveBack(Shown& shown, std::vector<TouchedRect>& rects)
{
    std::size_t texels = 0;
    while (!shown.held.empty() && texels < kTexelsAFrame && m_leaving.size() < kFacesAFrame) {
        const auto first = shown.held.begin();
        const FaceId face{first->first};
        m_sent->exchange(face, shown.now.face(face));
        const FaceTexels& now = m_sent->face(face);
        texels += now.isConstant() ? 1 : now.level().texelCount();
        rects.push_back(first->second);
        m_leaving.push_back(face);
        shown.held.erase(first);
    }
}

void CardPainting::drawn(render::Renderer& renderer)
{
    render::PaintPreview* preview = renderer.shownPreview();
    if (preview == nullptr || m_strokes.empty()) {
        m_leaving.clear();
        return;
    }
    preview->release(std::exchange(m_leaving, {}));
    const Shown& shown = m_strokes.front();
    if (shown.isSettled && shown.held.empty() && shown.changed.empty()) {
        preview->end(); // what is left was covered, but not changed
        m_strokes.pop_front();
        if (m_strokes.empty()) {
            m_sent.reset();
        }
    }
}

void CardPainting::forget()
{
    m_isMissed = m_isMissed || (!m_strokes.empty() && !m_strokes.back().isSettled);
    m_strokes.clear();
    m_sent.reset();
    m_leaving.clear();
    m_endsPreview = true;
}

} // namespace trixel::ui
