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

QByteArray svgOf(const Plot& plot, const ChartOptions& options, const PlotLook& look)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    QSvgGenerator generator;
    generator.setOutputDevice(&buffer);
    generator.setResolution(kScreenDpi);
    generator.setSize(options.size);
    generator.setViewBox(QRect(QPoint(), options.size));
    generator.setTitle(plot.title);
    generator.setDescription(plot.subtitle + '\n' + plot.note);
    const PlotFonts fonts(chartFont());
    QPainter painter(&generator);
    paintPlot(painter, plot, layOut(plot, options.size, fonts, {}), fonts, look);
    painter.end();
    return bytes;
}

QByteArray pngOf(const Plot& plot, const ChartOptions& options, const PlotLook& look)
{
    QImage image((QSizeF(options.size) * options.pixelsPerUnit).toSize(), QImage::Format_RGB32);
    image.setDevicePixelRatio(options.pixelsPerUnit);
    image.setText("Title", plot.title);
    const PlotFonts fonts(chartFont());
    QPainter painter(&image);
    paintPlot(painter, plot, layOut(plot, options.size, fonts, {}), fonts, look);
    painter.end();
    QByteArray bytes;
    QBuffer buffer(&bytes);
    image.save(&buffer, "PNG");
    return bytes;
}

Status writeBytes(const std::filesystem::path& path, std::string_view bytes)
{
    return commitFile(
        path,
        [&](FileWriter& file) { return file.write(bytes); },
        [&](const std::filesystem::path& written) -> Status {
            const Result<std::string> found = readFile(written);
            if (!found) {
                return tl::unexpected(found.error());
            }
            return *found == bytes ? Status()
                                   : pathError("what was read back differs from what was written");
        });
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

Status writePicture(const Plot& plot,
                    const std::filesystem::path& path,
                    const ChartOptions& options,
                    const std::optional<PlotMark>& chosen)
{
    const QSizeF pixels = QSizeF(options.size) * options.pixelsPerUnit;
    if (options.size.isEmpty() || !(pixels.width() >= 1 && pixels.width() <= kMostPixels) ||
        !(pixels.height() >= 1 && pixels.height() <= kMostPixels)) {
        return contentsError(path.string() + ": a chart is from 1 to 16384 pixels wide and high");
    }
    const PlotLook look{.theme = options.dark ? darkPlotTheme() : lightPlotTheme(),
                        .lettering = Lettering::Outlines,
                        .lifted = {},
                        .chosen = chosen};
    const LetterApplication letters;
    const QByteArray bytes =
        endingOf(path) == ".svg" ? svgOf(plot, options, look) : pngOf(plot, options, look);
    return writeBytes(path, std::string_view(bytes.constData(), std::size_t(bytes.size())));
}

bool isPicture(const std::filesystem::path& path)
{
    const std::string ending = endingOf(path);
    return ending == ".svg" || ending == ".png";
}

} // namespace

Status
writeChart(const Study& study, const std::filesystem::path& path, const ChartOptions& options)
{
    const std::string ending = endingOf(path);
    if (ending == ".csv") {
        return writeBytes(path, toCsv(study));
    }
    if (ending == ".json") {
        return writeBytes(path, toJson(study));
    }
    if (!isPicture(path)) {
        return contentsError(path.string() + ": a chart is written as .svg, .png, .csv or .json");
    }
    const Plot plot = plotOf(study, options.view);
    if (plot.isEmpty()) {
        return contentsError(path.string() + ": the study '" + study.name + "' has no points for " +
                             nameOf(options.view.footprintClass).toLower().toStdString());
    }
    return writePicture(plot, path, options, chosenMark(study, plot, options.chosen));
}

Status writePlot(const Plot& plot, const std::filesystem::path& path, const ChartOptions& options)
{
    if (!isPicture(path)) {
        return contentsError(path.string() + ": a chart is written as .svg or .png");
    }
    return writePicture(plot, path, options, std::nullopt);
}

} // namespace trixel::ui
