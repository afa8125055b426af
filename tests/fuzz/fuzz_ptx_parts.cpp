// SPDX-License-Identifier: GPL-3.0-or-later
//
// Any bytes as the parts of a .ptx before they are zipped: checksums keep mutations of a whole file
// from ever reaching what lies behind them.
#include "core/io/deflate.h"
#include "tests/fuzz/ptx_target.h"

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

namespace {

using namespace trixel;

// Takes parts off the front of the input, each behind a length of 16 bits.
class Parts
{
public:
    Parts(const std::uint8_t* data, std::size_t size)
        : m_bytes(std::as_bytes(std::span(data, size)))
    {
    }

    std::span<const std::byte> next()
    {
        std::uint16_t length = 0;
        take(&length, sizeof(length));
        const auto part = m_bytes.first(std::min<std::size_t>(length, m_bytes.size()));
        m_bytes = m_bytes.subspan(part.size());
        return part;
    }

    void take(void* to, std::size_t size)
    {
        size = std::min(size, m_bytes.size());
        if (size == 0) {
            return;
        }
        std::memcpy(to, m_bytes.data(), size);
        m_bytes = m_bytes.subspan(size);
    }

private:
    std::span<const std::byte> m_bytes;
};

std::string zipped(Deflater& deflater, std::span<const std::byte> bytes)
{
    const auto stream = deflater.zip(bytes);
    return {reinterpret_cast<const char*>(stream.data()), stream.size()};
}

std::string plain(std::span<const std::byte> bytes)
{
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static Deflater deflater(1);
    Parts parts(data, size);
    std::uint8_t faces = 0;
    std::uint8_t levels = 0;
    std::uint8_t channels = 0;
    std::uint8_t type = 0;
    parts.take(&faces, 1);
    parts.take(&levels, 1);
    parts.take(&channels, 1);
    parts.take(&type, 1);
    PtxHeader header;
    header.faces = faces % 16 + 1U;
    header.levels = static_cast<std::uint16_t>(levels % 4 + 1);
    header.channels = static_cast<std::uint16_t>(channels % 5 + 1);
    header.dataType = type % 4U;
    header.levelInfoBytes = static_cast<std::uint32_t>(header.levels * sizeof(PtxLevelInfo));

    std::vector<std::byte> infos(header.faces * sizeof(PtxFaceInfo));
    std::vector<std::byte> constants(header.faces * formatOf(header).texelBytes());
    parts.take(infos.data(), infos.size());
    parts.take(constants.data(), constants.size());
    const std::string infoStream = zipped(deflater, infos);
    const std::string constantStream = zipped(deflater, constants);
    header.faceInfoBytes = static_cast<std::uint32_t>(infoStream.size());
    header.constantBytes = static_cast<std::uint32_t>(constantStream.size());

    std::string levelInfos;
    std::string levelData;
    for (int level = 0; level < header.levels; ++level) {
        std::vector<std::byte> table((level == 0 ? header.faces : header.faces / 2) * 4);
        parts.take(table.data(), table.size());
        const std::string tableStream = zipped(deflater, table);
        // Blocks come zipped or as they are, so that tile tables can be written by hand too.
        const auto block = parts.next();
        std::uint8_t zip = 0;
        parts.take(&zip, 1);
        const std::string blocks = zip % 2 == 0 ? plain(block) : zipped(deflater, block);
        const PtxLevelInfo info{tableStream.size() + blocks.size(),
                                static_cast<std::uint32_t>(tableStream.size()),
                                static_cast<std::uint32_t>(table.size() / 4)};
        levelInfos.append(reinterpret_cast<const char*>(&info), sizeof(info));
        levelData += tableStream + blocks;
    }
    header.levelDataBytes = levelData.size();

    const auto metadata = parts.next();
    const auto largeTable = parts.next();
    const std::string metadataStream = zipped(deflater, metadata);
    const std::string largeTableStream = zipped(deflater, largeTable);
    const std::string largeData = zipped(deflater, parts.next());
    const std::string edits = plain(parts.next());
    header.metadataBytes = static_cast<std::uint32_t>(metadata.size());
    header.metadataZippedBytes = static_cast<std::uint32_t>(metadataStream.size());
    header.largeHeaderBytes = static_cast<std::uint32_t>(largeTable.size());
    header.largeHeaderZippedBytes = static_cast<std::uint32_t>(largeTableStream.size());
    header.largeDataBytes = largeData.size();
    std::string rest = infoStream + constantStream + levelInfos + levelData + metadataStream +
                       std::string(8, '\0') + largeTableStream + largeData;
    header.editOffset = PtxHeader::kBytes + PtxHeader::kExtendedBytes + rest.size();
    header.editBytes = edits.size();
    readAllOfPtx(plain(bytesOf(header)) + rest + edits);
    return 0;
}
