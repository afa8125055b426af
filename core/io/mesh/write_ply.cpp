// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/commit_file.h"
#include "core/io/mesh/uv_mesh.h"

#include <algorithm>
#include <bit>

namespace trixel {

namespace {

static_assert(std::endian::native == std::endian::little, "numbers are written as they lie");

template <class T>
void put(std::vector<std::byte>& bytes, const T& value)
{
    const auto* first = reinterpret_cast<const std::byte*>(&value);
    bytes.insert(bytes.end(), first, first + sizeof(T));
}

std::string headerOf(const UvMesh& uvMesh)
{
    const std::size_t faces = uvMesh.mesh.faceCount();
    return "ply\nformat binary_little_endian 1.0\ncomment TextureFile " + uvMesh.textures.front() +
           "\nelement vertex " + std::to_string(3 * faces) +
           "\nproperty float x\nproperty float y\nproperty float z\n"
           "property float s\nproperty float t\nelement face " +
           std::to_string(faces) + "\nproperty list uchar uint vertex_indices\nend_header\n";
}

} // namespace

Status writePly(const std::filesystem::path& path, const UvMesh& uvMesh, Progress& progress)
{
    check(uvMesh.textures.size() == 1, "one texture");
    check(uvMesh.uvs.size() == uvMesh.mesh.faceCount(), "uvs of every face");
    constexpr std::size_t kFacesAtOnce = 65536;
    const std::size_t faces = uvMesh.mesh.faceCount();
    std::vector<std::byte> bytes;
    /// Both halves of the file go face by face.
    const auto writeFaces = [&](FileWriter& file, double begin, const auto& putFace) -> Status {
        for (std::size_t first = 0; first < faces; first += kFacesAtOnce) {
            if (!progress.report(begin +
                                 0.5 * static_cast<double>(first) / static_cast<double>(faces))) {
                return cancelled();
            }
            bytes.clear();
            for (std::size_t f = first; f < std::min(first + kFacesAtOnce, faces); ++f) {
                putFace(f);
            }
            if (Status written = file.write(bytes); !written) {
                return written;
            }
        }
        return {};
    };
    const auto write = [&](FileWriter& file) -> Status {
        if (Status written = file.write(std::string_view(headerOf(uvMesh))); !written) {
            return written;
        }
        const Status vertices = writeFaces(file, 0, [&](std::size_t f) {
            const auto corners = uvMesh.mesh.corners(faceId(f));
            for (std::size_t k = 0; k < 3; ++k) {
                put(bytes, corners[k]);
                put(bytes, uvMesh.uvs[faceId(f)].corners[k]);
            }
        });
        if (!vertices) {
            return vertices;
        }
        return writeFaces(file, 0.5, [&](std::size_t f) {
            bytes.push_back(std::byte{3});
            for (std::uint32_t k = 0; k < 3; ++k) {
                put(bytes, static_cast<std::uint32_t>(3 * f) + k);
            }
        });
    };
    return commitFile(path, write, [](const std::filesystem::path&) { return Status(); });
}

} // namespace trixel
