// SPDX-License-Identifier: GPL-3.0-or-later
//
// OpenImageIO's TextureSystem.
#include "core/study/speed/peers/peer_module.h"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/texture.h>
#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>
#include <memory>
#include <string>

namespace trixel::peers {
namespace {

constexpr std::size_t kErrorBytes = 256;
constexpr int kMostChannels = 16;

class OiioTexture final : public PictureTexture
{
public:
    OiioTexture(const Picture& picture, const std::string& file)
        : m_system(OIIO::TextureSystem::create(false))
        , m_channels(picture.channels)
        , m_wrap(picture.periodic ? OIIO::TextureOpt::WrapPeriodic : OIIO::TextureOpt::WrapClamp)
    {
        m_system->attribute("max_memory_MB", 2048.0F); // all of it stays in memory
        m_thread = m_system->get_perthread_info();
        m_texture = m_system->get_texture_handle(OIIO::ustring(file), m_thread);
    }
    ~OiioTexture() override { OIIO::TextureSystem::destroy(m_system); }

    bool isGood() const { return m_texture != nullptr && m_system->good(m_texture); }

    void sample(const PictureSamples& samples,
                const PictureFilter& filter,
                float* values,
                std::size_t stride) const override
    {
        OIIO::TextureOpt options;
        options.swrap = m_wrap;
        options.twrap = m_wrap;
        options.mipmode = OIIO::TextureOpt::MipModeAniso;
        options.interpmode = filter.bicubic ? OIIO::TextureOpt::InterpSmartBicubic
                                            : OIIO::TextureOpt::InterpBilinear;
        options.anisotropic = filter.anisotropy;
        options.swidth = filter.width;
        options.twidth = filter.width;
        std::array<float, kMostChannels> result{};
        for (std::size_t i = 0; i < samples.count; ++i) {
            m_system->texture(m_texture,
                              m_thread,
                              options,
                              samples.s[i],
                              samples.t[i],
                              samples.dsdx[i],
                              samples.dtdx[i],
                              samples.dsdy[i],
                              samples.dtdy[i],
                              m_channels,
                              result.data());
            for (int c = 0; c < m_channels; ++c) {
                values[static_cast<std::size_t>(c) * stride + i] =
                    result[static_cast<std::size_t>(c)];
            }
        }
    }

private:
    OIIO::TextureSystem* m_system;
    OIIO::TextureSystem::Perthread* m_thread = nullptr;
    OIIO::TextureSystem::TextureHandle* m_texture = nullptr;
    int m_channels;
    OIIO::TextureOpt::Wrap m_wrap;
};

/// Tiles and mip levels as OpenImageIO makes them.
bool writeTexture(const Picture& picture, const std::string& file)
{
    const OIIO::ImageSpec spec(
        picture.width, picture.height, picture.channels, OIIO::TypeDesc::FLOAT);
    const OIIO::ImageBuf image(spec, const_cast<float*>(picture.values));
    OIIO::ImageSpec config;
    config.set_format(picture.bytes ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::FLOAT);
    config.tile_width = 64;
    config.tile_height = 64;
    config.attribute("maketx:filtername", "box");
    config.attribute("maketx:wrap", picture.periodic ? "periodic" : "clamp");
    config.attribute("wrapmodes", picture.periodic ? "periodic,periodic" : "clamp,clamp");
    return OIIO::ImageBufAlgo::make_texture(OIIO::ImageBufAlgo::MakeTxTexture, image, file, config);
}

PictureTexture* make(const Picture& picture, const char* folder, char* error)
{
    const auto fail = [&](const std::string& why) {
        std::snprintf(error, kErrorBytes, "%s", why.c_str());
        return nullptr;
    };
    if (picture.channels < 1 || picture.channels > kMostChannels) {
        return fail("more channels than it takes");
    }
    const std::string file = std::string(folder) + "/picture.tif";
    try {
        if (!writeTexture(picture, file)) {
            return fail(OIIO::geterror());
        }
        auto texture = std::make_unique<OiioTexture>(picture, file);
        return texture->isGood() ? texture.release() : fail("its own texture does not open");
    } catch (const std::exception& e) {
        return fail(e.what());
    }
}

} // namespace
} // namespace trixel::peers

extern "C" __attribute__((visibility("default"))) trixel::peers::PictureTexture*
trixelMakePictureTexture(const trixel::peers::Picture& picture, const char* folder, char* error)
{
    return trixel::peers::make(picture, folder, error);
}
