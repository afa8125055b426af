// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lattice/texel.h"
#include "core/texture/mips.h"
#include "render/display_texels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <deque>
#include <random>

using namespace trixel;
using namespace trixel::render;

namespace {

constexpr std::uint32_t kMuch = 1U << 27U;
constexpr std::size_t kAll = ~std::size_t{0};

std::vector<std::byte> bytesOf(std::initializer_list<int> values)
{
    std::vector<std::byte> bytes;
    for (const int value : values) {
        bytes.push_back(static_cast<std::byte>(value));
    }
    return bytes;
}

/// What the card would hold after the updates.
struct Card
{
    std::vector<std::byte> texels;
    std::vector<FaceRecord> records;
    std::size_t texelsSent = 0;
    std::size_t calls = 0;

    void apply(const DisplayTexels& display, const DisplayUpdate& update)
    {
        const std::size_t size = texelBytes(display.format());
        if (update.fresh) {
            texels.clear();
            records.assign(display.records().begin(), display.records().end());
        }
        ASSERT_GE(update.capacity * size, texels.size());
        texels.resize(update.capacity * size);
        for (const CardBlocks::Move& move : update.moves) {
            std::memmove(&texels[move.to * size], &texels[move.from * size], move.count * size);
        }
        std::size_t at = 0;
        for (const auto& range : update.texels) {
            ASSERT_LE(range.first + range.count, update.capacity);
            std::memcpy(&texels[range.first * size], &update.bytes[at], range.count * size);
            at += range.count * size;
            texelsSent += range.count;
        }
        ASSERT_EQ(at, update.bytes.size());
        calls += update.texels.size();
        for (const auto& range : update.records) {
            std::copy_n(display.records().begin() + range.first,
                        range.count,
                        records.begin() + range.first);
        }
    }

    /// What the shader finds for a texel of a face.
    std::span<const std::byte> shown(FaceId face, std::uint32_t index, std::size_t size) const
    {
        const FaceRecord& record = records[indexOf(face)];
        return {&texels[(record.offset + (record.isConstant() ? 0 : index)) * size], size};
    }
};

/// \param coarser  levels that the room costs
void expectShows(const Card& card, const TexelStore& store, int drop, int coarser = 0)
{
    const std::size_t size = texelBytes(displayFormat(store.format().type));
    for (std::size_t f = 0; f < store.faceCount(); ++f) {
        const FaceTexels face = reduced(store.format(), store.face(faceId(f)), drop + coarser);
        ASSERT_FALSE(card.records[f].isPending()) << f;
        ASSERT_EQ(card.records[f].ownLevel(), store.face(faceId(f)).level().coarser(drop).log2());
        ASSERT_TRUE(card.records[f].isConstant() || card.records[f].level() == face.level().log2());
        for (std::uint32_t t = 0; t < face.level().texelCount(); ++t) {
            std::vector<std::byte> expected;
            appendShown(store.format(), face.texel(t), expected);
            ASSERT_TRUE(std::ranges::equal(card.shown(faceId(f), t, size), expected))
                << f << " " << t;
        }
    }
}

void paint(TexelStore& store, FaceId face, std::mt19937& random)
{
    for (std::byte& b : store.writable(face)) {
        b = static_cast<std::byte>(random() & 0x3fU);
    }
}

TexelStore mixedStore(std::uint32_t faces)
{
    std::mt19937 random(5);
    const TexelFormat format;
    TexelStore store(faces, format, Level(3), bytesOf({10, 20, 30}));
    for (std::uint32_t f = 0; f < faces; ++f) {
        store.exchange(faceId(f),
                       FaceTexels::constant(Level(static_cast<int>(f % 6)), bytesOf({1, 2, 3})));
        if (f % 3 != 0) {
            paint(store, faceId(f), random);
        }
    }
    return store;
}

} // namespace

