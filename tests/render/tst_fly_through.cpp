// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is on the card while a camera flies, frame by frame.
#include "core/mesh/mesh_reader.h"
#include "core/texture/face_vertices.h"
#include "core/texture/mips.h"
#include "render/display_texels.h"
#include "render/display_vertices.h"
#include "tests/bench/sheet_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <random>

using namespace trixel;
using namespace trixel::render;

namespace {

TriangleMesh torusMesh(int around, int across)
{
    TriangleMesh mesh;
    for (int i = 0; i < around; ++i) {
        for (int j = 0; j < across; ++j) {
            const double a = 2 * std::numbers::pi * i / around;
            const double b = 2 * std::numbers::pi * j / across;
            const double r = 0.7 + 0.3 * std::cos(b);
            mesh.positions.emplace_back(r * std::cos(a), 0.3 * std::sin(b), r * std::sin(a));
        }
    }
    const auto id = [=](int i, int j) {
        return static_cast<std::uint32_t>((i % around) * across + j % across);
    };
    for (int i = 0; i < around; ++i) {
        for (int j = 0; j < across; ++j) {
            mesh.triangles.push_back({id(i, j), id(i, j + 1), id(i + 1, j)});
            mesh.triangles.push_back({id(i + 1, j + 1), id(i + 1, j), id(i, j + 1)});
        }
    }
    return mesh;
}

/// Noise at levels 0 to `most`, some faces constant.
TexelStore mixedStore(std::size_t faces, int most)
{
    std::mt19937 random(5);
    const std::vector<std::byte> grey(3, std::byte{128});
    TexelStore store(static_cast<std::uint32_t>(faces), TexelFormat{}, Level(), grey);
    for (std::size_t f = 0; f < faces; ++f) {
        const Level level(static_cast<int>(random() % static_cast<unsigned>(most + 1)));
        store.exchange(faceId(f), FaceTexels::constant(level, grey));
        if (f % 7 != 0) {
            for (std::byte& b : store.writable(faceId(f))) {
                b = static_cast<std::byte>(random());
            }
        }
    }
    return store;
}

/// The bunny, two units large.
TriangleMesh bunnyMesh()
{
    NoProgress progress;
    auto read = readMesh("/usr/share/glmark2/models/bunny.obj", progress);
    TriangleMesh mesh = read ? std::move(*read) : TriangleMesh();
    glm::vec3 low(1e30F);
    glm::vec3 high(-1e30F);
    for (const glm::vec3& position : mesh.positions) {
        low = glm::min(low, position);
        high = glm::max(high, position);
    }
    for (glm::vec3& position : mesh.positions) {
        position = 2.0F * (position - 0.5F * (low + high)) / (high.x - low.x);
    }
    return mesh;
}

/// What is displayed: texels or vertices, each with how to tell that they are right.
struct Texels
{
    Texels(const TriangleMesh& mesh, const TexelStore& store, std::uint32_t most)
        : extents(FaceExtents::of(mesh, Threads{1}))
    {
        display.reset(store, 0, most);
    }

    /// Before the mean has come a base is a texel of its face.
    static constexpr bool kBasesComeLater = true;
    static constexpr std::size_t kBase = 1; ///< elements

    void begin() const {}

    static bool isConstant(const TexelStore& store, FaceId face)
    {
        return store.face(face).isConstant();
    }

    static std::vector<std::byte> block(const TexelStore& store, FaceId face, Level level)
    {
        const FaceTexels& texels = store.face(face);
        std::vector<std::byte> expected;
        appendShown(store.format(),
                    reduced(store.format(), texels, texels.level().log2() - level.log2()).bytes(),
                    expected);
        return expected;
    }

    FaceExtents extents;
    DisplayTexels display;
};

struct Vertices
{
    Vertices(const TriangleMesh& mesh, const TexelStore& store, std::uint32_t most)
        : filterMesh(
              std::make_shared<const FilterMesh>(mesh, buildAdjacency(mesh.triangles), store))
        , extents(vertexExtents(mesh, *filterMesh, Threads{1}))
    {
        display.reset(filterMesh, store, 0, most);
    }

    static constexpr bool kBasesComeLater = false;
    static constexpr std::size_t kBase = 3; ///< elements

    /// For the store as it is: chains of faces are kept from one to the next.
    void begin() const { m_chains.forget(); }

    bool isConstant(const TexelStore& store, FaceId face) const
    {
        const FaceMips mips(store, m_chains);
        return FaceVertices(mips, filterMesh->adjacency(), filterMesh->rings()).isConstant(face);
    }

    std::vector<std::byte> block(const TexelStore& store, FaceId face, Level level) const
    {
        const FaceMips mips(store, m_chains);
        std::vector<std::byte> expected;
        FaceVertices(mips, filterMesh->adjacency(), filterMesh->rings())
            .appendBlock(face, level, expected);
        return expected;
    }

