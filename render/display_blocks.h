// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which elements of faces lie where on the graphics card and which have to be sent. Plain data, no
// OpenGL.
#pragma once

#include "core/texture/texel_store.h"
#include "render/block_making.h"
#include "render/card_blocks.h"
#include "render/display_conversion.h"
#include "render/prepared_opening.h"
#include "render/residency.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <span>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace trixel::render {

/// What to send to the card, in this order: room, moves, texels, records.
struct DisplayUpdate
{
    /// Consecutive elements.
    struct Range
    {
        std::uint32_t first = 0;
        std::uint32_t count = 0;
        bool operator==(const Range&) const = default;
    };

    bool fresh = false;  ///< into a buffer of its own, with all records
    bool isPart = false; ///< more comes before that buffer is to be shown in the place of the last
    std::uint32_t capacity = 0;          ///< elements the buffer must have room for
    std::vector<CardBlocks::Move> moves; ///< on the card
    std::vector<Range> texels; ///< where elements go; their bytes follow each other in `bytes`
    std::vector<std::byte> bytes;
    std::vector<Range> records; ///< faces whose records changed: read them from `records()`
};

/// Jobs to be made into blocks, on any thread.
struct JobBatch
{
    std::vector<BlockJob> jobs;
    std::int64_t elements = 0; ///< that they will take from or give back to the room
    std::uint32_t generation = 0;
};

/// What a store's faces show on the graphics card, within a bound: their texels (`DisplayTexels`)
/// or the vertices made of them (`DisplayVertices`).
///
/// Every face has a base, its level 0, which is sent first; finer blocks come and go as plans want
/// them (`residency.h`): one that wants everything, or one of a view (`follow`). What is shown
/// stays until better has come. Work is done either here and now (`take`), or elsewhere: what
/// `opener` gives while `needsOpening`, then `nextJobs` → what `maker` gives, on a snapshot of the
/// store → `accept`, and `takeReady` for what came of it, bases part by part (`isOpening`).
class DisplayBlocks
{
public:
    /// Make what is to be sent, on any thread and several at once; they need nothing of this
    /// object.
    using Opener = std::function<PreparedOpening(const TexelStore&)>;
    using Maker = std::function<MadeBlocks(const TexelStore&, std::span<const BlockJob>)>;

    virtual ~DisplayBlocks() = default;

    /// Another bound. Where the buffer is larger, all is opened anew.
    void setMost(std::uint32_t maxElements);

    /// Notes that texels changed. The store must be the one of `reset`, as it is now.
    virtual void touch(const TexelStore& store, std::span<const TouchedRect> rects);

    /// Notes that every texel may have changed. What is on the card stays until it is replaced.
    void touchAll() { opensAnew(); }

    /// Sends other channels from now on, and all anew where they are others.
    void showChannels(const CardChannels& channels);
    const CardChannels& channels() const { return m_form.channels; }

    /// Does and converts what is to be sent next: all that was touched, then jobs until
    /// `byteBudget` is reached.
    DisplayUpdate take(const TexelStore& store, std::size_t byteBudget);
    /// Whether `take` has something to give.
    bool hasWork() const;

    // Work done elsewhere.

    /// Whether everything is to be opened anew (`opener`), which comes before all.
    bool needsOpening() const { return m_opens; }
    const CardForm& form() const { return m_form; }
    /// Which need of an opening it is: what was read before the latest is not what there is now.
    std::uint32_t openingNumber() const { return m_openingNumber; }
    virtual Opener opener() const = 0;
    /// Whether `open` can go on with this one: bounds may have changed since it was begun.
    bool canOpen(const PreparedOpening& opening) const;
    /// Begins to send bases. \param opening  one that is possible (checked)
    void open(PreparedOpening opening);
    /// Whether there are bases left to be sent.
    bool isOpening() const { return m_opening.has_value(); }
    /// Whether there is something of every face on the card since `reset`.
    bool isShown() const { return m_isShown; }
    /// Whether a plan is needed: not all is as the last one took it to be.
    bool needsPlan() const { return m_plans; }
    /// For `planResidency`.
    std::vector<FaceOnCard> facesOnCard() const { return m_faces; }
    CardRoom mostRoom() const;
    /// Goes by a view's plan from now on.
    void follow(ResidencyPlan plan);
    /// What to make next, up to so many bytes but at least one; none when there is nothing or no
    /// room, or room is made with the next update.
    /// \param means  whether means may be among it that nothing waits for
    JobBatch nextJobs(std::size_t bytes, bool means = true);
    /// Makes blocks of one store as it is: of another, and once it changed, another is needed.
    virtual Maker maker() const = 0;
    /// Takes blocks over, made from a snapshot taken after the jobs were given out.
    /// \param store  as it is now
    void accept(const MadeBlocks& made, const JobBatch& batch, const TexelStore& store);
    /// Jobs come to nothing: what they were for stays as it is.
    void giveUp(const JobBatch& batch);
    /// What is ready to be sent: a part of the bases, or blocks accepted and what was touched.
    /// \param mostRead  texels of the store to be read for that, but at least one face
    DisplayUpdate takeReady(const TexelStore& store, std::size_t mostRead);
    bool hasReady() const;
    /// Whether jobs could be given out now.
    bool hasJobs(bool means = true) const;

