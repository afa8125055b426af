// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QThreadPool>
#include <QUndoStack>

#include "core/io/project.h"
#include "core/layers/compose.h"
#include "core/paint/brush.h"
#include "core/paint/stroke.h"
#include "core/paint/stroke_dabs.h"
#include "ui/document/change.h"

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace trixel {
struct SceneViews;
}

namespace trixel::ui {

class BackgroundJobs;
class StoredFacesWatch;
class BehindStroke;
class LayerComposer;
class PendingStroke;
struct LayerPatch;
struct LayersState;
class ViewBookmarks;

/// Other layers that were worked out elsewhere.
struct LayersEdit
{
    Layered all;
    LayerId active = kBaseLayer; ///< of these, to be painted from now on
    bool changesLevels = false;  ///< of some face
};

/// When texels get what a stroke paints.
enum class StrokePace {
    AtOnce, ///< before `extendStroke` returns
    Behind  ///< by and by, on another thread: for dabs so large that the window would be held up
};

/// Names a state of the document: equal names mean equal texels, layers, views and creases. Unlike
/// a position in the undo stack it stays true when undone commands are thrown away.
struct StateId
{
    std::uint64_t texels = 0; ///< equal ones mean equal texels and layers, whatever the views
    std::uint64_t views = 0;  ///< and creases

    bool operator==(const StateId&) const = default;
};

/// Owns the open project and one undo stack; pushing a command is the only lasting way to change
/// texels, bookmarked views and creases. A stroke in progress shows at once and becomes one command
/// when it ends.
class Document : public QObject
{
    Q_OBJECT

public:
    explicit Document(QObject* parent = nullptr);
    ~Document() override;

    /// Takes another project's place; undo history starts empty.
    /// \param path  the `.trixel` file it lives in; empty when it has none yet
    /// \param title what to call it while it has no file
    void open(Project project, const QString& path, const QString& title);

    /// Layers that take time to be put together are one of these jobs from now on, to be seen and
    /// cancelled, which leaves all as it was. \param jobs  outlives all edits
    void useJobs(BackgroundJobs& jobs);

    bool isOpen() const { return m_project.surface != nullptr; }
    /// Null before a project is open.
    const std::shared_ptr<const Surface>& surface() const { return m_project.surface; }
    /// What is shown: of a project with layers, these together.
    const TexelStore& texels() const { return m_project.texels; }
    /// The bytes of one shown texel that Erase moves towards; on layers it uncovers instead.
    const std::vector<std::byte>& fillTexel() const { return m_fill; }
    /// A snapshot for saving and exporting while painting goes on; cheap.
    Project snapshot() const { return m_project; }

    /// What reads the faces of a large file when they are asked for; null when all are in memory.
    const std::shared_ptr<StoredFaces>& storedFaces() const { return m_project.storedFaces; }
    /// `TexelStore::releaseHeld`: spans and references into stored faces end. Not during a stroke,
    /// which it leaves alone. Who keeps a copy of the texels does the same when it is told.
    void releaseHeldTexels();

    /// The views bookmarked in the project; changed through this, one undo step a change.
    ViewBookmarks& bookmarks() { return *m_bookmarks; }
    const ViewBookmarks& bookmarks() const { return *m_bookmarks; }

    /// From which the limit surface has creases beside those of the mesh.
    CreaseAngle creaseAngle() const { return m_project.creaseAngle; }
    /// One undo step.
    /// \param angle   in [0, 180] (checked)
    /// \param goesOn  whether it becomes one step with a change of the angle right before
    void setCreaseAngle(CreaseAngle angle, bool goesOn = false);

    /// What the texels come from; plain when there is nothing but them.
    const LayerStack& layers() const { return m_project.layers; }
    /// What strokes, erasers and fills change: the base where there are no layers.
    LayerId activeLayer() const { return m_activeLayer; }
    /// Ends a stroke in progress; no undo step. \param layer  of the stack (checked)
    void setActiveLayer(LayerId layer);
    /// Other layers, as one undo step. They are there at once; what they look like follows where
    /// that takes time, and the document settles meanwhile. More edits may come before it is there,
    /// strokes wait for it.
    /// \param next    made from `layers()`, or from `LayerStack(texels())` where these are plain;
    ///                of the same faces (checked). A plain one makes its base what is shown.
    /// \param active  of `next` (checked), to be painted from now on
    /// \param goesOn  whether it becomes one step with a change of the same layer's settings right
    ///                before, if it is one, too
    /// \return        whether it was done; refused with `notice` where it cannot be, and while a
    ///                stroke is settling (see `whenPainted`)
    bool editLayers(LayerStack next, LayerId active, const QString& text, bool goesOn = false);

