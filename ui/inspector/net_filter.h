// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFutureWatcher>
#include <QImage>
#include <QObject>
#include <QTimer>

#include "render/split.h"
#include "ui/inspector/layout_scene.h"
#include "ui/viewport/map_work.h"

#include <array>
#include <optional>

namespace trixel::ui {

class Document;
class FilterSceneSource;
class ViewSettings;

/// Faces laid into a plane as the chosen filter sees them: each pixel asks the filter about its own
/// footprint, in the background, coarsely first. Works while the view's map is Filtered; where two
/// filters are compared, B is computed, too.
class NetFilter : public QObject
{
    Q_OBJECT

public:
    /// What is seen where. A value.
    struct Place
    {
        LayoutScene scene;
        PlaneMap toPixels; ///< from the scene's plane to the picture
        QSize size;        ///< of the picture, in pixels
        QRect area;        ///< in which anything is drawn
        double unit = 1;   ///< pixels to one of 1/96 inch

        bool operator==(const Place&) const = default;
    };

    NetFilter(const Document& document,
              const ViewSettings& settings,
              FilterSceneSource& source,
              QObject* parent = nullptr);
    ~NetFilter() override;

    /// Whether the view's map asks for filtered pictures.
    bool isWanted() const;
    /// Begins with another place when it has been still for a moment; nothing: nobody looks. Says
    /// nothing by itself.
    void show(const std::optional<Place>& place);
    const std::optional<Place>& place() const { return m_place; }
    /// As far as it is computed, clear elsewhere; null while there is nothing yet.
    const QImage* picture(render::Side side) const;
    /// Whether every pixel is its own.
    bool isComplete() const;

signals:
    /// More of a picture is there, or none any more.
    void changed();

private:
    struct Picture
    {
        QFutureWatcher<MapBand> watcher;
        QImage image;
        bool isComplete = false;
    };

    void restart();
    void drop();
    void begin();
    void begin(Picture& picture, const MethodChoice& method);
    void take(Picture& picture, const MapBand& band);
    bool hasOther() const;

    const Document& m_document;
    const ViewSettings& m_settings;
    FilterSceneSource& m_source;
    QTimer m_pause;
    std::array<Picture, 2> m_pictures; ///< by side
    std::optional<Place> m_place;
};

} // namespace trixel::ui
