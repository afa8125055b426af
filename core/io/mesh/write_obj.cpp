// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/commit_file.h"
#include "core/io/mesh/text_lines.h"
#include "core/io/mesh/uv_mesh.h"

namespace trixel {

namespace {

std::string materialName(std::size_t texture)
{
    return "texture" + std::to_string(texture);
}

Status writeMaterials(const std::filesystem::path& path, const UvMesh& uvMesh)
{
    return commitFile(
        path,
        [&](FileWriter& file) {
            TextLines lines(file);
            for (std::size_t k = 0; k < uvMesh.textures.size(); ++k) {
                // White and not shiny: the texture is all there is to see.
                lines.add("newmtl ", materialName(k), "\nKd 1 1 1\nKs 0 0 0\nillum 1\nmap_Kd ");
                lines.add(uvMesh.textures[k], "\n");
                if (uvMesh.hasOpacity) {
                    lines.add("map_d -imfchan m ", uvMesh.textures[k], "\n");
                }
            }
            return lines.finish();
        },
        [](const std::filesystem::path&) { return Status(); });
}

} // namespace

Status writeObj(const std::filesystem::path& path,
                const std::filesystem::path& materials,
                const UvMesh& uvMesh,
                Progress& progress)
{
    check(uvMesh.uvs.size() == uvMesh.mesh.faceCount(), "uvs of every face");
    if (Status written = writeMaterials(materials, uvMesh); !written) {
        return written;
    }
    const TriangleMesh& mesh = uvMesh.mesh;
    const std::size_t steps = mesh.positions.size() + 2 * mesh.faceCount();
    const auto write = [&](FileWriter& file) -> Status {
        TextLines lines(file, steps, progress);
        lines.add("mtllib ", materials.filename().string(), "\n");
        for (const glm::vec3& p : mesh.positions) {
            lines.add("v ", p.x, " ", p.y, " ", p.z, "\n");
            lines.step();
        }
        for (const FaceUvs& uvs : uvMesh.uvs.values()) {
            for (const glm::vec2& uv : uvs.corners) {
                lines.add("vt ", uv.x, " ", uv.y, "\n");
            }
            lines.step();
        }
        lines.add("s 1\n"); // round, as Trixel shows it
        std::size_t current = uvMesh.textures.size();
        for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
            if (const std::size_t texture = uvMesh.uvs[faceId(f)].texture; texture != current) {
                current = texture;
                lines.add("usemtl ", materialName(current), "\n");
            }
            lines.add("f");
            for (std::size_t k = 0; k < 3; ++k) {
                lines.add(" ", mesh.triangles[f][k] + 1U, "/", 3 * f + k + 1);
            }
            lines.add("\n");
            lines.step();
        }
        return lines.finish();
    };
    return commitFile(path, write, [](const std::filesystem::path&) { return Status(); });
}

} // namespace trixel
