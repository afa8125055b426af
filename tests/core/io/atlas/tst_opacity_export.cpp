// SPDX-License-Identifier: GPL-3.0-or-later
//
// A layer that leaves alone, put over a bright background by another program: bilinear look-ups of
// the pixels as they are, colours and opacity each on their own.
#include "core/atlas/page_pixels.h"
#include "core/filter/filter_method.h"
#include "core/io/atlas/export_atlas.h"
#include "core/io/channel_colors.h"
#include "core/io/export_uv_image.h"
#include "core/io/image/decode_image.h"
#include "core/io/new_project.h"
#include "core/io/project_part.h"
#include "core/layers/compose.h"
#include "core/mesh/mesh_reader.h"
#include "core/study/solid_texture.h"
#include "tests/core/io/image/image_fixture.h"
#include "tests/core/test_meshes.h"

#include <iostream>
#include <random>

using namespace trixel;
using namespace trixel::test;

namespace {

constexpr Level kLevel{4};
constexpr std::size_t kChannels = 4; // three and the coverage
constexpr double kBackground = 1;

/// A square whose uvs are its positions, bent so that it is no plane.
TriangleMesh bentGrid(std::uint32_t cells = 3)
{
    TriangleMesh mesh = gridMesh(cells);
    for (const Triangle& triangle : mesh.triangles) {
        for (const std::uint32_t vertex : triangle) {
            mesh.cornerUvs.emplace_back(mesh.positions[vertex]);
        }
    }
    for (glm::vec3& p : mesh.positions) {
        p.z = 0.1F * std::sin(5 * p.x + 2 * p.y);
    }
    return mesh;
}

double distanceToLine(glm::dvec2 p, glm::dvec2 from, glm::dvec2 to)
{
    const glm::dvec2 along = to - from;
    const double t = std::clamp(glm::dot(p - from, along) / glm::dot(along, along), 0.0, 1.0);
    return glm::length(p - from - t * along);
}

/// A stroke with a hard edge, and a soft one across it.
double strokes(glm::dvec2 p)
{
    const bool hard = distanceToLine(p, {0.2, 0.25}, {0.85, 0.7}) < 0.11;
    const double away = distanceToLine(p, {0.15, 0.8}, {0.8, 0.15}) / 0.12;
    const double soft = away < 1 ? (1 - away * away) * (1 - away * away) : 0.0;
    return hard ? 1.0 : soft;
}

/// A project with nothing but paint on its only layer. \param colors  three of every texel
Project painted(const TexelStore& colors, const TriangleMesh& mesh)
{
    NoProgress progress;
    const std::array<float, 3> grey = {0.5F, 0.5F, 0.5F};
    Project project = *newProject(mesh,
                                  planUniform(mesh.faceCount(), kLevel),
                                  TexelFormat{TexelType::UInt8, 3, std::nullopt},
                                  grey,
                                  progress);
    LayerStack layers(project.texels);
    const LayerId layer = layers.insert(0, {"Over"});
    for (std::uint32_t f = 0; f < mesh.faceCount(); ++f) {
        const FaceId face = faceId(f);
        const std::span<std::byte> texels = layers.texels(layer).writable(face);
        for (std::uint32_t k = 0; k < kLevel.texelCount(); ++k) {
            const glm::dvec2 uv = centroid(kLevel, texelAt(kLevel, TexelIndex{k}));
            const auto corners = mesh.corners(face);
            const glm::vec3 at = corners[0] + float(uv.x) * (corners[1] - corners[0]) +
                                 float(uv.y) * (corners[2] - corners[0]);
            std::vector<float> texel(3);
            decode(colors.format().type, colors.face(face).texel(k), texel);
            texel.push_back(static_cast<float>(strokes(glm::dvec2(at))));
            if (texel.back() > 0) { // else all 0, as layers have it
                encode(TexelType::UInt8, texel, texels.subspan(kChannels * k, kChannels));
            }
        }
    }
    Layered all = *composed(std::move(layers), Threads{2}, progress);
    project.texels = std::move(all.shown);
    project.layers = std::move(all.layers);
    return project;
}

Project naturalPaint(const TriangleMesh& mesh)
{
    NoProgress progress;
    const auto data = parseTestData(storedTestFiles());
    return painted(
        *solidTexture(
            mesh, planUniform(mesh.faceCount(), kLevel), data.value(), Threads{2}, progress),
        mesh);
}

Project whitePaint(const TriangleMesh& mesh)
{
    const std::array<float, 3> white = {1, 1, 1};
    return painted(TexelStore(TexelFormat{TexelType::Float, 3, std::nullopt},
                              planUniform(mesh.faceCount(), kLevel).levels,
                              std::as_bytes(std::span(white))),
                   mesh);
}

/// A few faces, and many about them that have no paint.
Project whiteSpot()
{
    Project project = whitePaint(bentGrid(12));
    TexelStore& texels = project.layers.texels(project.layers.layers().front().id);
    const std::vector<std::byte> nothing(kChannels);
    for (std::uint32_t f = 0; f < texels.faceCount(); ++f) {
        const glm::dvec2 corner(project.surface->mesh().corners(faceId(f))[0]);
        if (glm::distance(corner, {0.45, 0.45}) > 0.12) {
            texels.exchange(faceId(f), FaceTexels::constant(kLevel, nothing));
        }
    }
    return project;
}

/// The layer, which is all that leaves.
Project alone(const Project& project)
{
    NoProgress progress;
    return partOf(project, {{}, {}, project.layers.layers().front().id}, Threads{2}, progress)
        .value();
}

/// What another program has of it: faces with uvs, and the image they lie in.
struct Received
{
    TriangleMesh mesh;
    Image image;
    bool isMultiplied = false;
};

/// As it is looked up.
std::array<float, kChannels> lookUp(const Received& received, FaceId face, glm::dvec2 uv)
{
    const auto corners = received.mesh.uvs(face);
    const glm::dvec2 at = glm::dvec2(corners[0]) + uv.x * glm::dvec2(corners[1] - corners[0]) +
                          uv.y * glm::dvec2(corners[2] - corners[0]);
    std::array<float, kChannels> value{};
    bilinear(received.image,
             {at.x * received.image.width(), (1 - at.y) * received.image.height()},
             value);
    return value;
}

/// Over the background, channel by channel.
std::array<double, 3> seen(const Received& received, FaceId face, glm::dvec2 uv)
{
    const auto value = lookUp(received, face, uv);
    std::array<double, 3> over{};
    const double opacity = double(value[3]);
    for (std::size_t c = 0; c < 3; ++c) {
        over[c] =
            double(value[c]) * (received.isMultiplied ? 1 : opacity) + (1 - opacity) * kBackground;
    }
    return over;
}

/// The layer's texels, colours multiplied with coverage: what can be averaged.
FilterScene multiplied(const Project& layer)
{
    const TexelFormat format{TexelType::Float, kChannels, std::nullopt};
    const std::array<float, kChannels> none{};
    TexelStore store(format,
                     planUniform(layer.texels.faceCount(), kLevel).levels,
                     std::as_bytes(std::span(none)));
    for (std::uint32_t f = 0; f < store.faceCount(); ++f) {
        std::vector<float> values(kChannels * kLevel.texelCount());
        for (std::uint32_t k = 0; k < kLevel.texelCount(); ++k) {
            const auto texel = std::span(values).subspan(kChannels * k, kChannels);
            decode(TexelType::UInt8, layer.texels.face(faceId(f)).texel(k), texel);
            for (std::size_t c = 0; c < 3; ++c) {
                texel[c] *= texel[3];
            }
        }
        store.exchange(
            faceId(f),
            FaceTexels::full(kLevel, format.texelBytes(), std::as_bytes(std::span(values))));
    }
    NoProgress progress;
    return FilterScene::build(std::make_shared<const FilterSurface>(FilterSurface::fromMesh(
                                  layer.surface->mesh(), layer.surface->adjacency())),
                              store,
                              Threads{2},
                              progress)
        .value();
}

/// The same with its colours multiplied before they are looked up, as no straight image has them.
Received inAdvance(const Received& received)
{
    if (received.isMultiplied) {
        return received;
    }
    const Image& image = received.image;
    std::vector<float> values(image.byteCount() / byteSize(image.format().type));
    decode(image.format().type, image.pixels(), values);
    for (std::size_t k = 0; k < values.size(); k += kChannels) {
        for (std::size_t c = 0; c < 3; ++c) {
            values[k + c] *= values[k + 3];
        }
    }
    TexelFormat format = image.format();
    format.type = TexelType::Float;
    Image multiplied(image.width(), image.height(), format, image.colors());
    encode(TexelType::Float, values, multiplied.writable());
    return {received.mesh, std::move(multiplied), true};
}

/// What is seen, in natural channels: what was painted, and what colours without opacity add to it.
struct Apart
{
    double psnr = 0;    ///< against filtering of the multiplied texels, in decibels
    double largest = 0; ///< likewise; of 255
    double fringe = 0;  ///< the largest against the same pixels, multiplied in advance; of 255
};

constexpr std::size_t kNatural = 2; // the third has hard edges of its own

QueryArrays anyPlaces(std::size_t faces)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> any(0, 1);
    QueryArrays places;
    for (std::size_t k = 0; k < 6'000; ++k) {
        const double s = std::sqrt(any(random));
        const double t = any(random);
        places.add(
            faceId(random() % faces), glm::vec2(s * (1 - t), s * t), glm::vec2(0), glm::vec2(0));
    }
    return places;
}

