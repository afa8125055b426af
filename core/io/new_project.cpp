// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/new_project.h"

#include "core/io/project_metadata.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace trixel {
namespace {

std::vector<std::byte> encoded(const TexelFormat& format, std::span<const float> values)
{
    std::vector<std::byte> texel(format.texelBytes());
    encode(format.type, values, texel);
    return texel;
}

TexelStore
constantFaces(const LevelPlan& plan, const TexelFormat& format, std::span<const std::byte> texel)
{
    // Faces of one level share one value.
    std::array<FaceTexels, Level::kMax + 1> faceOfLevel;
    for (int log2 = 0; log2 <= Level::kMax; ++log2) {
        faceOfLevel[static_cast<std::size_t>(log2)] = FaceTexels::constant(Level(log2), texel);
    }
    const std::span<const Level> levels = plan.levels.values();
    const Level first = levels.empty() ? Level() : levels.front();
    TexelStore store(static_cast<std::uint32_t>(levels.size()), format, first, texel);
    for (std::size_t i = 0; i < levels.size(); ++i) {
        if (levels[i] != first) {
            store.exchange(faceId(i), faceOfLevel[static_cast<std::size_t>(levels[i].log2())]);
        }
    }
    return store;
}

const std::vector<float>* recordedFill(const Project& project)
{
    for (const PtxMetadata& item : project.metadata) {
        if (item.key == kFillKey) {
            const auto* values = std::get_if<std::vector<float>>(&item.value);
            const bool fits = values && values->size() == project.texels.format().channels;
            return fits ? values : nullptr;
        }
    }
    return nullptr;
}

} // namespace

Result<Project> newProject(TriangleMesh mesh,
                           const LevelPlan& plan,
                           const TexelFormat& format,
                           std::span<const float> fill,
                           Progress& progress)
{
    check(plan.levels.size() == mesh.faceCount(), "the plan has a level for every face");
    check(fill.size() == format.channels, "the fill has a value for every channel");
    auto surface = Surface::build(std::move(mesh), progress);
    if (!surface) {
        return tl::unexpected(surface.error());
    }
    Project project;
    project.surface = std::move(*surface);
    project.texels = constantFaces(plan, format, encoded(format, fill));
    project.metadata.push_back({kFillKey, std::vector<float>(fill.begin(), fill.end())});
    return project;
}

std::uint64_t defaultTexelTotal(std::size_t faceCount)
{
    return std::max<std::uint64_t>(4'000'000, std::uint64_t{16} * faceCount);
}

std::vector<std::byte> fillOf(const Project& project)
{
    const TexelFormat& format = project.texels.format();
    if (const std::vector<float>* fill = recordedFill(project)) {
        return encoded(format, *fill);
    }
    const TexelStore& painted = project.layers.isPlain() ? project.texels : project.layers.base();
    for (std::uint32_t i = 0; i < painted.faceCount(); ++i) {
        const FaceTexels& face = painted.face(faceId(i));
        if (face.isConstant()) {
            return {face.bytes().begin(), face.bytes().end()};
        }
    }
    return encoded(format, std::vector<float>(format.channels, 1.0F));
}

} // namespace trixel
