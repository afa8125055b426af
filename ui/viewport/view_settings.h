// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "core/filter/filter_method.h"
#include "core/paint/brush.h"
#include "render/filtering.h"
#include "render/look.h"
#include "render/paint_on_card.h"
#include "ui/viewport/comparison.h"

namespace trixel::ui {

/// What the pointer does on the surface.
enum class Tool { Brush, Eraser, Fill, Pick, Select, Inspect };

/// A picture of numbers over the view: for each pixel, or for each face.
enum class ViewMapKind {
    None,
    Filtered,  ///< the texels as the chosen filter method sees them
    Condition, ///< of the pixel's footprint
    Error,     ///< of the chosen method against the exact answer
    Fit,       ///< that a planned fit leaves on each face
    Level,     ///< of each face
    Density,   ///< texels for a unit of length, of each face
    Difference ///< of each face from that of a file compared with
};

/// How the viewport draws. A value: compared, copied, stored in settings.
struct ViewOptions
{
    bool lit = true;
    bool wireframe = false;
    bool texelGrid = false;
    bool footprint = true; ///< ellipse of the hovered pixel on the surface
    int mipDrop = 0;       ///< show every face this many levels coarser
    ViewMapKind map = ViewMapKind::None;
    render::Filtering filtering = render::Filtering::Texels;
    bool limitSurface = false; ///< the cage's smooth surface in place of the cage
    double limitError = 0.5;   ///< pixels that it may be off by, > 0
    render::PaintOnCard paintOnCard = render::PaintOnCard::WhereFaster;
    bool hud = false;          ///< figures of the frame over the picture
    int cardBudget = 512;      ///< MiB of texels on the graphics card

    bool operator==(const ViewOptions&) const = default;
};

/// Brush, tool, filter, look, comparison and view options: set by panels and shortcuts, listened to
/// by the viewport.
class ViewSettings : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    const ViewOptions& view() const { return m_view; }
    void setView(const ViewOptions& view)
    {
        if (m_view != view) {
            m_view = view;
            emit viewChanged();
        }
    }

    const Brush& brush() const { return m_brush; }
    void setBrush(const Brush& brush)
    {
        m_brush = brush;
        emit brushChanged();
    }

    Tool tool() const { return m_tool; }
    void setTool(Tool tool)
    {
        if (m_tool != tool) {
            m_tool = tool;
            emit toolChanged();
        }
    }

    /// The filter that pictures, maps and read-outs are made with.
    const MethodChoice& method() const { return m_method; }
    void setMethod(const MethodChoice& method)
    {
        if (m_method != method) {
            m_method = method;
            emit methodChanged();
        }
    }

    /// How texel values become colours, in the view and in every panel that shows texels.
    const render::Look& look() const { return m_look; }
    void setLook(const render::Look& look)
    {
        if (m_look != look) {
            m_look = look;
            emit lookChanged();
        }
    }

    /// Whether and how the view is split.
    const Comparison& comparison() const { return m_comparison; }
    void setComparison(const Comparison& comparison)
    {
        if (m_comparison != comparison) {
            m_comparison = comparison;
            emit comparisonChanged();
        }
    }

signals:
    void viewChanged();
    void brushChanged();
    void toolChanged();
    void methodChanged();
    void lookChanged();
    void comparisonChanged();

private:
    ViewOptions m_view;
    Brush m_brush;
    Tool m_tool = Tool::Brush;
    MethodChoice m_method;
    render::Look m_look;
    Comparison m_comparison;
};

} // namespace trixel::ui
