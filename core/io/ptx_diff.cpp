// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/ptx_diff.h"

#include "core/io/ptx_file.h"
#include "core/io/ptx_metadata.h"
#include "core/io/ptx_reader.h"
#include "core/mesh/shared_progress.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>
#include <optional>
#include <unordered_map>

namespace trixel {

namespace {

constexpr std::size_t kGrainFaces = 512;

double distance(float a, float b)
{
    if (a == b || (std::isnan(a) && std::isnan(b))) {
        return 0;
    }
    const double difference = std::abs(double{a} - double{b});
    return std::isnan(difference) ? std::numeric_limits<double>::infinity() : difference;
}

std::vector<float> valuesOf(TexelType type, FaceTexels face)
{
    const std::span<const std::byte> bytes = face.writable(); // spreads out a constant face
    std::vector<float> values(bytes.size() / byteSize(type));
    decode(type, bytes, values);
    return values;
}

// Compares one face after the other; one per thread.
class FaceComparer
{
public:
    FaceComparer(const PtxFile& a, const PtxFile& b)
        : m_a(a)
        , m_b(b)
    {
    }

    Result<std::optional<PtxFaceDifference>> compare(FaceId face)
    {
        PtxFaceDifference difference{
            .face = face, .levelOfA = m_a.info(face).level(), .levelOfB = m_b.info(face).level()};
        if (difference.levelOfA != difference.levelOfB) {
            return difference;
        }
        const auto a = m_a.texels(face, 0, m_decoderA);
        const auto b = m_b.texels(face, 0, m_decoderB);
        if (!a || !b) {
            return tl::unexpected(a ? b.error() : a.error());
        }
        if (m_a.format().type == m_b.format().type && **a == **b) {
            return std::nullopt;
        }
        measure(valuesOf(m_a.format().type, **a), valuesOf(m_b.format().type, **b), difference);
        return difference.texels > 0 ? std::optional(difference) : std::nullopt;
    }

private:
    void measure(const std::vector<float>& a,
                 const std::vector<float>& b,
                 PtxFaceDifference& difference) const
    {
        const std::size_t channels = m_a.format().channels;
        double squares = 0;
        for (std::size_t t = 0; t < a.size(); t += channels) {
            double largest = 0;
            for (std::size_t c = t; c < t + channels; ++c) {
                const double d = distance(a[c], b[c]);
                largest = std::max(largest, d);
                squares += d * d;
            }
            difference.texels += largest > 0 ? 1 : 0;
            difference.maxAbs = std::max(difference.maxAbs, largest);
        }
        difference.rms = std::sqrt(squares / static_cast<double>(a.size()));
    }

