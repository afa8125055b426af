// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/import/image_row.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QSignalBlocker>

#include "core/io/image/tile_files.h"
#include "ui/dialogs/path_row.h"
#include "ui/import/import_words.h"

#include <utility>

namespace trixel::ui {

namespace {

constexpr int kTypingPauseMs = 350;

std::filesystem::path toPath(const QString& text)
{
    return {text.toStdString()};
}

/// The field says which file it is.
Error withoutPath(Error error, const QString& path)
{
    const std::string prefix = path.toStdString() + ": ";
    if (error.message.starts_with(prefix)) {
        error.message.erase(0, prefix.size());
    }
    return error;
}

} // namespace

ImageRow::ImageRow(BackgroundJobs& jobs, QFormLayout& form, QObject* parent)
    : QObject(parent)
    , m_jobs(jobs)
    , m_path(new PathRow(PathRow::Purpose::Open, tr("Image file"), imageFilter()))
    , m_tiles(new QCheckBox)
    , m_about(new QLabel)
    , m_color(new QComboBox)
    , m_channel(new QComboBox)
{
    m_about->setWordWrap(true);
    m_about->setAccessibleName(tr("About the image"));
    m_about->setToolTip(tr("What was found in the image file"));
    m_about->setMinimumHeight(2 * m_about->fontMetrics().lineSpacing());
    m_about->setAlignment(Qt::AlignTop);
    m_tiles->setAccessibleName(tr("Use the images of all tiles"));
    m_tiles->setToolTip(tr("Read all files that differ in the tile's number (UDIM) alone, each for "
                           "its own tile of the mesh's uvs"));
    m_tiles->hide();
    form.addRow(tr("Ima&ge"), m_path);
    form.addRow(QString(), m_about);
    form.addRow(QString(), m_tiles);

    m_typing.setSingleShot(true);
    m_typing.setInterval(kTypingPauseMs);
    connect(&m_typing, &QTimer::timeout, this, &ImageRow::read);
    connect(m_path, &PathRow::pathChanged, this, [this] { m_typing.start(); });
    connect(m_tiles, &QCheckBox::toggled, this, &ImageRow::read);
    connect(m_color, &QComboBox::currentIndexChanged, this, &ImageRow::meaningChanged);
    connect(m_channel, &QComboBox::currentIndexChanged, this, &ImageRow::meaningChanged);
    showImage();
}

void ImageRow::addMeaning(QFormLayout& form)
{
    m_color->setAccessibleName(tr("What the image’s colours mean"));
    m_color->setToolTip(
        tr("Colours are averaged in linear light: sRGB numbers are converted first, "
           "raw ones are data and taken as they are"));
    m_channel->setAccessibleName(tr("Channels of the image"));
    m_channel->setToolTip(
        tr("All colours, each to its own channel of the texels; or one channel of "
           "the image for all of them"));
    form.addRow(tr("C&olours"), m_color);
    form.addRow(tr("Cha&nnels"), m_channel);
}

QString ImageRow::name() const
{
    return QFileInfo(m_path->path()).fileName();
}

std::optional<ColorSpace> ImageRow::color() const
{
    const QVariant chosen = m_color->currentData();
    return chosen.isValid() ? std::optional(static_cast<ColorSpace>(chosen.toInt())) : std::nullopt;
}

std::optional<std::uint16_t> ImageRow::channel() const
{
    const QVariant chosen = m_channel->currentData();
    return chosen.isValid() ? std::optional(static_cast<std::uint16_t>(chosen.toInt()))
                            : std::nullopt;
}

void ImageRow::setPath(const QString& path)
{
    m_path->setPath(path);
    read();
}

void ImageRow::setFocus()
{
    m_path->setFocus(Qt::ShortcutFocusReason);
}

/// Whether other files are named like this one but for the tile's number.
void ImageRow::offerTiles()
{
    const auto pattern = tilePattern(toPath(m_path->path()));
    const auto files = pattern ? tileFiles(*pattern) : Result<std::vector<TileFile>>();
    const bool offered = pattern && files && files->size() > 1;
    if (offered) {
        m_tiles->setText(tr("All %1 &tiles").arg(files->size()));
    } else {
        const QSignalBlocker silent(m_tiles);
        m_tiles->setChecked(false);
    }
    m_tiles->setVisible(offered);
}

void ImageRow::read()
{
    m_typing.stop();
    const std::uint64_t number = ++m_asked;
    if (m_job) {
        m_job->cancel();
    }
    m_images.reset();
    m_problem.clear();
    const QString path = m_path->path();
    if (path.isEmpty()) {
        m_job = nullptr;
        showImage();
        emit imageChanged();
        return;
    }
    offerTiles();
    const std::filesystem::path file = toPath(path);
    const auto pattern = m_tiles->isChecked() ? tilePattern(file) : std::nullopt;
    m_job = &m_jobs.run(
        tr("Reading %1…").arg(name()),
        [file = pattern.value_or(file)](Progress& progress) {
            return readImportImages(file, progress);
        },
        [row = QPointer<ImageRow>(this),
         number](Result<std::shared_ptr<const ImportImages>> images) {
            if (row && row->m_asked == number) {
                row->m_job = nullptr;
                row->take(std::move(images));
            }
        });
    showImage();
    emit imageChanged();
}

void ImageRow::take(Result<std::shared_ptr<const ImportImages>> images)
{
    if (images) {
        m_images = std::move(*images);
    } else {
        m_problem = images.error().kind == ErrorKind::Cancelled
                        ? tr("Reading was cancelled: choose the file again.")
                        : problemText(withoutPath(images.error(), m_path->path()));
    }
    offerChannels();
    showImage();
    emit imageChanged();
}

void ImageRow::offerChannels()
{
    const QSignalBlocker silent(m_channel);
    const QVariant before = m_channel->currentData();
    m_channel->clear();
    m_channel->addItem(tr("All colours"));
    if (m_images) {
        for (int c = 0; c < m_images->first().format().channels; ++c) {
            m_channel->addItem(channelName(m_images->first().format(), c), c);
        }
    }
    m_channel->setCurrentIndex(before.isValid() ? std::max(0, m_channel->findData(before)) : 0);
    const QSignalBlocker silentToo(m_color);
    const int color = std::max(0, m_color->currentIndex());
    m_color->clear();
    m_color->addItem(m_images ? tr("As the file says: %1").arg(colorText(m_images->first()))
                              : tr("As the file says"));
    m_color->addItem(tr("sRGB"), static_cast<int>(ColorSpace::SRgb));
    m_color->addItem(tr("Linear light"), static_cast<int>(ColorSpace::Linear));
    m_color->addItem(tr("Raw data"), static_cast<int>(ColorSpace::Raw));
    m_color->setCurrentIndex(color);
}

void ImageRow::showImage()
{
    if (m_color->count() == 0) {
        offerChannels();
    }
    m_color->setEnabled(m_images != nullptr);
    m_channel->setEnabled(m_images != nullptr);
    if (m_images) {
        m_about->setText(aboutText(*m_images));
    } else if (!m_problem.isEmpty()) {
        m_about->setText(m_problem);
    } else {
        m_about->setText(m_job ? tr("Reading…")
                               : tr("PNG, JPEG, TIFF, OpenEXR, HDR, TGA, BMP or WebP; or drop one "
                                    "on the window."));
    }
}

} // namespace trixel::ui
