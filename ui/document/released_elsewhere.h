// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QThreadPool>

#include <memory>

namespace trixel::ui {

/// Shares something that is large to give up: whoever lets go of it last does not wait until it is
/// gone, which takes tenths of a second where it holds something for each of a million faces.
template <class T>
std::shared_ptr<T> releasedElsewhere(std::unique_ptr<T> owned)
{
    return {owned.release(), [](T* last) {
                QThreadPool::globalInstance()->start([last] { std::default_delete<T>()(last); });
            }};
}

} // namespace trixel::ui
