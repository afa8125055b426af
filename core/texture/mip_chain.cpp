// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/mip_chain.h"

#include "core/base/check.h"
#include "core/texture/texel_codec.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace trixel {

namespace {

/// The work of all reductions together is 4/3 of the first.
double doneAfter(int reductions)
{
    return 1.0 - std::pow(0.25, reductions);
}

} // namespace

Result<MipChain>
MipChain::build(const TexelFormat& format, FaceTexels face, ReductionRule rule, Progress& progress)
{
    MipChain chain;
    chain.m_levels.push_back(std::move(face));
    while (chain.m_levels.back().level().log2() > 0) {
        if (!progress.report(doneAfter(static_cast<int>(chain.m_levels.size()) - 1))) {
            return cancelled();
        }
        chain.m_levels.push_back(reduced(format, chain.m_levels.back(), rule));
    }
    return chain;
}

const FaceTexels& MipChain::at(Level level) const
{
    check(!m_levels.empty() && level <= base(), "a level that the face has");
    return m_levels[static_cast<std::size_t>(base().log2() - level.log2())];
}

std::uint64_t MipChain::madeBytes() const
{
    std::uint64_t bytes = 0;
    for (std::size_t k = 1; k < m_levels.size(); ++k) {
        bytes += m_levels[k].isConstant() ? 0 : m_levels[k].byteCount();
    }
    return bytes;
}

TexelDifference
differenceBetween(const TexelFormat& format, const FaceTexels& a, const FaceTexels& b)
{
    check(a.level() == b.level() && a.texelBytes() == format.texelBytes() &&
              b.texelBytes() == format.texelBytes(),
          "one level in the format");
    if (a.sharesBytesWith(b)) {
        return {};
    }
    const std::size_t channels = format.channels;
    const std::size_t count = a.level().texelCount() * channels;
    return withTexelType(format.type, [&](auto type) {
        using Codec = TexelCodec<decltype(type)::value>;
        using Stored = typename Codec::Stored;
        const auto valueOf = [channels](const FaceTexels& face, std::size_t k) {
            const std::size_t at = face.isConstant() ? k % channels : k;
            return static_cast<double>(Codec::decoded(loadStored<Stored>(face.bytes().data(), at)));
        };
        double worst = 0;
        double squares = 0;
        std::size_t counted = 0;
        for (std::size_t k = 0; k < count; ++k) {
            const double apart = std::abs(valueOf(a, k) - valueOf(b, k));
            if (std::isfinite(apart)) {
                worst = std::max(worst, apart);
                squares += apart * apart;
                ++counted;
            }
        }
        return TexelDifference{worst,
                               counted > 0 ? std::sqrt(squares / static_cast<double>(counted)) : 0};
    });
}

} // namespace trixel
