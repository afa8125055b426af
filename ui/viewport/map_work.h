// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPromise>

#include "core/filter/filter_method.h"
#include "core/study/views/view_queries.h"
#include "ui/viewport/view_settings.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace trixel::ui {

/// All that a map of one number a pixel is computed from; nothing of it changes meanwhile.
struct MapWork
{
    ViewMapKind map = ViewMapKind::None; ///< one of Filtered, Condition and Error
    ViewCamera camera;
    std::shared_ptr<const Surface> surface;
    std::shared_ptr<const LimitMesh> limit;   ///< of the surface, where it is seen in its place
    std::shared_ptr<const FilterScene> scene; ///< not needed for Condition
    MethodChoice method;
    double range = 0;   ///< of the values
    TexelFormat format; ///< this and what follows for Filtered alone
    render::Look look;
    double unit = 1; ///< pixels to one of 1/96 inch, for the patterns of marks
    /// Pixels that show the surface, in the place of those that the camera sees, of which only the
    /// picture's size counts then. \param step  one pixel of each step × step, in the order of rows
    std::function<ViewQueries(int step)> queries;
};

/// Some rows of the picture, which take the place of those computed before.
struct MapBand
{
    int step = 1; ///< one pixel of each step × step was computed
    int firstRow = 0;
    std::vector<std::uint32_t> pixels; ///< R G B A; clear where the mesh is not seen
    std::vector<float> values;         ///< of the map; NaN where there is none, empty for Filtered
    bool endsPass = false;             ///< the last rows of this step
};

/// Steps of the passes, the coarsest first.
inline constexpr int kMapSteps[] = {8, 4, 2, 1};

/// Computes the map pass after pass, each finer, in bands of a fraction of a second. Ends early
/// when the promise is cancelled.
void computeMap(QPromise<MapBand>& promise, const MapWork& work);

} // namespace trixel::ui
