// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/corner_uvs.h"
#include "core/mesh/off_binary.h"
#include "core/mesh/off_header.h"
#include "core/mesh/polygon_cutter.h"
#include "core/mesh/readers.h"
#include "core/mesh/row_progress.h"
#include "core/mesh/text_scanner.h"

#include <array>
#include <cmath>

namespace trixel {
namespace {

constexpr std::size_t kLeastVertexBytes = 6; // "0 0 0\n"
constexpr std::size_t kLeastFaceBytes = 8;   // "3 0 1 2\n"
constexpr std::size_t kMaxVertices = std::size_t{1} << 31U;

class AsciiOffReader
{
public:
    AsciiOffReader(const OffHeader& header, const TextScanner& scanner, Progress& progress)
        : m_header(header)
        , m_scanner(scanner)
        , m_size(scanner.rest().size())
        , m_progress(progress, m_size)
        , m_last{scanner, scanner}
    {
    }

    Result<TriangleMesh> read()
    {
        if (auto status = readAll(); !status) {
            return tl::unexpected(status.error());
        }
        auto mesh = cutPolygons(std::move(m_positions), std::span(&m_polygons, 1));
        if (mesh && m_header.textureCoordinates) {
            mesh->cornerUvs = cornerUvsOfVertices(mesh->triangles, m_uvs);
        }
        return mesh;
    }

private:
    Status readAll()
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
        if (m_scanner.skipEmptyLines()) {
            return m_scanner.expected("the end of the file");
        }
        return {};
    }

    bool goesOn() { return m_progress.goesOn(m_size - m_scanner.rest().size()); }

    Status readCounts();
    Result<std::size_t> readCount(const std::string& what, std::size_t leastBytes);
    Status readVertex();
    Status readFace();
    Result<int> skipNumbers(int most);
    glm::vec2 lastTwo() const;

    OffHeader m_header;
    TextScanner m_scanner;
    std::size_t m_size;
    RowProgress m_progress;
    std::size_t m_vertices = 0;
    std::size_t m_faces = 0;
    std::vector<glm::vec3> m_positions;
    PolygonList m_polygons;
    std::vector<std::uint32_t> m_corners; // of the face at hand
    std::array<TextScanner, 2> m_last;    // before the last two numbers skipped
    std::vector<glm::vec2> m_uvs;
};

Result<std::size_t> AsciiOffReader::readCount(const std::string& what, std::size_t leastBytes)
{
    TextScanner start = m_scanner;
    const auto count = m_scanner.integer();
    if (!count || *count < 0) {
        return start.expected("the number of " + what);
    }
    const std::size_t most = std::min(m_size / leastBytes + 1, kMaxVertices - 1);
    if (static_cast<std::size_t>(*count) > most) {
        return m_scanner.expected("at most " + std::to_string(most) + " " + what +
                                      " in the bytes that follow",
                                  std::to_string(*count));
    }
    return static_cast<std::size_t>(*count);
}

Status AsciiOffReader::readCounts()
{
    m_scanner.skipEmptyLines();
    const auto vertices = readCount("vertices", kLeastVertexBytes);
    if (!vertices) {
        return tl::unexpected(vertices.error());
    }
    const auto faces = readCount("faces", kLeastFaceBytes);
    if (!faces) {
        return tl::unexpected(faces.error());
    }
    m_vertices = *vertices;
    m_faces = *faces;
    m_scanner.integer(); // the number of edges means nothing and is missing in some files
    if (!m_scanner.atLineEnd()) {
        return m_scanner.expected("the end of the line after the counts");
    }
    m_scanner.skipLine();
    return {};
}

// Numbers to the end of the line; how many.
Result<int> AsciiOffReader::skipNumbers(int most)
{
    int numbers = 0;
    for (; !m_scanner.atLineEnd(); ++numbers) {
        if (numbers == most) {
            return m_scanner.expected("the end of the line");
        }
        m_last = {m_last[1], m_scanner};
        if (!m_scanner.skipNumber()) {
            return m_scanner.expected("a number");
        }
    }
    return numbers;
}

// Of the numbers skipped; none where one of them is not finite.
glm::vec2 AsciiOffReader::lastTwo() const
{
    TextScanner first = m_last[0];
    TextScanner second = m_last[1];
    const auto s = first.finiteFloat();
    const auto t = second.finiteFloat();
    return s && t ? glm::vec2(*s, *t) : glm::vec2(NAN);
}

Status AsciiOffReader::readVertex()
{
    if (!goesOn()) {
        return cancelled();
    }
    m_scanner.skipEmptyLines();
    const Result<glm::vec3> position = m_scanner.point();
    if (!position) {
        return tl::unexpected(position.error());
    }
    const int least = (m_header.normals ? 3 : 0) + (m_header.textureCoordinates ? 2 : 0);
    const auto extra = skipNumbers(least + (m_header.colours ? 4 : 0));
    if (!extra) {
        return tl::unexpected(extra.error());
    }
    // A colour has three or four numbers; COFF files that colour only their faces have none.
    if (const int colour = *extra - least; colour < 0 || colour == 1 || colour == 2) {
        return m_scanner.expected("more numbers for a vertex of this kind of OFF");
    }
    m_positions.push_back(*position);
    if (m_header.textureCoordinates) {
        m_uvs.push_back(lastTwo()); // they come last
    }
    m_scanner.skipLine();
    return {};
}

Status AsciiOffReader::readFace()
{
    if (!goesOn()) {
        return cancelled();
    }
    m_scanner.skipEmptyLines();
    TextScanner start = m_scanner;
    const auto corners = m_scanner.integer();
    if (!corners || *corners < 3) {
        return start.expected("a face of at least 3 corners");
    }
    if (static_cast<std::size_t>(*corners) > m_scanner.rest().size() / 2 + 1) {
        return start.expected("a number of corners that fits the rest of the file");
    }
    m_corners.clear();
    for (std::int64_t i = 0; i < *corners; ++i) {
        TextScanner corner = m_scanner;
        const auto vertex = m_scanner.integer();
        if (!vertex || *vertex < 0 || static_cast<std::size_t>(*vertex) >= m_vertices) {
            return corner.expected("a vertex number below " + std::to_string(m_vertices));
        }
        m_corners.push_back(static_cast<std::uint32_t>(*vertex));
    }
    m_polygons.add(m_corners);
    const auto colour = skipNumbers(4);
    if (!colour) {
        return tl::unexpected(colour.error());
    }
    if (*colour == 2) { // a map's index, or three or four numbers
        return m_scanner.expected("one more number for the colour");
    }
    m_scanner.skipLine();
    return {};
}

} // namespace

Result<TriangleMesh> parseOff(std::string_view bytes, Progress& progress)
{
    TextScanner scanner(withoutByteOrderMark(bytes));
    const auto header = parseOffHeader(scanner);
    if (!header) {
        return tl::unexpected(header.error());
    }
    if (header->binary) {
        const std::string_view data = scanner.rest();
        return parseBinaryOff(*header, data, bytes.size() - data.size(), progress);
    }
    return AsciiOffReader(*header, scanner, progress).read();
}

} // namespace trixel
