// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/resample/uv_image.h"

#include "core/base/check.h"
#include "core/filter/filter_method.h"
#include "core/filter/surface_walk.h"
#include "core/mesh/shared_progress.h"
#include "core/mesh/triangle_geometry.h"
#include "core/resample/fill_holes.h"
#include "core/resample/uv_raster.h"
#include "core/texture/opacity.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <new>
#include <string>
#include <utility>

namespace trixel {

namespace {

/// Pixels that one thread works on between two looks at the progress, in whole rows.
constexpr int kPixelsAtOnce = 8192;

/// Pixels that one method filters, and where their values go.
struct PixelQueries
{
    QueryArrays queries;
    std::vector<std::size_t> pixels;

    void clear()
    {
        queries = {};
        pixels.clear();
    }
};

class RowDrawer
{
public:
    RowDrawer(const FilterScene& scene,
              const TriangleMesh& mesh,
              const UvRaster& raster,
              const PixelPlane& plane,
              std::span<float> values,
              std::span<std::uint8_t> known)
        : m_scene(scene)
        , m_mesh(mesh)
        , m_raster(raster)
        , m_plane(plane)
        , m_values(values)
        , m_known(known)
        , m_between(makeMethod({"lattice-linear", std::nullopt}))
        , m_average(makeMethod({"ewa", std::nullopt}))
    {
    }

    void draw(int firstRow, int rows)
    {
        m_small.clear();
        m_large.clear();
        for (int y = firstRow; y < firstRow + rows; ++y) {
            for (int x = 0; x < m_raster.width; ++x) {
                ask(x, y);
            }
        }
        answer(*m_between, m_small);
        answer(*m_average, m_large);
    }

private:
    void ask(int x, int y)
    {
        const std::size_t pixel =
            static_cast<std::size_t>(y) * static_cast<std::size_t>(m_raster.width) +
            static_cast<std::size_t>(x);
        const std::uint32_t owner = m_raster.owners[pixel];
        if (owner == 0) {
            return;
        }
        const FaceId face = faceId(owner - 1);
        const auto in = PixelsInFace::of(m_mesh.uvs(face), m_plane);
        check(in.has_value(), "only faces with area own pixels");
        const glm::dvec2 centre(x + 0.5, y + 0.5);
        SurfacePlace place{face, in->uv(centre)};
        glm::dmat2 vectors(in->perX, in->perY);
        if (m_raster.inside[pixel] == 0) {
            const glm::dvec2 nearest = nearestUv(face, centre);
            const SurfaceWalk walk =
                walkStraight(m_scene.surface(), {face, nearest}, place.uv - nearest, vectors);
            place = walk.end;
            vectors = walk.carried;
        }
        add(pixel, place, vectors);
    }

    /// The point of a face's uvs nearest to a pixel, in the image.
    glm::dvec2 nearestUv(FaceId face, glm::dvec2 centre) const
    {
        const auto uvs = m_mesh.uvs(face);
        std::array<glm::vec3, 3> corners{};
        for (std::size_t k = 0; k < 3; ++k) {
            corners[k] = glm::vec3(glm::vec2(m_plane.pixels(glm::dvec2(uvs[k])) - centre), 0);
        }
        return nearestOnTriangle(corners, glm::dvec3(0)).uv;
    }

    void add(std::size_t pixel, const SurfacePlace& place, const glm::dmat2& vectors)
    {
        const glm::vec2 uv = insideTriangle(place.uv);
        // In texels of the face it lies on.
        const double texels = m_scene.level(place.face).resolution();
        const double longest =
            texels *
            std::sqrt(std::max({glm::dot(vectors[0], vectors[0]),
                                glm::dot(vectors[1], vectors[1]),
                                glm::dot(vectors[0] - vectors[1], vectors[0] - vectors[1])}));
        constexpr double kSmall = 2;
        const bool isSmall = longest <= kSmall;
        PixelQueries& queries = isSmall ? m_small : m_large;
        queries.queries.add(place.face,
                            uv,
                            isSmall ? glm::vec2(0) : glm::vec2(vectors[0]),
                            isSmall ? glm::vec2(0) : glm::vec2(vectors[1]));
        queries.pixels.push_back(pixel);
    }

    void answer(const FilterMethod& method, const PixelQueries& asked)
    {
        const std::size_t count = asked.pixels.size();
        const auto channels = static_cast<std::size_t>(m_scene.channels());
        if (count == 0) {
            return;
        }
        m_answers.resize(count * channels);
        method.filter(m_scene, asked.queries.queries(), {m_answers, count, {}, {}});
        for (std::size_t k = 0; k < count; ++k) {
            for (std::size_t c = 0; c < channels; ++c) {
                m_values[asked.pixels[k] * channels + c] = m_answers[c * count + k];
            }
            m_known[asked.pixels[k]] = 1;
        }
    }

