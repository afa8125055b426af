// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/ptx_reader.h"

#include <algorithm>
#include <mutex>

namespace trixel {

namespace {

constexpr std::size_t kBatchFaces = 16384;
// Texels decoded before they are handed on; large faces make small batches.
constexpr std::uint64_t kBatchBytes = std::uint64_t{64} << 20U;
constexpr std::size_t kGrainFaces = 256;
// A face in memory, beside its texels.
constexpr std::uint64_t kFaceBytes = 96;

std::size_t batchEnd(const PtxFile& file, std::size_t begin)
{
    std::uint64_t bytes = 0;
    std::size_t end = begin;
    while (end < file.faceCount() && end - begin < kBatchFaces && bytes < kBatchBytes) {
        const PtxFaceInfo& info = file.info(faceId(end++));
        bytes += info.isConstant() ? 0 : info.level().texelCount() * file.format().texelBytes();
    }
    return end;
}

// The first error by face number, whatever the order in which threads met them.
class FirstError
{
public:
    void note(std::size_t face, const Error& error)
    {
        const std::scoped_lock lock(m_mutex);
        if (!m_error || face < m_face) {
            m_face = face;
            m_error = error;
        }
    }
    const std::optional<Error>& error() const { return m_error; }

private:
    std::mutex m_mutex;
    std::size_t m_face = 0;
    std::optional<Error> m_error;
};

std::size_t grainFor(std::size_t faces, Threads threads)
{
    const std::size_t share = faces / (std::size_t{4} * std::max(1U, threads.count));
    return std::clamp<std::size_t>(share, 1, kGrainFaces);
}

bool isSymmetric(const PtxFile& file, std::size_t face, std::size_t edge)
{
    const PtxFaceInfo& own = file.info(faceId(face));
    const auto other = static_cast<std::size_t>(own.adjacentFaces[edge]);
    const auto otherEdge = static_cast<std::size_t>(own.adjacentEdge(edge));
    if (other == face && otherEdge == edge) {
        return false; // an edge is not its own neighbour
    }
    const PtxFaceInfo& back = file.info(faceId(other));
    return back.adjacentFaces[otherEdge] == static_cast<std::int32_t>(face) &&
           back.adjacentEdge(otherEdge) == static_cast<int>(edge);
}

} // namespace

Status
decodePtxFaces(const PtxFile& file,
               int reduction,
               Threads threads,
               Progress& progress,
               const std::function<void(FaceId first, std::span<std::optional<FaceTexels>>)>& visit)
{
    std::vector<std::optional<FaceTexels>> batch;
    for (std::size_t begin = 0; begin < file.faceCount();) {
        const std::size_t end = batchEnd(file, begin);
        batch.assign(end - begin, std::nullopt);
        FirstError firstError;
        const auto decodeRange = [&](std::size_t from, std::size_t to) {
            PtxDecoder decoder;
            for (std::size_t k = from; k < to; ++k) {
                auto texels = file.texels(faceId(begin + k), reduction, decoder);
                if (!texels) {
                    return firstError.note(begin + k, texels.error());
                }
                batch[k] = std::move(*texels);
            }
        };
        parallelFor(batch.size(), grainFor(batch.size(), threads), threads, decodeRange);
        if (firstError.error()) {
            return tl::unexpected(*firstError.error());
        }
        visit(faceId(begin), batch);
        begin = end;
        if (!progress.report(static_cast<double>(begin) / file.faceCount())) {
            return cancelled();
        }
    }
    return {};
}

Adjacency adjacencyOf(const PtxFile& file)
{
    Adjacency adjacency(file.faceCount());
    for (std::size_t face = 0; face < file.faceCount(); ++face) {
        const PtxFaceInfo& info = file.info(faceId(face));
        for (std::size_t edge = 0; edge < 3; ++edge) {
            if (info.adjacentFaces[edge] >= 0 && isSymmetric(file, face, edge)) {
                adjacency.connect(faceId(face),
                                  static_cast<LocalEdge>(edge),
                                  faceId(static_cast<std::size_t>(info.adjacentFaces[edge])),
                                  static_cast<LocalEdge>(info.adjacentEdge(edge)));
            }
        }
    }
    return adjacency;
}

Result<TexelStore> readTexels(const PtxFile& file, MemoryBudget& budget, Progress& progress)
{
    Status status = budget.take(file.texelBytes() + kFaceBytes * file.faceCount(), "the texels");
    if (!status) {
        return tl::unexpected(status.error());
    }
    const std::vector<std::byte> zero(file.format().texelBytes());
    TexelStore store(file.faceCount(), file.format(), Level(), zero);
    FaceTexels previous = store.face(FaceId{});
    const auto keep = [&](FaceId first, std::span<std::optional<FaceTexels>> faces) {
        for (std::size_t k = 0; k < faces.size(); ++k) {
            FaceTexels texels = faces[k]->collapsed();
            if (texels.isConstant() && previous.isConstant() && texels == previous) {
                texels = previous;
            } else {
                previous = texels;
            }
            store.exchange(faceId(indexOf(first) + k), std::move(texels));
        }
    };
    status = decodePtxFaces(file, 0, Threads::all(), progress, keep);
    if (!status) {
        return tl::unexpected(status.error());
    }
    return store;
}

Result<PtxContents> readContents(const PtxFile& file, MemoryBudget& budget, Progress& progress)
{
    PtxContents contents;
    auto metadata = file.metadata(budget);
    if (!metadata) {
        return tl::unexpected(metadata.error());
    }
    contents.metadata = std::move(*metadata);
    contents.hasMips = file.levelCount() > 1;
    contents.adjacency = adjacencyOf(file);
    auto texels = readTexels(file, budget, progress);
    if (!texels) {
        return tl::unexpected(texels.error());
    }
    contents.texels = std::move(*texels);
    return contents;
}

Result<PtxContents> parsePtx(std::string_view bytes, Progress& progress)
{
    MemoryBudget budget;
    auto file = PtxFile::open(memorySource(bytes), budget);
    return file ? readContents(*file, budget, progress) : tl::unexpected(file.error());
}

Result<PtxFile> openPtxFile(const std::filesystem::path& path, MemoryBudget& budget)
{
    auto source = fileSource(path);
    if (!source) {
        return tl::unexpected(source.error());
    }
    auto file = PtxFile::open(std::move(*source), budget);
    if (!file && file.error().kind == ErrorKind::Contents) {
        return prefixed(path.string(), file.error());
    }
    return file;
}

Result<PtxContents> readPtx(const std::filesystem::path& path, Progress& progress)
{
    MemoryBudget budget;
    const auto file = openPtxFile(path, budget);
    if (!file) {
        return tl::unexpected(file.error());
    }
    auto contents = readContents(*file, budget, progress);
    if (!contents && contents.error().kind == ErrorKind::Contents) {
        return prefixed(path.string(), contents.error());
    }
    return contents;
}

} // namespace trixel
