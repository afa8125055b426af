// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/check.h"
#include "core/base/parallel.h"
#include "core/mesh/corner_uvs.h"
#include "core/mesh/obj_statement.h"
#include "core/mesh/obj_tags.h"
#include "core/mesh/polygon_cutter.h"
#include "core/mesh/readers.h"
#include "core/mesh/shared_progress.h"
#include "core/mesh/text_scanner.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <new>

namespace trixel {
namespace {

constexpr std::size_t kChunkBytes = std::size_t{1} << 20U;
constexpr std::int64_t kMaxVertices = std::int64_t{1} << 31U;

// How many statements of the numbered kinds there are.
struct ObjCounts
{
    std::int64_t vertices = 0;
    std::int64_t textures = 0;
    std::int64_t normals = 0;

    ObjCounts operator+(const ObjCounts& b) const
    {
        return {vertices + b.vertices, textures + b.textures, normals + b.normals};
    }
};

// A run of whole lines, so that large files are read by several threads.
struct ObjChunk
{
    std::string_view text;
    std::size_t lines = 0;
    ObjCounts counts;

    std::size_t firstLine = 1;
    ObjCounts before; // in all earlier chunks

    PolygonList polygons;
    ObjTags tags;
    UvNumbers uvNumbers; // of the polygons' corners
    Status status;
};

bool endsContinued(std::string_view textUpToNewline)
{
    textUpToNewline.remove_suffix(textUpToNewline.ends_with('\r') ? 1 : 0);
    return textUpToNewline.ends_with('\\');
}

std::vector<ObjChunk> splitIntoChunks(std::string_view text)
{
    std::vector<ObjChunk> chunks;
    while (!text.empty()) {
        std::size_t newline = text.find('\n', std::min(kChunkBytes, text.size()) - 1);
        while (newline != std::string_view::npos && endsContinued(text.substr(0, newline))) {
            newline = text.find('\n', newline + 1);
        }
        const std::size_t size = newline == std::string_view::npos ? text.size() : newline + 1;
        chunks.emplace_back().text = text.substr(0, size);
        text.remove_prefix(size);
    }
    return chunks;
}

TextScanner scannerOf(const ObjChunk& chunk)
{
    return TextScanner(chunk.text, chunk.firstLine, TextScanner::Continuation::Backslash);
}

void countStatements(ObjChunk& chunk)
{
    TextScanner scanner = scannerOf(chunk);
    while (!scanner.atEnd()) {
        const std::string_view keyword = scanner.word();
        if (keyword.starts_with('v')) {
            const ObjStatement statement = objStatementOf(keyword);
            chunk.counts.vertices += statement == ObjStatement::Vertex ? 1 : 0;
            chunk.counts.textures += statement == ObjStatement::Texture ? 1 : 0;
            chunk.counts.normals += statement == ObjStatement::Normal ? 1 : 0;
        }
        scanner.skipLine();
    }
    chunk.lines = scanner.line() - 1;
}

// Sums up what lies before each chunk; returns what is in all.
ObjCounts placeChunks(std::span<ObjChunk> chunks)
{
    ObjCounts before;
    std::size_t line = 1;
    for (ObjChunk& chunk : chunks) {
        chunk.before = before;
        chunk.firstLine = line;
        before = before + chunk.counts;
        line += chunk.lines;
    }
    return before;
}

// Reads the vertices and faces of one chunk, when the counts of all are known.
class ObjChunkReader
{
public:
    ObjChunkReader(ObjChunk& chunk,
                   const ObjCounts& totals,
                   std::span<glm::vec3> positions,
                   std::span<glm::vec2> uvs)
        : m_chunk(chunk)
        , m_totals(totals)
        , m_positions(positions)
        , m_uvs(uvs)
        , m_scanner(scannerOf(chunk))
        , m_seen(chunk.before)
    {
    }

