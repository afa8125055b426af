// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspector/footprint_table.h"

#include <QGridLayout>
#include <QLabel>
#include <QResizeEvent>

#include "ui/viewport/surface_lines.h"

namespace trixel::ui {

namespace {

/// From here on the frozen numbers stand beside the live ones.
constexpr int kWide = 460;

FootprintRow rowAt(std::size_t index)
{
    return static_cast<FootprintRow>(index);
}

} // namespace

FootprintTable::FootprintTable(QWidget* parent)
    : QWidget(parent)
    , m_grid(new QGridLayout(this))
{
    m_grid->setContentsMargins(0, 0, 0, 0);
    m_grid->setHorizontalSpacing(10);
    m_grid->setVerticalSpacing(2);
    const auto valueLabel = [this](const QString& name, const QString& toolTip) {
        auto* label = new QLabel(this);
        label->setAccessibleName(name);
        label->setToolTip(toolTip);
        label->setWordWrap(true);
        label->setTextInteractionFlags(Qt::TextSelectableByMouse);
        label->setAlignment(Qt::AlignTop | Qt::AlignLeft);
        label->setMinimumWidth(1);
        label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
        return label;
    };
    for (std::size_t k = 0; k < kFootprintRows; ++k) {
        const QString name = footprintRowName(rowAt(k));
        const QString toolTip = footprintRowTip(rowAt(k));
        m_names[k] = new QLabel(name, this);
        m_names[k]->setToolTip(toolTip);
        m_names[k]->setAlignment(Qt::AlignTop | Qt::AlignLeft);
        m_values[k] = valueLabel(name.trimmed(), toolTip);
        m_frozen[k] = valueLabel(tr("%1 of the frozen footprint").arg(name.trimmed()), toolTip);
    }
    place();
    colorFrozen();
    show(std::nullopt);
    showFrozen(std::nullopt);
}

void FootprintTable::place()
{
    for (std::size_t k = 0; k < kFootprintRows; ++k) {
        const int row = 2 * static_cast<int>(k);
        m_grid->addWidget(m_names[k], row, 0);
        m_grid->addWidget(m_values[k], row, 1);
        m_grid->addWidget(m_frozen[k], m_isWide ? row : row + 1, m_isWide ? 2 : 1);
    }
    m_grid->setColumnStretch(1, 1);
    m_grid->setColumnStretch(2, m_isWide && m_hasFrozen ? 1 : 0);
}

/// The frozen numbers in the colour of its lines, as dark as paper needs it.
void FootprintTable::colorFrozen()
{
    const bool dark = palette().color(QPalette::Window).lightness() < 128;
    QPalette colors = palette();
    colors.setColor(QPalette::WindowText,
                    dark ? QColor::fromRgbF(kFrozenColor.r, kFrozenColor.g, kFrozenColor.b)
                         : QColor(0x9c, 0x1f, 0x8a));
    for (QLabel* label : m_frozen) {
        label->setPalette(colors);
    }
}

void FootprintTable::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) {
        colorFrozen();
    }
}

void FootprintTable::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    const bool wide = width() >= kWide;
    if (wide != m_isWide) {
        m_isWide = wide;
        place();
    }
}

void FootprintTable::show(const std::optional<FootprintFacts>& facts)
{
    for (std::size_t k = 0; k < kFootprintRows; ++k) {
        m_values[k]->setText(facts ? footprintRowText(rowAt(k), *facts) : QString("–"));
    }
}

void FootprintTable::showFrozen(const std::optional<FootprintFacts>& facts)
{
    for (std::size_t k = 0; k < kFootprintRows; ++k) {
        const bool told = rowAt(k) != FootprintRow::Texels && rowAt(k) != FootprintRow::Spread;
        m_frozen[k]->setVisible(facts.has_value() && told);
        m_frozen[k]->setText(facts ? footprintRowText(rowAt(k), *facts) : QString());
    }
    if (m_hasFrozen != facts.has_value()) {
        m_hasFrozen = facts.has_value();
        place();
    }
}

QString FootprintTable::text(FootprintRow row) const
{
    return m_values[static_cast<std::size_t>(row)]->text();
}

QString FootprintTable::frozenText(FootprintRow row) const
{
    return m_frozen[static_cast<std::size_t>(row)]->text();
}

QString FootprintTable::text() const
{
    QString lines;
    for (std::size_t k = 0; k < kFootprintRows; ++k) {
        lines +=
            QString(m_names[k]->text().trimmed() + ": " + m_values[k]->text()).replace('\n', ' ');
        if (m_hasFrozen && m_frozen[k]->isVisibleTo(this)) {
            lines += QString(" | " + m_frozen[k]->text()).replace('\n', ' ');
        }
        lines += '\n';
    }
    return lines;
}

} // namespace trixel::ui