TEST(DisplayTexels, showsAMixOfLevelsAndConstantFaces)
{
    const TexelStore store = mixedStore(40);
    for (const int drop : {0, 1, 2, 12}) {
        DisplayTexels display;
        Card card;
        display.reset(store, drop, kMuch);
        card.apply(display, display.take(store, kAll));
        EXPECT_FALSE(display.hasWork());
        expectShows(card, store, drop);
    }
}

TEST(DisplayTexels, aConstantFaceTakesOneTexel)
{
    const TexelStore store(100, TexelFormat{}, Level(7), bytesOf({1, 2, 3}));
    DisplayTexels display;
    display.reset(store, 0, kMuch);
    EXPECT_EQ(display.take(store, kAll).bytes.size(), 400U);
    EXPECT_EQ(display.texelsUsed(), 100U);
}

TEST(DisplayTexels, sendsInPartsOfTheBudgetAndInFewCalls)
{
    const TexelStore store = mixedStore(300);
    DisplayTexels display;
    Card card;
    display.reset(store, 0, kMuch);
    int parts = 0;
    while (display.hasWork()) {
        const DisplayUpdate update = display.take(store, 1000);
        EXPECT_LT(update.bytes.size(), 4 * 300U + 1000U + 4 * 1024);
        EXPECT_LE(update.texels.size(), 1U + 6U); // the bases, and a run a level
        card.apply(display, update);
        ASSERT_LT(++parts, 1000);
    }
    EXPECT_GT(parts, 10);
    expectShows(card, store, 0);
}

TEST(DisplayTexels, sendsExactlyTheTexelsOfARectangle)
{
    TexelStore store(3, TexelFormat{}, Level(6), bytesOf({9, 9, 9}));
    std::mt19937 random(1);
    paint(store, faceId(1), random);
    DisplayTexels display;
    Card card;
    display.reset(store, 0, kMuch);
    card.apply(display, display.take(store, kAll));

    paint(store, faceId(1), random); // all of it, but only the rectangle is announced
    const FaceTexels painted = store.face(faceId(1));
    const TouchedRect rect{faceId(1), 20, 30, 5, 7, false};
    const Card before = card;
    display.touch(store, {{rect}});
    const DisplayUpdate update = display.take(store, 0);
    EXPECT_FALSE(update.fresh);
    EXPECT_TRUE(update.records.empty());
    EXPECT_EQ(update.bytes.size(), 5U * 7U * 4U);
    card.apply(display, update);
    for (std::uint32_t t = 0; t < painted.level().texelCount(); ++t) {
        const std::uint32_t x = t % 64;
        const std::uint32_t y = t / 64;
        const bool inside = x >= 20 && x < 25 && y >= 30 && y < 37;
        std::vector<std::byte> expected;
        appendShown(store.format(), painted.texel(t), expected);
        const auto shown = card.shown(faceId(1), t, 4);
        ASSERT_TRUE(std::ranges::equal(
            shown, inside ? std::span<const std::byte>(expected) : before.shown(faceId(1), t, 4)));
    }
}

TEST(DisplayTexels, nearlyFullRowsGoInOneCall)
{
    TexelStore store(1, TexelFormat{}, Level(6), bytesOf({9, 9, 9}));
    std::mt19937 random(1);
    paint(store, faceId(0), random);
    DisplayTexels display;
    display.reset(store, 0, kMuch);
    (void)display.take(store, kAll);
    const TouchedRect rect{faceId(0), 2, 10, 60, 20, false};
    display.touch(store, {{rect}});
    const DisplayUpdate update = display.take(store, 0);
    ASSERT_EQ(update.texels.size(), 1U);
    const std::uint32_t begin = display.records()[0].offset;
    EXPECT_EQ(update.texels[0], (DisplayUpdate::Range{begin + 2 + 10 * 64, 19 * 64 + 60}));
}

