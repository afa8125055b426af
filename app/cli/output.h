// SPDX-License-Identifier: GPL-3.0-or-later
//
// How results look on standard output.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace trixel::app {

/// One JSON object and a line break; bytes that are not UTF-8 (in file names) are replaced.
void printJson(const nlohmann::json& object);

/// 1234567 as "1,234,567".
std::string grouped(std::uint64_t number);

/// A size people can read: "512 bytes", "3.4 MB" (powers of ten).
std::string byteSizeText(std::uint64_t bytes);

/// "1 face", "2 faces": the number and its word, with an s where there is not just one.
std::string counted(std::uint64_t number, const std::string& word);

} // namespace trixel::app
