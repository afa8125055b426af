// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSet>
#include <QWidget>

#include "core/study/views/view_camera.h"
#include "ui/document/background_job.h"

class QCheckBox;
class QLabel;
class QListWidget;
class QPushButton;

namespace trixel::ui {

class Document;
class ScaledSpinBox;
class Viewport;

/// Chooses the views that a fit is to keep: the checked ones of the document's bookmarks, and every
/// view beyond a distance.
class FitViews : public QWidget
{
    Q_OBJECT

public:
    FitViews(Document& document, const Viewport& viewport, QWidget* parent = nullptr);

    /// Without their names: what is planned does not depend on them.
    SceneViews chosen() const;

signals:
    void changed();

private:
    void makeList();
    QWidget* makeDistance();
    void listViews();
    void addPresent();
    void takeChecks();
    void takeDocument();
    void measureTexels();
    void proposeDistance();
    void explainDistance();
    DistantViews beyond() const;

    Document& m_document;
    const Viewport& m_viewport;
    BackgroundJobs m_jobs; // brief: nobody needs to see them
    quint64 m_generation = 0;
    QSet<QString> m_leftOut;         ///< names of those that are not checked
    double m_texelSpacing = 0;       ///< world units from texel to texel, mean; 0 while not known
    bool m_distanceIsChosen = false; ///< by the user
    QListWidget* m_list;
    QPushButton* m_add;
    QCheckBox* m_beyond;
    ScaledSpinBox* m_distance;
    QLabel* m_spacing;
};

} // namespace trixel::ui
