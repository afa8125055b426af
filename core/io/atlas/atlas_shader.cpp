// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/embed_file.h"
#include "core/io/atlas/atlas_description.h"

TRIXEL_EMBED(trixelAtlasShader, TRIXEL_ATLAS_SHADER)

namespace trixel {

std::string_view atlasShader()
{
    return {trixelAtlasShaderBegin, trixelAtlasShaderEnd};
}

} // namespace trixel
