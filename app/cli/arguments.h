// SPDX-License-Identifier: GPL-3.0-or-later
//
// Values of command line options, read strictly: the whole text must be the value. Errors name the
// option, what it takes and what was found.
#pragma once

#include "core/base/level.h"
#include "core/base/parallel.h"
#include "core/base/result.h"
#include "core/texture/texel_format.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trixel::app {

/// A whole number in [low, high].
Result<std::int64_t>
wholeNumber(std::string_view option, std::string_view text, std::int64_t low, std::int64_t high);

/// A finite number above 0.
Result<double> positiveNumber(std::string_view option, std::string_view text);

/// Finite numbers separated by commas, as many as there are channels; one stands for all.
Result<std::vector<float>>
channelValues(std::string_view option, std::string_view text, int channels);

Result<Level> level(std::string_view option, std::string_view text);

/// How many threads to use, all cores by default.
Result<Threads> threads(std::string_view option, const std::optional<std::string>& text);

/// uint8, uint16, half or float.
Result<TexelType> texelType(std::string_view option, std::string_view text);

} // namespace trixel::app
