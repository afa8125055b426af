// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointer>
#include <QTimer>
#include <QWidget>

#include "ui/document/background_job.h"
#include "ui/import/import_images.h"

#include <memory>
#include <optional>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;

namespace trixel::ui {

class PathRow;

/// Which image: its file, what is in it, and what its numbers mean. Read in the background as soon
/// as it is named; what is wrong with it stands below.
class ImageRow : public QObject
{
    Q_OBJECT

public:
    /// Adds the rows of the file to a form. \param jobs  outlive this
    ImageRow(BackgroundJobs& jobs, QFormLayout& form, QObject* parent);
    /// Adds those of what its numbers mean.
    void addMeaning(QFormLayout& form);

    /// Null where there is none, and while one is read.
    const std::shared_ptr<const ImportImages>& images() const { return m_images; }
    bool isReading() const { return m_job != nullptr || m_typing.isActive(); }
    /// One sentence where the file cannot be used; empty where it can, and where none is named.
    QString problem() const { return m_problem; }
    /// The file's name without its folder.
    QString name() const;
    std::optional<ColorSpace> color() const;
    std::optional<std::uint16_t> channel() const;

    void setPath(const QString& path);
    void setFocus();

signals:
    /// Another image, or none.
    void imageChanged();
    /// The image's numbers mean something else.
    void meaningChanged();

private:
    void read();
    void take(Result<std::shared_ptr<const ImportImages>> images);
    void showImage();
    void offerChannels();
    void offerTiles();

    BackgroundJobs& m_jobs;
    PathRow* m_path;
    QCheckBox* m_tiles;
    QLabel* m_about;
    QComboBox* m_color;
    QComboBox* m_channel;
    QTimer m_typing;
    QPointer<BackgroundJob> m_job;
    std::uint64_t m_asked = 0;
    std::shared_ptr<const ImportImages> m_images;
    QString m_problem;
};

} // namespace trixel::ui
