// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tl/expected.hpp>

#include <string>
#include <utility>

namespace trixel {

/// Why an operation could not be done; decides the exit status of the command line.
enum class ErrorKind {
    Contents, ///< the input or an argument is unusable (exit status 2)
    Path,     ///< a path cannot be read or written (exit status 3)
    Cancelled ///< the user stopped the work; nothing to report
};

/// An expected failure: one sentence that names the place and the cause.
struct Error
{
    ErrorKind kind = ErrorKind::Contents;
    std::string message;

    bool operator==(const Error&) const = default;
};

template <class T>
using Result = tl::expected<T, Error>;

/// Outcome of an operation that returns nothing but may fail.
using Status = Result<void>;

[[nodiscard]] inline tl::unexpected<Error> contentsError(std::string message)
{
    return tl::unexpected(Error{ErrorKind::Contents, std::move(message)});
}

[[nodiscard]] inline tl::unexpected<Error> pathError(std::string message)
{
    return tl::unexpected(Error{ErrorKind::Path, std::move(message)});
}

[[nodiscard]] inline tl::unexpected<Error> cancelled()
{
    return tl::unexpected(Error{ErrorKind::Cancelled, "Cancelled."});
}

/// The same error with "<prefix>: " before its message; used to add a file name.
[[nodiscard]] inline tl::unexpected<Error> prefixed(const std::string& prefix, const Error& error)
{
    return tl::unexpected(Error{error.kind, prefix + ": " + error.message});
}

} // namespace trixel
