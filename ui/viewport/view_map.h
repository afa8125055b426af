// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFutureWatcher>
#include <QObject>
#include <QTimer>

#include "ui/viewport/face_map.h"
#include "ui/viewport/pixel_map.h"
#include "ui/viewport/viewport.h"

#include <memory>
#include <optional>
#include <vector>

namespace trixel::ui {

class Document;
class FilterSceneSource;
class MapLegend;
class ViewSettings;

/// A picture of numbers over the view, by `ViewOptions::map`, computed in the background.
///
/// Numbers of pixels are those of the camera as it stands, first coarsely, then finer until every
/// pixel is its own; thrown away as soon as the camera, the texels or the method are others.
/// Numbers of faces colour the surface itself and stay while the camera moves.
class ViewMap : public QObject
{
    Q_OBJECT

public:
    ViewMap(const Document& document,
            ViewSettings& settings,
            FilterSceneSource& source,
            Viewport& viewport,
            QObject* parent = nullptr);
    ~ViewMap() override;

    /// The finest step that covers the whole view: 1 when every pixel is its own, 0 while there is
    /// nothing yet.
    int completeStep() const;
    bool isComplete() const { return completeStep() == 1; }
    /// The number shown at a position of the viewport; nothing off the surface and for maps that
    /// are pictures.
    std::optional<float> valueAt(QPointF position) const;
    const MapLegend& legend() const { return *m_legend; }

    /// What the map Fit shows; without errors it shows nothing.
    void setFaceErrors(FaceErrors errors);
    /// What the map Difference shows; without differences it shows nothing.
    void setFaceDifferences(FaceDifferences differences);

signals:
    /// Part of the picture is there, or none any more.
    void progressed();
    /// Numbers and colours of all faces are there, or none any more.
    void facesNumbered(const std::shared_ptr<const trixel::ui::FaceNumbers>& numbers);

private:
    void takeOptions();
    void restart();
    void begin();
    void beginPixels();
    void beginFaces();
    void takeFaces();
    void beginOther();
    bool hasOther() const;
    MapWork workOf(const MethodChoice& method) const;
    void drop();
    void showState();
    void showValue();
    QString title() const;
    bool isReady() const;
    void showLegend();

    const Document& m_document;
    ViewSettings& m_settings;
    FilterSceneSource& m_source;
    Viewport& m_viewport;
    MapLegend* m_legend; ///< a child of the viewport
    QTimer m_pause;
    PixelMap m_pixels; ///< of the whole view, or of A
    PixelMap m_other;  ///< of B, where two filters are compared
    QFutureWatcher<FaceNumbers> m_faceWatcher;
    std::vector<float> m_faceValues; ///< of every face; empty when there are none
    FaceErrors m_faceErrors;
    FaceDifferences m_faceDifferences;
    ViewMapKind m_map = ViewMapKind::None;
    Comparison m_comparison;
    std::optional<QPointF> m_pointer;
};

} // namespace trixel::ui
