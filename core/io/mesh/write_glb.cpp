// SPDX-License-Identifier: GPL-3.0-or-later
//
// glTF 2.0, section 4.4 (GLB): a header, one chunk of JSON, one of bytes.
#include "core/base/json_fields.h"
#include "core/io/commit_file.h"
#include "core/io/mesh/uv_mesh.h"
#include "core/mesh/corner_normals.h"

#include <algorithm>
#include <bit>
#include <glm/common.hpp>
#include <limits>

namespace trixel {

namespace {

static_assert(std::endian::native == std::endian::little, "numbers are written as they lie");

constexpr std::uint32_t kMagic = 0x46546C67; // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;
constexpr std::uint32_t kBytesChunk = 0x004E4942;
constexpr int kArrayBuffer = 34962;
constexpr int kFloat = 5126;
constexpr int kLinear = 9729;
constexpr int kClampToEdge = 33071;

/// What a primitive draws: the faces of one texture.
struct Part
{
    std::size_t texture = 0;
    std::vector<FaceId> faces;
};

std::vector<Part> partsOf(const UvMesh& uvMesh)
{
    std::vector<Part> parts(uvMesh.textures.size());
    for (std::size_t f = 0; f < uvMesh.mesh.faceCount(); ++f) {
        Part& part = parts[uvMesh.uvs[faceId(f)].texture];
        part.faces.push_back(faceId(f));
    }
    for (std::size_t k = 0; k < parts.size(); ++k) {
        parts[k].texture = k;
    }
    std::erase_if(parts, [](const Part& part) { return part.faces.empty(); });
    return parts;
}

/// The chunk of bytes and its views, in parallel.
class Views
{
public:
    /// Begins a view at the next multiple of four; the number of it.
    std::size_t begin()
    {
        m_size = (m_size + 3) / 4 * 4;
        m_views.push_back({{"buffer", 0}, {"byteOffset", m_size}});
        return m_views.size() - 1;
    }
    /// \param target  what a graphics card takes it for, or 0
    void end(std::uint64_t bytes, int target)
    {
        m_size += bytes;
        m_views.back()["byteLength"] = bytes;
        if (target != 0) {
            m_views.back()["target"] = target;
        }
    }
    std::uint64_t size() const { return (m_size + 3) / 4 * 4; }
    const Json& views() const { return m_views; }

private:
    std::uint64_t m_size = 0;
    Json m_views = Json::array();
};

class Glb
{
public:
    Glb(const UvMesh& uvMesh, std::span<const std::vector<std::byte>> pngs)
        : m_uvMesh(uvMesh)
        , m_pngs(pngs)
        , m_parts(partsOf(uvMesh))
        , m_normals(cornerNormals(uvMesh.mesh))
    {
        describe();
        // Names of files need not be UTF-8.
        m_text = m_json.dump(-1, ' ', false, Json::error_handler_t::replace);
        m_text.resize((m_text.size() + 3) / 4 * 4, ' ');
    }

    std::uint64_t size() const { return 12 + 8 + m_text.size() + 8 + m_views.size(); }

    Status write(FileWriter& file, Progress& progress)
    {
        putNumber(kMagic);
        putNumber(2);
        putNumber(static_cast<std::uint32_t>(size()));
        putNumber(static_cast<std::uint32_t>(m_text.size()));
        putNumber(kJsonChunk);
        put(std::as_bytes(std::span(m_text)));
        putNumber(static_cast<std::uint32_t>(m_views.size()));
        putNumber(kBytesChunk);
        m_begin = m_written + m_bytes.size();
        for (const Part& part : m_parts) {
            putVertices(file, progress, part, [&](FaceId face, std::size_t k) {
                const glm::vec3 at = m_uvMesh.mesh.corners(face)[k];
                put(std::as_bytes(std::span(&at, 1)));
            });
            putVertices(file, progress, part, [&](FaceId face, std::size_t k) {
                put(std::as_bytes(std::span(&m_normals[3 * indexOf(face) + k], 1)));
            });
            putVertices(file, progress, part, [&](FaceId face, std::size_t k) {
                // (0,0) is the upper left corner here.
                glm::vec2 uv = m_uvMesh.uvs[face].corners[k];
                uv.y = 1 - uv.y;
                put(std::as_bytes(std::span(&uv, 1)));
            });
        }
        for (const std::vector<std::byte>& png : m_pngs) {
            align();
            put(png);
            flush(file);
        }
        align();
        flush(file);
        return m_status;
    }

private:
    void describe()
    {
        Json primitives = Json::array();
        for (const Part& part : m_parts) {
            primitives.push_back(describePart(part));
        }
        Json images = Json::array();
        Json textures = Json::array();
        Json materials = Json::array();
        for (std::size_t k = 0; k < m_pngs.size(); ++k) {
            const std::size_t view = m_views.begin();
            m_views.end(m_pngs[k].size(), 0);
            images.push_back(
                {{"bufferView", view}, {"mimeType", "image/png"}, {"name", m_uvMesh.textures[k]}});
            textures.push_back({{"sampler", 0}, {"source", k}});
            // Opaque is what a program must take for granted that is told nothing.
            materials.push_back({{"name", m_uvMesh.textures[k]},
                                 {"alphaMode", m_uvMesh.hasOpacity ? "BLEND" : "OPAQUE"},
                                 {"doubleSided", true},
                                 {"pbrMetallicRoughness",
                                  {{"baseColorTexture", {{"index", k}}},
                                   {"metallicFactor", 0.0},
                                   {"roughnessFactor", 1.0}}}});
        }
        m_json = {{"asset", {{"version", "2.0"}, {"generator", "Trixel"}}},
                  {"scene", 0},
                  {"scenes", {{{"nodes", {0}}}}},
                  {"nodes", {{{"mesh", 0}}}},
                  {"meshes", {{{"primitives", primitives}}}},
                  {"accessors", m_accessors},
                  {"bufferViews", m_views.views()},
                  {"buffers", {{{"byteLength", m_views.size()}}}},
                  {"materials", materials},
                  {"textures", textures},
                  {"images", images},
                  {"samplers",
                   {{{"magFilter", kLinear},
                     {"minFilter", kLinear},
                     {"wrapS", kClampToEdge},
                     {"wrapT", kClampToEdge}}}}};
    }

