// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/bvh_build.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <limits>
#include <span>

namespace trixel {

namespace {

constexpr std::size_t kLeafFaces = 4;
constexpr int kBins = 16;
/// Beyond this depth ranges are halved by count: at most 30 more levels for 2^30 faces.
constexpr int kHalvingDepth = 48;
/// Subtrees of at most this part of the mesh are built in parallel.
constexpr std::size_t kSubtreeShare = 32;

struct Box
{
    glm::vec3 low{std::numeric_limits<float>::max()};
    glm::vec3 high{std::numeric_limits<float>::lowest()};

    void include(glm::vec3 boxLow, glm::vec3 boxHigh)
    {
        low = glm::min(low, boxLow);
        high = glm::max(high, boxHigh);
    }
    /// Half its area, in double: large coordinates do not overflow.
    double halfArea() const
    {
        const glm::dvec3 d = glm::dvec3(high) - glm::dvec3(low);
        return d.x * d.y + d.y * d.z + d.z * d.x;
    }
};

struct Item
{
    glm::vec3 low;
    std::uint32_t face;
    glm::vec3 high;
    std::uint32_t padding;

    glm::vec3 middle() const { return 0.5F * low + 0.5F * high; }
};

using Items = std::span<Item>;

/// Sorts middles into bins along one axis.
struct Binning
{
    int axis = 0;
    float start = 0;
    float scale = 0; ///< bins per world unit; 0 when the middles do not spread

    static Binning over(const Box& middles)
    {
        const glm::vec3 extent = middles.high - middles.low;
        Binning binning;
        binning.axis =
            extent.x > extent.y ? (extent.x > extent.z ? 0 : 2) : (extent.y > extent.z ? 1 : 2);
        binning.start = middles.low[binning.axis];
        const float length = extent[binning.axis];
        const float scale = static_cast<float>(kBins) / length;
        const bool usable = scale > 0 && scale < std::numeric_limits<float>::max();
        binning.scale = usable ? scale : 0;
        return binning;
    }

    int binOf(const Item& item) const
    {
        const float place = (item.middle()[axis] - start) * scale;
        return place > 0 ? static_cast<int>(std::min(place, float{kBins - 1})) : 0;
    }
};

struct Bin
{
    Box box;
    std::size_t count = 0;
};

/// The first bin of the right side where the expected cost of a query is least; 0 if there is no
/// split that leaves something on either side.
int cheapestSplit(const std::array<Bin, kBins>& bins)
{
    std::array<double, kBins> rightCost{};
    Bin right;
    for (int k = kBins - 1; k > 0; --k) {
        const Bin& bin = bins[static_cast<std::size_t>(k)];
        right.box.include(bin.box.low, bin.box.high);
        right.count += bin.count;
        rightCost[static_cast<std::size_t>(k)] =
            right.count > 0 ? right.box.halfArea() * static_cast<double>(right.count) : -1;
    }
    Bin left;
    int best = 0;
    double bestCost = std::numeric_limits<double>::infinity();
    for (int k = 1; k < kBins; ++k) {
        const Bin& bin = bins[static_cast<std::size_t>(k - 1)];
        left.box.include(bin.box.low, bin.box.high);
        left.count += bin.count;
        const double other = rightCost[static_cast<std::size_t>(k)];
        if (left.count == 0 || other < 0) {
            continue;
        }
        const double cost = left.box.halfArea() * static_cast<double>(left.count) + other;
        if (cost < bestCost) {
            bestCost = cost;
            best = k;
        }
    }
    return best;
}

/// Reorders the items and returns how many go to the left child; both sides get at least one.
std::size_t split(Items items, const Box& middles, int depth)
{
    const Binning binning = Binning::over(middles);
    if (binning.scale > 0 && depth < kHalvingDepth) {
        std::array<Bin, kBins> bins;
        for (const Item& item : items) {
            Bin& bin = bins[static_cast<std::size_t>(binning.binOf(item))];
            bin.box.include(item.low, item.high);
            ++bin.count;
        }
        if (const int bin = cheapestSplit(bins); bin > 0) {
            const auto middle = std::partition(items.begin(), items.end(), [&](const Item& item) {
                return binning.binOf(item) < bin;
            });
            return static_cast<std::size_t>(middle - items.begin());
        }
    }
    const auto half = items.begin() + static_cast<std::ptrdiff_t>(items.size() / 2);
    std::nth_element(items.begin(), half, items.end(), [&](const Item& a, const Item& b) {
        const float x = a.middle()[binning.axis];
        const float y = b.middle()[binning.axis];
        return x < y || (x == y && a.face < b.face);
    });
    return items.size() / 2;
}

/// A node yet to be filled in, and the items under it.
struct Pending
{
    std::size_t node = 0;
    std::size_t begin = 0;
    std::size_t end = 0;
    int depth = 0;
};

/// Builds nodes over a range of items, down to leaves or to ranges of at most `stop` items, which
/// are left in `pending`.
class Builder
{
public:
    Builder(Items items, std::size_t stop, std::vector<BvhNode>& nodes)
        : m_items(items)
        , m_stop(stop)
        , m_nodes(nodes)
    {
    }

