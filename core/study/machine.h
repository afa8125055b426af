// SPDX-License-Identifier: GPL-3.0-or-later
//
// What figures depend on beside the program's text.
#pragma once

#include <string>

namespace trixel {

struct Machine
{
    std::string processor; ///< model as the system names it, "unknown" where it does not
    std::string simd;      ///< the widest vectors that run here: "AVX3", "AVX2", "SSE4", …
    std::string version;   ///< of the program

    bool operator==(const Machine&) const = default;
};

Machine thisMachine();

/// "AMD EPYC …, AVX2, Trixel 0.1.0"
std::string toText(const Machine& machine);

} // namespace trixel
