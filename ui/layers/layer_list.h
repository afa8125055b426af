// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QListView>

namespace trixel::ui {

/// The rows of a `LayerModel`: an eye that shows and hides, the name, and how the layer is set.
///
/// | what | how |
/// |---|---|
/// | choose | click, up, down |
/// | show, hide | click on the eye, which chooses nothing; Space |
/// | rename | double click, F2 |
/// | another place | drag |
/// | delete | Delete |
class LayerList : public QListView
{
    Q_OBJECT

public:
    explicit LayerList(QWidget* parent = nullptr);

    /// Where the eye of a row is, in the viewport.
    QRect eyeRect(const QModelIndex& index) const;
    int rowHeight() const;

signals:
    void deleteWanted();

protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;

private:
    bool toggleEye(const QMouseEvent& event);

    bool m_isOnEye = false; ///< since the button went down
};

} // namespace trixel::ui
