// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/export_estimate.h"

#include <QByteArray>

#include <algorithm>
#include <utility>
#include <vector>

namespace trixel::ui {

namespace {

constexpr std::size_t kSampleFaces = 48;
constexpr std::size_t kSampleTexels = 16384; ///< of one face, at most
/// Face record, constant value, mesh geometry and adjacency of one face, compressed: 14 to 20 were
/// measured on scanned and modelled meshes.
constexpr std::uint64_t kBytesPerFace = 17;

/// The face, or of one that lies in a file a coarser level that is there for little.
FaceTexels sampleOf(const FaceTexels& face)
{
    for (int log2 = face.isLoaded() ? 0 : face.level().log2() - 1; log2 > 1; --log2) {
        if (Level(log2).texelCount() <= kSampleTexels) {
            if (auto coarse = face.storedLevel(Level(log2))) {
                return std::move(*coarse);
            }
        }
    }
    return face.pinned();
}

/// The first texels of a face in another type, one channel after the other.
QByteArray planar(const FaceTexels& face, const TexelFormat& format, TexelType type)
{
    const std::size_t count = std::min(kSampleTexels, face.byteCount() / format.texelBytes());
    std::vector<float> values(count * format.channels);
    decode(format.type, face.bytes().first(count * format.texelBytes()), values);
    std::vector<float> split(values.size());
    for (std::size_t k = 0; k < values.size(); ++k) {
        split[(k % format.channels) * count + k / format.channels] = values[k];
    }
    std::vector<std::byte> bytes(split.size() * byteSize(type));
    encode(type, split, bytes);
    return {reinterpret_cast<const char*>(bytes.data()), static_cast<qsizetype>(bytes.size())};
}

void takeDifferences(QByteArray& bytes, TexelType type)
{
    if (type != TexelType::UInt8) {
        return; // the wider types compress about alike with and without
    }
    for (qsizetype k = bytes.size() - 1; k > 0; --k) {
        bytes[k] = static_cast<char>(bytes[k] - bytes[k - 1]);
    }
}

} // namespace

ExportEstimate estimatePtx(const TexelStore& texels, TexelType type, bool mips)
{
    const TexelFormat& format = texels.format();
    ExportEstimate estimate;
    std::vector<FaceId> painted;
    for (std::size_t k = 0; k < texels.faceCount(); ++k) {
        const FaceTexels& face = texels.face(faceId(k));
        estimate.texels += face.isConstant() ? 1 : face.level().texelCount();
        if (!face.isConstant()) {
            painted.push_back(faceId(k));
        }
    }
    const std::uint64_t full = (estimate.texels - (texels.faceCount() - painted.size())) *
                               byteSize(type) * format.channels;
    const std::uint64_t constants =
        (texels.faceCount() - painted.size()) * byteSize(type) * format.channels;
    estimate.plainBytes = constants + (mips ? full + full / 3 : full);

    double sampled = 0;
    double compressed = 0;
    const std::size_t step = std::max<std::size_t>(1, painted.size() / kSampleFaces);
    for (std::size_t k = 0; k < painted.size(); k += step) {
        QByteArray bytes = planar(sampleOf(texels.face(painted[k])), format, type);
        takeDifferences(bytes, type);
        sampled += static_cast<double>(bytes.size());
        compressed += static_cast<double>(qCompress(bytes, 6).size());
    }
    const double ratio = sampled > 0 ? std::min(1.0, compressed / sampled) : 0.0;
    estimate.likelyBytes =
        static_cast<std::uint64_t>(static_cast<double>(estimate.plainBytes - constants) * ratio) +
        texels.faceCount() * kBytesPerFace;
    return estimate;
}

} // namespace trixel::ui