/// \param method  what the texels are filtered by, at points
Apart compare(const Project& layer, const Received& received, const std::string& method)
{
    const FilterScene scene = multiplied(layer);
    const QueryArrays places = anyPlaces(scene.faceCount());
    ResultArrays truth(places.size(), scene.channels());
    filterParallel(
        *makeMethod({method, std::nullopt}), scene, places.queries(), truth.results(), Threads{2});
    const auto painted = [&](std::size_t k, std::size_t c) {
        return static_cast<double>(truth.values[c * places.size() + k]);
    };
    const Received best = inAdvance(received);
    Apart apart;
    double squares = 0;
    std::size_t edges = 0;
    for (std::size_t k = 0; k < places.size(); ++k) {
        const auto over = seen(received, places.face[k], {places.u[k], places.v[k]});
        const auto bestOver = seen(best, places.face[k], {places.u[k], places.v[k]});
        const double opacity = painted(k, 3);
        edges += opacity > 0.01 && opacity < 0.99 ? 1 : 0;
        for (std::size_t c = 0; c < kNatural; ++c) {
            const double off = over[c] - painted(k, c) - (1 - opacity) * kBackground;
            squares += off * off;
            apart.largest = std::max(apart.largest, 255 * std::abs(off));
            apart.fringe = std::max(apart.fringe, 255 * std::abs(over[c] - bestOver[c]));
        }
    }
    EXPECT_GT(edges, 1000U);
    apart.psnr = -10 * std::log10(squares / double(kNatural * places.size()));
    return apart;
}

