// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>

#include "core/study/views/view_camera.h"

namespace trixel::ui {

class Document;

/// The views from which the document's surface is looked at, kept with the project. They are
/// numbered from 0, the cameras first, then the distant views. Every change is one undo step of the
/// document; what cannot be done is refused with the document's `notice`.
class ViewBookmarks : public QObject
{
    Q_OBJECT

public:
    /// Longest name of a view, in characters.
    static constexpr int kLongestName = 100;

    explicit ViewBookmarks(Document& document);

    const SceneViews& views() const { return m_views; }
    bool isEmpty() const { return m_views.isEmpty(); }
    int count() const;
    bool isDistant(int index) const;
    QString name(int index) const;

    /// Both give a view without a name one that no other has: "View 1", "Any view 1".
    /// \return  whether it was done
    bool add(ViewCamera camera);
    bool addDistant(DistantViews views);
    /// Adds all that are not there already (equal, name and all), as one step.
    bool addAll(SceneViews more);
    /// Takes the place of all views.
    bool replaceAll(SceneViews views);

    /// Another name; the same or none leaves all as it is.
    void rename(int index, const QString& name);
    /// Takes the place of a camera, or of distant views, that keep their name.
    bool update(int index, ViewCamera camera);
    bool update(int index, DistantViews views);
    void remove(int index);

signals:
    /// The views are others now; also after undo, and when another project opens.
    void changed();

private:
    friend class Document;
    /// What the document holds now.
    void take(SceneViews views);
    bool change(SceneViews next, const QString& text);
    /// The pattern with the least number that makes a name of its own.
    QString freeName(const QString& pattern) const;

    Document& m_document;
    SceneViews m_views;
};

} // namespace trixel::ui
