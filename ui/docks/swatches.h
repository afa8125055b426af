// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>
#include <QColor>
#include <QWidget>

#include <vector>

namespace trixel::ui {

/// A button that is a colour.
class SwatchButton : public QAbstractButton
{
    Q_OBJECT

public:
    explicit SwatchButton(QSize size, QWidget* parent = nullptr);

    QColor color() const { return m_color; }
    void setColor(const QColor& color);
    /// Said by tool tip and screen reader before the colour's code: "Colour to paint with".
    void setPurpose(const QString& purpose);

    QSize sizeHint() const override { return m_size; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void describe();

    QSize m_size;
    QColor m_color = Qt::black;
    QString m_purpose;
};

/// Colours side by side, in rows; clicking one chooses it. One stop of the Tab key: arrow keys go
/// from colour to colour.
class SwatchRow : public QWidget
{
    Q_OBJECT

public:
    /// \param purpose  of each swatch: "Palette colour"
    SwatchRow(int perRow, const QString& purpose, QWidget* parent = nullptr);

    void setColors(const std::vector<QColor>& colors);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

signals:
    void chosen(const QColor& color);

private:
    void stopAt(std::size_t swatch);

    int m_perRow;
    QString m_purpose;
    std::vector<SwatchButton*> m_swatches; // children
    std::size_t m_shown = 0;
    std::size_t m_stop = 0; ///< where Tab goes
};

/// The colours a painter reaches for first: greys, then around the colour circle, dark below light.
const std::vector<QColor>& paletteColors();

} // namespace trixel::ui