    std::shared_ptr<const FilterMesh> filterMesh;
    FaceExtents extents;
    DisplayVertices display;

private:
    mutable ChainCache m_chains{{0, 1, 2, -1}, std::size_t{1} << 28U};
};

/// A display and what the card would hold, with work done by the frame.
template <class Shown>
class Flight
{
public:
    Flight(const TriangleMesh& mesh, TexelStore store, std::uint32_t most)
        : m_store(std::move(store))
        , m_shown(mesh, m_store, most)
        , m_most(most)
    {
        m_camera.setViewport(500, 400);
        m_camera.setScene({-1, -1, -1}, {1, 1, 1});
    }

    void look(const CameraPose& pose)
    {
        m_camera.setPose(pose);
        m_isNewView = true;
    }

    /// One frame that has time for so many batches.
    void frame(int batches)
    {
        ++m_frames;
        if (m_display.needsOpening()) {
            m_display.open(m_display.opener()(m_store));
            m_isNewView = true;
        }
        while (m_display.isOpening()) {
            apply(m_display.takeReady(m_store, 1U << 20U));
        }
        if (m_isNewView || m_display.needsPlan()) {
            m_isNewView = false;
            m_wishes.resize(m_store.faceCount());
            wishesOf(m_shown.extents, m_camera, Threads{1}, m_wishes);
            m_display.follow(
                planResidency(m_wishes, m_display.facesOnCard(), m_display.mostRoom()));
        }
        while (m_underWay.size() < 3 && m_display.hasJobs()) {
            JobBatch batch = m_display.nextJobs(1U << 14U);
            if (batch.jobs.empty()) {
                break;
            }
            MadeBlocks made = m_display.maker()(m_store, batch.jobs);
            m_underWay.emplace_back(std::move(batch), std::move(made));
        }
        for (; batches > 0 && !m_underWay.empty(); --batches) {
            m_display.accept(m_underWay.front().second, m_underWay.front().first, m_store);
            m_underWay.pop_front();
        }
        apply(m_display.takeReady(m_store, 1U << 20U));
    }

    void rest()
    {
        for (int k = 0; k < 4000; ++k) {
            frame(4);
            if (m_underWay.empty() && !m_display.hasJobs() && !m_display.needsPlan()) {
                return;
            }
        }
        FAIL() << "never comes to rest";
    }

    void touchSomething(std::mt19937& random)
    {
        const FaceId face = faceId(random() % m_store.faceCount());
        const Level level = m_store.face(face).level();
        const bool wasConstant = m_store.face(face).isConstant();
        const auto x = static_cast<std::uint16_t>(random() % level.resolution());
        const auto y = static_cast<std::uint16_t>(random() % level.resolution());
        const std::span<std::byte> texels = m_store.writable(face);
        const auto index = static_cast<std::size_t>(x + y * level.resolution());
        texels[3 * index] = static_cast<std::byte>(random());
        const TouchedRect rect{face, x, y, 1, 1, wasConstant};
        m_display.touch(m_store, {{rect}});
    }

    /// No hole, no more than allowed, and every block true to the store.
    void expectSound(bool isAtRest) const
    {
        ASSERT_LE(m_elements.size() / 4, m_most);
        m_shown.begin();
        // All of them at rest, on the way every eighth, others each time.
        for (std::size_t f = isAtRest ? 0 : m_frames % 8; f < m_store.faceCount();
             f += isAtRest ? 1 : 8) {
            const FaceRecord& record = m_records[f];
            const FaceTexels& face = m_store.face(faceId(f));
            ASSERT_FALSE(record.isPending());
            ASSERT_EQ(record.ownLevel(), face.level().log2());
            if (Shown::kBasesComeLater && record.level() == 0 && !isAtRest) {
                continue;
            }
            const std::vector<std::byte> expected =
                m_shown.block(m_store, faceId(f), Level(record.level()));
            ASSERT_EQ(0,
                      std::memcmp(&m_elements[4 * std::size_t{record.offset}],
                                  expected.data(),
                                  expected.size()))
                << f;
        }
    }

    /// Every face in view as fine as wished, less what the plan had to cut.
    void expectWished() const
    {
        for (std::size_t f = 0; f < m_store.faceCount(); ++f) {
            const FaceTexels& face = m_store.face(faceId(f));
            const int cut = (m_wishes[f] - m_display.plan().bias + 7) >> 3;
            const int wanted = m_wishes[f] == kUnseen || m_shown.isConstant(m_store, faceId(f))
                                   ? 0
                                   : std::clamp(cut, 0, face.level().log2());
            ASSERT_GE(m_records[f].level(), wanted)
                << f << ": " << m_display.blocks().used() << " in " << m_display.blocks().reserved()
                << " of " << m_display.blocks().capacity() << ", planned "
                << m_display.plan().elements << " with " << m_display.mostRoom().elements;
        }
    }

