// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/corner_uvs.h"
#include "core/mesh/ply_header.h"
#include "core/mesh/ply_source.h"
#include "core/mesh/polygon_cutter.h"
#include "core/mesh/readers.h"
#include "core/mesh/row_progress.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace trixel {
namespace {

constexpr std::size_t kMaxVertices = std::size_t{1} << 31U;

tl::unexpected<Error>
expectedInHeader(std::size_t line, const std::string& what, const std::string& found)
{
    return contentsError("line " + std::to_string(line) + ": expected " + what + ", found " +
                         found);
}

// Where a mesh's data are among the elements of a header.
struct MeshLayout
{
    const PlyElement* vertices = nullptr;
    std::array<std::size_t, 3> coordinates{}; // which properties are x, y, z
    const PlyElement* faces = nullptr;
    std::size_t corners = 0; // which property lists a face's vertices
    // Where the properties are that are uvs: of vertices, and lists of two numbers a corner.
    std::optional<std::array<std::size_t, 2>> vertexUvs;
    std::optional<std::size_t> faceUvs;
};

constexpr std::string_view kFaceUvs = "texcoord";
constexpr std::array<std::array<std::string_view, 2>, 4> kVertexUvs{{
    {"s", "t"},
    {"u", "v"},
    {"texture_u", "texture_v"},
    {"texture_s", "texture_t"},
}};

const PlyElement* findElement(const PlyHeader& header, std::string_view name)
{
    const auto at = std::find_if(header.elements.begin(),
                                 header.elements.end(),
                                 [&](const PlyElement& element) { return element.name == name; });
    return at == header.elements.end() ? nullptr : &*at;
}

// The only property of one of these names.
Result<std::size_t> findProperty(const PlyElement& element,
                                 std::initializer_list<std::string_view> names)
{
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
        const PlyProperty& property = element.properties[i];
        if (std::find(names.begin(), names.end(), property.name) == names.end()) {
            continue;
        }
        if (found) {
            return expectedInHeader(
                property.line, "property " + quoted(property.name) + " once", "it again");
        }
        found = i;
    }
    if (!found) {
        return expectedInHeader(element.line,
                                "element " + quoted(element.name) + " with a property " +
                                    quoted(*names.begin()),
                                "none");
    }
    return *found;
}

bool has(const PlyElement& element, std::string_view name)
{
    return std::ranges::find(element.properties, name, &PlyProperty::name) !=
           element.properties.end();
}

// The first pair of single numbers that stand for a place in an image; others are passed over.
Status layOutVertexUvs(const PlyElement& element, MeshLayout& layout)
{
    for (const auto& names : kVertexUvs) {
        if (!has(element, names[0]) || !has(element, names[1])) {
            continue;
        }
        const auto first = findProperty(element, {names[0]});
        const auto second = findProperty(element, {names[1]});
        if (!first || !second) {
            return tl::unexpected(first ? second.error() : first.error());
        }
        if (!element.properties[*first].isList() && !element.properties[*second].isList()) {
            layout.vertexUvs = {*first, *second};
            return {};
        }
    }
    return {};
}

Status layOutVertices(const PlyElement& element, MeshLayout& layout)
{
    layout.vertices = &element;
    constexpr std::array<std::string_view, 3> kNames{"x", "y", "z"};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto at = findProperty(element, {kNames[axis]});
        if (!at) {
            return tl::unexpected(at.error());
        }
        const PlyProperty& property = element.properties[*at];
        if (property.isList()) {
            return expectedInHeader(property.line, "a single number", "a list");
        }
        layout.coordinates[axis] = *at;
    }
    if (element.rows >= kMaxVertices) {
        return expectedInHeader(
            element.line, "fewer than 2^31 vertices", std::to_string(element.rows));
    }
    return layOutVertexUvs(element, layout);
}

Status layOutFaces(const PlyElement& element, MeshLayout& layout)
{
    layout.faces = &element;
    const auto at = findProperty(element, {"vertex_indices", "vertex_index"});
    if (!at) {
        return tl::unexpected(at.error());
    }
    const PlyProperty& property = element.properties[*at];
    if (!property.isList() || !isInteger(property.type)) {
        return expectedInHeader(property.line, "a list of integers", "another type");
    }
    layout.corners = *at;
    if (has(element, kFaceUvs)) {
        const auto uvs = findProperty(element, {kFaceUvs});
        if (!uvs) {
            return tl::unexpected(uvs.error());
        }
        if (element.properties[*uvs].isList()) {
            layout.faceUvs = *uvs;
        }
    }
    return {};
}

// What a header has instead of an element.
std::string insteadOf(const PlyHeader& header, std::string_view name)
{
    if (name != "face") {
        return "none";
    }
    return findElement(header, "tristrips") != nullptr ? "triangle strips ('tristrips')"
                                                       : "none: points alone cannot be painted";
}

