// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is on the card while a camera flies, frame by frame.
#include "core/texture/mips.h"
#include "render/display_texels.h"
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

/// A display and what the card would hold, with work done by the frame.
class Flight
{
public:
    Flight(const TriangleMesh& mesh, TexelStore store, std::uint32_t maxTexels)
        : m_extents(FaceExtents::of(mesh, Threads{1}))
        , m_store(std::move(store))
        , m_maxTexels(maxTexels)
    {
        m_camera.setViewport(500, 400);
        m_camera.setScene({-1, -1, -1}, {1, 1, 1});
        m_display.reset(m_store, 0, maxTexels);
    }

    void look(const CameraPose& pose)
    {
        m_camera.setPose(pose);
        m_isNewView = true;
    }

    /// One frame that has time for so many batches.
    void frame(int batches)
    {
        if (m_display.needsOpening()) {
            m_display.open(openCard(m_store, m_display.form(), false, Threads{1}));
            m_isNewView = true;
        }
        if (m_isNewView || m_display.needsPlan()) {
            m_isNewView = false;
            m_wishes.resize(m_store.faceCount());
            wishesOf(m_extents, m_camera, Threads{1}, m_wishes);
            m_display.follow(
                planResidency(m_wishes, m_display.facesOnCard(), m_display.mostRoom()));
        }
        while (m_underWay.size() < 3 && m_display.hasJobs()) {
            JobBatch batch = m_display.nextJobs(1U << 14U);
            if (batch.jobs.empty()) {
                break;
            }
            MadeBlocks made = makeBlocks(m_store, m_display.form(), batch.jobs);
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
        ASSERT_LE(m_texels.size() / 4, m_maxTexels);
        for (std::size_t f = 0; f < m_store.faceCount(); ++f) {
            const FaceRecord& record = m_records[f];
            const FaceTexels& face = m_store.face(faceId(f));
            ASSERT_FALSE(record.isPending());
            ASSERT_EQ(record.ownLevel(), face.level().log2());
            if (record.level() == 0 && !isAtRest) {
                continue; // a texel of the face, until its mean has come
            }
            const FaceTexels shown =
                reduced(m_store.format(), face, face.level().log2() - record.level());
            std::vector<std::byte> expected;
            appendShown(m_store.format(), shown.bytes(), expected);
            ASSERT_EQ(0,
                      std::memcmp(&m_texels[4 * std::size_t{record.offset}],
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
            const int wanted = m_wishes[f] == kUnseen || face.isConstant()
                                   ? 0
                                   : std::clamp(cut, 0, face.level().log2());
            ASSERT_GE(m_records[f].level(), wanted) << f;
        }
    }

    const DisplayTexels& display() const { return m_display; }
    std::size_t bytesSent() const { return m_bytesSent; }

private:
    void apply(const DisplayUpdate& update)
    {
        if (update.fresh) {
            m_texels.clear();
            m_records.assign(m_display.records().begin(), m_display.records().end());
        }
        m_texels.resize(4 * std::size_t{update.capacity});
        for (const CardBlocks::Move& move : update.moves) {
            std::memcpy(&m_texels[4 * std::size_t{move.to}],
                        &m_texels[4 * std::size_t{move.from}],
                        4 * std::size_t{move.count});
        }
        std::size_t at = 0;
        for (const auto& range : update.texels) {
            const std::size_t size = 4 * std::size_t{range.count};
            ASSERT_LE(4 * std::size_t{range.first} + size, m_texels.size());
            std::memcpy(&m_texels[4 * std::size_t{range.first}], &update.bytes[at], size);
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

    FaceExtents m_extents;
    TexelStore m_store;
    std::uint32_t m_maxTexels = 0;
    Camera m_camera;
    bool m_isNewView = true;
    std::vector<Wish> m_wishes;
    DisplayTexels m_display;
    std::deque<std::pair<JobBatch, MadeBlocks>> m_underWay;
    std::vector<std::byte> m_texels;
    std::vector<FaceRecord> m_records;
    std::size_t m_bytesSent = 0;
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

void fly(const TriangleMesh& mesh, int mostLevel, std::uint32_t maxTexels, bool isTight)
{
    Flight flight(mesh, mixedStore(mesh.faceCount(), mostLevel), maxTexels);
    std::mt19937 random(8);
    int reduced = 0;
    for (int step = 0; step < 60; ++step) {
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

TEST(FlyThrough, aTorusWithinASmallBudget)
{
    fly(torusMesh(40, 20), 6, 120'000, true);
}

TEST(FlyThrough, aTorusWithRoomForAll)
{
    fly(torusMesh(40, 20), 6, 1U << 24U, false);
}

TEST(FlyThrough, aLargeSheetWithinASmallBudget)
{
    fly(sheetMesh(70), 4, 150'000, true);
}

TEST(FlyThrough, hardlyAnyRoomAtAll)
{
    fly(torusMesh(40, 20), 6, 3'000, true);
}
