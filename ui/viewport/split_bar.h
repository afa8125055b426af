// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include <functional>

class QMenu;
class QToolButton;

namespace trixel::ui {

class ViewSettings;

/// The line of a split view: dragged, or moved by the arrow keys, Home and End; beside it stand
/// what A and B show, each a button that offers other choices. Hidden while nothing is compared.
class SplitBar : public QWidget
{
    Q_OBJECT

public:
    /// \param bottom  room below what A and B show, in pixels
    /// \param isShown  whether the view shows what is compared; all views but few do
    explicit SplitBar(ViewSettings& settings,
                      QWidget* view,
                      int bottom = 56,
                      std::function<bool(const ViewSettings&)> isShown = {});

    /// What the buttons offer; null: nothing.
    void setMenus(QMenu* left, QMenu* right);
    /// Takes its place again, after the view has changed its size.
    void place();

    QString leftText() const;
    QString rightText() const;

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    QToolButton* makeButton(QWidget* view, const QString& name);
    void follow();
    void moveTo(double split);

    ViewSettings& m_settings;
    QToolButton* m_left;
    QToolButton* m_right;
    int m_bottom;
    std::function<bool(const ViewSettings&)> m_isShown;
    int m_grabbedAt = 0; ///< of the bar's own width
};

} // namespace trixel::ui
