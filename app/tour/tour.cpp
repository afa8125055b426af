// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tour/tour.h"

#include <QApplication>
#include <QSettings>
#include <QTemporaryDir>

#include "app/tour/stops.h"
#include "ui/viewport/viewport.h"
#include "ui/window/application.h"
#include "ui/window/main_window.h"

#include <string>
#include <system_error>

namespace trixel::app {

namespace {

constexpr QSize kWindowSize(1440, 900);

/// The person's own window layout and recent files must not show in the pictures, nor change.
void useSettingsOf(const QTemporaryDir& folder)
{
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder.path());
}

Status makeFolder(const std::filesystem::path& folder)
{
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    return error ? Status(pathError(folder.string() + ": " + error.message())) : Status();
}

Status openSample(ui::MainWindow& window, InputDriver& input)
{
    window.files().openSample();
    return input.waitFor([&] { return window.document().isOpen() && window.viewport().canDraw(); })
               ? Status()
               : Status(contentsError("tour: the sample scene did not open"));
}

Status visit(ui::MainWindow& window, const std::filesystem::path& folder)
{
    Stops stops(window, folder);
    using Stop = Status (Stops::*)();
    for (const Stop stop :
         {&Stops::wholeScene,      &Stops::hoveredTexel,    &Stops::heldTexel,
          &Stops::paintedStroke,   &Stops::undoneAndRedone, &Stops::texelsOfBothHalves,
          &Stops::faceMips,        &Stops::mipLevels,       &Stops::laidOutFace,
          &Stops::chosenLevels,    &Stops::paintedLayers,   &Stops::fittedLevels,
          &Stops::importedImage,   &Stops::bookmarkedViews, &Stops::conditionMap,
          &Stops::errorMap,        &Stops::falseColours,    &Stops::comparedFilters,
          &Stops::seamlessTexels,  &Stops::limitSurface,    &Stops::footprint,
          &Stops::seamMeter,       &Stops::faceTable,       &Stops::newProject,
          &Stops::exportedTexture, &Stops::exportedAtlas,   &Stops::measuredChart,
          &Stops::viewOnTheChart,  &Stops::sweptHazards}) {
        if (Status done = (stops.*stop)(); !done) {
            return done;
        }
    }
    // Files beside the sample; the last two open other meshes.
    for (const Stop stop : {&Stops::comparedFile, &Stops::transferredPaint, &Stops::bakedOut}) {
        if (Status done = (stops.*stop)(); !done) {
            return done;
        }
    }
    return {};
}

} // namespace

Status takeTour(const std::filesystem::path& folder)
{
    if (Status made = makeFolder(folder); !made) {
        return made;
    }
    const QTemporaryDir settings;
    useSettingsOf(settings);
    ui::prepareApplication();
    std::string name = "trixel";
    char* arguments[] = {name.data(), nullptr};
    int count = 1;
    QApplication application(count, arguments);
    ui::setUpApplication(application);
    ui::MainWindow window;
    window.resize(kWindowSize);
    window.show();
    InputDriver input(window);
    const Status opened = openSample(window, input);
    return opened ? visit(window, folder) : opened;
}

} // namespace trixel::app