    const FilterScene& m_scene;
    const TriangleMesh& m_mesh;
    const UvRaster& m_raster;
    const PixelPlane& m_plane;
    std::span<float> m_values;
    std::span<std::uint8_t> m_known;
    std::unique_ptr<const FilterMethod> m_between, m_average;
    PixelQueries m_small, m_large;
    std::vector<float> m_answers;
};

Status drawAll(const FilterScene& scene,
               const TriangleMesh& mesh,
               const UvRaster& raster,
               const PixelPlane& plane,
               Threads threads,
               std::span<float> values,
               std::span<std::uint8_t> known,
               Progress& progress)
{
    const int rowsAtOnce = std::max(1, kPixelsAtOnce / raster.width);
    const auto stripes = static_cast<std::size_t>((raster.height + rowsAtOnce - 1) / rowsAtOnce);
    SharedProgress shared(progress, stripes);
    std::atomic<bool> outOfMemory{false};
    parallelFor(stripes, 1, threads, [&](std::size_t begin, std::size_t end) {
        try {
            RowDrawer drawer(scene, mesh, raster, plane, values, known);
            for (std::size_t k = begin; k < end && shared.goesOn(); ++k) {
                const int top = static_cast<int>(k) * rowsAtOnce;
                drawer.draw(top, std::min(rowsAtOnce, raster.height - top));
                shared.step();
            }
        } catch (const std::bad_alloc&) { // must not leave its thread
            outOfMemory = true;
        }
    });
    if (outOfMemory) {
        return contentsError("the pixels do not fit into memory");
    }
    return shared.goesOn() ? Status() : cancelled();
}

/// Faces of the tile that own no pixel.
std::uint32_t countLost(const TriangleMesh& mesh, const UvRaster& raster, UdimTile tile)
{
    std::vector<bool> owns(mesh.faceCount());
    for (std::size_t k = 0; k < raster.pixelCount(); ++k) {
        if (raster.owners[k] != 0) {
            owns[raster.owners[k] - 1] = true;
        }
    }
    std::uint32_t lost = 0;
    for (std::uint32_t k = 0; k < mesh.faceCount(); ++k) {
        const auto uvs = mesh.uvs(faceId(k));
        const glm::dvec2 middle =
            (glm::dvec2(uvs[0]) + glm::dvec2(uvs[1]) + glm::dvec2(uvs[2])) / 3.0;
        lost += !owns[k] && udimTileAt(middle) == tile ? 1U : 0U;
    }
    return lost;
}

/// From weighed pixels to those that are stored. What nothing shows takes the colours about it:
/// they are looked up on their own, and must not be mixed with what was never there.
Status spreadColors(std::span<float> values,
                    const TexelFormat& format,
                    const UvImageOptions& options,
                    Progress& progress)
{
    const std::size_t channels = format.channels;
    std::vector<float> opacities(values.size() / channels);
    std::vector<std::uint8_t> shows(opacities.size());
    for (std::size_t k = 0; k < opacities.size(); ++k) {
        const auto pixel = values.subspan(k * channels, channels);
        unweigh(pixel, *format.alpha);
        opacities[k] = pixel[*format.alpha];
        shows[k] = opacities[k] > 0 ? 1 : 0;
    }
    Status filled = fillHoles(
        values, shows, options.width, options.height, format.channels, options.threads, progress);
    for (std::size_t k = 0; k < opacities.size(); ++k) {
        values[k * channels + *format.alpha] = opacities[k];
    }
    return filled;
}

Result<Image> encodedImage(std::span<float> values,
                           const TexelFormat& format,
                           const UvImageOptions& options,
                           Progress& progress)
{
    TexelFormat stored = format;
    stored.type = options.type;
    Image image(options.width, options.height, stored, options.colors);
    const std::span<std::byte> pixels = image.writable();
    const auto rows = static_cast<std::size_t>(options.height);
    const std::size_t rowValues = values.size() / rows;
    const std::size_t rowBytes = pixels.size() / rows;
    SharedProgress shared(progress, rows);
    parallelFor(rows, 1, options.threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t y = begin; y < end && shared.goesOn(); ++y) {
            const std::span<float> row = values.subspan(y * rowValues, rowValues);
            for (std::size_t k = 0; k < row.size(); ++k) {
                row[k] = fromLinear(options.colors[k % format.channels], row[k]);
            }
            encode(options.type, row, pixels.subspan(y * rowBytes, rowBytes));
            shared.step();
        }
    });
    return shared.goesOn() ? Result<Image>(std::move(image)) : cancelled();
}

