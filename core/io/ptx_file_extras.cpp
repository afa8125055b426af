// SPDX-License-Identifier: GPL-3.0-or-later
//
// What follows the level data of a .ptx: metadata, and edits appended to a finished file.
#include "core/base/check.h"
#include "core/io/byte_reader.h"
#include "core/io/ptx_file.h"
#include "core/io/ptx_metadata.h"

#include <algorithm>
#include <string>

namespace trixel {

namespace {

constexpr std::size_t kEditHeadBytes = 5;
constexpr std::uint64_t kBarrierBytes = 8;
// A small item costs more in memory than in the file.
constexpr std::uint64_t kMemoryPerMetadataByte = 16;

} // namespace

Status PtxFile::readEdits()
{
    Range edits{m_header.editOffset, m_header.editBytes};
    if (edits.offset == 0) { // a file older than the field: edits run to the end
        edits = {m_end, m_source->size() - m_end};
        if (edits.size >= kBarrierBytes && m_largeTable.size == 0) {
            const auto barrier = bytes({m_end, kBarrierBytes});
            if (barrier &&
                std::ranges::all_of(*barrier, [](auto b) { return b == std::byte{0}; })) {
                edits = {m_end + kBarrierBytes, edits.size - kBarrierBytes};
            }
        }
    }
    if (edits.offset > m_source->size() || edits.size > m_source->size() - edits.offset) {
        return contentsError("the edits (" + std::to_string(edits.size) + " bytes at byte " +
                             std::to_string(edits.offset) + ") should lie inside the file of " +
                             std::to_string(m_source->size()) + " bytes");
    }
    while (edits.size > 0) {
        if (edits.size < kEditHeadBytes) {
            return contentsError("the edit at byte " + std::to_string(edits.offset) +
                                 " ends inside its head");
        }
        const auto head = bytes({edits.offset, kEditHeadBytes});
        if (!head) {
            return tl::unexpected(head.error());
        }
        ByteReader reader(*head);
        const std::uint8_t type = reader.take<std::uint8_t>().value();
        const std::uint32_t size = reader.take<std::uint32_t>().value();
        if (size == 0) {
            return {};
        }
        const Range payload{edits.offset + kEditHeadBytes, size};
        if (size > edits.size - kEditHeadBytes) {
            return contentsError("the edit at byte " + std::to_string(edits.offset) + " of " +
                                 std::to_string(size) + " bytes ends beyond the edits");
        }
        Status status;
        if (type == 0) {
            status = readFaceEdit(payload);
        } else if (type == 1) {
            status = readMetadataEdit(payload);
        } // others are of a later version and may be skipped
        if (!status) {
            return status;
        }
        edits.offset += kEditHeadBytes + size;
        edits.size -= kEditHeadBytes + size;
    }
    return {};
}

Status PtxFile::readFaceEdit(Range payload)
{
    const std::string name = "the edit of a face at byte " + std::to_string(payload.offset);
    const std::uint64_t headBytes = 4 + sizeof(PtxFaceInfo) + 4 + m_format.texelBytes();
    if (payload.size < headBytes) {
        return contentsError(name + " has " + std::to_string(payload.size) +
                             " bytes, expected at least " + std::to_string(headBytes));
    }
    const auto head = bytes({payload.offset, headBytes});
    if (!head) {
        return tl::unexpected(head.error());
    }
    ByteReader reader(*head);
    const std::uint32_t face = reader.take<std::uint32_t>().value();
    PtxFaceInfo info = reader.take<PtxFaceInfo>().value();
    const PtxBlockHeader header(reader.take<std::uint32_t>().value());
    const auto value = reader.takeBytes(m_format.texelBytes()).value();
    if (face >= m_header.faces) {
        return contentsError(name + " is of face " + std::to_string(face) + ", but there are " +
                             std::to_string(m_header.faces) + " faces");
    }
    if (const std::string why = faultOf(info, face, m_header.faces); !why.empty()) {
        return contentsError(name + ": " + why);
    }
    if (!info.isConstant() && header.size() > payload.size - headBytes) {
        return contentsError(name + " has a block of " + std::to_string(header.size()) +
                             " bytes that ends beyond it");
    }
    info.flags |= PtxFaceInfo::kEdited;
    m_infos[face] = info;
    std::ranges::copy(value,
                      m_constantValues.begin() +
                          static_cast<std::ptrdiff_t>(face * m_format.texelBytes()));
    m_tables[0].headers[face] = header;
    m_tables[0].offsets[face] = payload.offset + headBytes;
    return {};
}

Status PtxFile::readMetadataEdit(Range payload)
{
    const std::string name = "the edit of metadata at byte " + std::to_string(payload.offset);
    if (payload.size < 8) {
        return contentsError(name + " ends inside its head");
    }
    const auto head = bytes({payload.offset, 8});
    if (!head) {
        return tl::unexpected(head.error());
    }
    ByteReader reader(*head);
    const std::uint32_t zipped = reader.take<std::uint32_t>().value();
    const std::uint32_t size = reader.take<std::uint32_t>().value();
    if (zipped > payload.size - 8) {
        return contentsError(name + " has a block of " + std::to_string(zipped) +
                             " bytes that ends beyond it");
    }
    m_metadataEdits.push_back({{payload.offset + 8, zipped}, size});
    return {};
}

Status PtxFile::readSmallMetadata(Range zipped,
                                  std::uint32_t size,
                                  MemoryBudget& budget,
                                  std::vector<PtxMetadata>& items) const
{
    Status status = checkPtxRatio(zipped.size, size, "the metadata").and_then([&] {
        return budget.take(kMemoryPerMetadataByte * size, "the metadata");
    });
    if (!status) {
        return status;
    }
    std::vector<std::byte> block(size);
    return unzip(zipped, block, "the metadata").and_then([&] {
        return parseMetadata(block, items);
    });
}

Status PtxFile::readLargeMetadata(MemoryBudget& budget, std::vector<PtxMetadata>& items) const
{
    const std::string what = "the table of large metadata";
    Status status = checkPtxRatio(m_largeTable.size, m_header.largeHeaderBytes, what).and_then([&] {
        return budget.take(kMemoryPerMetadataByte * m_header.largeHeaderBytes, what);
    });
    if (!status) {
        return status;
    }
    std::vector<std::byte> table(m_header.largeHeaderBytes);
    if (status = unzip(m_largeTable, table, what); !status) {
        return status;
    }
    const Result<std::vector<PtxLargeItem>> entries = parseLargeMetadata(table);
    if (!entries) {
        return tl::unexpected(entries.error());
    }
    Range rest = m_largeData;
    std::vector<std::byte> value;
    for (const PtxLargeItem& entry : *entries) {
        const std::string name = "the metadata \"" + entry.key + "\"";
        if (entry.zippedBytes > rest.size) {
            return contentsError(name + " ends beyond the large metadata");
        }
        status = checkPtxRatio(entry.zippedBytes, entry.bytes, name).and_then([&] {
            return budget.take(entry.bytes, name);
        });
        if (!status) {
            return status;
        }
        value.resize(entry.bytes);
        if (status = unzip({rest.offset, entry.zippedBytes}, value, name); !status) {
            return status;
        }
        Result<PtxMetadata> item = makeMetadata(entry.key, entry.type, value);
        if (!item) {
            return tl::unexpected(item.error());
        }
        items.push_back(std::move(*item));
        rest = {rest.offset + entry.zippedBytes, rest.size - entry.zippedBytes};
    }
    return {};
}

Result<std::vector<PtxMetadata>> PtxFile::metadata(MemoryBudget& budget) const
{
    std::vector<PtxMetadata> items;
    if (m_metadata.size > 0) {
        if (Status status = readSmallMetadata(m_metadata, m_header.metadataBytes, budget, items);
            !status) {
            return tl::unexpected(status.error());
        }
    }
    if (m_largeTable.size > 0) {
        if (Status status = readLargeMetadata(budget, items); !status) {
            return tl::unexpected(status.error());
        }
    }
    for (const MetadataEdit& edit : m_metadataEdits) {
        if (Status status = readSmallMetadata(edit.zipped, edit.bytes, budget, items); !status) {
            return tl::unexpected(status.error());
        }
    }
    mergeDuplicates(items);
    return items;
}

} // namespace trixel
