// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFutureWatcher>
#include <QObject>

#include "core/filter/filter_method.h"
#include "core/filter/footprint_net.h"

#include <memory>
#include <optional>
#include <vector>

namespace trixel::ui {

/// What a tilted view asks for and gets at one angle.
struct SweepPoint
{
    double degrees = 0;
    double anisotropy = 1;
    double level = 0;
    double taps = 0;  ///< not finite where the method refuses
    double error = 0; ///< against exact, in parts of the value range; not finite where refused
};

/// Footprints at some angles about one point, filtered in the background by a method and exactly.
class FootprintSweep : public QObject
{
    Q_OBJECT

public:
    struct Angle
    {
        double degrees = 0;
        double anisotropy = 1;
        PlacedFootprint placed;
    };

    explicit FootprintSweep(QObject* parent = nullptr);
    ~FootprintSweep() override;

    /// Begins anew. \param range  of values, that errors are told in parts of
    void start(const std::shared_ptr<const FilterScene>& scene,
               const MethodChoice& method,
               double range,
               std::vector<Angle> angles);
    void clear();

    /// As far as it went, by angle.
    const std::vector<SweepPoint>& points() const { return m_points; }

signals:
    void changed();

private:
    QFutureWatcher<SweepPoint> m_watcher;
    std::vector<SweepPoint> m_points;
};

} // namespace trixel::ui
