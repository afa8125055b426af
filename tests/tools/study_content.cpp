// SPDX-License-Identifier: GPL-3.0-or-later
#include "study_content.h"

#include "core/study/test_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <random>
#include <vector>

namespace trixel {
namespace {

const double kPeriod = kTileRhombi * static_cast<double>(kTileLevel.resolution());

std::uint32_t hashed(std::uint32_t x, std::uint32_t y, std::uint32_t seed)
{
    std::uint32_t h = x * 0x9E3779B1U ^ y * 0x85EBCA77U ^ seed * 0xC2B2AE3DU;
    h = (h ^ (h >> 15U)) * 0x2C1B3C6DU;
    h = (h ^ (h >> 12U)) * 0x297A2D39U;
    return h ^ (h >> 15U);
}

double valueAt(int x, int y, int cells, std::uint32_t seed)
{
    const auto wrapped = [&](int k) {
        return static_cast<std::uint32_t>(((k % cells) + cells) % cells);
    };
    return hashed(wrapped(x), wrapped(y), seed) / 4294967296.0 - 0.5;
}

/// Smoothly interpolated noise of `cells` cells across the tile.
double noise(double x, double y, int cells, std::uint32_t seed)
{
    const double gx = x / kPeriod * cells;
    const double gy = y / kPeriod * cells;
    const int ix = static_cast<int>(std::floor(gx));
    const int iy = static_cast<int>(std::floor(gy));
    const auto eased = [](double t) { return t * t * (3 - 2 * t); };
    const double tx = eased(gx - ix);
    const double ty = eased(gy - iy);
    return glm::mix(
        glm::mix(valueAt(ix, iy, cells, seed), valueAt(ix + 1, iy, cells, seed), tx),
        glm::mix(valueAt(ix, iy + 1, cells, seed), valueAt(ix + 1, iy + 1, cells, seed), tx),
        ty);
}

double fractalNoise(double x, double y, std::uint32_t seed)
{
    double sum = 0;
    double amplitude = 1;
    for (int cells = 4; cells <= 256; cells *= 2) {
        sum += amplitude * noise(x, y, cells, seed + static_cast<std::uint32_t>(cells));
        amplitude *= 0.5;
    }
    return sum;
}

struct Leaf
{
    glm::dvec2 centre; // oblique axes
    double radius;     // texels of the plane
    double stretch;
    double angle;
    double softness;
    glm::dvec3 colour;
};

double uniform(std::mt19937_64& random)
{
    return static_cast<double>(random() >> 11U) * 0x1p-53;
}

glm::dvec3 earthly(std::mt19937_64& random)
{
    constexpr std::array<std::array<double, 3>, 6> kPalette = {{{0.20, 0.34, 0.16},
                                                                {0.55, 0.47, 0.22},
                                                                {0.72, 0.62, 0.48},
                                                                {0.30, 0.20, 0.14},
                                                                {0.45, 0.58, 0.70},
                                                                {0.85, 0.80, 0.72}}};
    const auto& base = kPalette[static_cast<std::size_t>(uniform(random) * kPalette.size())];
    const double light = 0.6 + 0.7 * uniform(random);
    return {base[0] * light, base[1] * light, base[2] * light};
}

std::vector<Leaf> scatterLeaves()
{
    std::mt19937_64 random(7);
    std::vector<Leaf> leaves;
    for (int k = 0; k < 2200; ++k) {
        Leaf leaf;
        leaf.centre = {uniform(random) * kPeriod, uniform(random) * kPeriod};
        // Areas by a power law, as in photographs: many small ones.
        leaf.radius = 3.5 / std::sqrt(1 - uniform(random) * (1 - 12.25 / (90.0 * 90.0)));
        leaf.stretch = 1 + 2 * uniform(random);
        leaf.angle = 6.283185307179586 * uniform(random);
        leaf.softness = 1 + 2 * uniform(random);
        leaf.colour = earthly(random);
        leaves.push_back(leaf);
    }
    std::ranges::sort(leaves, std::ranges::greater{}, &Leaf::radius);
    return leaves;
}

/// From the nearest copy of the centre, in the plane.
glm::dvec2 offsetFrom(glm::dvec2 centre, double x, double y)
{
    const double dx = x - centre.x - kPeriod * std::round((x - centre.x) / kPeriod);
    const double dy = y - centre.y - kPeriod * std::round((y - centre.y) / kPeriod);
    return {dx + dy / 2, dy * 0.86602540378443865};
}

double coverage(const Leaf& leaf, double x, double y)
{
    const glm::dvec2 d = offsetFrom(leaf.centre, x, y);
    const double along = std::cos(leaf.angle) * d.x + std::sin(leaf.angle) * d.y;
    const double across = (std::cos(leaf.angle) * d.y - std::sin(leaf.angle) * d.x) * leaf.stretch;
    const double outside = std::sqrt(along * along + across * across) - leaf.radius;
    return 1 - glm::smoothstep(-leaf.softness, leaf.softness, outside);
}

/// Rows of letter-like signs, five by seven dots each in cells of six by eight.
bool sign(double x, double y, double dot)
{
    const int column = static_cast<int>(std::floor(x / dot));
    const int row = static_cast<int>(std::floor(y / dot));
    const int inX = column % 6;
    const int inY = row % 8;
    if (inX == 5 || inY == 7) {
        return false;
    }
    const auto letter = static_cast<std::uint32_t>(column / 6 + 97 * (row / 8));
    // Strokes rather than dust: whole columns and rows of the sign, and single dots between.
    const bool stem = (hashed(letter, static_cast<std::uint32_t>(inX), 1) & 3U) == 0;
    const bool bar = (hashed(letter, static_cast<std::uint32_t>(inY), 2) & 3U) == 0;
    return stem || bar;
}

bool ink(int pattern, double x, double y, double px, double py)
{
    const auto odd = [](double a) { return (static_cast<long>(std::floor(a)) & 1L) != 0; };
    const double size = std::array<double, 4>{2, 4, 8, 16}[static_cast<std::size_t>(pattern % 4)];
    switch (pattern / 4) {
    case 0: // checks along the lattice
        return odd(x / size) != odd(y / size);
    case 1: // stripes at an angle of their own
        return odd((px * (1 + pattern % 3) + py * (2 - pattern % 3)) / (1.6 * size));
    case 2:
        return sign(x, y, std::max(1.0, size / 3));
    default: { // rings
        const double r = std::hypot(px - 96, py - 56);
        return odd(r / size);
    }
    }
}

} // namespace

glm::dvec3 naturalContent(double x, double y)
{
    static const std::vector<Leaf> kLeaves = scatterLeaves();
    glm::dvec3 colour(0.42, 0.40, 0.33);
    for (const Leaf& leaf : kLeaves) {
        colour = glm::mix(colour, leaf.colour, coverage(leaf, x, y));
    }
    const double light = 1 + 0.5 * fractalNoise(x, y, 11);
    const double warmth = 0.05 * noise(x, y, 16, 5);
    return glm::clamp(colour * light + glm::dvec3(warmth, 0, -warmth), 0.0, 1.0);
}

glm::dvec3 hardEdgedContent(double x, double y)
{
    constexpr int kPatches = 4; // along each side of the tile
    const double size = kPeriod / kPatches;
    const int column = static_cast<int>(x / size);
    const int row = static_cast<int>(y / size);
    const double inX = x - column * size;
    const double inY = y - row * size;
    const int pattern = (column + kPatches * row) * 7 % 16;
    constexpr std::array<std::array<double, 3>, 4> kInks = {
        {{0, 0, 0}, {0.9, 0.1, 0.1}, {0.05, 0.2, 0.8}, {0.1, 0.1, 0.1}}};
    constexpr std::array<std::array<double, 3>, 4> kPapers = {
        {{1, 1, 1}, {1, 1, 0.2}, {0.9, 1, 0.9}, {0.2, 0.9, 0.3}}};
    const auto choice = static_cast<std::size_t>((column + 2 * row) % 4);
    const bool isInk = ink(pattern, inX, inY, inX + inY / 2, inY * 0.86602540378443865);
    const auto& c = isInk ? kInks[choice] : kPapers[choice];
    return {c[0], c[1], c[2]};
}

} // namespace trixel
