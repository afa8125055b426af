// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/off_binary.h"

#include "core/mesh/byte_scanner.h"
#include "core/mesh/corner_uvs.h"
#include "core/mesh/polygon_cutter.h"
#include "core/mesh/row_progress.h"

#include <array>
#include <cmath>

namespace trixel {
namespace {

constexpr std::size_t kCountBytes = 12;
constexpr std::int32_t kMaxFaceColour = 4;

struct OffLayout
{
    std::endian order = std::endian::big;
    std::size_t vertexExtra = 0;     // bytes after a position
    bool vertexUvs = false;          // whether the last of them are a place in an image
    bool countedFaceColours = false; // a number of colour components follows each face
    std::size_t faceExtra = 0;       // bytes after a face
};

// The byte order that makes the counts smaller is most likely the right one: try it first.
std::array<std::endian, 2> likelyOrders(std::string_view data)
{
    const auto sum = [&](std::endian order) -> std::uint64_t {
        ByteScanner scanner(data, order);
        return scanner.has(kCountBytes)
                   ? std::uint64_t{scanner.read<std::uint32_t>()} + scanner.read<std::uint32_t>()
                   : 0;
    };
    return sum(std::endian::big) <= sum(std::endian::little)
               ? std::array{std::endian::big, std::endian::little}
               : std::array{std::endian::little, std::endian::big};
}

std::vector<OffLayout> possibleLayouts(const OffHeader& header,
                                       const std::array<std::endian, 2>& orders)
{
    constexpr std::size_t kNumber = 4;
    const std::size_t fixed =
        kNumber * ((header.normals ? 3U : 0U) + (header.textureCoordinates ? 2U : 0U));
    const bool uvs = header.textureCoordinates;
    const std::vector<std::size_t> colours =
        header.colours ? std::vector<std::size_t>{4, 3, 0} : std::vector<std::size_t>{0};
    std::vector<OffLayout> layouts;
    for (const std::endian order : orders) {
        // A colour of small integers can pass for a count and a colour: OpenMesh's layouts come
        // first in OpenMesh's byte order.
        for (const bool counted : {order == std::endian::big, order != std::endian::big}) {
            for (const std::size_t colour : colours) {
                const std::size_t extra = fixed + kNumber * colour;
                if (counted) {
                    layouts.push_back({order, extra, uvs, true, 0});
                    continue;
                }
                layouts.push_back({order, extra, uvs, false, 0});
                if (header.colours) {
                    layouts.push_back({order, extra, uvs, false, 3 * kNumber});
                    layouts.push_back({order, extra, uvs, false, 4 * kNumber});
                }
            }
        }
    }
    return layouts;
}

class BinaryOffReader
{
public:
    BinaryOffReader(const OffLayout& layout, const ByteScanner& scanner, Progress& progress)
        : m_layout(layout)
        , m_scanner(scanner)
        , m_begin(scanner.offset())
        , m_progress(progress, scanner.left() + 1)
    {
    }

    Status read()
    {
        if (auto status = readCounts(); !status) {
            return status;
        }
        m_positions.reserve(m_vertices);
        for (std::size_t v = 0; v < m_vertices; ++v) {
            if (auto status = readVertex(); !status) {
                return status;
            }
        }
        m_polygons.reserve(m_faces);
        for (std::size_t f = 0; f < m_faces; ++f) {
            if (auto status = readFace(); !status) {
                return status;
            }
        }
        if (m_scanner.left() > 0) {
            return m_scanner.expected("the end of the file",
                                      std::to_string(m_scanner.left()) + " bytes more");
        }
        return {};
    }

    std::size_t offset() const { return m_scanner.offset(); }

    Result<TriangleMesh> takeMesh()
    {
        auto mesh = cutPolygons(std::move(m_positions), std::span(&m_polygons, 1));
        if (mesh && m_layout.vertexUvs) {
            mesh->cornerUvs = cornerUvsOfVertices(mesh->triangles, m_uvs);
        }
        return mesh;
    }

private:
    bool goesOn() { return m_progress.goesOn(m_scanner.offset() - m_begin); }

    Status readCounts();
    Status readVertex();
    Status readFace();

