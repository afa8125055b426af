// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/byte_scanner.h"
#include "core/mesh/readers.h"
#include "core/mesh/row_progress.h"
#include "core/mesh/text_scanner.h"
#include "core/mesh/vertex_welder.h"

#include <algorithm>
#include <cmath>

namespace trixel {
namespace {

constexpr std::size_t kHeaderBytes = 84;
constexpr std::size_t kFacetBytes = 50;
constexpr std::size_t kMaxFaces = (std::size_t{1} << 30U) - 1;

bool isWord(std::string_view word, std::string_view lowerCase)
{
    return std::equal(
        word.begin(), word.end(), lowerCase.begin(), lowerCase.end(), [](char a, char b) {
            return (a >= 'A' && a <= 'Z' ? static_cast<char>(a - 'A' + 'a') : a) == b;
        });
}

class AsciiStlReader
{
public:
    AsciiStlReader(std::string_view text, Progress& progress)
        : m_scanner(text)
        , m_progress(progress, text.size())
        , m_size(text.size())
    {
    }

    Result<TriangleMesh> read()
    {
        while (m_scanner.skipEmptyLines()) {
            if (auto status = readSolid(); !status) {
                return tl::unexpected(status.error());
            }
        }
        if (m_mesh.triangles.empty()) {
            return contentsError("expected at least one facet, found none");
        }
        m_mesh.positions = m_welder.takePositions();
        return std::move(m_mesh);
    }

private:
    // The next word of the text, on whatever line, must be this one.
    Status expectWord(std::string_view lowerCase)
    {
        m_scanner.skipEmptyLines();
        const TextScanner start = m_scanner;
        if (!isWord(m_scanner.word(), lowerCase)) {
            return TextScanner(start).expected(quoted(lowerCase));
        }
        return {};
    }

    Status expectWords(std::initializer_list<std::string_view> words)
    {
        for (const std::string_view word : words) {
            if (auto status = expectWord(word); !status) {
                return status;
            }
        }
        return {};
    }

    // From "solid" to "endsolid", names and all.
    Status readSolid()
    {
        if (auto status = expectWord("solid"); !status) {
            return status;
        }
        m_scanner.skipLine();
        for (;;) {
            m_scanner.skipEmptyLines();
            const TextScanner start = m_scanner;
            const std::string_view word = m_scanner.word();
            if (isWord(word, "endsolid")) {
                m_scanner.skipLine();
                return {};
            }
            if (!isWord(word, "facet")) {
                return TextScanner(start).expected("'facet' or 'endsolid'");
            }
            if (auto status = readFacet(); !status) {
                return status;
            }
        }
    }

    Status readFacet();
    Result<std::uint32_t> readVertex();

    TextScanner m_scanner;
    RowProgress m_progress;
    std::size_t m_size;
    VertexWelder m_welder;
    TriangleMesh m_mesh;
};

Result<std::uint32_t> AsciiStlReader::readVertex()
{
    if (auto status = expectWord("vertex"); !status) {
        return tl::unexpected(status.error());
    }
    const Result<glm::vec3> position = m_scanner.point();
    if (!position) {
        return tl::unexpected(position.error());
    }
    return m_welder.add(*position);
}

Status AsciiStlReader::readFacet()
{
    if (auto status = expectWord("normal"); !status) {
        return status;
    }
    // Writers put anything here for faces without area ("nan", "-nan(ind)"): it is not needed.
    for (int axis = 0; axis < 3; ++axis) {
        if (m_scanner.atLineEnd()) {
            return m_scanner.expected("the three numbers of a normal");
        }
        m_scanner.word();
    }
    if (auto status = expectWords({"outer", "loop"}); !status) {
        return status;
    }
    Triangle triangle{};
    for (std::uint32_t& corner : triangle) {
        const auto vertex = readVertex();
        if (!vertex) {
            return tl::unexpected(vertex.error());
        }
        corner = *vertex;
    }
    m_mesh.triangles.push_back(triangle);
    if (m_mesh.triangles.size() > kMaxFaces) {
        return contentsError("expected fewer than 2^30 facets");
    }
    if (!m_progress.goesOn(m_size - m_scanner.rest().size())) {
        return cancelled();
    }
    return expectWords({"endloop", "endfacet"});
}

Result<TriangleMesh> parseBinaryStl(std::string_view bytes, Progress& progress)
{
    const std::size_t facets = (bytes.size() - kHeaderBytes) / kFacetBytes;
    if (facets == 0) {
        return contentsError("expected at least one facet, found none");
    }
    if (facets > kMaxFaces) {
        return contentsError("expected fewer than 2^30 facets, found " + std::to_string(facets));
    }
    ByteScanner scanner(bytes, std::endian::little);
    scanner.skip(kHeaderBytes);
    RowProgress rows(progress, facets);
    VertexWelder welder;
    TriangleMesh mesh;
    mesh.triangles.resize(facets);
    for (std::size_t f = 0; f < facets; ++f) {
        if (!rows.goesOn(f)) {
            return cancelled();
        }
        scanner.skip(3 * sizeof(float)); // the normal
        for (std::uint32_t& corner : mesh.triangles[f]) {
            glm::vec3 position;
            for (int axis = 0; axis < 3; ++axis) {
                position[axis] = scanner.read<float>();
                if (!std::isfinite(position[axis])) {
                    return ByteScanner::expectedAt(scanner.offset() - sizeof(float),
                                                   "a finite number",
                                                   std::to_string(position[axis]));
                }
            }
            corner = welder.add(position);
        }
        scanner.skip(sizeof(std::uint16_t)); // attributes, in some files a colour
    }
    mesh.positions = welder.takePositions();
    return mesh;
}

// Why data that do not begin with "solid", or have zeros where a text has none, are not a binary
// file either.
tl::unexpected<Error> brokenBinaryStl(std::string_view bytes)
{
    if (bytes.size() < kHeaderBytes) {
        return ByteScanner::expectedAt(bytes.size(),
                                       "the word 'solid' at the start or a header of 84 bytes",
                                       "the end of the file");
    }
    ByteScanner scanner(bytes, std::endian::little);
    scanner.skip(kHeaderBytes - sizeof(std::uint32_t));
    const auto count = std::to_string(scanner.read<std::uint32_t>());
    return ByteScanner::expectedAt(kHeaderBytes - sizeof(std::uint32_t),
                                   "a number of facets that matches the file's " +
                                       std::to_string(bytes.size()) + " bytes (84 and 50 a facet)",
                                   count);
}

bool isBinaryStl(std::string_view bytes)
{
    if (bytes.size() < kHeaderBytes) {
        return false;
    }
    ByteScanner scanner(bytes, std::endian::little);
    scanner.skip(kHeaderBytes - sizeof(std::uint32_t));
    return bytes.size() == kHeaderBytes + kFacetBytes * std::size_t{scanner.read<std::uint32_t>()};
}

} // namespace

Result<TriangleMesh> parseStl(std::string_view bytes, Progress& progress)
{
    // By size first: many binary files have "solid" in their header.
    if (isBinaryStl(bytes)) {
        return parseBinaryStl(bytes, progress);
    }
    const std::string_view text = withoutByteOrderMark(bytes);
    TextScanner scanner(text);
    scanner.skipEmptyLines();
    const bool hasZeros = text.substr(0, kHeaderBytes).find('\0') != std::string_view::npos;
    if (hasZeros || !isWord(scanner.word(), "solid")) {
        return brokenBinaryStl(bytes);
    }
    return AsciiStlReader(text, progress).read();
}

} // namespace trixel
