// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QUndoStack>

#include "core/io/project.h"
#include "core/paint/brush.h"
#include "core/paint/stroke.h"

#include <optional>
#include <span>
#include <vector>

namespace trixel::ui {

/// What a change touched; `rects` is empty when everything may differ.
struct Change
{
    std::vector<TouchedRect> rects;
};

/// Owns the open project and one undo stack; pushing a command is the only lasting way to change
/// texels. A stroke in progress shows at once and becomes one command when it ends.
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

    bool isOpen() const { return m_project.surface != nullptr; }
    /// Null before a project is open.
    const std::shared_ptr<const Surface>& surface() const { return m_project.surface; }
    const TexelStore& texels() const { return m_project.texels; }
    /// A snapshot for saving and exporting while painting goes on; cheap.
    Project snapshot() const { return m_project; }

    QUndoStack& undoStack() { return m_undo; }
    QString path() const { return m_path; }
    QString title() const;
    bool isModified() const;
    /// Says that `undoIndex` of the stack is what the file at `path` now holds.
    void markSaved(const QString& path, int undoIndex);

    void beginStroke(const Brush& brush);
    void extendStroke(const StrokeSample& sample);
    /// Pushes the stroke as one undo step (nothing if it changed nothing).
    void endStroke();
    /// Takes back a stroke in progress.
    void cancelStroke();
    bool hasStroke() const { return m_stroke.has_value(); }

    /// One undo step; `color` as in `Brush::color`.
    void fillFaces(std::span<const FaceId> faces, const std::array<float, 4>& color);

signals:
    /// Another project, or none.
    void opened();
    void changed(const trixel::ui::Change& change);
    void modifiedChanged(bool modified);
    void titleChanged();

private:
    friend class SwapPatch;
    void swapPatch(TexelPatch& patch);

    Project m_project;
    std::vector<std::byte> m_fill;
    QString m_path;
    QString m_title;
    QUndoStack m_undo;
    std::optional<Stroke> m_stroke;
};

} // namespace trixel::ui
