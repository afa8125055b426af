// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/ptx_file.h"

#include "core/base/check.h"
#include "core/io/byte_reader.h"

#include <algorithm>
#include <array>
#include <string>

namespace trixel {

namespace {

// Key of the order in which reductions list the faces, largest first.
std::size_t orderKey(const PtxFaceInfo& info)
{
    return info.isConstant() ? 1 : static_cast<std::size_t>(info.uLog2);
}

} // namespace

PtxFile::PtxFile(std::unique_ptr<const ByteSource> source)
    : m_source(std::move(source))
{
}

Result<PtxFile> PtxFile::open(std::unique_ptr<const ByteSource> source, MemoryBudget& budget)
{
    PtxFile file(std::move(source));
    const Status status = file.readHeaders()
                              .and_then([&] { return file.placeParts(); })
                              .and_then([&] { return file.readFaceInfos(budget); })
                              .and_then([&] { return file.readConstants(budget); })
                              .and_then([&] { return file.readLevels(budget); })
                              .and_then([&] { return file.orderFaces(budget); })
                              .and_then([&] { return file.readEdits(); });
    if (!status) {
        return tl::unexpected(status.error());
    }
    return file;
}

Status PtxFile::readHeaders()
{
    if (m_source->size() < PtxHeader::kBytes) {
        return contentsError("has " + std::to_string(m_source->size()) +
                             " bytes, a .ptx starts with a header of 64");
    }
    Buffer scratch;
    const auto start = m_source->view(0, PtxHeader::kBytes, scratch);
    if (!start) {
        return tl::unexpected(start.error());
    }
    Result<PtxHeader> header = parsePtxHeader(*start);
    if (!header) {
        return tl::unexpected(header.error());
    }
    m_header = *header;
    m_format = formatOf(m_header);
    const std::uint64_t known =
        std::min<std::uint64_t>(m_header.extendedBytes, PtxHeader::kExtendedBytes);
    if (known > m_source->size() - PtxHeader::kBytes) {
        return contentsError("ends inside the extended header");
    }
    const auto more = m_source->view(PtxHeader::kBytes, known, scratch);
    if (!more) {
        return tl::unexpected(more.error());
    }
    parsePtxExtendedHeader(*more, m_header);
    return {};
}

// Parts lie one after the other. Their sizes are 32 and 64 bits, so sums are checked before each.
Status PtxFile::placeParts()
{
    std::uint64_t end = PtxHeader::kBytes;
    const auto place = [&](std::uint64_t size, const char* what, Range& range) -> Status {
        if (size > m_source->size() - end) {
            return contentsError(std::string(what) + " (" + std::to_string(size) +
                                 " bytes at byte " + std::to_string(end) +
                                 ") should lie inside the file of " +
                                 std::to_string(m_source->size()) + " bytes");
        }
        range = {end, size};
        end += size;
        return {};
    };
    Range extended;
    Range barrier;
    const bool hasLarge = m_header.largeHeaderZippedBytes > 0;
    return place(m_header.extendedBytes, "the extended header", extended)
        .and_then([&] { return place(m_header.faceInfoBytes, "the face infos", m_faceInfos); })
        .and_then([&] { return place(m_header.constantBytes, "the constants", m_constants); })
        .and_then([&] { return place(m_header.levelInfoBytes, "the level table", m_levelInfos); })
        .and_then([&] { return place(m_header.levelDataBytes, "the level data", m_levels); })
        .and_then([&] { return place(m_header.metadataZippedBytes, "the metadata", m_metadata); })
        .and_then([&] { return place(hasLarge ? 8 : 0, "the barrier", barrier); })
        .and_then([&] {
            return place(
                m_header.largeHeaderZippedBytes, "the table of large metadata", m_largeTable);
        })
        .and_then([&] {
            return place(hasLarge ? m_header.largeDataBytes : 0, "the large metadata", m_largeData);
        })
        .map([&] { m_end = end; });
}

Result<std::vector<std::byte>> PtxFile::bytes(Range range) const
{
    Buffer scratch;
    const auto view = m_source->view(range.offset, range.size, scratch);
    if (!view) {
        return tl::unexpected(view.error());
    }
    return std::vector<std::byte>(view->begin(), view->end());
}

Status PtxFile::unzip(Range zipped, std::span<std::byte> out, std::string_view what) const
{
    Buffer scratch;
    const auto view = m_source->view(zipped.offset, zipped.size, scratch);
    if (!view) {
        return tl::unexpected(view.error());
    }
    if (!Inflater().unzip(*view, out)) {
        return contentsError(std::string(what) + " at byte " + std::to_string(zipped.offset) +
                             " should unzip to " + std::to_string(out.size()) + " bytes, but " +
                             std::to_string(zipped.size) +
                             " zipped bytes are damaged or give another number");
    }
    return {};
}

Status checkPtxRatio(std::uint64_t zipped, std::uint64_t unzipped, std::string_view what)
{
    if (unzipped > zipped * Inflater::kMaxRatio) {
        return contentsError(std::string(what) + " should be " + std::to_string(unzipped) +
                             " bytes, which " + std::to_string(zipped) +
                             " zipped bytes cannot hold");
    }
    return {};
}

Status PtxFile::readFaceInfos(MemoryBudget& budget)
{
    const std::uint64_t size = std::uint64_t{m_header.faces} * sizeof(PtxFaceInfo);
    Status status = checkPtxRatio(m_faceInfos.size, size, "the face infos").and_then([&] {
        return budget.take(size, "the face infos");
    });
    if (!status) {
        return status;
    }
    m_infos.resize(m_header.faces);
    status = unzip(m_faceInfos, std::as_writable_bytes(std::span(m_infos)), "the face infos");
    if (!status) {
        return status;
    }
    for (std::uint32_t face = 0; face < m_header.faces; ++face) {
        PtxFaceInfo& info = m_infos[face];
        if (std::string why = faultOf(info, face, m_header.faces); !why.empty()) {
            return contentsError(std::move(why));
        }
        info.flags &= static_cast<std::uint8_t>(~PtxFaceInfo::kEdited);
    }
    return {};
}

Status PtxFile::readConstants(MemoryBudget& budget)
{
    const std::uint64_t size = std::uint64_t{m_header.faces} * m_format.texelBytes();
    Status status = checkPtxRatio(m_constants.size, size, "the constants").and_then([&] {
        return budget.take(size, "the constants");
    });
    if (!status) {
        return status;
    }
    m_constantValues.resize(size);
    return unzip(m_constants, m_constantValues, "the constants");
}

Status PtxFile::readLevels(MemoryBudget& budget)
{
    const auto table = bytes(m_levelInfos);
    if (!table) {
        return tl::unexpected(table.error());
    }
    ByteReader reader(*table);
    std::uint64_t offset = m_levels.offset;
    for (int reduction = 0; reduction < levelCount(); ++reduction) {
        const PtxLevelInfo info = reader.take<PtxLevelInfo>().value();
        if (info.dataBytes > m_levels.offset + m_levels.size - offset) {
            return contentsError("level " + std::to_string(reduction) +
                                 " should end inside the level data, but has " +
                                 std::to_string(info.dataBytes) + " bytes");
        }
        if (Status status = readLevel(info, reduction, offset, budget); !status) {
            return status;
        }
        offset += info.dataBytes;
    }
    return {};
}

Status PtxFile::readLevel(const PtxLevelInfo& info,
                          int reduction,
                          std::uint64_t offset,
                          MemoryBudget& budget)
{
    const std::string name = "level " + std::to_string(reduction);
    if (reduction == 0 ? info.faces != m_header.faces : info.faces > m_header.faces) {
        return contentsError(name + " lists " + std::to_string(info.faces) + " faces of " +
                             std::to_string(m_header.faces));
    }
    if (info.headerBytes > info.dataBytes) {
        return contentsError(name + " has a table of " + std::to_string(info.headerBytes) +
                             " bytes in " + std::to_string(info.dataBytes));
    }
    const std::string what = "the table of " + name;
    const std::uint64_t size = std::uint64_t{info.faces} * sizeof(PtxBlockHeader);
    LevelTable& table = m_tables.emplace_back();
    table.blocksBegin = offset + info.headerBytes;
    if (info.faces == 0) {
        return {};
    }
    Status status = checkPtxRatio(info.headerBytes, size, what).and_then([&] {
        return budget.take(3 * size, what);
    });
    if (!status) {
        return status;
    }
    table.headers.resize(info.faces);
    status =
        unzip({offset, info.headerBytes}, std::as_writable_bytes(std::span(table.headers)), what);
    if (!status) {
        return status;
    }
    table.offsets.resize(info.faces);
    const std::uint64_t end = offset + info.dataBytes;
    offset += info.headerBytes;
    for (std::size_t k = 0; k < info.faces; ++k) {
        table.offsets[k] = offset;
        if (table.headers[k].size() > end - offset) {
            return contentsError("block " + std::to_string(k) + " of " + name + " (" +
                                 std::to_string(table.headers[k].size()) +
                                 " bytes) ends beyond its level");
        }
        offset += table.headers[k].size();
    }
    return {};
}

// Reductions list the faces by falling resolution, equal ones by rising number. The order is that
// of the infos as stored, so it must be found before edits change them.
Status PtxFile::orderFaces(MemoryBudget& budget)
{
    if (levelCount() == 1) {
        return {};
    }
    if (Status status = budget.take(std::uint64_t{4} * m_header.faces, "the order of faces");
        !status) {
        return status;
    }
    std::array<std::uint32_t, Level::kMax + 1> next{};
    for (const PtxFaceInfo& info : m_infos) {
        for (std::size_t smaller = 0; smaller < orderKey(info); ++smaller) {
            ++next[smaller];
        }
    }
    m_places.resize(m_header.faces);
    for (std::size_t k = 0; k < m_infos.size(); ++k) {
        m_places[k] = next[orderKey(m_infos[k])]++;
    }
    return {};
}

const PtxFaceInfo& PtxFile::info(FaceId face) const
{
    check(indexOf(face) < m_infos.size(), "face exists");
    return m_infos[indexOf(face)];
}

std::span<const std::byte> PtxFile::constantValue(FaceId face) const
{
    check(indexOf(face) < m_infos.size(), "face exists");
    const std::size_t size = m_format.texelBytes();
    return std::span(m_constantValues).subspan(indexOf(face) * size, size);
}

std::optional<PtxBlock> PtxFile::block(FaceId face, int reduction) const
{
    const PtxFaceInfo& own = info(face);
    if (own.isConstant() || reduction < 0 || reduction >= levelCount() ||
        reduction > own.level().log2() || (reduction > 0 && own.isEdited())) {
        return std::nullopt;
    }
    const LevelTable& table = m_tables[static_cast<std::size_t>(reduction)];
    const std::size_t entry = reduction == 0 ? indexOf(face) : m_places[indexOf(face)];
    if (entry >= table.headers.size()) {
        return std::nullopt;
    }
    return PtxBlock{table.offsets[entry], table.headers[entry]};
}

std::uint64_t PtxFile::blocksBegin(int reduction) const
{
    check(reduction >= 0 && reduction < levelCount(), "a stored level");
    return m_tables[static_cast<std::size_t>(reduction)].blocksBegin;
}

Result<std::optional<FaceTexels>>
PtxFile::texels(FaceId face, int reduction, PtxDecoder& decoder) const
{
    const Level level = info(face).level().coarser(reduction);
    if (info(face).isConstant()) {
        return FaceTexels::constant(level, constantValue(face));
    }
    return decode(face, reduction, decoder).map([&](bool stored) {
        const std::size_t size = level.texelCount() * m_format.texelBytes();
        return stored ? std::optional(FaceTexels::full(
                            level, m_format.texelBytes(), decoder.texels.first(size)))
                      : std::nullopt;
    });
}

Result<bool> PtxFile::decode(FaceId face, int reduction, PtxDecoder& decoder) const
{
    if (!block(face, reduction)) {
        return false;
    }
    if (Status status = checkFaceSize(face, reduction); !status) {
        return tl::unexpected(status.error());
    }
    const std::size_t texels = info(face).level().coarser(reduction).texelCount();
    return decode(face, reduction, decoder, decoder.texels.first(texels * m_format.texelBytes()));
}

Result<bool>
PtxFile::decode(FaceId face, int reduction, PtxDecoder& decoder, std::span<std::byte> texels) const
{
    const std::optional<PtxBlock> place = block(face, reduction);
    if (!place) {
        return false;
    }
    const auto bytes = decoder.zipped[static_cast<std::size_t>(reduction)].view(
        *m_source, place->offset, place->header.size());
    if (!bytes) {
        return tl::unexpected(bytes.error());
    }
    const Level level = info(face).level().coarser(reduction);
    const std::string why = decodePtxBlock(m_format, level, place->header, *bytes, decoder, texels);
    return why.empty() ? Result<bool>(true) : blockError(face, reduction, why);
}

tl::unexpected<Error> PtxFile::blockError(FaceId face, int reduction, const std::string& why) const
{
    const std::string reduced =
        reduction > 0 ? ", reduced " + std::to_string(reduction) + " times," : std::string();
    return contentsError("the block of face " + std::to_string(indexOf(face)) + reduced +
                         " at byte " + std::to_string(block(face, reduction)->offset) + " " + why);
}

Status PtxFile::checkFaceSize(FaceId face, int reduction) const
{
    const std::uint64_t texels = info(face).level().coarser(reduction).texelCount();
    if (info(face).isConstant() || texels * m_format.texelBytes() < kMaxPtxFaceBytes) {
        return {};
    }
    return blockError(face, reduction, "has more texels than a .ptx can hold");
}

std::uint64_t PtxFile::texelBytes() const
{
    std::uint64_t texels = 0;
    for (const PtxFaceInfo& info : m_infos) {
        texels += info.isConstant() ? 1 : info.level().texelCount();
    }
    return texels * m_format.texelBytes();
}

} // namespace trixel