    const DisplayBlocks& display() const { return m_display; }
    std::size_t bytesSent() const { return m_bytesSent; }

private:
    void apply(const DisplayUpdate& update)
    {
        if (update.fresh) {
            m_elements.clear();
            m_records.assign(m_display.records().begin(), m_display.records().end());
        }
        m_elements.resize(4 * std::size_t{update.capacity});
        for (const CardBlocks::Move& move : update.moves) {
            std::memcpy(&m_elements[4 * std::size_t{move.to}],
                        &m_elements[4 * std::size_t{move.from}],
                        4 * std::size_t{move.count});
        }
        std::size_t at = 0;
        for (const auto& range : update.texels) {
            const std::size_t size = 4 * std::size_t{range.count};
            ASSERT_LE(4 * std::size_t{range.first} + size, m_elements.size());
            std::memcpy(&m_elements[4 * std::size_t{range.first}], &update.bytes[at], size);
            at += size;
        }
        ASSERT_EQ(at, update.bytes.size());
        m_bytesSent += at;
        for (const auto& range : update.records) {
            std::copy_n(m_display.records().begin() + range.first,
                        range.count,
                        m_records.begin() + range.first);
        }
    }

    TexelStore m_store;
    Shown m_shown;
    DisplayBlocks& m_display = m_shown.display;
    std::uint32_t m_most = 0;
    Camera m_camera;
    bool m_isNewView = true;
    std::vector<Wish> m_wishes;
    std::deque<std::pair<JobBatch, MadeBlocks>> m_underWay;
    std::vector<std::byte> m_elements;
    std::vector<FaceRecord> m_records;
    std::size_t m_bytesSent = 0;
    std::size_t m_frames = 0;
};

/// Around the scene, then close to it, then along it, then away.
CameraPose poseAt(int step)
{
    const double t = step / 60.0;
    CameraPose pose;
    pose.yaw = 4 * t;
    pose.pitch = 0.5 + 0.4 * std::sin(7 * t);
    pose.distance = 0.15 + 3 * std::pow(std::cos(2 * t), 2);
    pose.target = {0.6 * std::sin(3 * t), 0, 0.6 * std::cos(3 * t)};
    return pose;
}

template <class Shown>
void fly(const TriangleMesh& mesh, int mostLevel, std::uint32_t most, bool isTight, int steps = 60)
{
    ASSERT_GT(mesh.faceCount(), 0U);
    Flight<Shown> flight(mesh, mixedStore(mesh.faceCount(), mostLevel), most);
    std::mt19937 random(8);
    int reduced = 0;
    for (int step = 0; step < steps; ++step) {
        flight.look(poseAt(step));
        flight.touchSomething(random);
        flight.frame(1 + step % 3);
        flight.expectSound(false);
        if (step % 15 == 14) {
            flight.rest();
            flight.expectSound(true);
            flight.expectWished();
            reduced += flight.display().plan().bias > 0 ? 1 : 0;
            // A view that stays asks for nothing more.
            const std::size_t sent = flight.bytesSent();
            flight.look(poseAt(step));
            flight.rest();
            EXPECT_EQ(flight.bytesSent(), sent);
        }
        if (testing::Test::HasFatalFailure()) {
            FAIL() << "step " << step;
        }
    }
    EXPECT_EQ(reduced > 0, isTight);
}

} // namespace

template <class Shown>
class FlyThrough : public testing::Test
{
};

using Kinds = testing::Types<Texels, Vertices>;
TYPED_TEST_SUITE(FlyThrough, Kinds);

TYPED_TEST(FlyThrough, aTorusWithinASmallBudget)
{
    fly<TypeParam>(torusMesh(40, 20), 6, 120'000, true);
}

TYPED_TEST(FlyThrough, aTorusWithRoomForAll)
{
    fly<TypeParam>(torusMesh(40, 20), 6, 1U << 24U, false);
}

TYPED_TEST(FlyThrough, theBunnyWithinASmallBudget)
{
    const TriangleMesh mesh = bunnyMesh();
    const std::size_t bases = mesh.faceCount() * TypeParam::kBase;
    fly<TypeParam>(mesh, 5, static_cast<std::uint32_t>(bases + 40'000), true, 30);
}

TYPED_TEST(FlyThrough, aLargeSheetWithinASmallBudget)
{
    fly<TypeParam>(sheetMesh(70), 4, 150'000, true);
}

TYPED_TEST(FlyThrough, hardlyAnyRoomAtAll)
{
    fly<TypeParam>(torusMesh(40, 20), 6, 6'000, true);
}