    Status read()
    {
        while (m_scanner.skipEmptyLines()) {
            if (auto status = readStatement(); !status) {
                return status;
            }
            m_scanner.skipLine();
        }
        return {};
    }

private:
    Status readStatement()
    {
        TextScanner start = m_scanner;
        switch (objStatementOf(m_scanner.word())) {
        case ObjStatement::Vertex:
            return readVertex();
        case ObjStatement::Face:
            return readFace();
        case ObjStatement::Texture:
            readTexture();
            return {};
        case ObjStatement::Normal:
            ++m_seen.normals;
            return {};
        case ObjStatement::Tag:
            return readObjTag(m_scanner, m_totals.vertices, m_chunk.tags);
        case ObjStatement::Skipped:
            return {};
        case ObjStatement::Unknown:
            break;
        }
        return start.expected("an OBJ statement such as 'v' or 'f'");
    }

    Status readVertex();
    void readTexture();
    Status readFace();
    Status readCorner();
    // `number` as the file has it: from 1 on, or from -1 back; `seen` of `total` came so far.
    Status
    checkNumber(const char* what, std::int64_t number, std::int64_t seen, std::int64_t total) const;
    // \param found  set to the place, from 0 on, if there is a number
    Status readExtraNumber(const char* what,
                           std::int64_t seen,
                           std::int64_t total,
                           std::uint32_t* found = nullptr);

    ObjChunk& m_chunk;
    const ObjCounts& m_totals;
    std::span<glm::vec3> m_positions;
    std::span<glm::vec2> m_uvs;
    TextScanner m_scanner;
    ObjCounts m_seen;
    std::vector<std::uint32_t> m_corners; // of the face at hand
};

Status ObjChunkReader::readVertex()
{
    const Result<glm::vec3> position = m_scanner.point();
    if (!position) {
        return tl::unexpected(position.error());
    }
    int extra = 0; // a weight, or a colour, or both
    while (!m_scanner.atLineEnd()) {
        if (extra == 4 || !m_scanner.skipNumber()) {
            return m_scanner.expected(extra == 4 ? "the end of the line" : "a number");
        }
        ++extra;
    }
    if (extra == 2) {
        return m_scanner.expected("3, 4, 6 or 7 numbers", "5");
    }
    const auto place = static_cast<std::size_t>(m_seen.vertices++);
    check(place < m_positions.size(), "vertices were counted");
    m_positions[place] = *position;
    return {};
}

// Strict where faces refer to it, but not in its value: what is no number is no place.
void ObjChunkReader::readTexture()
{
    const auto place = static_cast<std::size_t>(m_seen.textures++);
    check(place < m_uvs.size(), "texture vertices were counted");
    const float u = m_scanner.finiteFloat().value_or(NAN);
    m_uvs[place] = {u, m_scanner.finiteFloat().value_or(NAN)};
}

Status ObjChunkReader::checkNumber(const char* what,
                                   std::int64_t number,
                                   std::int64_t seen,
                                   std::int64_t total) const
{
    if (number > 0 ? number <= total : number < 0 && -number <= seen) {
        return {};
    }
    std::string range =
        total > 0 ? " number in 1 to " + std::to_string(total) : " number (the file has none)";
    if (number < 0) {
        range = seen > 0 ? " number in -" + std::to_string(seen) + " to -1"
                         : " number (none comes before)";
    }
    return m_scanner.expected(what + range, std::to_string(number));
}

// After a slash; nothing between slashes is nothing to check.
Status ObjChunkReader::readExtraNumber(const char* what,
                                       std::int64_t seen,
                                       std::int64_t total,
                                       std::uint32_t* found)
{
    const auto number = m_scanner.integerPart();
    if (!number) {
        return {};
    }
    if (found != nullptr) {
        *found = static_cast<std::uint32_t>(*number > 0 ? *number - 1 : seen + *number);
    }
    return checkNumber(what, *number, seen, total);
}

Status ObjChunkReader::readCorner()
{
    const TextScanner start = m_scanner;
    const auto number = m_scanner.integerPart();
    if (!number) {
        return m_scanner.expected("a vertex number");
    }
    if (auto status = checkNumber("a vertex", *number, m_seen.vertices, m_totals.vertices);
        !status) {
        return status;
    }
    std::uint32_t uv = kNoUv;
    if (m_scanner.skipCharacter('/')) {
        if (auto status =
                readExtraNumber("a texture vertex", m_seen.textures, m_totals.textures, &uv);
            !status) {
            return status;
        }
        if (m_scanner.skipCharacter('/')) {
            if (auto status = readExtraNumber("a normal", m_seen.normals, m_totals.normals);
                !status) {
                return status;
            }
        }
    }
    if (!m_scanner.atWordEnd()) {
        return TextScanner(start).expected("a corner such as '1', '1/2', '1//3' or '1/2/3'");
    }
    m_corners.push_back(
        static_cast<std::uint32_t>(*number > 0 ? *number - 1 : m_seen.vertices + *number));
    if (m_totals.textures > 0) {
        m_chunk.uvNumbers.push_back(uv);
    }
    return {};
}

Status ObjChunkReader::readFace()
{
    m_corners.clear();
    while (!m_scanner.atLineEnd()) {
        if (auto status = readCorner(); !status) {
            return status;
        }
    }
    if (m_corners.size() < 3) {
        return m_scanner.expected("a face of at least 3 corners", std::to_string(m_corners.size()));
    }
    m_chunk.polygons.add(m_corners);
    return {};
}

// Calls a function that may run out of memory, for each chunk, until the user stops it.
void forEachChunk(std::span<ObjChunk> chunks,
                  SharedProgress& progress,
                  const std::function<void(ObjChunk&)>& work)
{
    parallelFor(chunks.size(), 1, Threads::all(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end && progress.goesOn(); ++i) {
            try {
                work(chunks[i]);
                progress.step();
            } catch (const std::bad_alloc&) { // must not leave its thread
                chunks[i].status = contentsError("the mesh does not fit into memory");
            }
        }
    });
}

std::vector<PolygonList> takePolygons(std::span<ObjChunk> chunks)
{
    std::vector<PolygonList> parts;
    for (ObjChunk& chunk : chunks) {
        parts.push_back(std::move(chunk.polygons));
    }
    return parts;
}

std::vector<ObjTags> takeTags(std::span<ObjChunk> chunks)
{
    std::vector<ObjTags> parts;
    for (ObjChunk& chunk : chunks) {
        parts.push_back(std::move(chunk.tags));
    }
    return parts;
}

std::vector<UvNumbers> takeUvNumbers(std::span<ObjChunk> chunks)
{
    std::vector<UvNumbers> numbers;
    for (ObjChunk& chunk : chunks) {
        numbers.push_back(std::move(chunk.uvNumbers));
    }
    return numbers;
}

} // namespace

