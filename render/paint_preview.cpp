// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/paint_preview.h"

#include <QVector4D>

#include "core/base/check.h"

#include <algorithm>
#include <utility>

namespace trixel::render {

namespace {

/// Words of faces closer than this are sent in one go: a call costs more than some words.
constexpr std::uint32_t kMergeGap = 256;

std::vector<Dab> dabsOf(std::span<const PlacedDab> placed)
{
    std::vector<Dab> dabs;
    dabs.reserve(placed.size());
    for (const PlacedDab& one : placed) {
        dabs.push_back(one.dab);
    }
    return dabs;
}

} // namespace

Result<std::unique_ptr<PaintPreview>> PaintPreview::create(Gl& gl, GLenum coverage)
{
    auto sheet = PaintSheet::create(gl, coverage);
    if (!sheet) {
        return tl::unexpected(sheet.error());
    }
    return std::unique_ptr<PaintPreview>(new PaintPreview(gl, std::move(*sheet)));
}

PaintPreview::PaintPreview(Gl& gl, std::unique_ptr<PaintSheet> sheet)
    : m_gl(gl)
    , m_sheet(std::move(sheet))
    , m_squares(m_sheet->mostRows())
    , m_cardWords(gl, GL_R32UI, sizeof(std::uint32_t))
{
}

void PaintPreview::begin(std::size_t faceCount, const Paint& paint)
{
    end();
    m_paint = paint;
    if (m_words.size() != faceCount) {
        m_words.assign(faceCount, 0);
        m_masks.assign(faceCount, 0);
        m_cardWords.fill(std::as_bytes(std::span(m_words)));
    }
}

bool PaintPreview::giveSquare(FaceId face, Level level)
{
    const PaintSquares before = m_squares;
    const auto square = m_squares.add(level);
    if (!square || !m_sheet->reserve(m_squares.rowsUsed())) {
        m_squares = before; // smaller ones may still find room
        return false;
    }
    m_words[indexOf(face)] = square->word();
    ++m_shown;
    return true;
}

void PaintPreview::add(const TriangleMesh& mesh,
                       const TexelStore& store,
                       std::span<const PlacedDab> dabs)
{
    check(mesh.faceCount() == m_words.size(), "the mesh that the stroke began on");
    while (!dabs.empty()) {
        const std::size_t some = std::min(dabs.size(), PaintBatch::kMostDabs);
        addBatch(mesh, store, dabs.first(some));
        dabs = dabs.subspan(some);
    }
}

void PaintPreview::addBatch(const TriangleMesh& mesh,
                            const TexelStore& store,
                            std::span<const PlacedDab> dabs)
{
    std::vector<FaceId> reached;
    for (std::size_t k = 0; k < dabs.size(); ++k) {
        for (const FaceId face : dabs[k].faces) {
            std::uint32_t& mask = m_masks[indexOf(face)];
            if (mask == 0) {
                reached.push_back(face);
            }
            mask |= 1U << k;
        }
    }
    PaintBatch batch(dabsOf(dabs));
    std::vector<std::uint32_t> isNew;
    for (const FaceId face : reached) {
        const std::uint32_t mask = std::exchange(m_masks[indexOf(face)], 0);
        const bool first = !hasSquare(face);
        if (first && !giveSquare(face, store.face(face).level())) {
            continue; // the sheet is full: seen when the store has it
        }
        if (first) {
            isNew.push_back(static_cast<std::uint32_t>(face));
        }
        batch.add(mesh.corners(face), PaintSquare::of(word(face)), mask, first);
    }
    m_sheet->draw(batch, m_paint.strength);
    sendWords(std::move(isNew));
}

void PaintPreview::fill(std::span<const FaceId> faces)
{
    const auto square = m_squares.add(Level(0));
    if (!square || !m_sheet->reserve(m_squares.rowsUsed())) {
        return;
    }
    PaintBatch batch(std::array{Dab{{}, {}, 1, 1}}); // whose centre is all of the face
    batch.add({}, *square, 1, true);
    m_sheet->draw(batch, {1, 1});
    std::vector<std::uint32_t> isNew;
    for (const FaceId face : faces) {
        m_shown += hasSquare(face) ? 0 : 1;
        m_words[indexOf(face)] = square->word();
        isNew.push_back(static_cast<std::uint32_t>(face));
    }
    sendWords(std::move(isNew));
}

void PaintPreview::project(const TriangleMesh& mesh,
                           const TexelStore& store,
                           std::span<const FaceId> faces,
                           const PictureProjection& picture)
{
    if (faces.empty()) {
        return;
    }
    PaintBatch batch(std::array{Dab{mesh.corners(faces.front())[0], {}, 1, 1}});
    std::vector<std::uint32_t> isNew;
    for (const FaceId face : faces) {
        if (giveSquare(face, store.face(face).level())) {
            batch.add(mesh.corners(face), PaintSquare::of(word(face)), 1, true);
            isNew.push_back(static_cast<std::uint32_t>(face));
        }
    }
    m_isPicture = m_sheet->drawPicture(batch, picture);
    if (m_isPicture) {
        sendWords(std::move(isNew));
    } else {
        end();
    }
}

PaintSpeed PaintPreview::measureSpeed(const TexelFormat& format, Threads threads)
{
    check(!isShown(), "an empty sheet");
    return measurePaintSpeed(m_gl, *m_sheet, format, threads);
}

void PaintPreview::release(std::span<const FaceId> faces)
{
    std::vector<std::uint32_t> given;
    for (const FaceId face : faces) {
        if (hasSquare(face)) {
            m_words[indexOf(face)] = 0;
            given.push_back(static_cast<std::uint32_t>(face));
        }
    }
    m_shown -= given.size();
    sendWords(std::move(given));
    if (m_shown == 0) {
        end();
    }
}

void PaintPreview::end()
{
    if (m_shown > 0) {
        std::ranges::fill(m_words, 0);
        m_cardWords.fill(std::as_bytes(std::span(m_words)));
        m_shown = 0;
    }
    m_isPicture = false;
    m_squares.clear();
    m_sheet->shrink();
}

void PaintPreview::sendWords(std::vector<std::uint32_t> faces)
{
    std::ranges::sort(faces);
    for (std::size_t k = 0; k < faces.size();) {
        const std::uint32_t first = faces[k];
        std::uint32_t last = first;
        while (k < faces.size() && faces[k] - last <= kMergeGap) {
            last = faces[k++];
        }
        const auto words = std::span(m_words).subspan(first, last - first + 1);
        m_cardWords.write(first, std::as_bytes(words));
    }
}

void PaintPreview::use(QOpenGLShaderProgram& program,
                       const CardChannels& channels,
                       GLuint squares,
                       GLuint coverage)
{
    m_cardWords.bind(squares);
    if (m_isPicture) {
        m_sheet->bindPicture(coverage);
    } else {
        m_sheet->bind(coverage);
    }
    std::array<float, 4> target{1, 1, 1, 1};
    for (std::size_t k = 0; k < target.size() && !m_isPicture; ++k) {
        if (channels[k] >= 0) {
            target[k] = m_paint.target.at(static_cast<std::size_t>(channels[k]));
        }
    }
    program.setUniformValue("squares", static_cast<GLint>(squares));
    program.setUniformValue("sheet", static_cast<GLint>(coverage));
    program.setUniformValue("paint", QVector4D(target[0], target[1], target[2], target[3]));
    program.setUniformValue("paintIsUnit", m_paint.isUnit);
    program.setUniformValue("paintIsPicture", m_isPicture);
    const auto part = [&](std::size_t k) { return std::clamp(channels[k], 0, 2); };
    const std::array<GLint, 3> parts{part(0), part(1), part(2)};
    m_gl.glUniform3iv(program.uniformLocation("paintParts"), 1, parts.data());
}

} // namespace trixel::render
