// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "core/texture/texel_format.h"
#include "render/look.h"

#include <optional>

class QPainter;

namespace trixel::ui {

/// What false colours and marks in the view mean: the scale with its numbers, the number under the
/// pointer, and a swatch for each mark. Hidden where the look has neither.
class LookLegend : public QWidget
{
    Q_OBJECT

public:
    explicit LookLegend(QWidget* view);

    void setLook(const TexelFormat& format, const render::Look& look);
    /// The number under the pointer, or none.
    void setValue(std::optional<float> value);
    /// Takes its size and its place. \param top  of the place, in the view
    void place(int top);
    bool isWanted() const { return m_look.falseColor || m_look.marks; }

    QString title() const { return m_title; }
    /// The number under the pointer as written; empty when there is none.
    QString valueText() const;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void paintScale(QPainter& painter, int top) const;
    void paintMarks(QPainter& painter, int top) const;
    std::vector<render::Mark> marks() const;
    int marksWidth() const;

    TexelFormat m_format;
    render::Look m_look;
    QString m_title;
    std::optional<float> m_value;
};

} // namespace trixel::ui
