// SPDX-License-Identifier: GPL-3.0-or-later
//
// The reference Ptex library, where it is installed.
#include "core/study/speed/peers/peer_module.h"

#include <Ptexture.h>
#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <string>

namespace trixel::peers {
namespace {

constexpr int kMostChannels = 16;

struct Release
{
    template <class T>
    void operator()(T* object) const
    {
        object->release();
    }
};

class ReferenceTexture final : public FaceTexture
{
public:
    explicit ReferenceTexture(PtexTexture* texture)
        : m_texture(texture)
        // Every filter type but point is the same on triangles.
        , m_filter(PtexFilter::getFilter(texture, PtexFilter::Options(PtexFilter::f_gaussian)))
    {
    }

    void sample(const FaceSamples& samples,
                int channels,
                float* values,
                std::size_t stride) const override
    {
        std::array<float, kMostChannels> result{};
        const int count = std::min(channels, kMostChannels);
        for (std::size_t i = 0; i < samples.count; ++i) {
            m_filter->eval(result.data(),
                           0,
                           count,
                           samples.face[i],
                           samples.u[i],
                           samples.v[i],
                           samples.uw1[i],
                           samples.vw1[i],
                           samples.uw2[i],
                           samples.vw2[i]);
            for (int c = 0; c < count; ++c) {
                values[static_cast<std::size_t>(c) * stride + i] =
                    result[static_cast<std::size_t>(c)];
            }
        }
    }

private:
    std::unique_ptr<PtexTexture, Release> m_texture;
    std::unique_ptr<PtexFilter, Release> m_filter;
};

} // namespace
} // namespace trixel::peers

extern "C" __attribute__((visibility("default"))) trixel::peers::FaceTexture*
trixelOpenFaceTexture(const char* path, char* error)
{
    Ptex::String why;
    PtexTexture* texture = PtexTexture::open(path, why);
    if (texture == nullptr) {
        std::snprintf(error, 256, "%s", why.c_str());
        return nullptr;
    }
    return new trixel::peers::ReferenceTexture(texture); // owned by the caller
}
