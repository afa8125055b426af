// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/uv_page.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QSpinBox>

#include "ui/dialogs/format_choice.h"

#include <algorithm>

namespace trixel::ui {

namespace {

constexpr int kSmallestSize = 128;
constexpr int kLargestSize = 16384;
/// Of the choices of type and meaning: what the file and the project suggest.
constexpr int kByItself = -1;

const QString kPlace = QString::fromUtf8(kUdimPlace.data(), qsizetype(kUdimPlace.size()));

void explain(QWidget* widget, const QString& name, const QString& toolTip)
{
    widget->setAccessibleName(name);
    widget->setToolTip(toolTip);
}

/// Pixels that stay a gutter for so many halvings more need twice as many.
constexpr int kLikelyGutter = 16;

} // namespace

UvPage::UvPage(QWidget* parent)
    : ExportPage(parent)
    , m_size(new QComboBox)
    , m_gutter(new QSpinBox)
    , m_tiles(new QCheckBox(tr("One &image for each tile, <UDIM> in the name")))
    , m_levels(new QCheckBox(tr("With all hal&ves, as renderers want them")))
    , m_type(new QComboBox)
    , m_space(new QComboBox)
{
    for (int side = kSmallestSize; side <= kLargestSize; side *= 2) {
        m_size->addItem(tr("%L1 × %L1 pixels").arg(side), side);
    }
    m_size->setCurrentIndex(m_size->findData(UvExportOptions().width));
    explain(m_size, tr("Image size"), tr("Of each image; faces too small for a pixel are told"));
    m_gutter->setRange(0, UvExportOptions::kMostGutter);
    m_gutter->setValue(kLikelyGutter);
    m_gutter->setSuffix(tr(" pixels"));
    explain(m_gutter,
            tr("Gutter"),
            tr("Beyond each chart: what lies there on the surface, so that no seam shows; 16 last "
               "for four halvings"));
    explain(m_tiles,
            tr("One image for each tile"),
            tr("For uvs beyond the unit square: the tile's number, 1001 and on, stands in the "
               "place of <UDIM>"));
    explain(m_levels,
            tr("With all halves"),
            tr("Tiled, each half of the image in the file; a third more pixels. Not in PNG"));
    m_type->addItem(tr("As the file holds the texels best"), kByItself);
    for (const TexelType type :
         {TexelType::UInt8, TexelType::UInt16, TexelType::Half, TexelType::Float}) {
        m_type->addItem(QString::fromUtf8(trixel::nameOf(type).data()), int(type));
    }
    explain(
        m_type, tr("Type of a pixel"), tr("PNG holds uint8 and uint16, OpenEXR half and float"));
    m_space->addItem(tr("As the project says; else sRGB of integers"), kByItself);
    m_space->addItem(tr("sRGB: colours"), int(ColorSpace::SRgb));
    m_space->addItem(tr("Linear: light"), int(ColorSpace::Linear));
    m_space->addItem(tr("Raw: data"), int(ColorSpace::Raw));
    explain(m_space, tr("Meaning"), tr("What the image's numbers are to mean; written into it"));

    auto* form = new QFormLayout(this);
    form->setContentsMargins(0, 0, 0, 0);
    form->addRow(tr("&Size"), m_size);
    form->addRow(tr("&Gutter"), m_gutter);
    form->addRow(QString(), m_tiles);
    form->addRow(QString(), m_levels);
    form->addRow(tr("&Type"), m_type);
    form->addRow(tr("&Meaning"), m_space);
    for (QComboBox* choice : {m_size, m_type, m_space}) {
        connect(choice, &QComboBox::currentIndexChanged, this, &ExportPage::changed);
    }
    connect(m_gutter, &QSpinBox::valueChanged, this, &ExportPage::changed);
    for (QCheckBox* box : {m_tiles, m_levels}) {
        connect(box, &QCheckBox::toggled, this, &ExportPage::changed);
    }
}

void UvPage::setEnding(const QString& ending)
{
    m_levels->setEnabled(ending != ".png");
}

ExportOptions UvPage::options(const QString& ending) const
{
    UvExportOptions options;
    options.width = m_size->currentData().toInt();
    options.height = options.width;
    options.gutter = m_gutter->value();
    options.levels = m_levels->isChecked() && ending != ".png";
    if (const int type = m_type->currentData().toInt(); type != kByItself) {
        options.type = static_cast<TexelType>(type);
    }
    if (const int space = m_space->currentData().toInt(); space != kByItself) {
        options.space = static_cast<ColorSpace>(space);
    }
    return options;
}

void UvPage::setOptions(const ExportOptions& options)
{
    if (const auto* uv = std::get_if<UvExportOptions>(&options)) {
        m_size->setCurrentIndex(std::max(0, m_size->findData(uv->width)));
        m_gutter->setValue(uv->gutter);
        m_levels->setChecked(uv->levels);
        m_type->setCurrentIndex(m_type->findData(uv->type ? int(*uv->type) : kByItself));
        m_space->setCurrentIndex(m_space->findData(uv->space ? int(*uv->space) : kByItself));
    }
}

/// "a.<UDIM>.png" or "a.png", as the box says.
QString UvPage::named(const QString& path) const
{
    if (path.isEmpty() || path.contains(kPlace) == m_tiles->isChecked()) {
        return path;
    }
    if (!m_tiles->isChecked()) {
        QString plain = path;
        return plain.remove("." + kPlace).remove(kPlace);
    }
    const QString ending = QFileInfo(path).suffix();
    return ending.isEmpty() ? path + "." + kPlace
                            : path.chopped(ending.size()) + kPlace + "." + ending;
}

void UvPage::followName(const QString& path)
{
    m_tiles->setChecked(path.contains(kPlace));
}

} // namespace trixel::ui
