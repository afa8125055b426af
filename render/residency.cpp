// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/residency.h"

#include "core/base/check.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>

namespace trixel::render {

namespace {

constexpr std::size_t kGrain = 1U << 14U;
constexpr float kMargin = 1.1F; // of the view that counts as seen
/// Faces are made finer in steps of so many levels at once.
constexpr int kStep = 3;
constexpr int kSteps = Level::kMax / kStep;
/// A block that the view could do without is kept until the wish is so much lower.
constexpr int kLag = 3;

/// ceil(8 log2 x) rounded up to the eighths of the number's own binary places.
int eighths(float x)
{
    constexpr int kBias = 127 << 3;
    return ((std::bit_cast<std::int32_t>(x) - 1) >> 20) - kBias + 1;
}

int levelFor(int wish, int bias)
{
    return std::max(0, (wish - bias + 7) >> 3);
}

/// The view in the form that the loop needs: coordinates along its axes, from the eye.
struct Cone
{
    glm::vec3 eye, right, up, forward;
    float sideX = 0, depthX = 0; ///< a sphere is inside where |x| sideX - z depthX <= radius
    float sideY = 0, depthY = 0;
    float perDepth = 0; ///< pixels of a length of 1 at depth 1, at the corner of the view

    explicit Cone(const Camera& camera)
    {
        const glm::dvec2 size(camera.viewport());
        const PixelRay ray = camera.pixelRay(size / 2.0);
        const double perUnit = 1 / glm::length(ray.perX);
        eye = ray.origin;
        right = perUnit * ray.perX;
        up = perUnit * ray.perY;
        forward = ray.direction;
        const glm::dvec2 tangent = size / (2 * perUnit);
        const auto sides = [](double t, float& side, float& depth) {
            const double wide = kMargin * t;
            side = static_cast<float>(1 / std::sqrt(1 + wide * wide));
            depth = static_cast<float>(wide / std::sqrt(1 + wide * wide));
        };
        sides(tangent.x, sideX, depthX);
        sides(tangent.y, sideY, depthY);
        // A length appears longest where it points away from the middle of the view.
        perDepth = static_cast<float>(perUnit * std::sqrt(1 + glm::dot(tangent, tangent)));
    }
};

/// How many faces in view wish for what, of those with the same finest level.
using Histogram = std::array<std::array<std::uint64_t, Level::kMax + 1>, kMostWish + 1>;

std::uint64_t elementsAt(const Histogram& counts, const CardRoom& room, int bias)
{
    std::uint64_t sum = 0;
    for (int wish = 1; wish <= kMostWish; ++wish) {
        const int level = levelFor(wish, bias);
        for (int own = 1; own <= Level::kMax; ++own) {
            const auto count =
                counts[static_cast<std::size_t>(wish)][static_cast<std::size_t>(own)];
            sum += count * room.perBlock[static_cast<std::size_t>(std::min(level, own))];
        }
    }
    return sum;
}

/// Jobs by urgency, sorted by counting.
class JobQueue
{
public:
    static constexpr std::size_t kKeys = (kSteps + 1) * (kMostWish + 1);

    void add(FaceId face, int level, int wish)
    {
        const int step = (level + kStep - 1) / kStep;
        const auto key = static_cast<std::uint16_t>(step * (kMostWish + 1) + kMostWish - wish);
        m_jobs.push_back({face, static_cast<std::uint8_t>(level)});
        m_keys.push_back(key);
        ++m_counts[key];
    }

    std::vector<BlockJob> sorted() const
    {
        std::array<std::size_t, kKeys> at{};
        for (std::size_t key = 1; key < kKeys; ++key) {
            at[key] = at[key - 1] + m_counts[key - 1];
        }
        std::vector<BlockJob> result(m_jobs.size());
        for (std::size_t k = 0; k < m_jobs.size(); ++k) {
            result[at[m_keys[k]]++] = m_jobs[k];
        }
        return result;
    }

private:
    std::vector<BlockJob> m_jobs;
    std::vector<std::uint16_t> m_keys;
    std::array<std::size_t, kKeys> m_counts{};
};

/// Steps on the way to a level, so that something better shows soon.
void addSteps(JobQueue& jobs, FaceId face, int from, int to, int wish)
{
    for (int level = kStep; level + 1 < to; level += kStep) {
        if (level > from) {
            jobs.add(face, level, wish);
        }
    }
    jobs.add(face, to, wish);
}

} // namespace

FaceExtents FaceExtents::of(const TriangleMesh& mesh, Threads threads)
{
    FaceExtents faces;
    for (std::vector<float>* values : {&faces.x, &faces.y, &faces.z, &faces.radius, &faces.edge}) {
        values->resize(mesh.faceCount());
    }
    parallelFor(mesh.faceCount(), kGrain, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f) {
            const auto c = mesh.corners(faceId(f));
            const glm::vec3 centre = (c[0] + c[1] + c[2]) / 3.0F;
            faces.x[f] = centre.x;
            faces.y[f] = centre.y;
            faces.z[f] = centre.z;
            faces.radius[f] = std::max({glm::distance(centre, c[0]),
                                        glm::distance(centre, c[1]),
                                        glm::distance(centre, c[2])});
            faces.edge[f] = std::max(
                {glm::distance(c[0], c[1]), glm::distance(c[1], c[2]), glm::distance(c[2], c[0])});
        }
    });
    return faces;
}