class OpacityExport : public ImageFiles
{
protected:
    Received handOff(const Project& layer) const
    {
        NoProgress progress;
        const auto written = exportHandOff(worker, at("a.obj"), layer, {}, progress);
        EXPECT_TRUE(written) << written.error().message;
        EXPECT_LE(255 * written->largestJump, 2);
        return {readMesh(at("a.obj"), progress).value(), read(at("a.png")).value()};
    }

    /// The pixels as they are in the file, whatever it says of them.
    Received uvImage(const Project& layer, const std::string& name, int size = 144) const
    {
        NoProgress progress;
        UvExportOptions options;
        options.width = options.height = size;
        const auto written = exportUvImages(worker, at(name), layer, options, Threads{2}, progress);
        EXPECT_TRUE(written) << written.error().message;
        DecodeOptions asStored;
        asStored.keepsAlpha = true;
        const DecodedImage stored =
            decodeImageFile(worker, at(name), asStored, progress, {}).value();
        Image image(stored.width, stored.height, stored.format, stored.colors);
        std::copy_n(stored.pixels.get(), image.byteCount(), image.writable().begin());
        return {layer.surface->mesh(), std::move(image), at(name).extension() == ".exr"};
    }
};

Project declared(Project project, ColorSpace space)
{
    declareChannelColors(project, std::vector<ColorSpace>(3, space));
    return project;
}

