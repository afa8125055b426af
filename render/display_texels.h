// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which texels lie where on the graphics card and which have to be sent. Plain data, no OpenGL.
#pragma once

#include "render/display_blocks.h"

namespace trixel::render {

/// The texels of a store on the graphics card, within a bound. The base of a face is one texel, its
/// mean.
class DisplayTexels : public DisplayBlocks
{
public:
    /// \param generation  see `DisplayBlocks`
    explicit DisplayTexels(std::uint32_t generation = 0)
        : DisplayBlocks(BlockKind::Texels, generation)
    {
    }

    /// Shows a store from now on, with its usual channels. What is on the card stays until it is
    /// replaced where there are as many faces of the same type.
    /// \param mipDrop    show every face this many levels coarser (>= 0)
    /// \param maxTexels  most texels the buffer can have; less is shown to fit, but for the bases
    void reset(const TexelStore& store, int mipDrop, std::uint32_t maxTexels)
    {
        begin(store, mipDrop, maxTexels);
    }

    Opener opener() const override;
    Maker maker() const override;
    std::uint32_t texelsUsed() const { return elementsUsed(); }

private:
    CardOpening openNow(const TexelStore& store) const override;
    std::optional<MadeBlocks> makeAgain(const TexelStore& store,
                                        const BlockJob& job) const override;
    void touched(FaceId face) override { touchInFlight(face); }
    void sendTouched(const TexelStore& store, std::size_t mostRead) override;

    std::size_t sendTouched(const TexelStore& store, FaceId face, const Rect& rect);
    std::size_t sendWhole(const FaceTexels& texels, FaceId face);
    std::size_t sendRect(const FaceTexels& texels, FaceId face, const Rect& rect);
    std::size_t sendReduced(const FaceTexels& texels, FaceId face, const Rect& rect);
    std::size_t sendMean(const FaceTexels& texels, FaceId face);
};

} // namespace trixel::render
