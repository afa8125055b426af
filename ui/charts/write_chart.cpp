// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/write_chart.h"

#include <QBuffer>
#include <QGuiApplication>
#include <QImage>
#include <QPainter>
#include <QSvgGenerator>

#include "core/base/read_file.h"
#include "core/io/commit_file.h"

#include <algorithm>
#include <array>
#include <iostream>
#include <memory>

namespace trixel::ui {

namespace {

constexpr int kFontPixels = 13;
constexpr int kScreenDpi = 96;
/// Larger pictures are refused rather than half drawn.
constexpr double kMostPixels = 16'384;

/// Letters need an application. The offscreen platform asks for no display.
class LetterApplication
{
public:
    LetterApplication()
    {
        if (QCoreApplication::instance() == nullptr) {
            m_handlerBefore = qInstallMessageHandler(&withoutWarnings);
            m_application = std::make_unique<QGuiApplication>(m_count, m_arguments.data());
        }
    }
    LetterApplication(const LetterApplication&) = delete;
    LetterApplication& operator=(const LetterApplication&) = delete;
    ~LetterApplication()
    {
        if (m_application != nullptr) {
            m_application.reset();
            qInstallMessageHandler(m_handlerBefore);
        }
    }

private:
    /// A bare machine lacks what a desktop has; drawing needs none of it, so it is not worth a
    /// word.
    static void
    withoutWarnings(QtMsgType type, const QMessageLogContext& /*context*/, const QString& message)
    {
        if (type == QtCriticalMsg || type == QtFatalMsg) {
            std::cerr << message.toStdString() << '\n';
        }
    }

    QtMessageHandler m_handlerBefore = nullptr;
    std::string m_name = "trixel";
    std::string m_option = "-platform";
    std::string m_platform = "offscreen";
    std::array<char*, 4> m_arguments{m_name.data(), m_option.data(), m_platform.data(), nullptr};
    int m_count = 3;
    std::unique_ptr<QGuiApplication> m_application;
};

QFont chartFont()
{
    QFont font;
    font.setFamilies({"Liberation Sans", "Noto Sans", "DejaVu Sans", "Sans Serif"});
    font.setPixelSize(kFontPixels);
    font.setHintingPreference(QFont::PreferNoHinting);
    return font;
}

/// One or several plots, side by side and below each other.
struct Sheet
{
    std::span<const Plot> plots;
    int columns = 1;
    QSize cell;
    PlotParts parts = {};
    PlotLook look;

