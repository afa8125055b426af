// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include <array>
#include <glm/vec3.hpp>

namespace trixel::ui {

class ValueSpin;

/// Three fields for a point of the world.
class PointRow : public QWidget
{
    Q_OBJECT

public:
    /// \param name     for screen readers, of which each field adds its axis
    /// \param toolTip  what the point is
    PointRow(const QString& name, const QString& toolTip, QWidget* parent = nullptr);

    glm::dvec3 value() const;
    /// Tells nobody.
    void setValue(const glm::dvec3& value);
    /// By how much the arrows of a field change it.
    void setStep(double step);

signals:
    /// By the user's hand.
    void edited();

private:
    std::array<ValueSpin*, 3> m_fields{};
    bool m_isSetting = false;
};

} // namespace trixel::ui
