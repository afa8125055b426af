// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/texture/face_filter.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace trixel {

/// Which faces are listed, and in what order.
struct FaceOrder
{
    FaceColumn by = FaceColumn::Face;
    bool descending = false;
    FaceFilter filter;

    /// Whether painting can change it.
    bool asksForTexels() const;

    bool operator==(const FaceOrder&) const = default;
};

/// The faces of a table, row by row, and the row of each face.
class FaceRows
{
public:
    FaceRows() = default;
    explicit FaceRows(std::size_t faceCount)
        : m_rowOf(faceCount, kNone)
    {
    }

    std::size_t size() const { return m_faces.size(); }
    std::span<const FaceId> faces() const { return m_faces; }
    /// Nothing for a face that is not listed or does not exist.
    std::optional<std::size_t> rowOf(FaceId face) const
    {
        return indexOf(face) < m_rowOf.size() && m_rowOf[indexOf(face)] != kNone
                   ? std::optional<std::size_t>(m_rowOf[indexOf(face)])
                   : std::nullopt;
    }

private:
    friend Result<FaceRows> arrangeFaces(const FaceFacts&, const FaceOrder&, Threads, Progress&);
    static constexpr std::uint32_t kNone = 0xFFFFFFFFU;

    std::vector<FaceId> m_faces;
    std::vector<std::uint32_t> m_rowOf;
};

/// Filters and sorts. Equal faces stay in the order of their numbers, and what is not known (NaN)
/// comes last, whichever way is sorted. Fails only when cancelled.
Result<FaceRows>
arrangeFaces(const FaceFacts& facts, const FaceOrder& order, Threads threads, Progress& progress);

} // namespace trixel