    const PtxFile& m_a;
    const PtxFile& m_b;
    PtxDecoder m_decoderA;
    PtxDecoder m_decoderB;
};

std::string incomparable(const PtxFile& a, const PtxFile& b)
{
    if (a.faceCount() != b.faceCount()) {
        return "the first has " + std::to_string(a.faceCount()) + " faces, the second " +
               std::to_string(b.faceCount());
    }
    if (a.format().channels != b.format().channels) {
        return "the first has " + std::to_string(a.format().channels) + " channels, the second " +
               std::to_string(b.format().channels);
    }
    return {};
}

std::string alphaName(const TexelFormat& format)
{
    return format.alpha ? "channel " + std::to_string(*format.alpha) : std::string("no channel");
}

void noteFormats(const PtxFile& a, const PtxFile& b, std::vector<std::string>& notes)
{
    if (a.format().type != b.format().type) {
        notes.push_back("the first stores " + std::string(nameOf(a.format().type)) +
                        ", the second " + std::string(nameOf(b.format().type)));
    }
    if (a.format().alpha != b.format().alpha) {
        notes.push_back("the first has " + alphaName(a.format()) + " as alpha, the second " +
                        alphaName(b.format()));
    }
    if (a.levelCount() != b.levelCount()) {
        notes.push_back("the first stores " + std::to_string(a.levelCount()) +
                        " levels, the second " + std::to_string(b.levelCount()));
    }
}

bool sameLinks(const PtxFaceInfo& a, const PtxFaceInfo& b)
{
    for (std::size_t edge = 0; edge < 3; ++edge) {
        if (a.adjacentFaces[edge] != b.adjacentFaces[edge] ||
            (a.adjacentFaces[edge] >= 0 && a.adjacentEdge(edge) != b.adjacentEdge(edge))) {
            return false;
        }
    }
    return true;
}

void noteLinks(const PtxFile& a, const PtxFile& b, std::vector<std::string>& notes)
{
    std::size_t count = 0;
    std::size_t first = 0;
    for (std::size_t face = a.faceCount(); face-- > 0;) {
        if (!sameLinks(a.infos()[face], b.infos()[face])) {
            ++count;
            first = face;
        }
    }
    if (count > 0) {
        notes.push_back(std::to_string(count) + " faces have other neighbours, the first is face " +
                        std::to_string(first));
    }
}

void noteMetadata(std::span<const PtxMetadata> a,
                  std::span<const PtxMetadata> b,
                  std::vector<std::string>& notes)
{
    std::unordered_map<std::string, const PtxMetadata*> rest;
    for (const PtxMetadata& item : b) {
        rest.emplace(item.key, &item);
    }
    for (const PtxMetadata& item : a) {
        const auto found = rest.find(item.key);
        if (found == rest.end()) {
            notes.push_back("only the first has the metadata \"" + item.key + "\"");
            continue;
        }
        if (item.value.index() != found->second->value.index() ||
            valueBytes(item) != valueBytes(*found->second)) {
            notes.push_back("the metadata \"" + item.key + "\" differ");
        }
        rest.erase(found);
    }
    for (const PtxMetadata& item : b) { // not from the map: its order is nobody's
        if (rest.contains(item.key)) {
            notes.push_back("only the second has the metadata \"" + item.key + "\"");
        }
    }
}

struct Comparison
{
    std::mutex mutex;
    std::vector<PtxFaceDifference> faces;
    std::optional<Error> error;
};

void compareRange(FaceComparer& comparer, std::size_t begin, std::size_t end, Comparison& all)
{
    for (std::size_t face = begin; face < end; ++face) {
        const auto difference = comparer.compare(faceId(face));
        if (difference && !*difference) {
            continue;
        }
        const std::scoped_lock lock(all.mutex);
        if (!difference) {
            all.error = difference.error();
            return;
        }
        all.faces.push_back(**difference);
    }
}

void sumUp(const PtxFile& file, PtxDiff& diff)
{
    std::uint64_t texels = 0; // of faces of equal level
    for (const PtxFaceInfo& info : file.infos()) {
        texels += info.level().texelCount();
    }
    double squares = 0; // over texels, a mean over channels each
    for (const PtxFaceDifference& face : diff.faces) {
        if (face.levelOfA != face.levelOfB) {
            ++diff.levelDifferences;
            texels -= face.levelOfA.texelCount();
        } else {
            diff.texels += face.texels;
            diff.maxAbs = std::max(diff.maxAbs, face.maxAbs);
            squares += face.rms * face.rms * face.levelOfA.texelCount();
        }
    }
    diff.rms = texels > 0 ? std::sqrt(squares / static_cast<double>(texels)) : 0;
}

Status compareFaces(const PtxFile& a, const PtxFile& b, Progress& progress, PtxDiff& diff)
{
    const std::size_t count = a.faceCount();
    const Threads threads = Threads::all();
    const std::size_t grain =
        std::clamp<std::size_t>(count / (std::size_t{16} * threads.count), 1, kGrainFaces);
    Comparison all;
    SharedProgress shared(progress, (count + grain - 1) / grain);
    std::atomic<std::size_t> next{0};
    parallelFor(threads.count, 1, threads, [&](std::size_t, std::size_t) {
        FaceComparer comparer(a, b);
        for (std::size_t begin = next.fetch_add(grain); begin < count && shared.goesOn();
             begin = next.fetch_add(grain)) {
            compareRange(comparer, begin, std::min(begin + grain, count), all);
            shared.step();
        }
    });
    if (!shared.goesOn()) {
        return cancelled();
    }
    if (all.error) {
        return tl::unexpected(*all.error);
    }
    diff.faces = std::move(all.faces);
    std::ranges::sort(diff.faces, {}, &PtxFaceDifference::face);
    sumUp(a, diff);
    return {};
}

} // namespace

Result<PtxDiff>
diffPtx(const std::filesystem::path& a, const std::filesystem::path& b, Progress& progress)
{
    MemoryBudget budget;
    const auto fileA = openPtxFile(a, budget);
    if (!fileA) {
        return tl::unexpected(fileA.error());
    }
    const auto fileB = openPtxFile(b, budget);
    if (!fileB) {
        return tl::unexpected(fileB.error());
    }
    PtxDiff diff;
    diff.incomparable = incomparable(*fileA, *fileB);
    if (!diff.incomparable.empty()) {
        return diff;
    }
    const auto metadataA = fileA->metadata(budget);
    if (!metadataA) {
        return prefixed(a.string(), metadataA.error());
    }
    const auto metadataB = fileB->metadata(budget);
    if (!metadataB) {
        return prefixed(b.string(), metadataB.error());
    }
    noteFormats(*fileA, *fileB, diff.notes);
    noteLinks(*fileA, *fileB, diff.notes);
    noteMetadata(*metadataA, *metadataB, diff.notes);
    if (Status status = compareFaces(*fileA, *fileB, progress, diff); !status) {
        return status.error().kind == ErrorKind::Cancelled
                   ? tl::unexpected(status.error())
                   : prefixed(a.string() + " or " + b.string(), status.error());
    }
    return diff;
}

} // namespace trixel
