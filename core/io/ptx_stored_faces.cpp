// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/ptx_stored_faces.h"

#include "core/io/ptx_average.h"
#include "core/io/ptx_reader.h"

#include <algorithm>
#include <utility>

namespace trixel {

namespace {

// What a stored face takes in memory before it is read, beside its place in the file.
constexpr std::uint64_t kFaceBytes = 192;
// A decoder that worked on larger faces is not kept: its memory is several times the face's.
constexpr std::size_t kMostKeptBytes = std::size_t{4} << 20U;

} // namespace

PtxFaceReader::PtxFaceReader(PtxFile file, std::string name)
    : m_file(std::move(file))
    , m_name(std::move(name))
{
}

std::unique_ptr<PtxDecoder> PtxFaceReader::takeDecoder() const
{
    const std::scoped_lock lock(m_mutex);
    if (m_decoders.empty()) {
        return std::make_unique<PtxDecoder>();
    }
    auto decoder = std::move(m_decoders.back());
    m_decoders.pop_back();
    return decoder;
}

void PtxFaceReader::giveBack(std::unique_ptr<PtxDecoder> decoder, std::size_t used) const
{
    if (used <= kMostKeptBytes) {
        const std::scoped_lock lock(m_mutex);
        m_decoders.push_back(std::move(decoder));
    }
}

Result<bool> PtxFaceReader::read(FaceId face, Level level, std::span<std::byte> texels) const
{
    const int reduction = m_file.info(face).level().log2() - level.log2();
    std::unique_ptr<PtxDecoder> decoder = takeDecoder();
    Result<bool> found = m_file.decode(face, reduction, *decoder, texels);
    giveBack(std::move(decoder), texels.size());
    // Asked last: damage may come of the change, and texels from a changed file are not to be
    // trusted even if they unzip.
    if (Status status = m_file.source().checkUnchanged(); !status) {
        return tl::unexpected(status.error());
    }
    if (!found && found.error().kind == ErrorKind::Contents) {
        return prefixed(m_name, found.error());
    }
    if (found && *found && reduction > 0) {
        unpremultiply(m_file.format(), texels);
    }
    return found;
}

bool PtxFaceReader::stores(FaceId face, Level level) const
{
    return m_file.block(face, m_file.info(face).level().log2() - level.log2()).has_value();
}

std::span<const std::byte> PtxFaceReader::mean(FaceId face) const
{
    return m_file.constantValue(face);
}

namespace {

Result<OpenedTexels> storedTexels(PtxFile file, const std::string& name, const OpenOptions& options)
{
    const std::uint32_t count = file.faceCount();
    const TexelFormat format = file.format();
    const std::vector<std::byte> zero(format.texelBytes());
    TexelStore store(count, format, Level(), zero);
    // Equal constant faces in a row share their value.
    FaceTexels previous = FaceTexels::constant(Level(), zero);
    for (std::uint32_t k = 0; k < count; ++k) {
        if (Status status = file.checkFaceSize(faceId(k)); !status) {
            return tl::unexpected(status.error());
        }
        if (file.info(faceId(k)).isConstant()) {
            const auto value = file.constantValue(faceId(k));
            const Level level = file.info(faceId(k)).level();
            previous = std::ranges::equal(value, previous.bytes())
                           ? previous.atLevel(level)
                           : FaceTexels::constant(level, value);
            store.exchange(faceId(k), previous);
        }
    }
    const std::vector<PtxFaceInfo> infos(file.infos().begin(), file.infos().end());
    auto faces = StoredFaces::make(
        format, std::make_unique<PtxFaceReader>(std::move(file), name), options.cacheBytes);
    for (std::uint32_t k = 0; k < count; ++k) {
        if (!infos[k].isConstant()) {
            store.exchange(faceId(k), faces->face(faceId(k), infos[k].level()));
        }
    }
    return OpenedTexels{std::move(store), std::move(faces)};
}

} // namespace

Result<OpenedTexels> openTexels(PtxFile file,
                                const std::string& name,
                                const OpenOptions& options,
                                MemoryBudget& budget,
                                Progress& progress)
{
    if (file.texelBytes() > options.wholeBytes) {
        return budget.take(kFaceBytes * file.faceCount(), "the faces").and_then([&] {
            return storedTexels(std::move(file), name, options);
        });
    }
    return readTexels(file, budget, progress).map([](TexelStore&& texels) {
        return OpenedTexels{std::move(texels), nullptr};
    });
}

} // namespace trixel