    DisplayFormat format() const { return displayFormat(m_form.format.type); }
    std::span<const FaceRecord> records() const { return m_blocks.records(); }
    const CardBlocks& blocks() const { return m_blocks; }
    const ResidencyPlan& plan() const { return m_plan; }
    /// Levels dropped: the drop asked for, and those that the room costs.
    int levelsDropped() const { return m_form.mipDrop + (m_plan.bias + 7) / 8; }
    /// Whether faces are shown coarser than asked for because they do not fit.
    bool isReduced() const { return m_plan.bias > 0; }
    /// Eighths of that, as levels: by how much a view shows everything coarser to fit.
    float viewCut() const
    {
        return m_followsView ? 0.125F * static_cast<float>(m_plan.bias) : 0.0F;
    }
    /// Faces in the view that is followed, or close to it; nothing where none is.
    std::optional<std::uint64_t> facesInView() const
    {
        return m_followsView ? std::optional(m_plan.facesInView) : std::nullopt;
    }
    /// Texels or vertices in blocks, the bases included.
    std::uint32_t elementsUsed() const { return m_blocks.used(); }
    /// Of the buffer and the records, on the card.
    std::uint64_t cardBytes() const
    {
        return m_blocks.capacity() * m_form.elementBytes() + m_faces.size() * sizeof(FaceRecord);
    }

protected:
    /// A rectangle of the packed square.
    struct Rect
    {
        std::uint32_t x0 = 0, y0 = 0, x1 = 0, y1 = 0; ///< end exclusive
        bool whole = false;                           ///< every texel of the face instead

        TouchedRect of(FaceId face) const;
        std::size_t area() const { return std::size_t{x1 - x0} * (y1 - y0); }
    };

    /// \param generation  jobs of another display that this one takes the place of must have a
    ///                    number at least 2^16 away
    DisplayBlocks(BlockKind kind, std::uint32_t generation)
        : m_kind(kind)
        , m_generation(generation)
        , m_openingNumber(generation)
    {
    }
    DisplayBlocks(const DisplayBlocks&) = default;
    DisplayBlocks(DisplayBlocks&&) = default;
    DisplayBlocks& operator=(const DisplayBlocks&) = default;
    DisplayBlocks& operator=(DisplayBlocks&&) = default;

    /// Begins with a store; see `DisplayTexels::reset`.
    void begin(const TexelStore& store, int mipDrop, std::uint32_t maxElements);

    /// Does to an opening what takes long, on any thread.
    std::function<PreparedOpening(CardOpening)> preparer() const;
    /// An opening with nothing left for later, here and now.
    virtual CardOpening openNow(const TexelStore& store) const = 0;
    /// A job's block that was touched on its way, from the store as it is; none where a job should
    /// rather make it again.
    virtual std::optional<MadeBlocks> makeAgain(const TexelStore& store, const BlockJob& job) const;
    /// Marks what depends on a face as touched on its way (`touchInFlight`).
    virtual void touched(FaceId face) = 0;
    /// Brings what depends on touched texels up to date, until so much has been read.
    virtual void sendTouched(const TexelStore& store, std::size_t mostRead) = 0;