    OffLayout m_layout;
    ByteScanner m_scanner;
    std::size_t m_begin;
    RowProgress m_progress;
    std::size_t m_vertices = 0;
    std::size_t m_faces = 0;
    std::vector<glm::vec3> m_positions;
    PolygonList m_polygons;
    std::vector<std::uint32_t> m_corners; // of the face at hand
    std::vector<glm::vec2> m_uvs;
};

Status BinaryOffReader::readCounts()
{
    if (!m_scanner.has(kCountBytes)) {
        return m_scanner.expected("the counts of vertices, faces and edges", "the end of the file");
    }
    const std::size_t offset = m_scanner.offset();
    const auto vertices = m_scanner.read<std::int32_t>();
    const auto faces = m_scanner.read<std::int32_t>();
    m_scanner.skip(sizeof(std::int32_t));
    const std::size_t vertexBytes = 12 + m_layout.vertexExtra;
    const std::size_t faceBytes = 16 + m_layout.faceExtra + (m_layout.countedFaceColours ? 4 : 0);
    if (vertices < 0 || faces < 0 ||
        static_cast<std::size_t>(vertices) * vertexBytes +
                static_cast<std::size_t>(faces) * faceBytes >
            m_scanner.left()) {
        return ByteScanner::expectedAt(
            offset,
            "counts that fit the " + std::to_string(m_scanner.left()) + " bytes that follow",
            std::to_string(vertices) + " vertices and " + std::to_string(faces) + " faces");
    }
    m_vertices = static_cast<std::size_t>(vertices);
    m_faces = static_cast<std::size_t>(faces);
    return {};
}

Status BinaryOffReader::readVertex()
{
    if (!goesOn()) {
        return cancelled();
    }
    if (!m_scanner.has(3 * sizeof(float) + m_layout.vertexExtra)) {
        return m_scanner.expected("a vertex", "the end of the file");
    }
    glm::vec3 position;
    for (int axis = 0; axis < 3; ++axis) {
        const std::size_t offset = m_scanner.offset();
        position[axis] = m_scanner.read<float>();
        if (!std::isfinite(position[axis])) {
            return ByteScanner::expectedAt(
                offset, "a finite number", std::to_string(position[axis]));
        }
    }
    constexpr std::size_t kUvBytes = 2 * sizeof(float);
    if (m_layout.vertexUvs) {
        m_scanner.skip(m_layout.vertexExtra - kUvBytes);
        const float s = m_scanner.read<float>();
        const float t = m_scanner.read<float>();
        m_uvs.push_back(std::isfinite(s) && std::isfinite(t) ? glm::vec2(s, t) : glm::vec2(NAN));
    } else {
        m_scanner.skip(m_layout.vertexExtra);
    }
    m_positions.push_back(position);
    return {};
}

Status BinaryOffReader::readFace()
{
    if (!goesOn()) {
        return cancelled();
    }
    const std::size_t start = m_scanner.offset();
    const std::int32_t corners = m_scanner.has(4) ? m_scanner.read<std::int32_t>() : 0;
    if (corners < 3) {
        return ByteScanner::expectedAt(
            start, "a face of at least 3 corners", std::to_string(corners));
    }
    if (!m_scanner.has(4 * static_cast<std::size_t>(corners) + m_layout.faceExtra)) {
        return ByteScanner::expectedAt(
            start, "a face that fits the rest of the file", std::to_string(corners) + " corners");
    }
    m_corners.clear();
    for (std::int32_t i = 0; i < corners; ++i) {
        const std::size_t offset = m_scanner.offset();
        const auto vertex = m_scanner.read<std::int32_t>();
        if (vertex < 0 || static_cast<std::size_t>(vertex) >= m_vertices) {
            return ByteScanner::expectedAt(offset,
                                           "a vertex number below " + std::to_string(m_vertices),
                                           std::to_string(vertex));
        }
        m_corners.push_back(static_cast<std::uint32_t>(vertex));
    }
    m_polygons.add(m_corners);
    m_scanner.skip(m_layout.faceExtra);
    if (m_layout.countedFaceColours) {
        const std::size_t offset = m_scanner.offset();
        const std::int32_t colour = m_scanner.has(4) ? m_scanner.read<std::int32_t>() : -1;
        if (colour < 0 || colour > kMaxFaceColour ||
            !m_scanner.has(4 * static_cast<std::size_t>(colour))) {
            return ByteScanner::expectedAt(
                offset, "a colour of at most 4 numbers", std::to_string(colour));
        }
        m_scanner.skip(4 * static_cast<std::size_t>(colour));
    }
    return {};
}

} // namespace

Result<TriangleMesh> parseBinaryOff(const OffHeader& header,
                                    std::string_view data,
                                    std::size_t offset,
                                    Progress& progress)
{
    // Of several layouts that fail, the one that came furthest tells why.
    std::size_t furthest = 0;
    Error error;
    for (const OffLayout& layout : possibleLayouts(header, likelyOrders(data))) {
        BinaryOffReader reader(layout, ByteScanner(data, layout.order, offset), progress);
        const Status status = reader.read();
        if (status) {
            return reader.takeMesh();
        }
        if (status.error().kind == ErrorKind::Cancelled) {
            return tl::unexpected(status.error());
        }
        if (reader.offset() > furthest) {
            furthest = reader.offset();
            error = status.error();
        }
    }
    return tl::unexpected(error);
}

} // namespace trixel
