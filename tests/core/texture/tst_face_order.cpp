// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/face_order.h"
#include "tests/core/test_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <set>
#include <tuple>

using namespace trixel;

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// Faces of mixed levels, some painted, some with NaN, some without extent.
struct Scene
{
    explicit Scene(std::uint32_t cells = 40)
        : mesh(test::gridMesh(cells))
    {
        std::mt19937 random(5);
        for (std::size_t k = 0; k < mesh.faceCount(); k += 97) {
            mesh.triangles[k][1] = mesh.triangles[k][2] = mesh.triangles[k][0];
        }
        const TexelFormat format{TexelType::Float, 1, {}};
        FaceMap<Level> levels(mesh.faceCount());
        for (Level& level : levels.values()) {
            level = Level(static_cast<int>(random() % 4));
        }
        const float grey = 0.5F;
        store = TexelStore(format, levels, std::as_bytes(std::span(&grey, 1)));
        for (std::size_t k = 0; k < mesh.faceCount(); k += 3) {
            const auto texels = store.writable(faceId(k));
            for (std::size_t at = 0; at < texels.size(); at += sizeof(float)) {
                const float value =
                    random() % 50 == 0 ? kNan : static_cast<float>(random() % 100) / 50.0F - 1.0F;
                std::memcpy(texels.data() + at, &value, sizeof value);
            }
        }
        jumps.resize(mesh.faceCount());
        for (float& jump : jumps) {
            jump = random() % 5 == 0 ? kNan : static_cast<float>(random() % 10) / 100.0F;
        }
        for (std::size_t k = 0; k < mesh.faceCount(); k += 7) {
            selected.push_back(faceId(k));
        }
        NoProgress progress;
        figures = FaceFigures::measure(mesh, store, {}, Threads::all(), progress).value();
    }
    FaceFacts facts() const { return {figures, jumps, selected}; }

    TriangleMesh mesh;
    TexelStore store;
    FaceFigures figures;
    std::vector<float> jumps;
    std::vector<FaceId> selected;
};

FaceRows arranged(const FaceFacts& facts, const FaceOrder& order)
{
    NoProgress progress;
    return arrangeFaces(facts, order, Threads::all(), progress).value();
}

std::vector<FaceId> passing(const Scene& scene, const char* filter)
{
    const FaceRows rows =
        arranged(scene.facts(), {FaceColumn::Face, false, parseFaceFilter(filter).value()});
    return {rows.faces().begin(), rows.faces().end()};
}

void expectError(const char* filter, const char* part)
{
    const auto parsed = parseFaceFilter(filter);
    ASSERT_FALSE(parsed) << filter;
    EXPECT_EQ(parsed.error().kind, ErrorKind::Contents);
    EXPECT_NE(parsed.error().message.find(part), std::string::npos) << parsed.error().message;
    EXPECT_TRUE(parsed.error().message.ends_with('.'));
}

} // namespace

TEST(FaceOrder, everyColumnSortsBothWaysEqualFacesByNumberUnknownOnesLast)
{
    const Scene scene(140); // 39,200 faces: more than one thread's share
    const FaceFacts facts = scene.facts();
    for (const FaceColumn column : kFaceColumns) {
        for (const bool descending : {false, true}) {
            const FaceRows rows = arranged(facts, {column, descending, {}});
            ASSERT_EQ(rows.size(), scene.mesh.faceCount());
            const auto rank = [&](FaceId face) {
                const double value = valueIn(facts, column, face);
                const double turned = descending ? -value : value;
                return std::tuple(std::isnan(value), std::isnan(value) ? 0 : turned, face);
            };
            for (std::size_t row = 1; row < rows.size(); ++row) {
                ASSERT_LT(rank(rows.faces()[row - 1]), rank(rows.faces()[row]))
                    << nameOf(column) << ' ' << descending << ' ' << row;
            }
        }
    }
}

TEST(FaceOrder, everyListedFaceFindsItsRow)
{
    const Scene scene;
    const FaceRows rows =
        arranged(scene.facts(), {FaceColumn::Mean, true, parseFaceFilter("level>1").value()});
    ASSERT_GT(rows.size(), 100U);
    ASSERT_LT(rows.size(), scene.mesh.faceCount());
    std::set<FaceId> listed;
    for (std::size_t row = 0; row < rows.size(); ++row) {
        EXPECT_EQ(rows.rowOf(rows.faces()[row]), row);
        listed.insert(rows.faces()[row]);
    }
    for (std::size_t k = 0; k < scene.mesh.faceCount(); ++k) {
        EXPECT_EQ(rows.rowOf(faceId(k)).has_value(), listed.contains(faceId(k)));
    }
    EXPECT_FALSE(rows.rowOf(faceId(scene.mesh.faceCount())));
}

TEST(FaceOrder, theNumberOfThreadsChangesNothing)
{
    const Scene scene(140);
    NoProgress progress;
    const FaceOrder order{FaceColumn::Mean, false, parseFaceFilter("level!=0").value()};
    const auto one = arrangeFaces(scene.facts(), order, Threads{1}, progress).value();
    const auto three = arrangeFaces(scene.facts(), order, Threads{3}, progress).value();
    EXPECT_TRUE(std::ranges::equal(one.faces(), three.faces()));
}