    Json describePart(const Part& part)
    {
        glm::vec3 low(std::numeric_limits<float>::max());
        glm::vec3 high(-low);
        for (const FaceId face : part.faces) {
            for (const glm::vec3& p : m_uvMesh.mesh.corners(face)) {
                low = glm::min(low, p);
                high = glm::max(high, p);
            }
        }
        const std::size_t count = 3 * part.faces.size();
        const std::size_t positions = describeVertices(count, 3);
        m_accessors.back()["min"] = {low.x, low.y, low.z};
        m_accessors.back()["max"] = {high.x, high.y, high.z};
        const std::size_t normals = describeVertices(count, 3);
        const std::size_t uvs = describeVertices(count, 2);
        return {{"attributes", {{"POSITION", positions}, {"NORMAL", normals}, {"TEXCOORD_0", uvs}}},
                {"material", part.texture}};
    }

    std::size_t describeVertices(std::size_t count, std::size_t numbers)
    {
        const std::size_t view = m_views.begin();
        m_views.end(std::uint64_t{count} * numbers * sizeof(float), kArrayBuffer);
        m_accessors.push_back({{"bufferView", view},
                               {"componentType", kFloat},
                               {"count", count},
                               {"type", numbers == 3 ? "VEC3" : "VEC2"}});
        return m_accessors.size() - 1;
    }

    template <class PutCorner>
    void
    putVertices(FileWriter& file, Progress& progress, const Part& part, const PutCorner& putCorner)
    {
        constexpr std::size_t kFacesAtOnce = 65536;
        align();
        for (std::size_t k = 0; k < part.faces.size(); ++k) {
            for (std::size_t corner = 0; corner < 3; ++corner) {
                putCorner(part.faces[k], corner);
            }
            if (k % kFacesAtOnce == kFacesAtOnce - 1) {
                flush(file);
            }
        }
        flush(file);
        if (m_status &&
            !progress.report(static_cast<double>(m_written) / static_cast<double>(size()))) {
            m_status = cancelled();
        }
    }

    void put(std::span<const std::byte> bytes)
    {
        m_bytes.insert(m_bytes.end(), bytes.begin(), bytes.end());
    }
    void putNumber(std::uint32_t number) { put(std::as_bytes(std::span(&number, 1))); }
    void align()
    {
        const std::uint64_t at = m_written + m_bytes.size() - m_begin;
        m_bytes.resize(m_bytes.size() + (4 - at % 4) % 4);
    }
    void flush(FileWriter& file)
    {
        if (m_status) {
            m_status = file.write(m_bytes);
        }
        m_written += m_bytes.size();
        m_bytes.clear();
    }

    const UvMesh& m_uvMesh;
    std::span<const std::vector<std::byte>> m_pngs;
    std::vector<Part> m_parts;
    std::vector<glm::vec3> m_normals;
    Views m_views;
    Json m_accessors = Json::array();
    Json m_json;
    std::string m_text;

    std::vector<std::byte> m_bytes; ///< not written yet
    std::uint64_t m_written = 0;
    std::uint64_t m_begin = 0; ///< of the chunk of bytes in the file
    Status m_status;
};

} // namespace

Status writeGlb(const std::filesystem::path& path,
                const UvMesh& uvMesh,
                std::span<const std::vector<std::byte>> pngs,
                Progress& progress)
{
    check(uvMesh.uvs.size() == uvMesh.mesh.faceCount(), "uvs of every face");
    check(pngs.size() == uvMesh.textures.size(), "a PNG for each texture");
    Glb glb(uvMesh, pngs);
    if (glb.size() > std::numeric_limits<std::uint32_t>::max()) {
        return contentsError(path.string() + ": it would take " + std::to_string(glb.size()) +
                             " bytes, more than the 4 GiB that a .glb can hold");
    }
    return commitFile(
        path,
        [&](FileWriter& file) { return glb.write(file, progress); },
        [](const std::filesystem::path&) { return Status(); });
}

} // namespace trixel
