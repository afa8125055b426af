// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/embed_file.h"
#include "core/mesh/mesh_reader.h"
#include "core/study/small_studies.h"
#include "core/study/test_scene.h"

TRIXEL_EMBED(trixelNaturalTile, TRIXEL_STUDY_DATA "/natural.ptx")
TRIXEL_EMBED(trixelHardEdgedTile, TRIXEL_STUDY_DATA "/hard-edged.ptx")
TRIXEL_EMBED(trixelStudyQueries, TRIXEL_STUDY_DATA "/queries.csv")
TRIXEL_EMBED(trixelSampleCage, TRIXEL_SAMPLE_CAGE)

namespace trixel {

TestDataFiles storedTestFiles()
{
    return {{trixelNaturalTileBegin, trixelNaturalTileEnd},
            {trixelHardEdgedTileBegin, trixelHardEdgedTileEnd},
            {trixelStudyQueriesBegin, trixelStudyQueriesEnd}};
}

Result<TriangleMesh> storedCage()
{
    NoProgress progress;
    return parseMesh(MeshFormat::Obj, {trixelSampleCageBegin, trixelSampleCageEnd}, progress);
}

} // namespace trixel
