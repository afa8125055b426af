// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a module with a peer offers. Modules are loaded when they are wanted, because the libraries
// they bring take a quarter of a second and a hundred megabytes; only plain data crosses over, so
// that a module needs nothing of the program.
#pragma once

#include <cstddef>

namespace trixel::peers {

/// A picture for a texture system: rows from t = 0 on, channels interleaved, values in [0,1] where
/// `bytes` asks for 8-bit storage.
struct Picture
{
    int width = 0;
    int height = 0;
    int channels = 0;
    const float* values = nullptr;
    bool bytes = true;
    bool periodic = false; ///< else clamped at the borders
};

/// N samples of a picture: position and derivatives in (s,t).
struct PictureSamples
{
    std::size_t count = 0;
    const float* s = nullptr;
    const float* t = nullptr;
    const float* dsdx = nullptr;
    const float* dtdx = nullptr;
    const float* dsdy = nullptr;
    const float* dtdy = nullptr;
};

struct PictureFilter
{
    int anisotropy = 16; ///< most probes along the major axis
    float width = 1;     ///< what derivatives are multiplied with
    bool bicubic = false;
};

/// A picture in a texture system, its mip levels made.
class PictureTexture
{
public:
    virtual ~PictureTexture() = default;
    /// Channel c of sample i goes to values[c * stride + i]. Not from several threads at once.
    virtual void sample(const PictureSamples& samples,
                        const PictureFilter& filter,
                        float* values,
                        std::size_t stride) const = 0;
};

/// Symbol "trixelMakePictureTexture". Null when it cannot be made; then `error`, of 256 bytes, says
/// why. `folder` is for its files, which may go when the texture is gone.
using MakePictureTexture = PictureTexture* (*)(const Picture& picture,
                                               const char* folder,
                                               char* error);

/// N footprints on faces, as the reference library takes them.
struct FaceSamples
{
    std::size_t count = 0;
    const int* face = nullptr;
    const float* u = nullptr;
    const float* v = nullptr;
    const float* uw1 = nullptr;
    const float* vw1 = nullptr;
    const float* uw2 = nullptr;
    const float* vw2 = nullptr;
};

/// A .ptx opened by the reference library.
class FaceTexture
{
public:
    virtual ~FaceTexture() = default;
    virtual void
    sample(const FaceSamples& samples, int channels, float* values, std::size_t stride) const = 0;
};

/// Symbol "trixelOpenFaceTexture"; as above.
using OpenFaceTexture = FaceTexture* (*)(const char* path, char* error);

} // namespace trixel::peers