Result<MeshLayout> layOut(const PlyHeader& header)
{
    MeshLayout layout;
    for (const std::string_view name : {"vertex", "face"}) {
        const PlyElement* const element = findElement(header, name);
        if (element == nullptr) {
            return expectedInHeader(header.dataLine - 1,
                                    "an element " + quoted(name) + " in the header",
                                    insteadOf(header, name));
        }
        const Status status =
            name == "vertex" ? layOutVertices(*element, layout) : layOutFaces(*element, layout);
        if (!status) {
            return tl::unexpected(status.error());
        }
    }
    return layout;
}

template <class Source>
class PlyBodyReader
{
public:
    PlyBodyReader(const PlyHeader& header,
                  const MeshLayout& layout,
                  Source source,
                  Progress& progress)
        : m_header(header)
        , m_layout(layout)
        , m_source(std::move(source))
        , m_room(m_source.room())
        , m_progress(progress, m_room + 1)
    {
    }

    Result<TriangleMesh> read()
    {
        for (const PlyElement& element : m_header.elements) {
            if (auto status = checkRows(element); !status) {
                return tl::unexpected(status.error());
            }
        }
        for (const PlyElement& element : m_header.elements) {
            if (auto status = readElement(element); !status) {
                return tl::unexpected(status.error());
            }
        }
        if (auto status = m_source.expectEnd(); !status) {
            return tl::unexpected(status.error());
        }
        auto mesh = cutPolygons(std::move(m_positions), std::span(&m_polygons, 1));
        if (mesh) {
            mesh->cornerUvs = takeUvs(mesh->triangles);
        }
        return mesh;
    }

private:
    // Those of the faces' corners, else those of the vertices.
    std::vector<glm::vec2> takeUvs(std::span<const Triangle> triangles)
    {
        if (m_layout.faceUvs && !m_uvs.empty()) {
            return cornerUvs(triangles, std::span(&m_polygons, 1), {std::move(m_uvNumbers)}, m_uvs);
        }
        return m_layout.vertexUvs ? cornerUvsOfVertices(triangles, m_vertexUvs)
                                  : std::vector<glm::vec2>();
    }

    // As many rows as the header says must fit the file, before memory is taken for them.
    Status checkRows(const PlyElement& element) const
    {
        std::size_t rowBytes = 0;
        for (const PlyProperty& property : element.properties) {
            rowBytes += Source::leastBytes(property);
        }
        if (&element == m_layout.faces) {
            rowBytes += 3 * Source::leastBytes(element.properties[m_layout.corners].type);
        }
        if (rowBytes > 0 && element.rows > m_room / rowBytes) {
            return expectedInHeader(element.line,
                                    "at most " + std::to_string(m_room / rowBytes) + " elements " +
                                        quoted(element.name) + " in the data that follow",
                                    std::to_string(element.rows));
        }
        return {};
    }

    Status readElement(const PlyElement& element)
    {
        if (element.properties.empty()) {
            return {}; // nothing in the file, however many rows
        }
        if (&element == m_layout.vertices) {
            m_positions.reserve(element.rows);
            m_axes.assign(element.properties.size(), -1);
            for (int axis = 0; axis < 3; ++axis) {
                m_axes[m_layout.coordinates[static_cast<std::size_t>(axis)]] = axis;
            }
            if (m_layout.vertexUvs) {
                m_vertexUvs.reserve(element.rows);
                m_axes[(*m_layout.vertexUvs)[0]] = kU;
                m_axes[(*m_layout.vertexUvs)[1]] = kV;
            }
        } else if (&element == m_layout.faces) {
            m_polygons.reserve(element.rows);
        }
        for (std::size_t row = 0; row < element.rows; ++row) {
            if (!m_progress.goesOn(m_room - m_source.room())) {
                return cancelled();
            }
            m_source.beginRow();
            if (auto status = readRow(element); !status) {
                return status;
            }
            if (auto status = m_source.endRow(); !status) {
                return status;
            }
        }
        return {};
    }

    Status readRow(const PlyElement& element)
    {
        if (&element == m_layout.vertices) {
            return readVertex(element);
        }
        const bool isFace = &element == m_layout.faces;
        m_faceUvs.clear();
        for (std::size_t i = 0; i < element.properties.size(); ++i) {
            const PlyProperty& property = element.properties[i];
            auto status = isFace && i == m_layout.corners   ? readFace(property)
                          : isFace && i == m_layout.faceUvs ? readFaceUvs(property)
                                                            : skipProperty(property);
            if (!status) {
                return status;
            }
        }
        return isFace && m_layout.faceUvs ? takeFaceUvs() : Status();
    }

    // Two numbers a corner, or none.
    Status readFaceUvs(const PlyProperty& property)
    {
        const auto numbers = m_source.integer(*property.listLengthType);
        if (!numbers || *numbers < 0 || *numbers % 2 != 0) {
            return m_source.expected("an even length of list " + quoted(property.name));
        }
        if (static_cast<std::size_t>(*numbers) >
            m_source.room() / Source::leastBytes(property.type)) {
            return m_source.expected("a list " + quoted(property.name) +
                                     " that fits the rest of the file");
        }
        for (std::int64_t i = 0; i < *numbers; i += 2) {
            const auto s = m_source.anyNumber(property.type);
            const auto t = s ? m_source.anyNumber(property.type) : s;
            if (!s || !t) {
                return m_source.expected("a number of list " + quoted(property.name));
            }
            m_faceUvs.push_back(placeOf(*s, *t));
        }
        return {};
    }

