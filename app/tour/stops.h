// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPoint>
#include <QPointF>

#include "app/tour/input_driver.h"
#include "core/base/result.h"
#include "ui/window/main_window.h"

#include <array>
#include <filesystem>
#include <string>

class QComboBox;

namespace trixel::ui {
class ImportPanel;
class ChartPanel;
class LayerList;
} // namespace trixel::ui

namespace trixel::app {

/// The stops of the tour, in order. Each uses the window, checks that the window did what it
/// should, and leaves a picture behind; an error names the stop and what was missing.
class Stops
{
public:
    Stops(ui::MainWindow& window, std::filesystem::path folder);

    Status wholeScene();
    Status hoveredTexel();
    Status heldTexel();
    Status paintedStroke();
    Status undoneAndRedone();
    Status texelsOfBothHalves();
    Status mipLevels();
    Status laidOutFace();
    Status faceMips();
    Status chosenLevels();
    Status paintedLayers();
    Status fittedLevels();
    Status importedImage();
    Status newProject();
    Status exportedTexture();
    Status exportedAtlas();
    Status measuredChart();
    Status viewOnTheChart();
    Status bookmarkedViews();
    Status conditionMap();
    Status errorMap();
    Status falseColours();
    Status comparedFilters();
    Status seamlessTexels();
    Status limitSurface();
    Status footprint();
    Status seamMeter();
    Status faceTable();
    Status sweptHazards();
    Status comparedFile();
    Status transferredPaint();
    Status bakedOut();

private:
    /// A place in the view by its share of width and height, [0,1] each.
    QPoint inView(double x, double y) const;
    Status picture(const std::string& name);
    Status pictureOf(QWidget& widget, const std::string& name);
    /// Presses the button that a screen reader calls by that name.
    Status press(QWidget& panel, const QString& name);
    /// Runs the study that is chosen, to its end where that comes soon.
    Status runStudy(ui::ChartPanel& panel);
    Status bandOnLayer(const std::array<float, 4>& color, double height, int layers);
    Status hiddenLayer(ui::LayerList& list);
    Status exportedLayer();
    Status lowLevels();
    Status chosenCreases();
    /// Opens the dialog and asks for a file of that name; pictures it once its size is said, unless
    /// the picture has no name.
    Status askForExport(const std::string& file, const std::string& pictureName);
    Status copiedPicture();
    Status distortedImage(ui::ImportPanel& panel, QComboBox& kinds);
    /// Drags the corner of an image that a screen reader calls by that name.
    Status draggedCorner(const QString& name, QPoint by);
    /// Runs the command that the palette lists first for the words.
    Status command(const QString& words);

    ui::MainWindow& m_window;
    QWidget& m_view;
    InputDriver m_input;
    std::filesystem::path m_folder;
    int m_taken = 0;
};

} // namespace trixel::app
