// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/views/seen_faces.h"

#include "core/lattice/texel.h"
#include "core/study/views/view_queries.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace trixel {
namespace {

/// Part of the distance by which what is nearer hides nothing.
constexpr double kTouching = 1e-5;

constexpr double kPixelsAsked = 4e6;

/// Points within a face: the centroids of 16 cells, and for what shows only past another face's
/// edge, places close to the corners and to the middles of the edges.
std::vector<glm::dvec2> makeProbes()
{
    constexpr double kInset = 1e-3;
    const Level cells(2);
    std::vector<glm::dvec2> probes;
    for (std::uint32_t cell = 0; cell < cells.texelCount(); ++cell) {
        probes.push_back(centroid(cells, texelAt(cells, static_cast<TexelIndex>(cell))));
    }
    const glm::dvec2 middle(1.0 / 3.0);
    for (const glm::dvec2 place : {glm::dvec2(0, 0),
                                   glm::dvec2(1, 0),
                                   glm::dvec2(0, 1),
                                   glm::dvec2(0.5, 0),
                                   glm::dvec2(0.5, 0.5),
                                   glm::dvec2(0, 0.5)}) {
        probes.push_back(place + kInset * (middle - place));
    }
    return probes;
}

} // namespace

bool sees(const Surface& surface, const ViewCamera& camera, glm::dvec3 point, double margin)
{
    if (!camera.frames(point, margin)) {
        return false;
    }
    const glm::dvec3 away = point - camera.position;
    const auto hit = surface.bvh().raycast({glm::vec3(camera.position), glm::vec3(away)});
    // Past an edge a ray may miss the very point it is aimed at.
    return !hit || glm::dot(glm::dvec3(hit->position) - camera.position, away) >=
                       (1 - kTouching) * glm::dot(away, away);
}

SeenFaces::SeenFaces(std::size_t faces, std::size_t cameras)
    : m_words((cameras + 63) / 64)
    , m_seen(faces * m_words, 0)
{
}

bool SeenFaces::isSeen(FaceId face) const
{
    const auto words = std::span(m_seen).subspan(indexOf(face) * m_words, m_words);
    return std::ranges::any_of(words, [](std::uint64_t word) { return word != 0; });
}

Status SeenFaces::askPixels(const Surface& surface,
                            std::span<const ViewCamera> cameras,
                            Threads threads,
                            Progress& progress)
{
    double pixels = 0;
    for (const ViewCamera& camera : cameras) {
        pixels += static_cast<double>(camera.width) * camera.height;
    }
    const int step = std::max(1, static_cast<int>(std::ceil(std::sqrt(pixels / kPixelsAsked))));
    for (std::size_t k = 0; k < cameras.size(); ++k) {
        StageProgress part(progress,
                           static_cast<double>(k) / static_cast<double>(cameras.size()),
                           static_cast<double>(k + 1) / static_cast<double>(cameras.size()));
        const auto found = viewQueries(surface, cameras[k], {step, 0}, threads, part);
        if (!found) {
            return tl::unexpected(found.error());
        }
        for (const FaceId face : found->queries.face) {
            mark(k, face);
        }
    }
    return {};
}

Status SeenFaces::askFaces(const Surface& surface,
                           std::span<const ViewCamera> cameras,
                           double margin,
                           Threads threads,
                           Progress& progress)
{
    constexpr std::size_t kBetweenReports = 16384;
    const std::vector<glm::dvec2> probes = makeProbes();
    const std::size_t faces = surface.mesh().faceCount();
    const auto ask = [&](std::size_t camera, FaceId face) {
        const auto corners = surface.mesh().corners(face);
        return std::ranges::any_of(probes, [&](glm::dvec2 uv) {
            const glm::dvec3 a(corners[0]);
            return sees(surface,
                        cameras[camera],
                        a + uv.x * (glm::dvec3(corners[1]) - a) +
                            uv.y * (glm::dvec3(corners[2]) - a),
                        margin);
        });
    };
    for (std::size_t first = 0; first < faces; first += kBetweenReports) {
        if (!progress.report(static_cast<double>(first) / static_cast<double>(faces))) {
            return cancelled();
        }
        const std::size_t count = std::min(kBetweenReports, faces - first);
        parallelFor(count, 64, threads, [&](std::size_t begin, std::size_t end) {
            for (std::size_t f = first + begin; f < first + end; ++f) {
                for (std::size_t k = 0; k < cameras.size(); ++k) {
                    if (!isSeenBy(k, faceId(f)) && ask(k, faceId(f))) {
                        mark(k, faceId(f));
                    }
                }
            }
        });
    }
    return {};
}

Result<SeenFaces> SeenFaces::find(const Surface& surface,
                                  std::span<const ViewCamera> cameras,
                                  double margin,
                                  Threads threads,
                                  Progress& progress)
{
    SeenFaces seen(surface.mesh().faceCount(), cameras.size());
    StageProgress looking(progress, 0, 0.5);
    if (const Status status = seen.askPixels(surface, cameras, threads, looking); !status) {
        return tl::unexpected(status.error());
    }
    StageProgress asking(progress, 0.5, 1);
    if (const Status status = seen.askFaces(surface, cameras, margin, threads, asking); !status) {
        return tl::unexpected(status.error());
    }
    return seen;
}

} // namespace trixel
