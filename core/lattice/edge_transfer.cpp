// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lattice/edge_transfer.h"

namespace trixel {

EdgeCoord toEdge(LocalEdge edge, glm::dvec2 uv)
{
    const double w = 1.0 - uv.x - uv.y;
    switch (edge) {
    case LocalEdge::E0:
        return {uv.x, uv.y};
    case LocalEdge::E1:
        return {uv.y, w};
    case LocalEdge::E2:
        break;
    }
    return {w, uv.x};
}

glm::dvec2 fromEdge(LocalEdge edge, EdgeCoord coord)
{
    const double rest = 1.0 - coord.t - coord.h;
    switch (edge) {
    case LocalEdge::E0:
        return {coord.t, coord.h};
    case LocalEdge::E1:
        return {rest, coord.t};
    case LocalEdge::E2:
        break;
    }
    return {coord.h, rest};
}

glm::dvec2 acrossEdge(LocalEdge from, LocalEdge to, glm::dvec2 uv)
{
    const EdgeCoord here = toEdge(from, uv);
    return fromEdge(to, {1.0 - here.t, -here.h});
}

} // namespace trixel