TEST(FaceOrder, minusZeroEqualsZero)
{
    const TriangleMesh mesh = test::gridMesh(1);
    const TexelFormat format{TexelType::Float, 1, {}};
    const std::array values{0.0F, -0.0F};
    TexelStore store(2, format, Level(0), std::as_bytes(std::span(&values[0], 1)));
    static_cast<void>(store.exchange(
        faceId(1), FaceTexels::constant(Level(0), std::as_bytes(std::span(&values[1], 1)))));
    NoProgress progress;
    const auto figures = FaceFigures::measure(mesh, store, {}, Threads{1}, progress).value();
    const FaceRows rows = arranged({figures, {}, {}}, {FaceColumn::Mean, false, {}});
    EXPECT_EQ(rows.faces()[0], faceId(0));
}

TEST(FaceFilter, conditionsPickTheFacesTheyName)
{
    const Scene scene;
    const auto expect = [&](const char* filter, const auto& holds) {
        std::vector<FaceId> wanted;
        for (std::size_t k = 0; k < scene.mesh.faceCount(); ++k) {
            if (holds(faceId(k))) {
                wanted.push_back(faceId(k));
            }
        }
        EXPECT_EQ(passing(scene, filter), wanted) << filter;
    };
    const FaceFigures& figures = scene.figures;
    expect("", [](FaceId) { return true; });
    expect("level = 2", [&](FaceId f) { return figures.level(f) == Level(2); });
    expect("level>=2", [&](FaceId f) { return figures.level(f) >= Level(2); });
    expect("level<2, texels != 1", [&](FaceId f) { return figures.level(f) == Level(1); });
    expect("bytes>0.1k", [&](FaceId f) { return figures.bytes(f) > 100; });
    expect("CONSTANT", [&](FaceId f) { return figures.isConstant(f); });
    expect("!constant", [&](FaceId f) { return !figures.isConstant(f); });
    expect("nan", [&](FaceId f) { return figures.holdsNan(f); });
    expect("selected", [&](FaceId f) { return indexOf(f) % 7 == 0; });
    expect("!selected level=0",
           [&](FaceId f) { return indexOf(f) % 7 != 0 && figures.level(f) == Level(0); });
    expect("mean>0.5", [&](FaceId f) { return figures.mean(f) > 0.5F; });
    expect("min < -5e-1", [&](FaceId f) { return figures.lowest(f) < -0.5F; });
    expect("max=0.98", [&](FaceId f) { return figures.highest(f) == 0.98F; });
    expect("jump>=5%", [&](FaceId f) { return scene.jumps[indexOf(f)] >= 0.05F; });
    expect("density<30", [&](FaceId f) { return figures.density(f) < 30.0F; });
    expect("123", [](FaceId f) { return indexOf(f) == 123; });
    expect("face<10", [](FaceId f) { return indexOf(f) < 10; });
}

TEST(FaceFilter, refusalsNameWhatWasFoundAndWhatWouldDo)
{
    expectError("colour>1", "'colour'");
    expectError("colour>1", "density");
    expectError("level", "after 'level', found nothing");
    expectError("level five", "'five'");
    expectError("level >", "found none");
    expectError("level > x", "'x'");
    expectError("level >> 3", "found none");
    expectError("density<1e999", "'1e999'");
    expectError("mean<nan", "'nan'");
    expectError("bytes>1x", "'1x'");
    expectError("!level=3", "'level'");
    expectError("=3", "'=3'");
    expectError("constant=1", "'=1'");
    expectError(std::string(5000, 'y').c_str(), "…");
}

TEST(FaceFilter, anyTextIsParsedOrRefused)
{
    std::mt19937 random(3);
    const std::string letters = "level minx!=<>, 0.1e-%kfacesd\xff\n\0;";
    for (int k = 0; k < 20'000; ++k) {
        std::string text(random() % 20, ' ');
        for (char& c : text) {
            c = letters[random() % letters.size()];
        }
        const auto parsed = parseFaceFilter(text);
        if (!parsed) {
            EXPECT_FALSE(parsed.error().message.empty());
        }
    }
}

TEST(FaceFilter, whatPaintingCanChangeIsKnown)
{
    const auto asks = [](const char* filter, FaceColumn by) {
        return FaceOrder{by, false, parseFaceFilter(filter).value()}.asksForTexels();
    };
    EXPECT_FALSE(asks("", FaceColumn::Face));
    EXPECT_FALSE(asks("selected face<3 jump>1%", FaceColumn::Jump));
    EXPECT_TRUE(asks("", FaceColumn::Mean));
    EXPECT_TRUE(asks("constant", FaceColumn::Face));
    EXPECT_TRUE(asks("mean>0", FaceColumn::Face));
    EXPECT_TRUE(parseFaceFilter("level=1 !selected")->asksForSelection());
    EXPECT_FALSE(parseFaceFilter("level=1")->asksForSelection());
}
