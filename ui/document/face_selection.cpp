// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/face_selection.h"

#include "ui/document/document.h"

#include <algorithm>
#include <utility>

namespace trixel::ui {

namespace {

std::vector<bool> marksOf(std::span<const FaceId> faces, std::size_t faceCount)
{
    std::vector<bool> marks(faceCount);
    for (const FaceId face : faces) {
        marks[indexOf(face)] = true;
    }
    return marks;
}

std::vector<FaceId> facesWhere(const std::vector<bool>& marks, bool marked)
{
    std::vector<FaceId> faces;
    for (std::size_t f = 0; f < marks.size(); ++f) {
        if (marks[f] == marked) {
            faces.push_back(faceId(f));
        }
    }
    return faces;
}

} // namespace

FaceSelection::FaceSelection(Document& document, QObject* parent)
    : QObject(parent)
    , m_document(document)
{
    connect(&document, &Document::opened, this, &FaceSelection::clear);
}

std::size_t FaceSelection::faceCount() const
{
    return m_document.isOpen() ? m_document.texels().faceCount() : 0;
}

bool FaceSelection::contains(FaceId face) const
{
    return std::ranges::binary_search(m_faces, face);
}

void FaceSelection::set(std::vector<FaceId> faces)
{
    const std::size_t count = faceCount();
    std::erase_if(faces, [count](FaceId face) { return indexOf(face) >= count; });
    std::ranges::sort(faces);
    faces.erase(std::ranges::unique(faces).begin(), faces.end());
    replace(std::move(faces));
}

void FaceSelection::replace(std::vector<FaceId> sorted)
{
    if (m_faces != sorted) {
        m_faces = std::move(sorted);
        emit changed();
    }
}

void FaceSelection::add(FaceId face)
{
    const auto at = std::ranges::lower_bound(m_faces, face);
    if (indexOf(face) < faceCount() && (at == m_faces.end() || *at != face)) {
        m_faces.insert(at, face);
        emit changed();
    }
}

void FaceSelection::remove(FaceId face)
{
    const auto at = std::ranges::lower_bound(m_faces, face);
    if (at != m_faces.end() && *at == face) {
        m_faces.erase(at);
        emit changed();
    }
}

void FaceSelection::selectAll()
{
    replace(facesWhere(std::vector<bool>(faceCount()), false));
}

void FaceSelection::invert()
{
    replace(facesWhere(marksOf(m_faces, faceCount()), false));
}

void FaceSelection::grow()
{
    if (isEmpty()) {
        return;
    }
    const Adjacency& adjacency = m_document.surface()->adjacency();
    std::vector<bool> marks = marksOf(m_faces, faceCount());
    for (const FaceId face : m_faces) {
        for (const LocalEdge edge : kLocalEdges) {
            if (const auto across = adjacency.neighbour(face, edge)) {
                marks[indexOf(across->face)] = true;
            }
        }
    }
    replace(facesWhere(marks, true));
}

} // namespace trixel::ui