Result<TriangleMesh> parseObj(std::string_view bytes, Progress& progress)
{
    std::vector<ObjChunk> chunks = splitIntoChunks(withoutByteOrderMark(bytes));
    SharedProgress shared(progress, 2 * chunks.size());
    forEachChunk(chunks, shared, countStatements);
    if (!shared.goesOn()) {
        return cancelled();
    }
    const ObjCounts totals = placeChunks(chunks);
    if (std::max(totals.vertices, totals.textures) >= kMaxVertices) {
        return contentsError("expected fewer than 2^31 vertices, found " +
                             std::to_string(std::max(totals.vertices, totals.textures)));
    }
    std::vector<glm::vec3> positions(static_cast<std::size_t>(totals.vertices));
    std::vector<glm::vec2> uvs(static_cast<std::size_t>(totals.textures));
    forEachChunk(chunks, shared, [&](ObjChunk& chunk) {
        chunk.status = ObjChunkReader(chunk, totals, positions, uvs).read();
    });
    if (!shared.goesOn()) {
        return cancelled();
    }
    for (const ObjChunk& chunk : chunks) {
        if (!chunk.status) {
            return tl::unexpected(chunk.status.error());
        }
    }
    std::vector<PolygonList> polygons = takePolygons(chunks);
    auto mesh = cutPolygons(std::move(positions), polygons);
    if (!mesh) {
        return mesh;
    }
    auto sharpness = gatherTags(*mesh, takeTags(chunks));
    if (!sharpness) {
        return tl::unexpected(sharpness.error());
    }
    mesh->sharpness = std::move(*sharpness);
    if (!uvs.empty()) {
        mesh->cornerUvs = cornerUvs(mesh->triangles, polygons, takeUvNumbers(chunks), uvs);
    }
    return mesh;
}

} // namespace trixel