    Status takeFaceUvs()
    {
        if (!m_faceUvs.empty() && m_faceUvs.size() != m_corners.size()) {
            return m_source.expected(std::to_string(2 * m_corners.size()) + " numbers in list " +
                                     quoted(kFaceUvs) + ", two a corner, before a list of " +
                                     std::to_string(2 * m_faceUvs.size()) + " ends");
        }
        for (std::size_t i = 0; i < m_corners.size(); ++i) {
            m_uvNumbers.push_back(m_faceUvs.empty() ? kNoUv
                                                    : static_cast<std::uint32_t>(m_uvs.size() + i));
        }
        m_uvs.insert(m_uvs.end(), m_faceUvs.begin(), m_faceUvs.end());
        return {};
    }

    // A corner has both coordinates or none.
    static glm::vec2 placeOf(float s, float t)
    {
        return std::isnan(s) || std::isnan(t) ? glm::vec2(NAN) : glm::vec2(s, t);
    }

    Status readVertex(const PlyElement& element)
    {
        glm::vec3 position(0);
        glm::vec2 uv(NAN);
        for (std::size_t i = 0; i < element.properties.size(); ++i) {
            if (m_axes[i] < 0) {
                if (auto status = skipProperty(element.properties[i]); !status) {
                    return status;
                }
                continue;
            }
            if (m_axes[i] >= kU) {
                const auto value = m_source.anyNumber(element.properties[i].type);
                if (!value) {
                    return m_source.expected("a number for " + quoted(element.properties[i].name));
                }
                uv[m_axes[i] - kU] = *value;
                continue;
            }
            const auto value = m_source.coordinate(element.properties[i].type);
            if (!value) {
                return m_source.expected("a finite number that fits a float");
            }
            position[m_axes[i]] = *value;
        }
        m_positions.push_back(position);
        if (m_layout.vertexUvs) {
            m_vertexUvs.push_back(placeOf(uv.x, uv.y));
        }
        return {};
    }

    Status readFace(const PlyProperty& property)
    {
        const auto corners = m_source.integer(*property.listLengthType);
        if (!corners || *corners < 3) {
            return m_source.expected("a face of at least 3 corners");
        }
        if (static_cast<std::size_t>(*corners) >
            m_source.room() / Source::leastBytes(property.type)) {
            return m_source.expected("a number of corners that fits the rest of the file");
        }
        const auto vertices = static_cast<std::int64_t>(m_layout.vertices->rows);
        m_corners.clear();
        for (std::int64_t i = 0; i < *corners; ++i) {
            const auto vertex = m_source.integer(property.type);
            if (!vertex || *vertex < 0 || *vertex >= vertices) {
                return m_source.expected("a vertex number below " + std::to_string(vertices));
            }
            m_corners.push_back(static_cast<std::uint32_t>(*vertex));
        }
        m_polygons.add(m_corners);
        return {};
    }

    Status skipProperty(const PlyProperty& property)
    {
        std::int64_t count = 1;
        if (property.isList()) {
            const auto length = m_source.integer(*property.listLengthType);
            if (!length || *length < 0) {
                return m_source.expected("the length of list " + quoted(property.name));
            }
            count = *length;
        }
        if (!m_source.skip(property.type, static_cast<std::size_t>(count))) {
            return m_source.expected(property.isList()
                                         ? std::to_string(count) + " values of list " +
                                               quoted(property.name)
                                         : "a value of " + quoted(property.name));
        }
        return {};
    }

    static constexpr int kU = 3; // after the three axes
    static constexpr int kV = 4;

    const PlyHeader& m_header;
    const MeshLayout& m_layout;
    Source m_source;
    std::size_t m_room;
    RowProgress m_progress;
    std::vector<glm::vec3> m_positions;
    std::vector<int> m_axes; // of the vertex's properties; -1 for others
    PolygonList m_polygons;
    std::vector<std::uint32_t> m_corners; // of the face at hand
    std::vector<glm::vec2> m_faceUvs;     // of the face at hand
    std::vector<glm::vec2> m_uvs;         // of all faces
    UvNumbers m_uvNumbers;                // of all faces' corners
    std::vector<glm::vec2> m_vertexUvs;
};

} // namespace

Result<TriangleMesh> parsePly(std::string_view bytes, Progress& progress)
{
    const auto header = parsePlyHeader(bytes);
    if (!header) {
        return tl::unexpected(header.error());
    }
    const auto layout = layOut(*header);
    if (!layout) {
        return tl::unexpected(layout.error());
    }
    if (header->encoding == PlyEncoding::Ascii) {
        return PlyBodyReader(
                   *header, *layout, PlyTextSource(header->data, header->dataLine), progress)
            .read();
    }
    const std::endian order =
        header->encoding == PlyEncoding::LittleEndian ? std::endian::little : std::endian::big;
    const std::size_t offset = bytes.size() - header->data.size();
    return PlyBodyReader(*header, *layout, PlyBinarySource(header->data, order, offset), progress)
        .read();
}

} // namespace trixel
