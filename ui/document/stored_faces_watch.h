// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>

#include <cstddef>
#include <memory>

namespace trixel {
class StoredFaces;
}

namespace trixel::ui {

class Document;

/// Looks now and then at the faces that a large file is read from: tells of those that could not be
/// read, and has the document give back memory once more of it is held than the cache may keep.
class StoredFacesWatch : public QObject
{
    Q_OBJECT

public:
    explicit StoredFacesWatch(Document& document);

    /// Another project was opened.
    void begin();
    /// What the timer does.
    void look();

signals:
    /// One sentence about faces that could not be read.
    void damaged(const QString& sentence);

private:
    Document& m_document;
    QTimer m_timer;
    std::shared_ptr<StoredFaces> m_faces;
    std::size_t m_told = 0;
};

} // namespace trixel::ui
