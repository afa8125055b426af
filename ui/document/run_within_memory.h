// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFuture>
#include <QtConcurrent>

#include <new>
#include <optional>
#include <type_traits>
#include <utility>

namespace trixel::ui {

/// Runs work on another thread. Where memory runs out the future ends without a result (`madeOf`)
/// instead of throwing at whoever looks at it.
template <class Work>
auto runWithinMemory(Work work) -> QFuture<std::invoke_result_t<Work>>
{
    using Made = std::invoke_result_t<Work>;
    return QtConcurrent::run([work = std::move(work)](QPromise<Made>& promise) {
        try {
            promise.addResult(work());
        } catch (const std::bad_alloc&) {
            // No result tells of it.
        }
    });
}

/// The same of work that has several results, each told as soon as it is there: where memory runs
/// out the future ends with those it has.
template <class Made, class Work>
QFuture<Made> runWithinMemory(Work work)
{
    return QtConcurrent::run([work = std::move(work)](QPromise<Made>& promise) {
        try {
            work(promise);
        } catch (const std::bad_alloc&) {
            // What is missing tells of it.
        }
    });
}

/// What came of it; nothing where there was no memory. \pre it has ended
template <class Made>
std::optional<Made> madeOf(const QFuture<Made>& future)
{
    return future.resultCount() > 0 ? std::optional(future.result()) : std::nullopt;
}

} // namespace trixel::ui
