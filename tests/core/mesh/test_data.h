// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/read_file.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace trixel::test {

inline std::filesystem::path dataPath(const std::string& name)
{
    return std::filesystem::path(TRIXEL_TEST_DATA) / name;
}

/// Files of a folder of tests/data in the order of their names.
inline std::vector<std::filesystem::path> filesIn(const std::string& folder)
{
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(dataPath(folder))) {
        files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

/// The four bytes of a 32-bit number in either byte order, for binary files made by tests.
template <class T>
std::string littleEndian(T value)
{
    static_assert(sizeof(T) <= 8);
    return {reinterpret_cast<const char*>(&value), sizeof(T)};
}

template <class T>
std::string bigEndian(T value)
{
    std::string bytes = littleEndian(value);
    std::reverse(bytes.begin(), bytes.end());
    return bytes;
}

} // namespace trixel::test
