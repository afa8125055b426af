// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/ptx_verify.h"

#include "core/io/ptx_file.h"
#include "core/io/ptx_metadata.h"
#include "core/mesh/shared_progress.h"
#include "core/texture/pinned_face.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <string>

namespace trixel {

namespace {

constexpr std::size_t kGrainFaces = 1024;

// Compares the faces of one file with what was meant; one per thread.
class FaceVerifier
{
public:
    FaceVerifier(const PtxFile& file, const TexelStore& meant)
        : m_file(file)
        , m_meant(meant)
    {
    }

    /// What is wrong with the face; empty if nothing.
    std::string faultOf(FaceId face)
    {
        const PinnedFace pin(m_meant.face(face));
        const FaceTexels& meant = *pin;
        if (m_file.info(face).isConstant()) {
            return meant == FaceTexels::constant(meant.level(), m_file.constantValue(face))
                       ? std::string()
                       : "has other texels";
        }
        if (std::string why = readBlock(face); !why.empty()) {
            return why;
        }
        if (!std::ranges::equal(m_decoder.texels.first(byteCount(meant.level())), meant.bytes())) {
            return "has other texels";
        }
        return {};
    }

private:
    std::size_t byteCount(Level level) const
    {
        return level.texelCount() * m_meant.format().texelBytes();
    }

    std::string readBlock(FaceId face)
    {
        const auto why = m_file.decode(face, 0, m_decoder);
        if (!why) {
            return why.error().message;
        }
        return *why ? std::string() : "lacks its texels";
    }

    const PtxFile& m_file;
    const TexelStore& m_meant;
    PtxDecoder m_decoder;
};

// The order may differ: a .ptx keeps large items after the small ones.
bool sameItems(std::span<const PtxMetadata> a, std::span<const PtxMetadata> b)
{
    const auto sorted = [](std::span<const PtxMetadata> items) {
        std::vector<const PtxMetadata*> order;
        for (const PtxMetadata& item : items) {
            order.push_back(&item);
        }
        std::ranges::sort(order, {}, [](const PtxMetadata* item) { return item->key; });
        return order;
    };
    // Byte by byte, so that a NaN equals itself.
    return std::ranges::equal(sorted(a), sorted(b), [](const auto* x, const auto* y) {
        return x->key == y->key && x->value.index() == y->value.index() &&
               valueBytes(*x) == valueBytes(*y);
    });
}

Status verifyStructure(const PtxFile& file,
                       const PtxContents& contents,
                       std::span<const PtxFaceInfo> infos,
                       std::span<const std::byte> constants)
{
    if (file.format() != contents.texels.format() || file.faceCount() != infos.size()) {
        return contentsError("the header differs");
    }
    for (std::size_t k = 0; k < infos.size(); ++k) {
        if (file.info(faceId(k)) != infos[k]) {
            return contentsError("the info of face " + std::to_string(k) + " differs");
        }
    }
    const std::size_t texelBytes = file.format().texelBytes();
    for (std::size_t k = 0; k < infos.size(); ++k) {
        if (!std::ranges::equal(file.constantValue(faceId(k)),
                                constants.subspan(k * texelBytes, texelBytes))) {
            return contentsError("the average of face " + std::to_string(k) + " differs");
        }
    }
    MemoryBudget budget(~std::uint64_t{0});
    return file.metadata(budget).and_then([&](const std::vector<PtxMetadata>& items) -> Status {
        return sameItems(items, contents.metadata) ? Status()
                                                   : contentsError("the metadata differ");
    });
}

Status
verifyFaces(const PtxFile& file, const TexelStore& meant, Threads threads, Progress& progress)
{
    const std::size_t count = meant.faceCount();
    // Few large faces are dealt out one by one.
    const std::size_t grain =
        std::clamp<std::size_t>(count / (std::size_t{16} * threads.count), 1, kGrainFaces);
    SharedProgress shared(progress, (count + grain - 1) / grain);
    std::mutex mutex;
    std::size_t firstFace = count;
    std::string firstWhy;
    std::atomic<std::size_t> next{0};
    parallelFor(threads.count, 1, threads, [&](std::size_t, std::size_t) {
        FaceVerifier verifier(file, meant);
        for (std::size_t begin = next.fetch_add(grain); begin < count && shared.goesOn();
             begin = next.fetch_add(grain)) {
            const std::size_t end = std::min(begin + grain, count);
            for (std::size_t k = begin; k < end; ++k) {
                std::string why = verifier.faultOf(faceId(k));
                if (!why.empty()) {
                    const std::scoped_lock lock(mutex);
                    if (k < firstFace) {
                        firstFace = k;
                        firstWhy = std::move(why);
                    }
                    break;
                }
            }
            shared.step();
        }
    });
    if (firstFace < count) {
        return contentsError("face " + std::to_string(firstFace) + ": " + firstWhy);
    }
    return shared.goesOn() ? Status() : Status(cancelled());
}

// The blocks of one reduction follow its table in the order in which they were packed.
Status verifyReduction(const PtxFile& file, const PtxFaces& packed, int reduction, Buffer& scratch)
{
    std::uint64_t offset = file.blocksBegin(reduction);
    Status status;
    packed.forEachBlocks(reduction, [&](const PtxBlocks& blocks) {
        if (!status) {
            return;
        }
        const auto written = file.source().view(offset, blocks.bytes.size(), scratch);
        if (!written) {
            status = tl::unexpected(written.error());
        } else if (!std::ranges::equal(*written, blocks.bytes)) {
            status = contentsError("the faces reduced " + std::to_string(reduction) +
                                   " times differ near byte " + std::to_string(offset));
        }
        offset += blocks.bytes.size();
    });
    return status;
}

Status verifyReductions(const PtxFile& file, const PtxFaces& packed)
{
    if (file.levelCount() != packed.levelCount) {
        return contentsError("the number of levels differs");
    }
    Buffer scratch;
    for (int reduction = 1; reduction < packed.levelCount; ++reduction) {
        if (Status status = verifyReduction(file, packed, reduction, scratch); !status) {
            return status;
        }
    }
    return {};
}

} // namespace

Status verifyPtx(const std::filesystem::path& written,
                 const PtxContents& contents,
                 const PtxFaces& packed,
                 Threads threads,
                 Progress& progress)
{
    auto source = fileSource(written);
    if (!source) {
        return tl::unexpected(source.error());
    }
    MemoryBudget budget(~std::uint64_t{0}); // the file is our own
    const auto file = PtxFile::open(std::move(*source), budget);
    if (!file) {
        return tl::unexpected(file.error());
    }
    return verifyStructure(*file, contents, packed.infos, packed.constants)
        .and_then([&] { return verifyReductions(*file, packed); })
        .and_then([&] { return verifyFaces(*file, contents.texels, threads, progress); });
}

} // namespace trixel