TEST(DisplayTexels, rectanglesOfOneFaceBecomeOne)
{
    TexelStore store(1, TexelFormat{}, Level(6), bytesOf({9, 9, 9}));
    std::mt19937 random(1);
    paint(store, faceId(0), random);
    DisplayTexels display;
    display.reset(store, 0, kMuch);
    (void)display.take(store, kAll);
    const TouchedRect a{faceId(0), 2, 10, 4, 4, false};
    const TouchedRect b{faceId(0), 4, 12, 4, 4, false};
    display.touch(store, {{a}});
    display.touch(store, {{b}});
    EXPECT_EQ(display.take(store, 0).bytes.size(), 6U * 6U * 4U);
}

TEST(DisplayTexels, aFaceThatStopsBeingConstantGetsABlockUntilItIsAgain)
{
    TexelStore store(50, TexelFormat{}, Level(4), bytesOf({9, 9, 9}));
    const TexelStore unpainted = store;
    DisplayTexels display;
    Card card;
    display.reset(store, 0, kMuch);
    card.apply(display, display.take(store, kAll));
    std::mt19937 random(1);

    paint(store, faceId(7), random);
    const TouchedRect rect{faceId(7), 0, 0, 1, 1, false}; // too small on purpose: all of it is new
    display.touch(store, {{rect}});
    const DisplayUpdate update = display.take(store, 0);
    EXPECT_EQ(update.bytes.size(), 256U * 4U);
    ASSERT_EQ(update.records.size(), 1U);
    EXPECT_EQ(update.records[0], (DisplayUpdate::Range{7, 1}));
    card.apply(display, update);
    expectShows(card, store, 0);

    const std::uint32_t used = display.texelsUsed();
    EXPECT_EQ(used, 50U + 256U);
    store = unpainted;
    const TouchedRect whole{faceId(7), 0, 0, 16, 16, true};
    display.touch(store, {{whole}});
    card.apply(display, display.take(store, kAll));
    expectShows(card, store, 0);
    EXPECT_EQ(display.texelsUsed(), 50U);
    paint(store, faceId(7), random);
    display.touch(store, {{whole}});
    card.apply(display, display.take(store, kAll));
    expectShows(card, store, 0);
    EXPECT_EQ(display.texelsUsed(), used);
}

TEST(DisplayTexels, theBufferGrowsWithoutStartingOver)
{
    TexelStore store(200, TexelFormat{}, Level(6), bytesOf({9, 9, 9}));
    DisplayTexels display;
    Card card;
    display.reset(store, 0, kMuch);
    card.apply(display, display.take(store, kAll));
    std::mt19937 random(1);
    const std::size_t before = card.texels.size();
    for (std::uint32_t f = 0; f < 200; ++f) {
        paint(store, faceId(f), random);
        const TouchedRect rect{faceId(f), 0, 0, 64, 64, true};
        display.touch(store, {{rect}});
        const DisplayUpdate update = display.take(store, kAll);
        ASSERT_FALSE(update.fresh);
        card.apply(display, update);
    }
    EXPECT_GT(card.texels.size(), before);
    expectShows(card, store, 0);
}

TEST(DisplayTexels, touchingAllSendsAllAgainAndLeavesNoFacePending)
{
    TexelStore store = mixedStore(60);
    DisplayTexels display;
    Card card;
    display.reset(store, 0, kMuch);
    card.apply(display, display.take(store, kAll));
    std::mt19937 random(2);
    for (std::uint32_t f = 0; f < 60; ++f) {
        if (f % 4 == 0) {
            store.exchange(
                faceId(f),
                FaceTexels::constant(Level(static_cast<int>(f % 5)), bytesOf({int(f % 9), 8, 7})));
        } else {
            paint(store, faceId(f), random);
        }
    }
    display.touchAll();
    while (display.hasWork()) {
        const DisplayUpdate update = display.take(store, 500);
        EXPECT_FALSE(update.fresh);
        card.apply(display, update);
        for (const FaceRecord& record : card.records) {
            EXPECT_FALSE(record.isPending());
        }
    }
    expectShows(card, store, 0);
}

