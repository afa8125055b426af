// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspector/shown_faces.h"

#include <QFuture>
#include <QtConcurrent>

#include "ui/document/document.h"
#include "ui/document/inspection.h"
#include "ui/viewport/view_settings.h"

#include <algorithm>
#include <utility>

namespace trixel::ui {

namespace {

/// A net and a face beside it, and as many again for the way back.
constexpr std::size_t kMostEntries = 10;
/// Faces up to this level are reduced at once: half a millisecond each.
constexpr Level kReducedAtOnce(8);
/// A first look at a face has no more texels: some milliseconds of reading here and there.
constexpr Level kSampledAtMost(9);
/// More changes than this are not looked through for the few faces that are kept.
constexpr std::size_t kMostRects = 20000;
/// Changes while a face is being reduced; then it is begun anew.
constexpr std::size_t kMostSince = 1000;

} // namespace

ShownFaces::ShownFaces(const Document& document,
                       const ViewSettings& settings,
                       const Inspection& inspection,
                       QObject* parent)
    : ShownFaces(document,
                 settings,
                 {[&document]() -> const TexelStore& { return document.texels(); },
                  [&inspection](FaceId face) { return inspection.surface().level(face); }},
                 parent)
{
}

ShownFaces::ShownFaces(const Document& document,
                       const ViewSettings& settings,
                       FaceSource source,
                       QObject* parent)
    : QObject(parent)
    , m_source(std::move(source))
    , m_settings(settings)
{
    m_pool.setMaxThreadCount(1);
    connect(&document, &Document::opened, this, [this] {
        forgetAll();
        emit changed();
    });
    connect(&document, &Document::changed, this, &ShownFaces::takeChange);
    connect(&settings, &ViewSettings::lookChanged, this, &ShownFaces::forgetLook);
}

ShownFaces::~ShownFaces()
{
    forgetAll();
    m_pool.waitForDone();
}

Level ShownFaces::level(FaceId face) const
{
    return m_source.level(face);
}

void ShownFaces::paint(QImage& image,
                       const QRect& clip,
                       const FaceLayout& layout,
                       FaceId face,
                       const TexelPaint& paint)
{
    Entry& known = entry(face);
    const Level suited = levelToDraw(layout, level(face));
    const FaceTexels& drawn = texelsToDraw(known, suited);
    paintTexels(image, clip, layout, drawn, shades(known, drawn.level()), paint);
}

const FaceTexels* ShownFaces::texels(FaceId face)
{
    Entry& known = entry(face);
    const Level shown = level(face);
    if (shown == known.base) {
        return &m_source.texels().face(face);
    }
    return haveCoarser(known, false) ? &known.coarser->at(shown) : nullptr;
}

std::optional<QRgb> ShownFaces::color(FaceId face, TexelCoord texel)
{
    const FaceTexels* shown = texels(face);
    if (shown == nullptr) {
        return std::nullopt;
    }
    return plainColor(
        shades(entry(face), shown->level()).at(*shown, packedPixel(shown->level(), texel)));
}

void ShownFaces::complete(FaceId face)
{
    haveCoarser(entry(face), true);
}

void ShownFaces::rest()
{
    forgetAll();
}

ShownFaces::Entry& ShownFaces::entry(FaceId face)
{
    const Level base = m_source.texels().face(face).level();
    auto found = std::ranges::find(m_entries, face, [](const auto& known) { return known->face; });
    if (found != m_entries.end() && (*found)->base != base) {
        forget(**found);
        m_entries.erase(found);
        found = m_entries.end();
    }
    if (found == m_entries.end()) {
        if (m_entries.size() >= kMostEntries) {
            const auto oldest = std::ranges::min_element(
                m_entries, {}, [](const auto& known) { return known->lastUsed; });
            forget(**oldest);
            m_entries.erase(oldest);
        }
        auto added = std::make_unique<Entry>();
        added->face = face;
        added->base = base;
        m_entries.push_back(std::move(added));
        found = std::prev(m_entries.end());
    }
    (*found)->lastUsed = ++m_uses;
    return **found;
}

/// Whether coarser levels are there; begins to make them where they are not.
/// \param now  makes them here if need be
bool ShownFaces::haveCoarser(Entry& entry, bool now)
{
    if (entry.coarser) {
        return true;
    }
    const FaceTexels& face = m_source.texels().face(entry.face);
    if (now || face.isConstant() || entry.base <= kReducedAtOnce) {
        forget(entry);
        entry.coarser = CoarserLevels::of(m_source.texels().format(), face);
        forgetCoarserShades(entry);
        return true;
    }
    if (!entry.wanted) {
        reduceElsewhere(entry);
    }
    return false;
}

void ShownFaces::reduceElsewhere(Entry& entry)
{
    entry.wanted = std::make_shared<std::atomic<bool>>(true);
    entry.since.clear();
    // The copy shares its bytes for as long as the work takes; a stroke meanwhile copies them once.
    QtConcurrent::run(
        &m_pool,
        [wanted = entry.wanted,
         format = m_source.texels().format(),
         face = m_source.texels().face(entry.face)]() -> std::optional<CoarserLevels> {
            return *wanted ? std::optional(CoarserLevels::of(format, face)) : std::nullopt;
        })
        .then(
            this,
            [this, face = entry.face, wanted = entry.wanted](std::optional<CoarserLevels> levels) {
                if (levels && *wanted) {
                    takeCoarser(face, wanted.get(), std::move(*levels));
                }
            });
}

void ShownFaces::takeCoarser(FaceId face, const std::atomic<bool>* job, CoarserLevels levels)
{
    const auto found = std::ranges::find_if(
        m_entries, [&](const auto& known) { return known->wanted.get() == job; });
    if (found == m_entries.end()) {
        return;
    }
    Entry& known = **found;
    known.wanted.reset();
    const FaceTexels& texels = m_source.texels().face(face);
    for (const TouchedRect& rect : known.since) {
        if (!levels.canFollow(texels, rect)) {
            reduceElsewhere(known);
            return;
        }
        levels.update(m_source.texels().format(), texels, rect);
    }
    known.coarser = std::move(levels);
    forgetCoarserShades(known);
    emit changed();
}

const FaceTexels& ShownFaces::texelsToDraw(Entry& entry, Level level)
{
    const FaceTexels& face = m_source.texels().face(entry.face);
    if (level == entry.base) {
        return face;
    }
    if (haveCoarser(entry, false)) {
        return entry.coarser->at(level);
    }
    const Level first = std::min(level, kSampledAtMost);
    if (!entry.sampled || entry.sampled->level() != first) {
        entry.sampled = sampledAt(first, face);
        entry.shades[static_cast<std::size_t>(first.log2())].reset();
    }
    return *entry.sampled;
}

ShadedTexels& ShownFaces::shades(Entry& entry, Level level)
{
    auto& kept = entry.shades[static_cast<std::size_t>(level.log2())];
    if (!kept) {
        kept = std::make_unique<ShadedTexels>(m_source.texels().format(), m_settings.look(), level);
    }
    // A large face that is looked through bit by bit does not stay in memory as a whole.
    constexpr std::size_t kMostBytes = std::size_t{24} << 20U;
    if (kept->memoryBytes() > kMostBytes) {
        kept->forget();
    }
    return *kept;
}

void ShownFaces::takeChange(const Change& change)
{
    if (m_entries.empty()) {
        return;
    }
    if (change.rects.empty() || change.rects.size() > kMostRects) {
        forgetAll();
        emit changed();
        return;
    }
    bool touched = false;
    for (const TouchedRect& rect : change.rects) {
        for (const auto& known : m_entries) {
            touched = (known->face == rect.face && touch(*known, rect)) || touched;
        }
    }
    if (touched) {
        emit changed();
    }
}

bool ShownFaces::touch(Entry& entry, const TouchedRect& rect)
{
    const FaceTexels& face = m_source.texels().face(entry.face);
    if (face.level() != entry.base) {
        return true; // begun anew when it is next drawn
    }
    forgetCoarserShades(entry);
    if (auto& shades = entry.shades[static_cast<std::size_t>(entry.base.log2())]) {
        shades->forget(rect);
    }
    if (entry.wanted) {
        entry.since.push_back(rect);
        if (entry.since.size() > kMostSince) {
            forget(entry);
        }
    }
    if (entry.coarser && entry.coarser->canFollow(face, rect)) {
        entry.coarser->update(m_source.texels().format(), face, rect);
    } else {
        entry.coarser.reset();
    }
    return true;
}

void ShownFaces::forgetCoarserShades(Entry& entry)
{
    entry.sampled.reset();
    for (std::size_t k = 0; std::cmp_less(k, entry.base.log2()); ++k) {
        entry.shades[k].reset();
    }
}

/// What is being reduced for it is no longer wanted.
void ShownFaces::forget(Entry& entry)
{
    if (entry.wanted) {
        *std::exchange(entry.wanted, nullptr) = false;
    }
}

void ShownFaces::forgetAll()
{
    for (const auto& known : m_entries) {
        forget(*known);
    }
    m_entries.clear();
}

void ShownFaces::forgetLook()
{
    for (const auto& known : m_entries) {
        for (auto& shades : known->shades) {
            shades.reset();
        }
    }
    emit changed();
}

} // namespace trixel::ui