void wishesOf(const FaceExtents& faces,
              const Camera& camera,
              Threads threads,
              std::span<Wish> wishes)
{
    check(wishes.size() == faces.size(), "one wish a face");
    const Cone cone(camera);
    parallelFor(faces.size(), kGrain, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f) {
            const float dx = faces.x[f] - cone.eye.x;
            const float dy = faces.y[f] - cone.eye.y;
            const float dz = faces.z[f] - cone.eye.z;
            const float r = faces.radius[f];
            const float x = dx * cone.right.x + dy * cone.right.y + dz * cone.right.z;
            const float y = dx * cone.up.x + dy * cone.up.y + dz * cone.up.z;
            const float z = dx * cone.forward.x + dy * cone.forward.y + dz * cone.forward.z;
            const float outX = std::abs(x) * cone.sideX - z * cone.depthX;
            const float outY = std::abs(y) * cone.sideY - z * cone.depthY;
            const float out = std::max(std::max(outX, outY), -z);
            // What reaches behind the eye is as near as can be.
            const float depth = std::max(z - r, 1e-30F);
            const float pixels = std::min(faces.edge[f] * cone.perDepth / depth, 1e30F);
            const int wish = std::clamp(eighths(std::max(pixels, 1e-30F)), 0, int{kMostWish});
            wishes[f] = out <= r ? static_cast<Wish>(wish) : kUnseen;
        }
    });
}

CardRoom CardRoom::of(const CardBlocks& blocks, std::uint64_t elements)
{
    CardRoom room;
    // Ends of shelves, and runs of pages at the end of the buffer.
    std::uint64_t lost = elements / 16;
    for (int level = 1; level <= Level::kMax; ++level) {
        const CardBlocks::ShelfSize shelf = blocks.shelfOf(Level(level));
        const auto k = static_cast<std::size_t>(level);
        room.perBlock[k] = (shelf.elements + shelf.blocks - 1) / shelf.blocks;
        if (shelf.elements - room.perBlock[k] <= elements / 64) {
            lost += shelf.elements - room.perBlock[k];
        }
    }
    room.elements = elements > lost ? elements - lost : 0;
    return room;
}

ResidencyPlan
planResidency(std::span<const Wish> wishes, std::span<const FaceOnCard> faces, const CardRoom& room)
{
    check(wishes.size() == faces.size(), "one wish a face");
    ResidencyPlan plan;
    Histogram counts{};
    for (std::size_t f = 0; f < faces.size(); ++f) {
        if (wishes[f] != kUnseen) {
            ++counts[wishes[f]][faces[f].own];
            ++plan.facesInView;
        }
    }
    plan.elements = elementsAt(counts, room, 0);
    while (plan.elements > room.elements && plan.bias < kMostWish) {
        plan.elements = elementsAt(counts, room, ++plan.bias);
    }
    plan.wanted.resize(faces.size());
    JobQueue jobs;
    std::vector<BlockJob> excess;
    std::vector<BlockJob> lagging;
    for (std::size_t f = 0; f < faces.size(); ++f) {
        const FaceOnCard& face = faces[f];
        const bool isSeen = wishes[f] != kUnseen;
        const int wish = isSeen ? wishes[f] : 0;
        const int wanted = isSeen ? levelFor(wish, plan.bias) : 0;
        const int target = std::min<int>(wanted, face.own);
        const int shown = face.level();
        plan.wanted[f] = static_cast<std::uint8_t>(std::min(wanted, Level::kMax));
        const bool isWrong = shown > 0 && (face.isStale() || shown > face.own);
        if (isWrong && target == 0) {
            plan.release.push_back(faceId(f));
        } else if (isWrong) {
            jobs.add(faceId(f), std::max(target, std::min<int>(shown, face.own)), wish);
        } else if (shown < target) {
            addSteps(jobs, faceId(f), shown, target, wish);
        } else if (shown > target) {
            const BlockJob job{faceId(f), static_cast<std::uint8_t>(target)};
            const bool isFar = shown > std::min<int>(levelFor(wish + kLag, plan.bias), face.own);
            (!isSeen ? plan.spare : isFar ? excess : lagging).push_back(job);
        }
    }
    plan.make = jobs.sorted();
    plan.spare.insert(plan.spare.end(), excess.begin(), excess.end());
    plan.spare.insert(plan.spare.end(), lagging.begin(), lagging.end());
    return plan;
}

} // namespace trixel::render
