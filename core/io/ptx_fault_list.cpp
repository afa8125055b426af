// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/ptx_fault_list.h"

#include <iterator>

namespace trixel {

namespace {

constexpr std::array<const char*, 7> kKindNames{"metadata",
                                                "differences from the mesh",
                                                "links between faces",
                                                "flags",
                                                "blocks of texels",
                                                "reductions",
                                                "averages"};

} // namespace

void PtxFaultList::add(PtxFault kind, std::size_t face, std::string sentence)
{
    const std::scoped_lock lock(m_mutex);
    Kind& faults = m_kinds[static_cast<std::size_t>(kind)];
    ++faults.count;
    faults.first.emplace(face, std::move(sentence));
    if (faults.first.size() > m_maxOfAKind) {
        faults.first.erase(std::prev(faults.first.end()));
    }
}

std::vector<std::string> PtxFaultList::sentences() const
{
    std::vector<std::string> sentences;
    for (std::size_t k = 0; k < m_kinds.size(); ++k) {
        const Kind& faults = m_kinds[k];
        for (const auto& [face, sentence] : faults.first) {
            sentences.push_back(sentence);
        }
        if (faults.count > faults.first.size()) {
            sentences.push_back("and " + std::to_string(faults.count - faults.first.size()) +
                                " more faults of " + kKindNames[k]);
        }
    }
    return sentences;
}

} // namespace trixel
