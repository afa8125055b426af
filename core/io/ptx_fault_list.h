// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <mutex>
#include <string>
#include <vector>

namespace trixel {

/// What can be wrong with a .ptx that can be opened.
enum class PtxFault { Metadata, Mesh, Link, Flag, Block, Reduction, Average };

/// Faults found by several threads; of each kind those of the first faces are kept.
class PtxFaultList
{
public:
    explicit PtxFaultList(std::size_t maxOfAKind)
        : m_maxOfAKind(maxOfAKind)
    {
    }

    void add(PtxFault kind, std::size_t face, std::string sentence);

    /// Kind by kind, in the order of faces; a last line says how many more of a kind there are.
    std::vector<std::string> sentences() const;

private:
    static constexpr std::size_t kKinds = 7;
    struct Kind
    {
        std::size_t count = 0;
        std::multimap<std::size_t, std::string> first; // by face
    };

    std::size_t m_maxOfAKind;
    std::mutex m_mutex;
    std::array<Kind, kKinds> m_kinds;
};

} // namespace trixel
