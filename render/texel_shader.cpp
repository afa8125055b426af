// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/texel_shader.h"

#include "core/base/check.h"

#include <algorithm>

namespace trixel::render {

namespace {

constexpr std::size_t kBytes = 256;
constexpr std::size_t kBatchValues = 4096;

} // namespace

TexelShader::TexelShader(const TexelFormat& format, const Look& look)
    : m_format(format)
    , m_rule(LookRule::of(format, look))
{
    if (format.type != TexelType::UInt8) {
        return;
    }
    const bool isNumber = m_rule.kind != LookRule::Kind::Colors;
    if (isNumber && m_rule.number != LookRule::kLuminance) {
        const TexelFormat single{TexelType::UInt8, 1, {}};
        Look alone = look;
        alone.channel = 0;
        m_numbers.resize(kBytes);
        for (std::size_t b = 0; b < kBytes; ++b) {
            const float value = static_cast<float>(b) / 255.0F;
            m_numbers[b] = shade(single, {&value, 1}, alone);
        }
    } else if (!isNumber && !m_rule.marks) {
        const TexelFormat single{TexelType::UInt8, 1, {}};
        m_levels.resize(kBytes);
        for (std::size_t b = 0; b < kBytes; ++b) {
            const float value = static_cast<float>(b) / 255.0F;
            m_levels[b] = shade(single, {&value, 1}, look)[0];
        }
    }
}

Rgba TexelShader::operator()(std::span<const float> values) const
{
    check(values.size() == m_format.channels, "a value a channel");
    return shade(m_rule, values);
}

void TexelShader::operator()(std::span<const std::byte> texels, std::span<Rgba> colors) const
{
    check(texels.size() == colors.size() * m_format.texelBytes(), "a colour a texel");
    if (m_numbers.empty() && m_levels.empty()) {
        decoded(texels, colors);
    } else {
        bytes(texels, colors);
    }
}

void TexelShader::bytes(std::span<const std::byte> texels, std::span<Rgba> colors) const
{
    const std::size_t stride = m_format.channels;
    const auto byteAt = [&](std::size_t texel, std::size_t channel) {
        return std::to_integer<std::size_t>(texels[texel * stride + channel]);
    };
    if (!m_numbers.empty()) {
        const auto channel = static_cast<std::size_t>(m_rule.number);
        for (std::size_t k = 0; k < colors.size(); ++k) {
            colors[k] = m_numbers[byteAt(k, channel)];
        }
        return;
    }
    const std::size_t second = stride < 3 ? 0 : 1;
    for (std::size_t k = 0; k < colors.size(); ++k) {
        colors[k] = {m_levels[byteAt(k, 0)],
                     m_levels[byteAt(k, second)],
                     m_levels[byteAt(k, 2 * second)],
                     255};
    }
    if (m_rule.opacity >= 0) {
        const auto channel = static_cast<std::size_t>(m_rule.opacity);
        for (std::size_t k = 0; k < colors.size(); ++k) {
            colors[k][3] = static_cast<std::uint8_t>(byteAt(k, channel));
        }
    }
}

/// A batch at a time through the format's decoder.
void TexelShader::decoded(std::span<const std::byte> texels, std::span<Rgba> colors) const
{
    const std::size_t channels = m_format.channels;
    const std::size_t batch = std::max<std::size_t>(1, kBatchValues / channels);
    std::vector<float> values(std::min(batch, colors.size()) * channels);
    for (std::size_t done = 0; done < colors.size(); done += batch) {
        const std::size_t count = std::min(batch, colors.size() - done);
        const auto part = std::span(values).first(count * channels);
        decode(m_format.type,
               texels.subspan(done * m_format.texelBytes(), count * m_format.texelBytes()),
               part);
        for (std::size_t k = 0; k < count; ++k) {
            colors[done + k] = shade(m_rule, part.subspan(k * channels, channels));
        }
    }
}

} // namespace trixel::render
