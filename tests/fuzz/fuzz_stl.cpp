// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/mesh_target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    return trixel::fuzz::readMeshBytes(trixel::MeshFormat::Stl, data, size);
}
