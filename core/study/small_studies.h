// SPDX-License-Identifier: GPL-3.0-or-later
//
// Four choices of the program, each measured against the one it was made instead of. They need no
// asset and take a second or two. Only `studySubdivision` marks a front: in the others points of
// one cost stand side by side. Points reach the watcher as they are measured; all fail only when
// cancelled unless they say otherwise.
#pragma once

#include "core/base/result.h"
#include "core/mesh/triangle_mesh.h"
#include "core/study/study.h"

namespace trixel {

/// Painting both halves of the packed square with and without the offset of 1/6 texel, at every
/// level: the colour that each texel gets from where it was sampled against the one at its
/// centroid, on a sine of 20 texels. Cost: ns a texel of rasterising. Notes: texels that came from
/// the wrong half or from nobody, and the farthest sample from its centroid.
Result<Study> studyPaintProjection(StudyWatcher& watcher);

/// Halving a sine of 20 texels once to four times, by the rule for triangles (in float and in
/// uint8) and by the 2 × 2 box of images, against the mean over the area of each texel. Cost: ns a
/// texel that is read.
Result<Study> studyReduction(StudyWatcher& watcher);

/// The natural tile stored as uint8, uint16, half and float: the error of its texels, of its stored
/// mips one to six levels down against doubles, and of filtering it against filtering the floats.
/// Cost: bytes a texel. Notes:
/// the mean drift of uint8 mips.
Result<Study> studyStorage(StudyWatcher& watcher);

/// Loop subdivision against the limit surface: how far the limit lies from the faces, as a fraction
/// of the bounding box's diagonal, over its points. Cost: faces.
/// \param cage  of few enough faces to be refined at all (see `loopRefined`)
/// Fails as `loopRefined` does, and on a cage without faces or extent.
Result<Study> studySubdivision(const TriangleMesh& cage, StudyWatcher& watcher);

/// The control cage of the sample scene's chameleon, which the program carries with it.
Result<TriangleMesh> storedCage();

} // namespace trixel