    bool isVertices() const { return m_kind == BlockKind::Vertices; }
    void touchInFlight(FaceId face);
    /// Enters what a face is, whatever of it is on the card.
    void show(FaceId face, int own, bool isConstant);
    /// The level that the plan has a face at; where no view is followed as if it had been so when
    /// all was wanted.
    int wantedLevel(FaceId face);
    /// A block of a level for a face, for which room is made if need be. Without one it keeps its
    /// base, and a job comes later. \return whether it has the block
    bool place(FaceId face, int level);
    /// The face keeps its base alone. \param keeps  whether what its block shows is to be seen on
    void release(FaceId face, bool keeps);
    /// From now on the base may not be what the face's block begins with.
    void outdateBase(FaceId face) { m_hasOldBase[indexOf(face)] = true; }
    /// Notes the bytes appended since as elements of a face's block. \param first  in the block
    void write(FaceId face, std::uint8_t level, std::uint32_t first, std::size_t bytesBefore);
    void meanLater(FaceId face);
    /// Has a job make a block that was touched on its way, or would take too long here.
    void makeAgainLater(const BlockJob& job);
    FaceOnCard& onCard(FaceId face) { return m_faces[indexOf(face)]; }

    CardForm m_form;
    CardBlocks m_blocks;
    std::unordered_map<std::uint32_t, Rect> m_touched;
    std::vector<std::byte> m_bytes; ///< on their way

private:
    /// Elements on their way; they go where the face's block is when they are sent.
    struct Write
    {
        FaceId face{};
        std::uint8_t level = 0; ///< of the block they are for; 0 for the base
        std::uint32_t first = 0;
        std::uint32_t count = 0;
    };
    static constexpr std::uint8_t kTouchedInFlight = 0x80;
    static std::uint64_t keyOf(const BlockJob& job)
    {
        return std::uint64_t{indexOf(job.face)} << 8U | job.level;
    }

    /// Bases on their way to the card, and what of them has been sent.
    struct Opening
    {
        CardOpening made;
        bool isFresh = false;
        bool isBegun = false;
        std::size_t nextFace = 0;
    };

    // display_opening.cpp
    void opensAnew();
    void openFresh(FreshBlocks fresh);
    void openAgain(std::size_t face);
    DisplayUpdate nextBases(std::size_t mostFaces);
    void opened();

    // display_blocks.cpp
    void planEverything();
    DisplayUpdate gathered();
    std::optional<DisplayUpdate::Range> placeOf(const Write& write) const;
    void makeRoomFor(std::uint64_t blockElements);

    // display_jobs.cpp
    enum class Room { Found, None, Later };
    bool isUseful(const BlockJob& job) const;
    bool makeSpare(JobBatch& batch);
    bool isUpdateFull() const;
    Room addJob(const BlockJob& job, JobBatch& batch);
    void addMeans(std::size_t bytes, JobBatch& batch);
    bool resize(FaceId face, int level, bool keeps = false);
    bool placeBlock(const BlockJob& job);
    bool land(const BlockJob& job);
    void acceptBlock(const BlockJob& job, std::span<const std::byte> bytes);
    std::size_t bytesOf(int level) const;
    std::int64_t roomUsed() const;

    BlockKind m_kind;
    std::uint32_t m_maxElements = 0;
    bool m_opens = false;
    bool m_isOpen = false;
    bool m_isShown = false;
    std::optional<Opening> m_opening;
    CardRoom m_room; ///< in the buffer as it is
    std::vector<FaceOnCard> m_faces;

    std::deque<BlockJob> m_again;                ///< see `makeAgainLater`
    std::unordered_set<std::uint64_t> m_isAgain; ///< keys of those

    bool m_plans = false;
    bool m_followsView = false;
    ResidencyPlan m_plan;
    std::size_t m_nextMake = 0;
    std::size_t m_nextSpare = 0;
    std::vector<std::uint8_t> m_inFlight; ///< jobs given out of each face, and a flag
    std::int64_t m_elementsInFlight = 0;
    std::uint32_t m_generation = 0; ///< of buffers; jobs for one before are forgotten
    std::uint32_t m_openingNumber = 0;
    std::vector<bool> m_noMean;  ///< faces whose base is not their mean
    std::vector<FaceId> m_means; ///< the same, from m_nextMean on
    std::size_t m_nextMean = 0;
    std::uint32_t m_noRoom = 0;  ///< a bit a level that found none; until the next update
    std::size_t m_spared = 0;    ///< blocks made coarser or given up for others since the last one
    bool m_isMakingRoom = false; ///< and more are to be, after the next one
    std::vector<bool> m_hasOldBase; ///< faces of vertices: see `outdateBase`

    std::vector<Write> m_writes;
};

} // namespace trixel::render
