// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/atlas/atlas_layout.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>

using namespace trixel;

namespace {

FaceMap<Level> randomLevels(std::size_t faces, int most, unsigned seed)
{
    std::mt19937 random(seed);
    FaceMap<Level> levels(faces);
    for (std::size_t f = 0; f < faces; ++f) {
        levels[faceId(f)] = Level(static_cast<int>(random() % static_cast<unsigned>(most + 1)));
    }
    return levels;
}

/// As faces of a painted mesh are: most of two or three sizes, a few much finer.
FaceMap<Level> mixedLevels(std::size_t faces)
{
    std::mt19937 random(3);
    FaceMap<Level> levels(faces);
    for (std::size_t f = 0; f < faces; ++f) {
        const auto k = random() % 1000;
        levels[faceId(f)] = Level(k < 4 ? 7 : k < 40 ? 6 : k < 850 ? 5 : k < 950 ? 4 : 3);
    }
    return levels;
}

std::vector<AtlasOptions> allOptions()
{
    std::vector<AtlasOptions> all;
    for (const AtlasBorder border : {AtlasBorder::None, AtlasBorder::Bilinear}) {
        for (const AtlasPacking packing : {AtlasPacking::Bands, AtlasPacking::Shelves}) {
            for (const bool mips : {false, true}) {
                for (const std::uint32_t page : {16384U, 200U}) {
                    all.push_back({border, packing, mips, page});
                }
            }
        }
    }
    return all;
}

TEST(AtlasLayout, tilesLieInTheirPagesAndDoNotOverlap)
{
    const FaceMap<Level> levels = randomLevels(700, 5, 1);
    for (const AtlasOptions& options : allOptions()) {
        const auto layout = AtlasLayout::plan(levels, options);
        ASSERT_TRUE(layout);
        std::map<std::uint32_t, std::vector<bool>> taken;
        std::uint64_t useful = 0;
        for (std::size_t f = 0; f < levels.size(); ++f) {
            const Level own = levels[faceId(f)];
            for (int n = options.mips ? 0 : own.log2(); n <= own.log2(); ++n) {
                const AtlasPlace place = layout->place(faceId(f), Level(n));
                const std::uint32_t side = layout->tile(Level(n)).side();
                ASSERT_LT(place.page, layout->pages().size());
                const AtlasPage page = layout->pages()[place.page];
                ASSERT_LE(page.width, options.largestPage);
                ASSERT_LE(page.height, options.largestPage);
                ASSERT_LE(place.origin.x + side, page.width);
                ASSERT_LE(place.origin.y + side, page.height);
                std::vector<bool>& pixels = taken[place.page];
                pixels.resize(std::size_t{page.width} * page.height);
                for (std::uint32_t y = 0; y < side; ++y) {
                    for (std::uint32_t x = 0; x < side; ++x) {
                        const std::size_t at =
                            std::size_t{place.origin.y + y} * page.width + place.origin.x + x;
                        ASSERT_FALSE(pixels[at]);
                        pixels[at] = true;
                    }
                }
                useful += Level(n).texelCount();
            }
        }
        EXPECT_EQ(layout->usefulTexels(), useful);
        EXPECT_LE(layout->occupancy(), 1.0);
    }
}

TEST(AtlasLayout, finerFacesHaveLowerRanksAndFacesOfALevelKeepTheirOrder)
{
    const FaceMap<Level> levels = randomLevels(500, 6, 2);
    const auto layout = AtlasLayout::plan(levels, {});
    ASSERT_TRUE(layout);
    for (std::uint32_t rank = 0; rank < levels.size(); ++rank) {
        const FaceId face = layout->faceOfRank(rank);
        EXPECT_EQ(layout->rank(face), rank);
        if (rank > 0) {
            const FaceId before = layout->faceOfRank(rank - 1);
            EXPECT_TRUE(levels[before] > levels[face] ||
                        (levels[before] == levels[face] && before < face));
        }
        EXPECT_EQ(layout->finerFaces(levels[face]) + layout->tileRank(face, levels[face]), rank);
    }
}

TEST(AtlasLayout, shelvesWasteLessThanBands)
{
    // A few large faces do not fill a band.
    FaceMap<Level> levels(1003, Level(3));
    for (const std::size_t f : {7U, 500U, 900U}) {
        levels[faceId(f)] = Level(7);
    }
    AtlasOptions options;
    options.packing = AtlasPacking::Bands;
    const double bands = AtlasLayout::plan(levels, options)->occupancy();
    options.packing = AtlasPacking::Shelves;
    const double shelves = AtlasLayout::plan(levels, options)->occupancy();
    EXPECT_GT(shelves, bands);
}

TEST(AtlasLayout, aHundredThousandMixedFacesFillThreeQuarters)
{
    const FaceMap<Level> levels = mixedLevels(100'000);
    for (const bool mips : {false, true}) {
        AtlasOptions options;
        options.mips = mips;
        const auto layout = AtlasLayout::plan(levels, options);
        ASSERT_TRUE(layout);
        // Borders alone leave 79 % of a face of 32² texels; coarser mips are all border.
        EXPECT_GE(layout->occupancy(), mips ? 0.65 : 0.75);
        RecordProperty(mips ? "with_mips" : "without", std::to_string(layout->occupancy()));
    }
}

TEST(AtlasLayout, aFaceThatNoPageHoldsIsNamed)
{
    FaceMap<Level> levels(10, Level(2));
    levels[faceId(6)] = Level(7);
    AtlasOptions options;
    options.largestPage = 131;
    const auto layout = AtlasLayout::plan(levels, options);
    ASSERT_FALSE(layout);
    EXPECT_EQ(layout.error().message,
              "face 6 needs pages of 132 pixels, more than the 131 allowed");
    options.largestPage = 132;
    EXPECT_TRUE(AtlasLayout::plan(levels, options));
}

TEST(AtlasLayout, noFacesNeedNoPages)
{
    const auto layout = AtlasLayout::plan({}, {});
    ASSERT_TRUE(layout);
    EXPECT_TRUE(layout->pages().empty());
    EXPECT_EQ(layout->occupancy(), 1.0);
}

} // namespace