    QUndoStack& undoStack() { return m_undo; }
    QString path() const { return m_path; }
    QString title() const;
    /// Whether texels or views differ from those last saved (or opened). A stroke in progress
    /// counts once it ends.
    bool isModified() const
    {
        return isOpen() && (isSettling() || !m_later.empty() || state() != m_savedState);
    }
    /// The state the undo stack stands at.
    StateId state() const;
    /// The state the project was opened in, which also tells one opened project from the next.
    StateId openedState() const { return m_openedState; }
    /// Says that the file at `path` now holds `saved`, which need not be the present state:
    /// painting goes on while a snapshot is saved.
    void markSaved(const QString& path, StateId saved);

    /// Starts a stroke on the active layer, ending one in progress. An unusable brush and a hidden
    /// layer are refused with `notice`. While another change is settling it is kept, and painted
    /// when that has come to rest.
    /// \param limit  of the surface, to paint on instead (see `Stroke`), at once whatever the pace
    void beginStroke(const Brush& brush,
                     StrokePace pace = StrokePace::AtOnce,
                     std::shared_ptr<const LimitMesh> limit = {});
    /// Does nothing without a stroke in progress.
    void extendStroke(const StrokeSample& sample);
    /// The pointer came to another part of the surface: no dabs on the way there.
    void liftStroke();
    /// Pushes the stroke as one undo step (nothing if it changed nothing). One that is painted
    /// behind then settles: its undo step is there, its last texels follow.
    void endStroke();
    /// Takes back a stroke in progress.
    void cancelStroke();
    /// Whether a stroke is in progress or settling: texels are about to change.
    bool hasStroke() const { return isTakingSamples() || isSettling(); }
    /// Whether `extendStroke` has a stroke to extend.
    bool isTakingSamples() const;
    /// Whether something that has ended is still being painted behind, or layers are still being
    /// put together.
    bool isSettling() const;
    /// Calls `work` once texels hold all that was painted: at once, unless something is settling.
    void whenSettled(std::function<void()> work);
    /// Calls `work` once layers hold all that was painted, whatever is known of their look: at
    /// once, unless paint is settling or something waits already.
    void whenPainted(std::function<void()> work);

    /// One undo step, on the active layer; `color` as in `Brush::color`. Very many faces are filled
    /// behind. Refused with `notice` where that layer is hidden.
    void fillFaces(std::span<const FaceId> faces, const std::array<float, 4>& color);

    /// Exchanges a patch with the texels, as one undo step; levels may change. Refused with
    /// `notice` when the texels have changed since. Of a project without layers (checked).
    /// \param patch    the texels to come, made elsewhere from a copy
    /// \param madeFor  the state that the copy was of; views bookmarked since do not matter
    /// \return         whether it was applied
    bool applyPatch(TexelPatch patch, StateId madeFor, const QString& text);

    /// The same with all texels, for changes of so many faces that going through them would hold
    /// the window up. Costs the same for any number of faces. Of a project without layers
    /// (checked). \param texels  of as many faces and the same format (checked)
    bool replaceTexels(TexelStore texels, StateId madeFor, const QString& text);

