// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "core/study/views/view_camera.h"

class QLabel;
class QModelIndex;
class QPushButton;
class QTreeView;

namespace trixel::ui {

class BackgroundJobs;
class CameraFiles;
class Document;
class ScaledSpinBox;
class ViewsModel;
class Viewport;

/// The bookmarked views of the document, to go to, rename, change and remove.
///
/// | what | how |
/// |---|---|
/// | go to a view | Enter or double click |
/// | rename | F2 |
/// | remove | Delete |
class ViewsPanel : public QWidget
{
    Q_OBJECT

public:
    ViewsPanel(Document& document,
               BackgroundJobs& jobs,
               const Viewport& viewport,
               QWidget* parent = nullptr);

    /// Keeps what the viewport shows as another view.
    void bookmark();
    /// Adds every view that is no closer to the surface than the present one.
    void addDistant();
    /// Goes to a view by its number; for distant views, to their distance.
    void goTo(int view);
    CameraFiles& files() { return *m_files; }

signals:
    /// The user wants to see it.
    void viewChosen(const trixel::ViewCamera& view);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void makeList();
    QWidget* makeDistance();
    QWidget* makeButtons();
    QPushButton* addButton(const QString& text, const QString& name, const QString& toolTip);
    /// -1 when there is none.
    int current() const;
    void choose(int view);
    void update();
    void remove();
    void setDistance();
    void showDistance(double distance);
    void showState();

    Document& m_document;
    const Viewport& m_viewport;
    CameraFiles* m_files;
    ViewsModel* m_model;
    QTreeView* m_list;
    QLabel* m_empty;
    QWidget* m_distanceRow;
    ScaledSpinBox* m_distance;
    QLabel* m_inDiagonals;
    QPushButton* m_bookmark;
    QPushButton* m_addDistant;
    QPushButton* m_update;
    QPushButton* m_remove;
    QPushButton* m_load;
    QPushButton* m_save;
};

} // namespace trixel::ui
