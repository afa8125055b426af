// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/rearranged_faces.h"

#include "core/base/check.h"

#include <algorithm>
#include <cstring>
#include <utility>
#include <vector>

namespace trixel {

namespace {

constexpr std::size_t kFacesAtOnce = 4096;
constexpr std::size_t kGrain = 16;

} // namespace

FaceTexels inOrder(const FaceTexels& other, const CornerOrder& order)
{
    if (other.isConstant() || order == kSameCorners) {
        return other;
    }
    const Level level = other.level();
    const std::size_t bytes = other.texelBytes();
    const FaceTexels source = other.pinned();
    FaceTexels result = source;
    const std::span<const std::byte> from = source.bytes();
    const std::span<std::byte> to = result.writable(); // a copy: the source holds the bytes too
    for (std::uint32_t k = 0; k < level.texelCount(); ++k) {
        const TexelCoord there = texelInOrder(level, texelAt(level, TexelIndex(k)), order);
        std::memcpy(
            to.data() + k * bytes, from.data() + indexOf(texelIndex(level, there)) * bytes, bytes);
    }
    return result;
}

Result<TexelStore>
rearranged(const TexelStore& other, const FaceMatch& match, Threads threads, Progress& progress)
{
    const auto faceCount = static_cast<std::uint32_t>(match.size());
    check(
        std::ranges::all_of(
            match, [&](const MatchedFace& face) { return indexOf(face.face) < other.faceCount(); }),
        "faces of the other store");
    const std::vector<std::byte> fill(other.format().texelBytes());
    TexelStore result(faceCount, other.format(), Level(), fill);
    std::vector<FaceTexels> some;
    for (std::size_t first = 0; first < faceCount; first += kFacesAtOnce) {
        if (!progress.report(static_cast<double>(first) / faceCount)) {
            return cancelled();
        }
        some.assign(std::min<std::size_t>(kFacesAtOnce, faceCount - first), {});
        parallelFor(some.size(), kGrain, threads, [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k) {
                const MatchedFace& from = match[first + k];
                some[k] = inOrder(other.face(from.face), from.corners);
            }
        });
        for (std::size_t k = 0; k < some.size(); ++k) {
            result.exchange(faceId(first + k), std::move(some[k]));
        }
    }
    if (const Status whole = other.checkWhole(); !whole) {
        return tl::unexpected(whole.error());
    }
    return progress.report(1) ? Result<TexelStore>(std::move(result)) : cancelled();
}

} // namespace trixel
