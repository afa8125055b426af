// SPDX-License-Identifier: GPL-3.0-or-later
//
// Views that tests of bookmarks keep.
#pragma once

#include "core/study/views/view_camera.h"

#include <string>

namespace trixel::ui {

inline ViewCamera camera(const std::string& name, double x)
{
    ViewCamera made;
    made.name = name;
    made.position = {x, 1, 3};
    return made;
}

inline DistantViews distant(const std::string& name, double distance)
{
    DistantViews made;
    made.name = name;
    made.distance = distance;
    return made;
}

} // namespace trixel::ui
