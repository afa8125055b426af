// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/check.h"
#include "core/base/ids.h"

#include <span>
#include <vector>

namespace trixel {

/// One value per face, indexed only by `FaceId`.
template <class T>
class FaceMap
{
public:
    FaceMap() = default;
    explicit FaceMap(std::size_t faceCount, const T& value = T())
        : m_values(faceCount, value)
    {
    }

    std::size_t size() const { return m_values.size(); }

    const T& operator[](FaceId face) const
    {
        check(indexOf(face) < m_values.size(), "face exists");
        return m_values[indexOf(face)];
    }
    T& operator[](FaceId face)
    {
        check(indexOf(face) < m_values.size(), "face exists");
        return m_values[indexOf(face)];
    }

    std::span<const T> values() const { return m_values; }
    std::span<T> values() { return m_values; }

    bool operator==(const FaceMap&) const = default;

private:
    std::vector<T> m_values;
};

} // namespace trixel