TEST(DisplayTexels, aLevelChangeMovesTheFace)
{
    TexelStore store = mixedStore(20);
    DisplayTexels display;
    Card card;
    display.reset(store, 0, kMuch);
    card.apply(display, display.take(store, kAll));
    store.exchange(faceId(5), FaceTexels::constant(Level(7), bytesOf({3, 3, 3})));
    std::mt19937 random(1);
    paint(store, faceId(5), random);
    const TouchedRect rect{faceId(5), 0, 0, 2, 2, false};
    display.touch(store, {{rect}});
    card.apply(display, display.take(store, kAll));
    expectShows(card, store, 0);
}

TEST(DisplayTexels, dropsLevelsUntilTheTexelsFit)
{
    std::mt19937 random(1);
    TexelStore store(20, TexelFormat{}, Level(5), bytesOf({9, 9, 9}));
    for (std::uint32_t f = 0; f < 20; ++f) {
        paint(store, faceId(f), random);
    }
    DisplayTexels display;
    Card card;
    display.reset(store, 0, 20 * 1024 / 10);
    card.apply(display, display.take(store, kAll));
    EXPECT_TRUE(display.isReduced());
    EXPECT_EQ(display.levelsDropped(), 2);
    EXPECT_LE(card.texels.size(), 4U * 2048);
    expectShows(card, store, 0, 2);
}

TEST(DisplayTexels, everyFaceBecomesCoarserWhenPaintNoLongerFits)
{
    std::mt19937 random(1);
    TexelStore store(20, TexelFormat{}, Level(5), bytesOf({9, 9, 9}));
    DisplayTexels display;
    Card card;
    display.reset(store, 0, 5000);
    card.apply(display, display.take(store, kAll));
    EXPECT_FALSE(display.isReduced());
    for (std::uint32_t f = 0; f < 20; ++f) {
        paint(store, faceId(f), random);
        const TouchedRect rect{faceId(f), 0, 0, 32, 32, true};
        display.touch(store, {{rect}});
        int takes = 0;
        while (display.hasWork()) {
            card.apply(display, display.take(store, kAll));
            ASSERT_LT(++takes, 5);
        }
    }
    EXPECT_TRUE(display.isReduced());
    for (std::size_t f = 0; f < 20; ++f) {
        const int level = card.records[f].level();
        EXPECT_GE(level, 5 - display.levelsDropped());
        EXPECT_LE(level, 5);
        const FaceTexels face = reduced(store.format(), store.face(faceId(f)), 5 - level);
        for (std::uint32_t t = 0; t < face.level().texelCount(); ++t) {
            std::vector<std::byte> expected;
            appendShown(store.format(), face.texel(t), expected);
            ASSERT_TRUE(std::ranges::equal(card.shown(faceId(f), t, 4), expected)) << f << " " << t;
        }
    }
    EXPECT_LE(display.texelsUsed(), 5000U);
}

TEST(DisplayTexels, facesThatCameLaterAreSentAsTheyAreThen)
{
    TexelStore store = mixedStore(60);
    DisplayTexels display;
    Card card;
    std::mt19937 random(2);
    display.reset(store, 0, kMuch);
    card.apply(display, display.take(store, 100));
    for (std::uint32_t f = 0; f < 60; ++f) {
        paint(store, faceId(f), random);
        const TouchedRect rect{faceId(f), 0, 0, 1, 1, true};
        display.touch(store, {{rect}});
    }
    while (display.hasWork()) {
        card.apply(display, display.take(store, 100));
    }
    expectShows(card, store, 0);
}

