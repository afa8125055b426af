// SPDX-License-Identifier: GPL-3.0-or-later
//
// Any bytes as a .ptx file.
#include "tests/fuzz/ptx_target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    trixel::readAllOfPtx({reinterpret_cast<const char*>(data), size});
    return 0;
}
