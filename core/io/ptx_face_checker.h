// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/io/ptx_fault_list.h"
#include "core/io/ptx_file.h"

#include <span>
#include <vector>

namespace trixel {

/// Reads every level of a face and compares each with the one it is made from, and the average with
/// the texels. One per thread.
class PtxFaceChecker
{
public:
    PtxFaceChecker(const PtxFile& file, PtxFaultList& faults)
        : m_file(file)
        , m_faults(faults)
    {
    }

    void check(FaceId face);

private:
    bool read(FaceId face, int reduction, std::vector<float>& values);
    void premultiply();
    void checkReduction(FaceId face, int reduction);
    void checkAverage(FaceId face);

    const PtxFile& m_file;
    PtxFaultList& m_faults;
    PtxDecoder m_decoder;
    std::vector<float> m_finer;
    std::vector<float> m_coarser;
};

} // namespace trixel
