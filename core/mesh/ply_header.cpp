// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/ply_header.h"

#include "core/mesh/text_scanner.h"

#include <algorithm>
#include <array>

namespace trixel {
namespace {

struct TypeName
{
    std::string_view name;
    PlyType type;
};

constexpr std::array<TypeName, 16> kTypeNames{{{"char", PlyType::Int8},
                                               {"int8", PlyType::Int8},
                                               {"uchar", PlyType::Uint8},
                                               {"uint8", PlyType::Uint8},
                                               {"short", PlyType::Int16},
                                               {"int16", PlyType::Int16},
                                               {"ushort", PlyType::Uint16},
                                               {"uint16", PlyType::Uint16},
                                               {"int", PlyType::Int32},
                                               {"int32", PlyType::Int32},
                                               {"uint", PlyType::Uint32},
                                               {"uint32", PlyType::Uint32},
                                               {"float", PlyType::Float},
                                               {"float32", PlyType::Float},
                                               {"double", PlyType::Double},
                                               {"float64", PlyType::Double}}};

class PlyHeaderParser
{
public:
    explicit PlyHeaderParser(std::string_view bytes)
        : m_scanner(bytes)
    {
    }

    Result<PlyHeader> parse()
    {
        TextScanner start = m_scanner;
        if (m_scanner.word() != "ply") {
            return start.expected("'ply'");
        }
        auto status = endLine().and_then([this] { return parseFormat(); });
        while (status && !m_ended) {
            status = parseLine();
        }
        if (!status) {
            return tl::unexpected(status.error());
        }
        m_header.data = m_scanner.rest();
        m_header.dataLine = m_scanner.line();
        return std::move(m_header);
    }

private:
    Status endLine()
    {
        if (!m_scanner.atLineEnd()) {
            return m_scanner.expected("the end of the line");
        }
        m_scanner.skipLine();
        return {};
    }

    Status parseFormat();
    Status parseLine();
    Status parseElement();
    Status parseProperty();
    Result<PlyType> parseType(const std::string& what);

    TextScanner m_scanner;
    PlyHeader m_header;
    bool m_ended = false;
};

Status PlyHeaderParser::parseFormat()
{
    for (;;) {
        m_scanner.skipEmptyLines();
        TextScanner start = m_scanner;
        const std::string_view word = m_scanner.word();
        if (word == "comment" || word == "obj_info") {
            m_scanner.skipLine();
            continue;
        }
        if (word != "format") {
            return start.expected("'format'");
        }
        break;
    }
    TextScanner start = m_scanner;
    const std::string_view encoding = m_scanner.word();
    if (encoding == "ascii") {
        m_header.encoding = PlyEncoding::Ascii;
    } else if (encoding == "binary_little_endian") {
        m_header.encoding = PlyEncoding::LittleEndian;
    } else if (encoding == "binary_big_endian") {
        m_header.encoding = PlyEncoding::BigEndian;
    } else {
        return start.expected("ascii, binary_little_endian or binary_big_endian");
    }
    start = m_scanner;
    if (m_scanner.word() != "1.0") {
        return start.expected("version 1.0");
    }
    return endLine();
}

Status PlyHeaderParser::parseLine()
{
    m_scanner.skipEmptyLines();
    TextScanner start = m_scanner;
    const std::string_view word = m_scanner.word();
    if (word == "element") {
        return parseElement();
    }
    if (word == "property") {
        return m_header.elements.empty() ? start.expected("an element before its properties")
                                         : parseProperty();
    }
    // Blender 2.4's exporter forgot the word "comment" before "Created by Blender3D".
    if (word == "comment" || word == "obj_info" ||
        (word == "Created" && m_scanner.word() == "by")) {
        m_scanner.skipLine();
        return {};
    }
    if (word != "end_header") {
        return start.expected("'element', 'property', 'comment' or 'end_header'");
    }
    m_ended = true;
    return endLine();
}

Status PlyHeaderParser::parseElement()
{
    PlyElement element;
    element.line = m_scanner.line();
    element.name = m_scanner.word();
    if (element.name.empty()) {
        return m_scanner.expected("the element's name");
    }
    if (std::any_of(m_header.elements.begin(), m_header.elements.end(), [&](const PlyElement& e) {
            return e.name == element.name;
        })) {
        return m_scanner.expected("each element once", quoted(element.name) + " again");
    }
    TextScanner start = m_scanner;
    const auto rows = m_scanner.integer();
    if (!rows || *rows < 0) {
        return start.expected("the number of " + quoted(element.name) + " elements");
    }
    element.rows = static_cast<std::size_t>(*rows);
    m_header.elements.push_back(element);
    return endLine();
}

Result<PlyType> PlyHeaderParser::parseType(const std::string& what)
{
    TextScanner start = m_scanner;
    const std::string_view word = m_scanner.word();
    const auto* const type =
        std::find_if(kTypeNames.begin(), kTypeNames.end(), [&](const TypeName& candidate) {
            return candidate.name == word;
        });
    if (type == kTypeNames.end()) {
        return start.expected(what);
    }
    return type->type;
}

Status PlyHeaderParser::parseProperty()
{
    PlyProperty property;
    property.line = m_scanner.line();
    const TextScanner start = m_scanner;
    if (m_scanner.word() == "list") {
        TextScanner typeStart = m_scanner;
        const auto type = parseType("the type of the list's length");
        if (!type) {
            return tl::unexpected(type.error());
        }
        if (!isInteger(*type)) {
            return typeStart.expected("an integer type for the list's length");
        }
        property.listLengthType = *type;
    } else {
        m_scanner = start;
    }
    const auto type = parseType("a type such as 'float' or 'int'");
    if (!type) {
        return tl::unexpected(type.error());
    }
    property.type = *type;
    property.name = m_scanner.word();
    if (property.name.empty()) {
        return m_scanner.expected("the property's name");
    }
    m_header.elements.back().properties.push_back(property);
    return endLine();
}

} // namespace

std::size_t byteSizeOf(PlyType type)
{
    constexpr std::array<std::size_t, 8> kSizes{1, 1, 2, 2, 4, 4, 4, 8};
    return kSizes[static_cast<std::size_t>(type)];
}

Result<PlyHeader> parsePlyHeader(std::string_view bytes)
{
    return PlyHeaderParser(bytes).parse();
}

} // namespace trixel
