// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/texel_search.h"

#include "core/base/check.h"
#include "core/texture/pinned_face.h"

#include <algorithm>
#include <vector>

namespace trixel {

namespace {

constexpr std::size_t kBatchValues = 8192;

std::size_t texelsOf(const FaceTexels& face)
{
    return face.isConstant() ? 1 : face.level().texelCount();
}

/// Looks through texels in [first, end) of a face, a batch at a time.
class Search
{
public:
    Search(const TexelFormat& format, const TexelTest& test)
        : m_format(format)
        , m_test(test)
        , m_batch(std::max<std::size_t>(1, kBatchValues / format.channels))
        , m_values(m_batch * format.channels)
    {
    }

    std::optional<std::size_t> first(const FaceTexels& face, std::size_t begin, std::size_t end)
    {
        for (std::size_t at = begin; at < end; at += m_batch) {
            const std::size_t count = std::min(m_batch, end - at);
            const auto values = std::span(m_values).first(count * m_format.channels);
            const std::size_t bytes = face.texelBytes();
            decode(m_format.type, face.bytes().subspan(at * bytes, count * bytes), values);
            if (const auto found = m_test(values)) {
                return at + *found;
            }
        }
        return std::nullopt;
    }

private:
    const TexelFormat& m_format;
    const TexelTest& m_test;
    std::size_t m_batch;
    std::vector<float> m_values;
};

} // namespace

Result<std::optional<TexelSpot>> nextTexel(const TexelStore& store,
                                           std::optional<TexelSpot> after,
                                           const TexelTest& test,
                                           Progress& progress)
{
    const std::size_t faces = store.faceCount();
    if (faces == 0) {
        return std::nullopt;
    }
    const std::size_t start = after ? indexOf(after->face) : 0;
    check(start < faces, "a face of the store");
    const FaceTexels& startFace = store.face(faceId(start));
    check(!after || indexOf(after->index) < startFace.level().texelCount(), "a texel of the face");
    const std::size_t passed = after ? startFace.isConstant() ? 1 : indexOf(after->index) + 1 : 0;
    Search search(store.format(), test);
    // The face begun with comes twice: what follows `after` first, what is before it last.
    for (std::size_t k = 0; k <= faces; ++k) {
        if (k % 256 == 0 && !progress.report(static_cast<double>(k) / static_cast<double>(faces))) {
            return cancelled();
        }
        const std::size_t f = (start + k) % faces;
        const PinnedFace pin(store.face(faceId(f)));
        const FaceTexels& face = *pin;
        const std::size_t begin = k == 0 ? passed : 0;
        const std::size_t end = k == faces ? passed : texelsOf(face);
        if (const auto found = search.first(face, begin, end)) {
            return TexelSpot{faceId(f), static_cast<TexelIndex>(*found)};
        }
    }
    return std::nullopt;
}

} // namespace trixel
