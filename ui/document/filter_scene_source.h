// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>
#include <QTimer>

#include "core/filter/filter_scene.h"
#include "core/study/value_range.h"
#include "ui/document/background_job.h"

#include <memory>
#include <vector>

namespace trixel::ui {

struct Change;
class Document;

/// What filters read of the document: built in the background when something first needs it,
/// brought up to date where texels were touched, and given up when nothing needs it any more.
///
/// A scene that was handed out never changes, so work in the background may go on reading it; what
/// follows is a copy that shares all untouched faces.
class FilterSceneSource : public QObject
{
    Q_OBJECT

public:
    /// \param jobs  of the window, which shows and cancels the building
    FilterSceneSource(Document& document, BackgroundJobs& jobs, QObject* parent = nullptr);

    /// Says whether someone needs the scene. The first to do so has it built, the last to leave
    /// gives it up; someone who dies has left.
    void want(QObject& who, bool wanted);

    /// The newest scene there is; null while there is none. May lag behind the texels by moments.
    const std::shared_ptr<const FilterScene>& scene() const { return m_scene; }
    /// Whether the scene holds the texels as they are now.
    bool isCurrent() const { return m_scene && !m_isStale && !m_isBusy; }
    /// Largest difference between two texels, which errors are told in parts of. Painting widens it
    /// at once and does not narrow it.
    double valueRange() const { return m_bounds.range(); }

    /// Memory that the scene takes; 0 while there is none.
    std::size_t memoryBytes() const { return m_bytes; }
    /// Memory that the scene of a store will take, at most: 16 bytes for each group of four
    /// channels of each texel that is stored, of its mips, and of the vertices between them.
    static std::uint64_t expectedBytes(const TexelStore& store);

signals:
    /// Another scene is there, or none.
    void changed();
    /// The building was cancelled, or there is no memory for it: a sentence. Nobody is regarded as
    /// needing it any more.
    void refused(const QString& sentence);

private:
    struct Made
    {
        std::shared_ptr<const FilterSurface> surface;
        std::shared_ptr<const FilterScene> scene;
        ValueBounds bounds;
        std::size_t bytes = 0;
    };

    void forget();
    void takeChange(const Change& change);
    void leave(const QObject* who);
    void refresh();
    void build();
    void update();
    void take(quint64 generation, const Result<Made>& made);
    static std::size_t bytesOf(const FilterScene& scene);

    Document& m_document;
    BackgroundJobs& m_jobs;
    BackgroundJobs m_updates; // brief: nobody needs to see them
    QTimer m_pause;
    std::vector<const QObject*> m_wanting;

    std::shared_ptr<const FilterSurface> m_surface; // of the document; null until needed
    std::shared_ptr<const FilterScene> m_scene;
    ValueBounds m_bounds;
    std::size_t m_bytes = 0;
    std::vector<TouchedRect> m_touched; // since the newest scene was begun
    bool m_isStale = true;
    bool m_rebuild = true; // everything may differ
    bool m_isBusy = false;
    quint64 m_generation = 0;
    QPointer<BackgroundJob> m_building;
};

} // namespace trixel::ui