    void build(const Pending& task)
    {
        const std::size_t count = task.end - task.begin;
        if (count <= m_stop) {
            pending.push_back(task);
            return;
        }
        const Items items = m_items.subspan(task.begin, count);
        Box box;
        Box middles;
        for (const Item& item : items) {
            box.include(item.low, item.high);
            middles.include(item.middle(), item.middle());
        }
        BvhNode node{box.low, static_cast<std::uint32_t>(task.begin), box.high, 0};
        if (count <= kLeafFaces) {
            node.count = static_cast<std::uint32_t>(count);
            m_nodes[task.node] = node;
            return;
        }
        const std::size_t middle = task.begin + split(items, middles, task.depth);
        const std::size_t left = m_nodes.size();
        node.first = static_cast<std::uint32_t>(left);
        m_nodes[task.node] = node;
        m_nodes.resize(left + 2);
        build({left, task.begin, middle, task.depth + 1});
        build({left + 1, middle, task.end, task.depth + 1});
    }

    std::vector<Pending> pending;

private:
    Items m_items;
    std::size_t m_stop;
    std::vector<BvhNode>& m_nodes;
};

std::vector<Item> itemsOf(const TriangleMesh& mesh, Threads threads)
{
    std::vector<Item> items(mesh.faceCount());
    parallelFor(items.size(), 65536, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            const auto [a, b, c] = mesh.corners(faceId(k));
            items[k] = {glm::min(glm::min(a, b), c),
                        static_cast<std::uint32_t>(k),
                        glm::max(glm::max(a, b), c),
                        0};
        }
    });
    return items;
}

/// Puts a subtree, numbered from its own root at 0, in the place of a node of the whole tree.
void graft(const std::vector<BvhNode>& subtree, std::size_t place, std::vector<BvhNode>& nodes)
{
    const auto shift = static_cast<std::uint32_t>(nodes.size()) - 1;
    const auto moved = [shift](BvhNode node) {
        node.first += node.isLeaf() ? 0 : shift;
        return node;
    };
    nodes[place] = moved(subtree.front());
    std::transform(subtree.begin() + 1, subtree.end(), std::back_inserter(nodes), moved);
}

} // namespace

BvhTree buildBvh(const TriangleMesh& mesh, Threads threads)
{
    BvhTree tree;
    if (mesh.faceCount() == 0) {
        return tree;
    }
    std::vector<Item> items = itemsOf(mesh, threads);
    tree.nodes.resize(1);
    // Where subtrees begin depends on the mesh alone, so the tree does not depend on threads.
    Builder top(items, std::max<std::size_t>(items.size() / kSubtreeShare, 1024), tree.nodes);
    top.build({0, 0, items.size(), 0});

    std::vector<std::vector<BvhNode>> subtrees(top.pending.size());
    parallelFor(subtrees.size(), 1, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            Pending task = top.pending[k];
            task.node = 0;
            subtrees[k].resize(1);
            Builder(items, 0, subtrees[k]).build(task);
        }
    });
    for (std::size_t k = 0; k < subtrees.size(); ++k) {
        graft(subtrees[k], top.pending[k].node, tree.nodes);
    }
    tree.nodes.shrink_to_fit();
    tree.faces.reserve(items.size());
    for (const Item& item : items) {
        tree.faces.push_back(faceId(item.face));
    }
    return tree;
}

} // namespace trixel