FaceTexels
linearFace(const TexelFormat& format, const std::vector<ColorSpace>& colors, const FaceTexels& face)
{
    std::vector<float> values(face.byteCount() / byteSize(format.type));
    decode(format.type, face.bytes(), values);
    for (std::size_t k = 0; k < values.size(); ++k) {
        values[k] = toLinear(colors[k % format.channels], values[k]);
    }
    const auto bytes = std::as_bytes(std::span(values));
    return face.isConstant()
               ? FaceTexels::constant(face.level(), bytes)
               : FaceTexels::full(face.level(), sizeof(float) * format.channels, bytes);
}

} // namespace

Result<std::vector<UdimTile>> uvTiles(const TriangleMesh& mesh)
{
    if (const Status usable = checkUvs(mesh, {}, true); !usable) {
        return tl::unexpected(usable.error());
    }
    std::vector<UdimTile> tiles;
    for (std::uint32_t k = 0; k < mesh.faceCount(); ++k) {
        const auto reached = tilesOfFace(mesh.uvs(faceId(k)));
        if (!reached) {
            return contentsError("the mesh's uvs leave all tiles at face " + std::to_string(k));
        }
        tiles.insert(tiles.end(), reached->begin(), reached->end());
        if (tiles.size() > 65536) {
            std::sort(tiles.begin(), tiles.end());
            tiles.erase(std::unique(tiles.begin(), tiles.end()), tiles.end());
        }
    }
    std::sort(tiles.begin(), tiles.end());
    tiles.erase(std::unique(tiles.begin(), tiles.end()), tiles.end());
    return tiles;
}

Result<TexelStore> linearStore(const TexelStore& store,
                               const std::vector<ColorSpace>& colors,
                               Threads threads,
                               Progress& progress)
{
    const bool isCurved = std::find(colors.begin(), colors.end(), ColorSpace::SRgb) != colors.end();
    if (!isCurved) {
        return store;
    }
    check(colors.size() == store.format().channels, "a colour space for each channel");
    TexelFormat format = store.format();
    format.type = TexelType::Float;
    return store.transformed(
        format,
        [&](const FaceTexels& face) { return linearFace(store.format(), colors, face); },
        threads,
        progress);
}

Result<UvImage> makeUvImage(const FilterScene& scene,
                            const TriangleMesh& mesh,
                            const TexelFormat& format,
                            const UvImageOptions& options,
                            Progress& progress)
{
    check(scene.faceCount() == mesh.faceCount(), "a scene of the mesh's faces");
    check(options.colors.size() == format.channels, "a colour space for each channel");
    if (const Status usable = checkUvs(mesh, {}, true); !usable) {
        return tl::unexpected(usable.error());
    }
    if (!progress.report(0)) {
        return cancelled();
    }
    StageProgress rastering(progress, 0, 0.05);
    auto raster =
        rasterUvs(mesh, options.width, options.height, options.tile, options.threads, rastering);
    if (!raster) {
        return tl::unexpected(raster.error());
    }
    UvImage made;
    made.insidePixels = static_cast<std::uint64_t>(
        std::count(raster->inside.begin(), raster->inside.end(), std::uint8_t{1}));
    if (made.insidePixels == 0) {
        return contentsError("an image of " + std::to_string(options.width) + " × " +
                             std::to_string(options.height) +
                             " pixels is too small: no face of tile " +
                             std::to_string(options.tile.number()) + " holds a pixel's centre");
    }
    made.facesWithoutPixel = countLost(mesh, *raster, options.tile);
    StageProgress growing(progress, 0.05, 0.15);
    if (const Status grown =
            growRaster(*raster, mesh, options.tile, options.gutter, options.threads, growing);
        !grown) {
        return tl::unexpected(grown.error());
    }
    const auto channels = static_cast<std::size_t>(format.channels);
    std::vector<float> values(raster->pixelCount() * channels);
    std::vector<std::uint8_t> known(raster->pixelCount());
    const PixelPlane plane(options.width, options.height, options.tile);
    StageProgress drawing(progress, 0.15, 0.85);
    if (const Status drawn =
            drawAll(scene, mesh, *raster, plane, options.threads, values, known, drawing);
        !drawn) {
        return tl::unexpected(drawn.error());
    }
    made.gutterPixels =
        static_cast<std::uint64_t>(std::count(known.begin(), known.end(), std::uint8_t{1})) -
        made.insidePixels;
    StageProgress filling(progress, 0.85, format.alpha ? 0.9 : 0.95);
    Status filled = fillHoles(
        values, known, options.width, options.height, format.channels, options.threads, filling);
    if (filled && format.alpha) {
        StageProgress spreading(progress, 0.9, 0.95);
        filled = spreadColors(values, format, options, spreading);
    }
    if (!filled) {
        return tl::unexpected(filled.error());
    }
    StageProgress encoding(progress, 0.95, 1);
    return encodedImage(values, format, options, encoding).map([&](Image image) {
        made.image = std::move(image);
        return std::move(made);
    });
}

} // namespace trixel
