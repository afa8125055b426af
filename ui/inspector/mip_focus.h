// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>

#include "core/texture/mip_comparison.h"
#include "ui/document/inspection.h"
#include "ui/inspector/mip_work.h"

#include <array>
#include <memory>
#include <optional>

namespace trixel::ui {

class Document;

/// The levels of the face that is looked at, and in each of them the texel that is looked at: what
/// a panel of mips shows.
///
/// Small faces are reduced at once, large ones in the background; what a level takes in a .ptx
/// always follows from there, the coarsest first. Nothing is done while no panel is seen.
class MipFocus : public QObject
{
    Q_OBJECT

public:
    /// Finer faces are reduced in the background.
    static constexpr Level kFinestAtOnce{6};

    MipFocus(Document& document, Inspection& inspection, QObject* parent = nullptr);

    /// Whether somebody sees what is shown.
    void setActive(bool active);

    /// Nothing before anything was pointed at.
    std::optional<FaceId> face() const;
    /// The face's own level; there is a face (checked), also below.
    Level base() const;
    /// Of the face, as the document has them now.
    const FaceTexels& texels() const;
    const TexelFormat& format() const;
    /// Level of the face as the view shows it.
    Level shown() const;

    /// Null until they are made.
    const MipComparison* levels() const { return m_levels.get(); }
    /// Bytes that the level's block takes in a .ptx; nothing until measured, and for levels that
    /// are no blocks.
    std::optional<quint64> fileBytes(Level level) const;
    bool isMeasured() const { return m_isMeasured; }

    /// The level whose texel counts: that under the pointer in the panel, else the one chosen
    /// there, else the one that the view shows.
    Level level() const;
    /// The texel of that level which covers the point looked at, or holds it.
    TexelCoord texel(Level level) const;

    /// A level for pointers elsewhere; the one that the view shows goes with the view.
    void choose(Level level);
    /// The panel's own pointer is in a level: all look at the texel that the view shows there.
    /// Does nothing while a texel is held.
    void pointAt(Level level, glm::vec2 uv);
    void pointAway();
    /// The same, and holds it.
    void hold(Level level, glm::vec2 uv);
    /// Holds the texel looked at, or lets it go.
    void toggleHold();
    void letGo();

signals:
    /// Another face, or its texels.
    void faceChanged();
    /// Another texel or level of the same face.
    void texelChanged();
    void measured();

private:
    void take();
    void takeTexels();
    void forget();
    void ask();

    Document& m_document;
    Inspection& m_inspection;
    MipWork m_work;
    QTimer m_pause;
    bool m_isActive = false;
    std::optional<FaceId> m_face; ///< whose levels are shown
    Level m_base;                 ///< its own when they were
    std::shared_ptr<const MipComparison> m_levels;
    std::array<std::optional<quint64>, Level::kMax + 1> m_bytes;
    bool m_isMeasured = false;
    std::optional<Level> m_chosen;
    std::optional<Level> m_pointed;
};

} // namespace trixel::ui