/// As the view works: two batches are always under way, and made from the store as it is.
TEST(DisplayTexels, aFaceTouchedWithTwoOfItsJobsUnderWayComesToRest)
{
    std::mt19937 random(4);
    TexelStore store(1, TexelFormat{}, Level(9), bytesOf({1, 2, 3}));
    paint(store, faceId(0), random);
    DisplayTexels display;
    Card card;
    display.reset(store, 0, kMuch);
    display.open(display.opener()(store));
    card.apply(display, display.takeReady(store, kAll));
    display.follow(
        planResidency(std::vector<Wish>{8 * 9}, display.facesOnCard(), display.mostRoom()));
    const auto giveOut = [&] { return display.nextJobs(1); };
    std::deque<JobBatch> underWay{giveOut(), giveOut()};
    ASSERT_FALSE(underWay[0].jobs.empty());
    ASSERT_FALSE(underWay[1].jobs.empty()); // levels in steps
    paint(store, faceId(0), random);
    const TouchedRect rect{faceId(0), 0, 0, 512, 512, false};
    display.touch(store, {{rect}});
    int rounds = 0;
    while (!underWay.empty()) {
        ASSERT_LT(++rounds, 20);
        const JobBatch batch = std::move(underWay.front());
        underWay.pop_front();
        display.accept(display.maker()(store, batch.jobs), batch, store);
        card.apply(display, display.takeReady(store, kAll));
        while (underWay.size() < 2) {
            JobBatch more = giveOut();
            if (more.jobs.empty()) {
                break;
            }
            underWay.push_back(std::move(more));
        }
    }
    EXPECT_FALSE(display.hasJobs());
    expectShows(card, store, 0);
}

