// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/io/image/read_image.h"
#include "core/io/image/write_image.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <unistd.h>

namespace trixel {

/// A folder of its own for every test, and the worker that the build made.
class ImageFiles : public testing::Test
{
protected:
    ImageFiles()
        : worker(TRIXEL_IMAGE_WORKER)
    {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        folder = std::filesystem::temp_directory_path() /
                 ("trixel-images-" + std::to_string(::getpid()) + "-" + test->name());
        std::filesystem::create_directories(folder);
    }
    ~ImageFiles() override { std::filesystem::remove_all(folder); }

    std::filesystem::path at(const std::string& name) const { return folder / name; }

    std::filesystem::path put(const std::string& name, std::string_view bytes) const
    {
        std::ofstream(at(name), std::ios::binary) << bytes;
        return at(name);
    }
    static std::string bytesOf(const std::filesystem::path& path)
    {
        std::ifstream file(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }
    std::size_t fileCount() const
    {
        return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder),
                                                      std::filesystem::directory_iterator()));
    }

    Result<Image> read(const std::filesystem::path& path, const ImageLimits& limits = {}) const
    {
        NoProgress progress;
        return readImage(worker, path, progress, limits);
    }
    Status write(const std::filesystem::path& path,
                 std::span<const Image> levels,
                 const ImageWriteOptions& options = {}) const
    {
        NoProgress progress;
        return writeImage(worker, path, levels, options, progress);
    }

    ImageWorker worker;
    std::filesystem::path folder;
};

/// Waves of other lengths in each channel, opacity between a half and one.
inline Image wavyImage(int width,
                       int height,
                       TexelType type,
                       std::uint16_t channels,
                       ColorSpace space = ColorSpace::SRgb)
{
    TexelFormat format{type, channels, std::nullopt};
    if (channels == 2 || channels == 4) {
        format.alpha = static_cast<std::uint16_t>(channels - 1);
    }
    Image image(width, height, format, uniformColors(space, channels, format.alpha));
    std::vector<float> values;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            for (int c = 0; c < channels; ++c) {
                const double wave = std::sin(0.2 * (c + 1) * x + 0.13 * y + c);
                const bool isOpacity = format.alpha == c;
                values.push_back(
                    static_cast<float>(isOpacity ? 0.75 + 0.25 * wave : 0.5 + 0.45 * wave));
            }
        }
    }
    encode(type, values, image.writable());
    return image;
}

} // namespace trixel
