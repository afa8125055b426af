// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "core/base/result.h"
#include "core/texture/texel_walk.h"

#include <glm/vec2.hpp>
#include <optional>
#include <string_view>

namespace trixel::ui {

struct Change;
class Document;

/// A texel that is looked at, and the very point of it.
struct InspectedTexel
{
    TexelPlace place;
    Level level;     ///< of the face as shown, levels dropped included
    glm::vec2 uv{0}; ///< in the texel; its centroid where no pointer chose a point

    bool operator==(const InspectedTexel&) const = default;
};

/// The texel that the view and every inspecting panel look at together: the one under the pointer,
/// wherever that is, or one that is held.
///
/// View and panels say what their pointer meets and show what `texel` says, whoever said it. A
/// texel stays when the pointer leaves, so that a panel still has something to show when it is gone
/// to; `isPointedAt` tells the two apart. A held texel stays until it is let go, stepped from or
/// another is held. It ends with the project.
class Inspection : public QObject
{
    Q_OBJECT

public:
    explicit Inspection(Document& document, QObject* parent = nullptr);

    /// Nothing before anything was pointed at.
    const std::optional<InspectedTexel>& texel() const { return m_texel; }
    /// Whether a pointer is on the texel, here or in a panel; always so for a held one.
    bool isPointedAt() const { return m_isPointedAt || m_isHeld; }
    bool isHeld() const { return m_isHeld; }
    /// What is walked over, at the levels shown. A document is open (checked).
    WalkedSurface surface() const;

    /// Every face is shown so many levels coarser than it is (>= 0).
    void setLevelsDropped(int levels);
    int levelsDropped() const { return m_levelsDropped; }

    /// The pointer is on a point of the surface. Does nothing while a texel is held. A face that
    /// does not exist is ignored.
    void pointAt(FaceId face, glm::vec2 uv);
    /// The pointer is on a texel as shown; the centroid stands for it. The same rules.
    void pointAt(const TexelPlace& place);
    /// The pointer left view or panel.
    void pointAway();

    /// Holds a texel, one held before or not. A face that does not exist is ignored.
    void hold(FaceId face, glm::vec2 uv);
    void hold(const TexelPlace& place);
    /// Holds the texel looked at, if there is one.
    void hold();
    void letGo();

    enum class Step { Right, Left, Ahead, Back };
    /// Goes one texel on, as `TexelWalk` does, and holds that. False at a border, or where no texel
    /// is looked at.
    bool step(Step step);

    /// Holds the texel that an address names (`parseTexelAddress`), or says why it names none.
    Status goTo(std::string_view address);

signals:
    /// Another texel, another point of it, or its face holds other values or levels.
    void changed();
    void heldChanged(bool held);
    /// A texel was chosen from afar, by address or by steps: views should bring it into sight.
    void wentTo();

private:
    bool exists(FaceId face) const;
    void look(const std::optional<InspectedTexel>& texel, bool pointedAt, bool held);
    InspectedTexel at(FaceId face, glm::vec2 uv) const;
    InspectedTexel at(const TexelPlace& place) const;
    void takeChange(const Change& change);
    void takeLevels();

    Document& m_document;
    std::optional<InspectedTexel> m_texel;
    std::optional<TexelWalk> m_walk; ///< how the held texel was come to
    int m_levelsDropped = 0;
    bool m_isPointedAt = false;
    bool m_isHeld = false;
};

} // namespace trixel::ui
