// SPDX-License-Identifier: GPL-3.0-or-later
//
// The assembler puts the files into the program as they are; the build says where they lie.
#include "core/mesh/mesh_reader.h"
#include "core/study/small_studies.h"
#include "core/study/test_scene.h"

// NOLINTBEGIN: no other way to name what the assembler defines
#define TRIXEL_EMBED(symbol, file)                                                                 \
    __asm__(".section .rodata\n"                                                                   \
            ".global " #symbol "Begin\n.global " #symbol "End\n" #symbol "Begin:\n.incbin \"" file \
            "\"\n" #symbol "End:\n"                                                                \
            ".previous\n");                                                                        \
    extern "C" const char symbol##Begin[];                                                         \
    extern "C" const char symbol##End[];

TRIXEL_EMBED(trixelNaturalTile, TRIXEL_STUDY_DATA "/natural.ptx")
TRIXEL_EMBED(trixelHardEdgedTile, TRIXEL_STUDY_DATA "/hard-edged.ptx")
TRIXEL_EMBED(trixelStudyQueries, TRIXEL_STUDY_DATA "/queries.csv")
TRIXEL_EMBED(trixelSampleCage, TRIXEL_SAMPLE_CAGE)
// NOLINTEND

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