    /// The same with layers, from a project with or without.
    /// \param edit  of as many faces and the same format (checked)
    bool replaceLayers(LayersEdit edit, StateId madeFor, const QString& text);

signals:
    /// See `releaseHeldTexels`.
    void heldTexelsReleased();
    /// Another project, or none.
    void opened();
    void changed(const trixel::ui::Change& change);
    /// Faces have other levels; follows `changed`.
    void levelsChanged();
    /// The limit surface has other creases.
    void creasesChanged();
    /// Another stack: other layers, order, names or settings; not for what is painted on them.
    void layersChanged();
    void activeLayerChanged();
    void modifiedChanged(bool modified);
    void titleChanged();
    /// Dabs that texels will have later: of a stroke painted behind.
    void dabsPlaced(const trixel::Brush& brush, const std::vector<trixel::PlacedDab>& dabs);
    /// Faces that will have this colour later.
    void fillPlaced(const std::vector<trixel::FaceId>& faces, const std::array<float, 4>& color);
    /// A stroke or a fill in this colour became a step.
    void colorUsed(const std::array<float, 4>& color);
    /// What was placed is in the texels, which `changed` has told; or was taken back, all of it.
    void settled(bool isInTexels);
    /// One sentence about something that was refused.
    void notice(const QString& sentence);

private:
    friend class PendingStroke;
    friend class SwapCreases;
    friend class SwapLayers;
    friend class SwapPatch;
    friend class SwapStore;
    /// A stroke drawn while another was settling.
    struct KeptStroke
    {
        Brush brush;
        StrokePace pace = StrokePace::AtOnce;
        std::shared_ptr<const LimitMesh> limit;
        LayerId layer = kBaseLayer;
        std::vector<std::optional<StrokeSample>> samples; ///< none where it was lifted
    };
    /// What waits for a stroke to settle.
    struct Later
    {
        PendingStroke* command = nullptr; ///< of an edit, on the stack; none for anything else
        std::function<void()> work;
    };
    void start(const KeptStroke& stroke);
    void extend(const StrokeSample& sample);
    void finish();
    bool isPaintSettling() const;
    void watch(std::unique_ptr<BehindStroke> work);
    static QString strokeText(const Brush& brush);
    void tellColor(const Brush& brush);
    void endBehind();
    void dropBehind();
    void settle(LayerPatch& applied);
    void complete(PendingStroke& command, LayerPatch applied);
    void doLater();
    void play(const KeptStroke& kept);
    bool hasUnsettled() const;
    void wait(const QString& text, std::function<void()> work);
    void waitAgain(PendingStroke& command, std::function<void()> work);
    void doWaiting(PendingStroke& command, const std::function<void()>& work);
    std::function<void()> takeBackWaiting(PendingStroke& command);
    std::unique_ptr<BehindStroke> hideBehind();
    void resumePending(std::unique_ptr<BehindStroke> work, PendingStroke& command);
    PendingStroke* pushPending(const QString& text);
    void beginPending(const QString& text);
    void fill(const std::vector<FaceId>& faces, const std::array<float, 4>& color, LayerId layer);
    TexelStore& painted(LayerId layer);
    LayerPatch finishStroke();
    bool mayPaint();
    void swapPatch(LayerPatch& patch);
    void swapStore(TexelStore& texels);
    bool mayReplace(StateId madeFor, const QString& text);
    void exchange(TexelStore& texels);
    void exchange(LayerPatch& patch);
    void push(LayerPatch applied, const QString& text);
    bool mayEditLayers(const QString& text);
    Result<LayersState> stateOf(LayerStack next, bool looksAlike) const;
    void swapLayers(LayersState& state, bool changesLevels);
    void compose(const Layered& now);
    void dropComposing();
    void layersComposed();
    void takeBackLayers(const Error& why);
    StateId stateBelowWaiting() const;
    friend class SwapViews;
    friend class ViewBookmarks;
    void swapViews(SceneViews& views);
    StateId withOtherViews();
    void swapCreases(CreaseAngle& angle);
    /// \param next  valid views, other than the present ones
    void pushViews(SceneViews next, const QString& text);
    void announceModified();

    Project m_project;
    std::vector<std::byte> m_fill;
    QString m_path;
    QString m_title;
    LayerId m_activeLayer = kBaseLayer;
    ViewBookmarks* m_bookmarks;
    StoredFacesWatch* m_storedFaces;
    std::optional<Stroke> m_stroke;
    Brush m_brush;                      ///< of the stroke
    LayerId m_strokeLayer = kBaseLayer; ///< of the stroke
    QThreadPool m_strokeThread;
    std::unique_ptr<BehindStroke> m_behind; ///< a stroke or fill painted behind
    std::unique_ptr<LayerComposer> m_composer;
    PendingStroke* m_pending = nullptr;      ///< its command, on the stack
    PendingStroke* m_waited = nullptr;       ///< of what waited and is being done now
    std::uint64_t m_texelsBeforePending = 0; ///< the texels' state until another edit settles
    std::optional<KeptStroke> m_kept;        ///< being drawn while another settles
    std::vector<Later> m_later;
    QUndoStack m_undo;
    StateId m_openedState;
    StateId m_savedState;
    std::uint64_t m_lastState = 0;
    bool m_announcedModified = false;
};

} // namespace trixel::ui