    QSize size() const
    {
        const int rows = (static_cast<int>(plots.size()) + columns - 1) / columns;
        return {cell.width() * columns, cell.height() * rows};
    }
};

void paintSheet(QPainter& painter, const Sheet& sheet)
{
    const PlotFonts fonts(chartFont());
    painter.fillRect(QRect(QPoint(), sheet.size()), sheet.look.theme.background);
    for (std::size_t k = 0; k < sheet.plots.size(); ++k) {
        const Plot& plot = sheet.plots[k];
        const int at = static_cast<int>(k);
        painter.save();
        painter.translate(at % sheet.columns * sheet.cell.width(),
                          at / sheet.columns * sheet.cell.height());
        paintPlot(painter, plot, layOut(plot, sheet.cell, fonts, sheet.parts), fonts, sheet.look);
        painter.restore();
    }
}

QByteArray svgOf(const Sheet& sheet)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    QSvgGenerator generator;
    generator.setOutputDevice(&buffer);
    generator.setResolution(kScreenDpi);
    generator.setSize(sheet.size());
    generator.setViewBox(QRect(QPoint(), sheet.size()));
    const Plot& first = sheet.plots.front();
    generator.setTitle(first.title);
    generator.setDescription(first.subtitle + '\n' + first.note);
    QPainter painter(&generator);
    paintSheet(painter, sheet);
    painter.end();
    return bytes;
}

QByteArray pngOf(const Sheet& sheet, double pixelsPerUnit)
{
    QImage image((QSizeF(sheet.size()) * pixelsPerUnit).toSize(), QImage::Format_RGB32);
    image.setDevicePixelRatio(pixelsPerUnit);
    image.setText("Title", sheet.plots.front().title);
    QPainter painter(&image);
    paintSheet(painter, sheet);
    painter.end();
    QByteArray bytes;
    QBuffer buffer(&bytes);
    image.save(&buffer, "PNG");
    return bytes;
}

std::string endingOf(const std::filesystem::path& path)
{
    std::string ending = path.extension().string();
    std::ranges::transform(
        ending, ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending;
}

/// The point of the method in use.
std::optional<PlotMark>
chosenMark(const Study& study, const Plot& plot, const std::optional<MethodChoice>& chosen)
{
    return chosen ? markOf(study, plot, *chosen) : std::nullopt;
}

Status writePicture(const Sheet& sheet, const std::filesystem::path& path, double pixelsPerUnit)
{
    const QSizeF pixels = QSizeF(sheet.size()) * pixelsPerUnit;
    if (sheet.size().isEmpty() || !(pixels.width() >= 1 && pixels.width() <= kMostPixels) ||
        !(pixels.height() >= 1 && pixels.height() <= kMostPixels)) {
        return contentsError(path.string() + ": a chart is from 1 to 16384 pixels wide and high");
    }
    const LetterApplication letters;
    const QByteArray bytes = endingOf(path) == ".svg" ? svgOf(sheet) : pngOf(sheet, pixelsPerUnit);
    return writeText(path, std::string_view(bytes.constData(), std::size_t(bytes.size())));
}

PlotLook lookOf(const ChartOptions& options, const std::optional<PlotMark>& chosen)
{
    return {.theme = options.dark ? darkPlotTheme() : lightPlotTheme(),
            .lettering = Lettering::Outlines,
            .lifted = {},
            .chosen = chosen};
}

bool isPicture(const std::filesystem::path& path)
{
    const std::string ending = endingOf(path);
    return ending == ".svg" || ending == ".png";
}

} // namespace

Status writeText(const std::filesystem::path& path, std::string_view text)
{
    return commitFile(
        path,
        [&](FileWriter& file) { return file.write(text); },
        [&](const std::filesystem::path& written) -> Status {
            const Result<std::string> found = readFile(written);
            if (!found) {
                return tl::unexpected(found.error());
            }
            return *found == text ? Status()
                                  : pathError("what was read back differs from what was written");
        });
}

Status
writeChart(const Study& study, const std::filesystem::path& path, const ChartOptions& options)
{
    const std::string ending = endingOf(path);
    if (ending == ".csv") {
        return writeText(path, toCsv(study));
    }
    if (ending == ".json") {
        return writeText(path, toJson(study));
    }
    if (!isPicture(path)) {
        return contentsError(path.string() + ": a chart is written as .svg, .png, .csv or .json");
    }
    const Plot plot = plotOf(study, options.view);
    if (plot.isEmpty()) {
        return contentsError(path.string() + ": the study '" + study.name + "' has no points for " +
                             nameOf(options.view.footprintClass).toLower().toStdString());
    }
    const Sheet sheet{.plots = {&plot, 1},
                      .columns = 1,
                      .cell = options.size,
                      .look = lookOf(options, chosenMark(study, plot, options.chosen))};
    return writePicture(sheet, path, options.pixelsPerUnit);
}

Status writePlot(const Plot& plot, const std::filesystem::path& path, const ChartOptions& options)
{
    if (!isPicture(path)) {
        return contentsError(path.string() + ": a chart is written as .svg or .png");
    }
    const Sheet sheet{.plots = {&plot, 1},
                      .columns = 1,
                      .cell = options.size,
                      .look = lookOf(options, std::nullopt)};
    return writePicture(sheet, path, options.pixelsPerUnit);
}

Status writeSheet(std::span<const Plot> plots,
                  int columns,
                  const std::filesystem::path& path,
                  const ChartOptions& options)
{
    if (!isPicture(path) || plots.empty()) {
        return contentsError(path.string() + ": charts are written as .svg or .png, at least one");
    }
    const Sheet sheet{.plots = plots,
                      .columns = columns,
                      .cell = options.size,
                      .parts = {.heading = true, .note = false},
                      .look = lookOf(options, std::nullopt)};
    return writePicture(sheet, path, options.pixelsPerUnit);
}

} // namespace trixel::ui