/// So many that their bases are not sent at once; every third of them painted.
TexelStore manyFaces()
{
    TexelStore store(150'000, TexelFormat{}, Level(1), bytesOf({1, 2, 3}));
    std::mt19937 random(5);
    for (std::uint32_t f = 0; f < store.faceCount(); f += 3) {
        paint(store, faceId(f), random);
    }
    return store;
}

/// Takes over bases part by part. \return  the parts
std::vector<DisplayUpdate> openInParts(DisplayTexels& display, const TexelStore& store)
{
    display.open(display.opener()(store));
    std::vector<DisplayUpdate> parts;
    while (display.isOpening()) {
        EXPECT_FALSE(display.hasJobs());
        EXPECT_TRUE(display.nextJobs(kAll).jobs.empty());
        EXPECT_TRUE(display.hasReady());
        parts.push_back(display.takeReady(store, kAll));
    }
    return parts;
}

TEST(DisplayTexels, basesComeInPartsAndAreShownOnceAllHaveCome)
{
    const TexelStore store = manyFaces();
    DisplayTexels display;
    display.reset(store, 0, kMuch);
    const std::vector<DisplayUpdate> parts = openInParts(display, store);
    ASSERT_EQ(parts.size(), 3U);
    EXPECT_TRUE(display.isShown());
    std::uint32_t next = 0;
    for (std::size_t k = 0; k < parts.size(); ++k) {
        EXPECT_EQ(parts[k].fresh, k == 0);
        EXPECT_EQ(parts[k].isPart, k < 2);
        ASSERT_EQ(parts[k].texels.size(), 1U);
        EXPECT_EQ(parts[k].texels[0].first, next);
        EXPECT_EQ(parts[k].bytes.size(), 4 * parts[k].texels[0].count);
        next += parts[k].texels[0].count;
    }
    EXPECT_EQ(next, store.faceCount());
    Card card;
    for (const DisplayUpdate& part : parts) {
        card.apply(display, part);
    }
    while (display.hasWork()) {
        card.apply(display, display.take(store, kAll));
    }
    expectShows(card, store, 0);
}

TEST(DisplayTexels, aBufferToComeHoldsOnlyBasesWhileAnotherIsShown)
{
    const TexelStore store = manyFaces();
    DisplayTexels display;
    display.reset(store, 0, kMuch);
    Card card;
    while (display.hasWork()) {
        card.apply(display, display.take(store, kAll));
    }
    display.setMost(200'000);
    ASSERT_TRUE(display.needsOpening());
    card = {};
    for (const DisplayUpdate& part : openInParts(display, store)) {
        EXPECT_EQ(part.capacity, store.faceCount());
        EXPECT_TRUE(display.isShown()); // what was there
        card.apply(display, part);
    }
    while (display.hasWork()) {
        card.apply(display, display.take(store, kAll));
    }
    EXPECT_LE(card.texels.size(), 4 * 200'000U);
    EXPECT_GT(card.texels.size(), 4 * 150'000U);
}

TEST(DisplayTexels, openedAgainFacesStayShownUntilTheirPartComes)
{
    TexelStore store = manyFaces();
    DisplayTexels display;
    display.reset(store, 0, kMuch);
    Card card;
    card.apply(display, display.take(store, kAll));
    std::mt19937 random(9);
    for (std::uint32_t f = 0; f < store.faceCount(); f += 2) {
        paint(store, faceId(f), random);
    }
    display.touchAll();
    for (const DisplayUpdate& part : openInParts(display, store)) {
        EXPECT_FALSE(part.fresh || part.isPart);
        card.apply(display, part);
    }
    while (display.hasWork()) {
        card.apply(display, display.take(store, kAll));
    }
    expectShows(card, store, 0);
}

TEST(DisplayTexels, whatIsTouchedWhileBasesComeIsSentAfterThem)
{
    TexelStore store = manyFaces();
    DisplayTexels display;
    display.reset(store, 0, kMuch);
    Card card;
    std::mt19937 random(3);
    display.open(display.opener()(store));
    for (std::uint32_t part = 0; display.isOpening(); ++part) {
        for (const std::uint32_t f : {part, 70'000 + part, 149'990 + part}) {
            const bool isWhole = store.face(faceId(f)).isConstant();
            paint(store, faceId(f), random);
            const TouchedRect rect{faceId(f), 0, 0, 2, 2, isWhole};
            display.touch(store, {{rect}});
        }
        card.apply(display, display.takeReady(store, kAll));
    }
    while (display.hasWork()) {
        card.apply(display, display.take(store, kAll));
    }
    expectShows(card, store, 0);
}

TEST(DisplayTexels, anOpeningForAnotherBoundIsNotPossible)
{
    const TexelStore store = mixedStore(60);
    DisplayTexels display;
    display.reset(store, 0, kMuch);
    const PreparedOpening made = display.opener()(store);
    EXPECT_TRUE(display.canOpen(made));
    display.setMost(kMuch / 2);
    EXPECT_FALSE(display.canOpen(made));
    EXPECT_TRUE(display.canOpen(display.opener()(store)));
}

TEST(DisplayTexels, anEmptyStoreNeedsNothing)
{
    const TexelStore store;
    DisplayTexels display;
    display.reset(store, 0, kMuch);
    const DisplayUpdate update = display.take(store, kAll);
    EXPECT_TRUE(update.bytes.empty());
    EXPECT_FALSE(display.hasWork());
}

TEST(DisplayConversion, fewChannelsAreGreyAndTheOpacityChannelIsKept)
{
    const auto shown = [](TexelFormat format, std::initializer_list<int> texel) {
        std::vector<std::byte> out;
        appendShown(format, bytesOf(texel), out);
        return out;
    };
    using enum TexelType;
    EXPECT_EQ(shown({UInt8, 1, {}}, {7}), bytesOf({7, 7, 7, 255}));
    EXPECT_EQ(shown({UInt8, 2, {}}, {7, 9}), bytesOf({7, 7, 7, 255}));
    EXPECT_EQ(shown({UInt8, 2, 1}, {7, 9}), bytesOf({7, 7, 7, 9}));
    EXPECT_EQ(shown({UInt8, 3, {}}, {7, 9, 11}), bytesOf({7, 9, 11, 255}));
    EXPECT_EQ(shown({UInt8, 4, 3}, {7, 9, 11, 13}), bytesOf({7, 9, 11, 13}));
    EXPECT_EQ(shown({UInt8, 5, {}}, {1, 2, 3, 4, 5}), bytesOf({1, 2, 3, 255}));
    EXPECT_EQ(shown({UInt16, 3, {}}, {255, 254, 0, 128, 127, 0}),
              bytesOf({255, 254, 0, 128, 127, 0, 255, 255}));
    EXPECT_EQ(shown({Half, 1, {}}, {1, 2}), bytesOf({1, 2, 1, 2, 1, 2, 0, 0x3c}));
}

TEST(DisplayConversion, floatsArriveToTheBit)
{
    const std::vector<std::uint32_t> bits{0x3f000000U, 0x7fc01234U, 0xff800000U, 0x7149f2caU};
    std::vector<std::byte> out;
    appendShown({TexelType::Float, 4, 3}, std::as_bytes(std::span(bits)), out);
    EXPECT_TRUE(std::ranges::equal(out, std::as_bytes(std::span(bits))));
}

TEST(DisplayConversion, anIsolatedChannelIsSentOnlyWhereTheUsualOnesLackIt)
{
    const TexelFormat six{TexelType::UInt8, 6, std::uint16_t{4}};
    const auto channels = [&](std::optional<std::uint16_t> channel) {
        Look look;
        look.channel = channel;
        return channelsFor(six, LookRule::of(six, look));
    };
    EXPECT_EQ(channels({}), (CardChannels{0, 1, 2, 4}));
    EXPECT_EQ(channels(2), (CardChannels{0, 1, 2, 4}));
    EXPECT_EQ(channels(4), (CardChannels{0, 1, 2, 4}));
    EXPECT_EQ(channels(3), (CardChannels{3, 3, 3, -1}));
    std::vector<std::byte> out;
    appendShown(six, channels(5), bytesOf({1, 2, 3, 4, 5, 6}), out);
    EXPECT_EQ(out, bytesOf({6, 6, 6, 255}));
}

TEST(DisplayTexels, otherChannelsAreSentForEveryFace)
{
    const TexelFormat five{TexelType::UInt8, 5, {}};
    TexelStore store(3, five, Level(1), bytesOf({1, 2, 3, 4, 5}));
    std::ranges::fill(store.writable(faceId(1)), std::byte{9});
    DisplayTexels display;
    Card card;
    display.reset(store, 0, kMuch);
    card.apply(display, display.take(store, kAll));
    display.showChannels({0, 1, 2, -1}); // as it is
    EXPECT_FALSE(display.hasWork());
    display.showChannels({4, 4, 4, -1});
    EXPECT_TRUE(display.hasWork());
    card.apply(display, display.take(store, kAll));
    EXPECT_TRUE(std::ranges::equal(card.shown(faceId(2), 3, 4), bytesOf({5, 5, 5, 255})));
    EXPECT_TRUE(std::ranges::equal(card.shown(faceId(1), 3, 4), bytesOf({9, 9, 9, 255})));
    display.reset(store, 0, kMuch);
    EXPECT_EQ(display.channels(), (CardChannels{0, 1, 2, -1}));
}

TEST(DisplayConversion, manyTexelsConvertLikeOneByOne)
{
    std::mt19937 random(9);
    std::uniform_real_distribution<float> in(-1, 2);
    const TexelFormat format{TexelType::Float, 3, {}};
    std::vector<float> values(3 * 5000);
    std::ranges::generate(values, [&] { return in(random); });
    const auto bytes = std::as_bytes(std::span(values));
    std::vector<std::byte> together;
    std::vector<std::byte> alone;
    appendShown(format, bytes, together);
    for (std::size_t k = 0; k < 5000; ++k) {
        appendShown(format, bytes.subspan(12 * k, 12), alone);
    }
    EXPECT_EQ(together, alone);
}
