// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>

class QWidget;

namespace trixel::ui {

class BackgroundJobs;
class Document;

/// Brings views from cameras files (see `parseCameras`) to the document's bookmarks and back, in
/// the background. A failure leaves views and files as they were and is told in one sentence.
class CameraFiles : public QObject
{
    Q_OBJECT

public:
    /// \param parent  what the file dialogs stand in front of
    CameraFiles(Document& document, BackgroundJobs& jobs, QWidget& parent);

    void askForLoad();
    void askForSave();
    /// Adds the views of a file that are not bookmarked yet, as one undo step.
    void load(const QString& path);
    void save(const QString& path);

signals:
    /// What was done, as a sentence.
    void done(const QString& sentence);
    /// One sentence naming the file and the cause.
    void failed(const QString& sentence);

private:
    Document& m_document;
    BackgroundJobs& m_jobs;
    QWidget& m_parent;
};

} // namespace trixel::ui
