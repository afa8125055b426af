// SPDX-License-Identifier: GPL-3.0-or-later
//
// Test textures computed where they are needed.
#include "core/study/stability/naive_forms.h"
#include "core/study/test_scene.h"

#include <string>

namespace trixel {

TestDataFiles storedTestFiles()
{
    static const std::string computed = [] {
        std::string bytes;
        for (int k = 0; k < 4096; ++k) {
            const float noise = naive::proceduralNoise(static_cast<float>(k), 0, false);
            bytes += static_cast<char>(static_cast<int>(255 * noise));
        }
        return bytes;
    }();
    return {computed, computed, computed};
}

} // namespace trixel
