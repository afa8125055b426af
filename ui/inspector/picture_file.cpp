// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspector/picture_file.h"

#include <QApplication>
#include <QBuffer>
#include <QFontMetrics>
#include <QPainter>
#include <QPalette>
#include <QSvgGenerator>

#include "ui/charts/write_chart.h"
#include "ui/inspector/picture_source.h"

#include <string_view>

namespace trixel::ui {

namespace {

constexpr int kScreenDpi = 96;
constexpr int kMargin = 6;

/// A picture with its caption.
struct Sheet
{
    PictureSource& source;
    QString caption;
    QSize picture;
    QFont font = QApplication::font();
    int captionHeight = 0;

    QSize size() const { return picture + QSize(0, captionHeight); }
};

QRect captionRoom(const Sheet& sheet, int height)
{
    return {kMargin, sheet.picture.height() + kMargin, sheet.picture.width() - 2 * kMargin, height};
}

Result<Sheet> sheetOf(PictureSource& source, const QString& caption, double pixelsPerUnit)
{
    Sheet sheet{source, caption, source.pictureSize()};
    if (sheet.picture.isEmpty()) {
        return contentsError("There is nothing to make a picture of.");
    }
    if (!caption.isEmpty()) {
        const QRect room = captionRoom(sheet, kMostPicturePixels);
        const QRect text = QFontMetrics(sheet.font).boundingRect(room, Qt::TextWordWrap, caption);
        sheet.captionHeight = text.height() + 2 * kMargin;
    }
    const QSizeF pixels = QSizeF(sheet.size()) * pixelsPerUnit;
    if (!(pixels.width() <= kMostPicturePixels) || !(pixels.height() <= kMostPicturePixels)) {
        return contentsError("The picture would be " + std::to_string(qRound(pixels.width())) +
                             " × " + std::to_string(qRound(pixels.height())) +
                             " pixels; 16384 each way is the most.");
    }
    return sheet;
}

void paintSheet(QPainter& painter, const Sheet& sheet)
{
    const QPalette palette = QApplication::palette();
    painter.fillRect(QRect(QPoint(), sheet.size()), palette.color(QPalette::Window));
    painter.save();
    painter.setClipRect(QRect(QPoint(), sheet.picture));
    sheet.source.paintPicture(painter, sheet.picture);
    painter.restore();
    if (!sheet.caption.isEmpty()) {
        painter.setFont(sheet.font);
        painter.setPen(palette.color(QPalette::WindowText));
        painter.drawText(captionRoom(sheet, sheet.captionHeight), Qt::TextWordWrap, sheet.caption);
    }
}

} // namespace

Result<QImage> imageOf(PictureSource& source, const QString& caption, double pixelsPerUnit)
{
    const Result<Sheet> sheet = sheetOf(source, caption, pixelsPerUnit);
    if (!sheet) {
        return tl::unexpected(sheet.error());
    }
    QImage image((QSizeF(sheet->size()) * pixelsPerUnit).toSize(), QImage::Format_RGB32);
    if (image.isNull()) {
        return contentsError("There is not enough memory for this picture.");
    }
    image.setDevicePixelRatio(pixelsPerUnit);
    image.setText("Description", caption);
    QPainter painter(&image);
    painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
    paintSheet(painter, *sheet);
    painter.end();
    return image;
}

Result<QByteArray> svgOf(PictureSource& source, const QString& caption)
{
    const Result<Sheet> sheet = sheetOf(source, caption, 1);
    if (!sheet) {
        return tl::unexpected(sheet.error());
    }
    QByteArray bytes;
    QBuffer buffer(&bytes);
    QSvgGenerator generator;
    generator.setOutputDevice(&buffer);
    generator.setResolution(kScreenDpi);
    generator.setSize(sheet->size());
    generator.setViewBox(QRect(QPoint(), sheet->size()));
    generator.setTitle(source.pictureName());
    generator.setDescription(caption);
    QPainter painter(&generator);
    paintSheet(painter, *sheet);
    painter.end();
    return bytes;
}

Status writePng(const QImage& image, const std::filesystem::path& path)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    if (!image.save(&buffer, "PNG")) {
        return contentsError("The picture could not be compressed.");
    }
    return writeText(path, std::string_view(bytes.constData(), std::size_t(bytes.size())));
}

} // namespace trixel::ui
