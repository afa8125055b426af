// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QFont>

#include "ui/inspector/mip_cells.h"
#include "ui/inspector/mip_pictures.h"

#include <vector>

class QPainter;

namespace trixel::ui {

class MipFocus;

/// How the levels of a face are shown. A value: compared, copied.
struct MipOptions
{
    MipContent content = MipContent::Right;
    MipArrangement arrangement;

    bool operator==(const MipOptions&) const = default;
};

/// Colours and letters around the pictures.
struct MipInk
{
    QColor text;
    QColor faint;
    QColor ground; ///< of pictures to come
    QFont font;
};

/// Light around the texel looked at, its parents and its children.
inline constexpr QColor kItselfLight(255, 255, 255);
inline constexpr QColor kParentLight(255, 214, 10);
inline constexpr QColor kChildLight(64, 196, 255);

/// Draws levels into their cells: pictures, labels, and the family of the texel looked at.
class MipPainter
{
public:
    MipPainter(const MipFocus& focus,
               const MipOptions& options,
               const MipPictures& pictures,
               const MipInk& ink)
        : m_focus(focus)
        , m_options(options)
        , m_pictures(pictures)
        , m_ink(ink)
    {
    }

    void paint(QPainter& painter, const std::vector<MipCell>& cells) const;

private:
    void paintPicture(QPainter& painter, const MipCell& cell) const;
    void paintLabel(QPainter& painter, const MipCell& cell) const;
    void paintFamily(QPainter& painter, const MipCell& cell) const;

    const MipFocus& m_focus;
    const MipOptions& m_options;
    const MipPictures& m_pictures;
    const MipInk& m_ink;
};

} // namespace trixel::ui
