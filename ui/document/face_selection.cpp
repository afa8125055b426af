// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/face_selection.h"

#include "ui/document/document.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <iterator>
#include <utility>

namespace trixel::ui {

namespace {

/// A bit for every face of the mesh.
class FaceMarks
{
public:
    explicit FaceMarks(std::size_t faceCount)
        : m_words((faceCount + kBits - 1) / kBits)
        , m_faceCount(faceCount)
    {
    }

    std::size_t wordCount() const { return m_words.size(); }

    bool operator[](FaceId face) const
    {
        return (m_words[indexOf(face) / kBits] >> (indexOf(face) % kBits) & 1U) != 0;
    }

    void mark(FaceId face)
    {
        m_words[indexOf(face) / kBits] |= std::uint64_t{1} << (indexOf(face) % kBits);
    }

    void invert()
    {
        for (std::uint64_t& word : m_words) {
            word = ~word;
        }
        if (m_faceCount % kBits != 0) {
            m_words.back() &= (std::uint64_t{1} << (m_faceCount % kBits)) - 1;
        }
    }

    /// Calls visit(face) for the unmarked faces of one word.
    template <class Visit>
    void visitUnmarked(std::size_t word, const Visit& visit) const
    {
        visitBits(~m_words[word], word, [&](FaceId face) {
            if (indexOf(face) < m_faceCount) {
                visit(face);
            }
        });
    }

    /// Ascending.
    std::vector<FaceId> faces() const
    {
        std::size_t count = 0;
        for (const std::uint64_t word : m_words) {
            count += static_cast<std::size_t>(std::popcount(word));
        }
        std::vector<FaceId> faces(count);
        FaceId* next = faces.data();
        for (std::size_t k = 0; k < m_words.size(); ++k) {
            visitBits(m_words[k], k, [&](FaceId face) { *next++ = face; });
        }
        return faces;
    }

private:
    static constexpr std::size_t kBits = 64;

    template <class Visit>
    static void visitBits(std::uint64_t bits, std::size_t word, const Visit& visit)
    {
        const std::size_t first = word * kBits;
        if (bits == ~std::uint64_t{0}) {
            for (std::size_t k = 0; k < kBits; ++k) {
                visit(faceId(first + k));
            }
            return;
        }
        for (; bits != 0; bits &= bits - 1) {
            visit(faceId(first + static_cast<std::size_t>(std::countr_zero(bits))));
        }
    }

    std::vector<std::uint64_t> m_words;
    std::size_t m_faceCount;
};

FaceMarks marksOf(std::span<const FaceId> faces, std::size_t faceCount)
{
    FaceMarks marks(faceCount);
    for (const FaceId face : faces) {
        marks.mark(face);
    }
    return marks;
}

template <class Visit>
void visitNeighbours(const Adjacency& adjacency, FaceId face, const Visit& visit)
{
    for (const LocalEdge edge : kLocalEdges) {
        if (const auto across = adjacency.neighbour(face, edge)) {
            visit(across->face);
        }
    }
}

/// A few faces look for their neighbours.
FaceMarks grownFromFaces(const Adjacency& adjacency, std::span<const FaceId> faces, FaceMarks marks)
{
    for (const FaceId face : faces) {
        visitNeighbours(adjacency, face, [&](FaceId other) { marks.mark(other); });
    }
    return marks;
}

/// Of many faces most are surrounded by others: those not chosen look for a chosen neighbour.
FaceMarks grownFromRest(const Adjacency& adjacency, const FaceMarks& marks)
{
    FaceMarks grown = marks;
    for (std::size_t word = 0; word < marks.wordCount(); ++word) {
        marks.visitUnmarked(word, [&](FaceId face) {
            visitNeighbours(adjacency, face, [&](FaceId other) {
                if (marks[other]) {
                    grown.mark(face);
                }
            });
        });
    }
    return grown;
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
    return std::ranges::binary_search(*m_faces, face);
}

/// Those that exist, ascending, each once.
std::vector<FaceId> FaceSelection::usable(std::vector<FaceId> faces) const
{
    const std::size_t count = faceCount();
    std::erase_if(faces, [count](FaceId face) { return indexOf(face) >= count; });
    if (std::ranges::is_sorted(faces)) {
        faces.erase(std::ranges::unique(faces).begin(), faces.end());
        return faces;
    }
    // Many faces, as a sorted table has them, are in order sooner by marking them.
    constexpr std::size_t kMany = 32;
    if (faces.size() > count / kMany) {
        return marksOf(faces, count).faces();
    }
    std::ranges::sort(faces);
    faces.erase(std::ranges::unique(faces).begin(), faces.end());
    return faces;
}

void FaceSelection::set(std::vector<FaceId> faces)
{
    replace(usable(std::move(faces)));
}

void FaceSelection::replace(std::vector<FaceId> sorted)
{
    if (*m_faces != sorted) {
        m_faces = std::make_shared<const std::vector<FaceId>>(std::move(sorted));
        emit changed();
    }
}

void FaceSelection::add(std::vector<FaceId> more)
{
    more = usable(std::move(more));
    std::vector<FaceId> all;
    all.reserve(m_faces->size() + more.size());
    std::ranges::set_union(*m_faces, more, std::back_inserter(all));
    replace(std::move(all));
}

void FaceSelection::remove(std::vector<FaceId> others)
{
    others = usable(std::move(others));
    std::vector<FaceId> rest;
    rest.reserve(m_faces->size());
    std::ranges::set_difference(*m_faces, others, std::back_inserter(rest));
    replace(std::move(rest));
}

void FaceSelection::selectAll()
{
    std::vector<FaceId> faces(faceCount());
    for (std::size_t f = 0; f < faces.size(); ++f) {
        faces[f] = faceId(f);
    }
    replace(std::move(faces));
}

void FaceSelection::invert()
{
    FaceMarks marks = marksOf(faces(), faceCount());
    marks.invert();
    replace(marks.faces());
}

void FaceSelection::grow()
{
    if (isEmpty()) {
        return;
    }
    constexpr std::size_t kFewParts = 8;
    const Adjacency& adjacency = m_document.surface()->adjacency();
    FaceMarks marks = marksOf(faces(), faceCount());
    const bool few = kFewParts * faces().size() < faceCount();
    replace((few ? grownFromFaces(adjacency, faces(), std::move(marks))
                 : grownFromRest(adjacency, marks))
                .faces());
}

} // namespace trixel::ui
