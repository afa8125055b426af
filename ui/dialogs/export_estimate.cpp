// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/export_estimate.h"

#include <QByteArray>
#include <QElapsedTimer>
#include <QObject>

#include "core/filter/filter_method.h"
#include "core/mesh/adjacency.h"
#include "ui/dialogs/format_choice.h"

#include <algorithm>
#include <cmath>
#include <random>
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

namespace {

/// Seconds that a byte of noise takes to compress here: what writing images spends most of its time
/// on. Reading it again takes a fraction of that.
double secondsPerByte()
{
    constexpr qsizetype kBytes = qsizetype{1} << 18;
    constexpr double kReadAgain = 1.4;
    QByteArray noise(kBytes, '\0');
    std::minstd_rand random(1);
    for (char& byte : noise) {
        byte = static_cast<char>(random() >> 12U);
    }
    QElapsedTimer clock;
    clock.start();
    const qsizetype compressed = qCompress(noise, 4).size();
    return compressed > 0 ? kReadAgain * static_cast<double>(clock.nsecsElapsed()) * 1e-9 / kBytes
                          : 0;
}

/// Seconds that a sample of a hand-off atlas takes here: `exact` on a few faces.
double secondsPerSample(const TexelFormat& format)
{
    constexpr std::size_t kSamples = 256;
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    mesh.triangles = {{0, 1, 2}, {3, 2, 1}};
    const TexelStore texels(
        2, format, Level(4), std::vector<std::byte>(format.texelBytes(), std::byte{1}));
    NoProgress ignored;
    const auto scene =
        FilterScene::build(std::make_shared<const FilterSurface>(
                               FilterSurface::fromMesh(mesh, buildAdjacency(mesh.triangles))),
                           texels,
                           Threads{1},
                           ignored);
    if (!scene) {
        return 0;
    }
    QueryArrays queries;
    for (std::size_t k = 0; k < kSamples; ++k) {
        queries.add(FaceId{0}, {0.3F, static_cast<float>(k) / 512}, glm::vec2(0), glm::vec2(0));
    }
    ResultArrays answers(kSamples, scene->channels());
    const auto method = makeMethod({"exact", std::nullopt});
    QElapsedTimer clock;
    clock.start();
    method->filter(*scene, queries.queries(), answers.results());
    return static_cast<double>(clock.nsecsElapsed()) * 1e-9 / kSamples / Threads::all().count;
}

QString durationText(double seconds)
{
    return seconds < 1    ? QObject::tr("under a second")
           : seconds < 90 ? QObject::tr("about %1 s").arg(std::ceil(seconds))
                          : QObject::tr("about %1 min").arg(std::ceil(seconds / 60));
}

/// "2 pages, the largest 8,192 × 4,096"
QString pagesText(const AtlasEstimate& estimate)
{
    const auto largest = std::ranges::max_element(estimate.pages, {}, [](const AtlasPage& page) {
        return std::uint64_t{page.width} * page.height;
    });
    if (estimate.pages.size() == 1) {
        return QObject::tr("1 page of %L1 × %L2 pixels").arg(largest->width).arg(largest->height);
    }
    return QObject::tr("%L1 pages, the largest %L2 × %L3 pixels")
        .arg(estimate.pages.size())
        .arg(largest->width)
        .arg(largest->height);
}

QString atlasText(const AtlasEstimate& estimate, double seconds)
{
    QString text = QObject::tr("%1, %2 before compression, %3; %4 % of the pixels used")
                       .arg(pagesText(estimate),
                            sizeText(estimate.bytes()),
                            durationText(seconds),
                            QString::number(100 * estimate.occupancy, 'f', 0));
    if (estimate.otherOccupancy) {
        text += QObject::tr(" (%1 % in the other packing)")
                    .arg(QString::number(100 * *estimate.otherOccupancy, 'f', 0));
    }
    return text;
}

/// "2 images of 2,048 × 2,048 pixels, 25.2 MB before compression, about 3 s"
QString imagesText(const UvExportPlan& plan, const UvExportOptions& options, double seconds)
{
    const QString size = QObject::tr("%L1 × %L2 pixels").arg(options.width).arg(options.height);
    const QString images = plan.tiles.size() == 1
                               ? QObject::tr("1 image of %1").arg(size)
                               : QObject::tr("%L1 images of %2").arg(plan.tiles.size()).arg(size);
    return QObject::tr("%1, %2 of %3, %4 before compression, %5")
        .arg(images,
             plan.format.channels == 1 ? QObject::tr("1 channel")
                                       : QObject::tr("%1 channels").arg(plan.format.channels),
             QString::fromUtf8(nameOf(plan.format.type).data()),
             sizeText(plan.bytes(options)),
             durationText(seconds));
}

Result<QString> estimateUvImages(const Project& part,
                                 const std::filesystem::path& path,
                                 const UvExportOptions& options)
{
    const auto plan = planUvExport(path, part, options);
    if (!plan) {
        return tl::unexpected(plan.error());
    }
    const double drawing =
        static_cast<double>(plan->pixels) * secondsPerSample(part.texels.format());
    const double writing = static_cast<double>(plan->bytes(options)) * secondsPerByte();
    return imagesText(*plan, options, drawing + writing);
}

} // namespace

Result<QString>
estimateExport(const Project& project, const ExportRequest& request, Progress& progress)
{
    const auto part = partOf(project, request.part, Threads::all(), progress);
    if (!part) {
        return tl::unexpected(part.error());
    }
    if (const auto* ptx = std::get_if<PtxExportOptions>(&request.options)) {
        const ExportEstimate estimate =
            estimatePtx(part->texels, ptx->type.value_or(part->texels.format().type), ptx->mips);
        return QObject::tr("about %1, mesh included (texels before compression: %2), %3")
            .arg(sizeText(estimate.likelyBytes),
                 sizeText(estimate.plainBytes),
                 durationText(static_cast<double>(estimate.plainBytes) * secondsPerByte()));
    }
    if (const auto* uv = std::get_if<UvExportOptions>(&request.options)) {
        return estimateUvImages(*part, request.path, *uv);
    }
    const auto* packed = std::get_if<PackedExportOptions>(&request.options);
    const auto estimate =
        packed != nullptr
            ? estimatePackedAtlas(request.path, *part, *packed)
            : estimateHandOff(request.path, *part, std::get<HandOffExportOptions>(request.options));
    if (!estimate) {
        return tl::unexpected(estimate.error());
    }
    const double writing = static_cast<double>(estimate->bytes()) * secondsPerByte();
    const double samples = static_cast<double>(estimate->pixels()) * estimate->occupancy;
    return atlasText(
        *estimate,
        packed != nullptr ? writing : writing + samples * secondsPerSample(part->texels.format()));
}

} // namespace trixel::ui