/// As many pixels as texels along an edge are few for bilinear look-ups of any content, twice as
/// many are enough.
TEST_F(OpacityExport, naturalPaintLooksAsItIsFiltered)
{
    const Project layer = alone(declared(naturalPaint(bentGrid()), ColorSpace::Linear));
    const auto expectAlike = [](const Apart& apart, double psnr, double fringe) {
        std::cout << apart.psnr << " dB, largest " << apart.largest << ", fringe " << apart.fringe
                  << " of 255\n";
        EXPECT_GE(apart.psnr, psnr);
        EXPECT_LE(apart.fringe, fringe);
    };
    expectAlike(compare(layer, handOff(layer), "exact"), 50, 1);
    expectAlike(compare(layer, uvImage(layer, "a.png", 144), "lattice-linear"), 48, 1);
    expectAlike(compare(layer, uvImage(layer, "a.tif", 144), "lattice-linear"), 48, 1);
    expectAlike(compare(layer, uvImage(layer, "a.exr", 144), "lattice-linear"), 48, 0);
    expectAlike(compare(layer, uvImage(layer, "a.png", 68), "lattice-linear"), 40, 4);
}

/// Whatever is darker is a fringe.
TEST_F(OpacityExport, whitePaintCannotBeSeenOnWhite)
{
    for (const ColorSpace space : {ColorSpace::Linear, ColorSpace::SRgb}) {
        const Project layer = alone(declared(whitePaint(bentGrid()), space));
        for (const Received& received : {handOff(layer),
                                         uvImage(layer, "a.png"),
                                         uvImage(layer, "a.tif"),
                                         uvImage(layer, "a.exr")}) {
            double darkest = 1;
            const QueryArrays places = anyPlaces(layer.texels.faceCount());
            for (std::size_t k = 0; k < places.size(); ++k) {
                const auto over = seen(received, places.face[k], {places.u[k], places.v[k]});
                darkest = std::min({darkest, over[0], over[1], over[2]});
            }
            EXPECT_GE(255 * darkest, 254.9);
        }
    }
}

/// So that levels that a program makes on its own have no fringe either.
TEST_F(OpacityExport, colorsGoOnBeneathWhatIsTransparent)
{
    for (const Project& paint : {whitePaint(bentGrid()), whiteSpot()}) {
        const Project layer = alone(declared(paint, ColorSpace::SRgb));
        for (const Received& received : {handOff(layer), uvImage(layer, "a.png")}) {
            const QueryArrays places = anyPlaces(layer.texels.faceCount());
            std::size_t transparent = 0;
            for (std::size_t k = 0; k < places.size(); ++k) {
                const auto value = lookUp(received, places.face[k], {places.u[k], places.v[k]});
                EXPECT_NEAR(value[0] + value[1] + value[2], 3, 1e-5);
                transparent += value[3] == 0 ? 1 : 0;
            }
            EXPECT_GT(transparent, 1000U);
        }
    }
}

} // namespace
