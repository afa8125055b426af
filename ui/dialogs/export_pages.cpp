// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/export_pages.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QSpinBox>

#include "ui/dialogs/format_choice.h"

namespace trixel::ui {

namespace {

constexpr int kSmallestPage = 256;
constexpr int kLargestPage = 16384;
constexpr int kMostSamples = 8;
constexpr int kMostPadding = 32;

void explain(QWidget* widget, const QString& name, const QString& toolTip)
{
    widget->setAccessibleName(name);
    widget->setToolTip(toolTip);
}

QFormLayout* formOf(QWidget* page)
{
    auto* form = new QFormLayout(page);
    form->setContentsMargins(0, 0, 0, 0);
    return form;
}

QComboBox* makePageChoice(std::uint32_t standard)
{
    auto* choice = new QComboBox;
    for (int side = kSmallestPage; side <= kLargestPage; side *= 2) {
        choice->addItem(ExportPage::tr("%L1 pixels").arg(side), side);
    }
    choice->setCurrentIndex(choice->findData(static_cast<int>(standard)));
    explain(choice,
            ExportPage::tr("Largest page"),
            ExportPage::tr("Longest side of an image; what does not fit goes on further ones"));
    return choice;
}

void choosePage(QComboBox* choice, std::uint32_t side)
{
    if (const int index = choice->findData(static_cast<int>(side)); index >= 0) {
        choice->setCurrentIndex(index);
    }
}

} // namespace

PtxPage::PtxPage(TexelType type, QWidget* parent)
    : ExportPage(parent)
    , m_type(new TypeChoice)
    , m_mips(new QCheckBox(tr("Store &reduced levels (mips)")))
{
    QFormLayout* form = formOf(this);
    form->addRow(tr("&Type"), m_type);
    form->addRow(QString(), m_mips);
    m_type->setType(type);
    m_mips->setChecked(true);
    explain(m_mips,
            tr("Store reduced levels"),
            tr("Renderers read reduced levels for far views; a third more texels"));
    connect(m_type, &QComboBox::currentIndexChanged, this, &ExportPage::changed);
    connect(m_mips, &QCheckBox::toggled, this, &ExportPage::changed);
}

ExportOptions PtxPage::options(const QString& /*ending*/) const
{
    return PtxExportOptions{m_type->type(), m_mips->isChecked()};
}

void PtxPage::setOptions(const ExportOptions& options)
{
    if (const auto* ptx = std::get_if<PtxExportOptions>(&options)) {
        if (ptx->type) {
            m_type->setType(*ptx->type);
        }
        m_mips->setChecked(ptx->mips);
    }
}

PackedPage::PackedPage(QWidget* parent)
    : ExportPage(parent)
    , m_packing(new QComboBox)
    , m_border(new QCheckBox(tr("&Borders of the true neighbours, to interpolate in")))
    , m_mips(new QCheckBox(tr("Coarser &levels of every face too (mips)")))
    , m_page(makePageChoice(AtlasOptions().largestPage))
{
    QFormLayout* form = formOf(this);
    m_packing->addItem(tr("Shelves: small faces fill the gaps of large ones"));
    m_packing->addItem(tr("Bands: one a level"));
    explain(m_packing,
            tr("Packing"),
            tr("How faces of different levels share a page; the estimate tells both"));
    explain(m_border,
            tr("Borders"),
            tr("One texel about each half of a face; without it shaders fetch single texels"));
    explain(m_mips, tr("Coarser levels"), tr("Made face by face; a third more pixels"));
    m_border->setChecked(true);
    form->addRow(tr("&Packing"), m_packing);
    form->addRow(QString(), m_border);
    form->addRow(QString(), m_mips);
    form->addRow(tr("Lar&gest page"), m_page);
    for (QComboBox* choice : {m_packing, m_page}) {
        connect(choice, &QComboBox::currentIndexChanged, this, &ExportPage::changed);
    }
    for (QCheckBox* box : {m_border, m_mips}) {
        connect(box, &QCheckBox::toggled, this, &ExportPage::changed);
    }
}

ExportOptions PackedPage::options(const QString& /*ending*/) const
{
    PackedExportOptions options;
    options.layout.packing =
        m_packing->currentIndex() == 0 ? AtlasPacking::Shelves : AtlasPacking::Bands;
    options.layout.border = m_border->isChecked() ? AtlasBorder::Bilinear : AtlasBorder::None;
    options.layout.mips = m_mips->isChecked();
    options.layout.largestPage = m_page->currentData().toUInt();
    return options;
}

void PackedPage::setOptions(const ExportOptions& options)
{
    if (const auto* packed = std::get_if<PackedExportOptions>(&options)) {
        m_packing->setCurrentIndex(packed->layout.packing == AtlasPacking::Shelves ? 0 : 1);
        m_border->setChecked(packed->layout.border != AtlasBorder::None);
        m_mips->setChecked(packed->layout.mips);
        choosePage(m_page, packed->layout.largestPage);
    }
}

MeshPage::MeshPage(QWidget* parent)
    : ExportPage(parent)
    , m_samples(new QSpinBox)
    , m_padding(new QSpinBox)
    , m_page(makePageChoice(HandOffOptions().largestPage))
    , m_powerOfTwo(new QCheckBox(tr("Sides are po&wers of two")))
    , m_image(new QComboBox)
{
    const HandOffOptions standard;
    QFormLayout* form = formOf(this);
    m_samples->setRange(1, kMostSamples);
    m_samples->setValue(static_cast<int>(standard.samplesPerTexel));
    m_samples->setSuffix(tr(" per texel"));
    explain(m_samples,
            tr("Samples along an edge"),
            tr("Faces are sampled anew, because plain uvs cannot address triangle texels: "
               "2 keep natural pictures within 40 dB, more keep hard edges too"));
    m_padding->setRange(1, kMostPadding);
    m_padding->setValue(static_cast<int>(standard.padding));
    m_padding->setSuffix(tr(" pixels"));
    explain(m_padding,
            tr("Padding"),
            tr("Of the true neighbours about every face, so that reduced levels do not bleed"));
    explain(m_powerOfTwo,
            tr("Sides are powers of two"),
            tr("Some game engines compress and reduce only such images"));
    m_image->addItem(tr("PNG: integers"), "png");
    m_image->addItem(tr("TIFF: any type"), "tif");
    m_image->addItem(tr("OpenEXR: half and float"), "exr");
    explain(m_image,
            tr("Texture format"),
            tr("Of the images beside .obj and .ply; a .glb has PNG inside"));
    form->addRow(tr("&Samples"), m_samples);
    form->addRow(tr("P&adding"), m_padding);
    form->addRow(tr("Lar&gest page"), m_page);
    form->addRow(QString(), m_powerOfTwo);
    form->addRow(tr("Te&xtures"), m_image);
    for (QSpinBox* box : {m_samples, m_padding}) {
        connect(box, &QSpinBox::valueChanged, this, &ExportPage::changed);
    }
    for (QComboBox* choice : {m_page, m_image}) {
        connect(choice, &QComboBox::currentIndexChanged, this, &ExportPage::changed);
    }
    connect(m_powerOfTwo, &QCheckBox::toggled, this, &ExportPage::changed);
}

void MeshPage::setEnding(const QString& ending)
{
    m_image->setEnabled(ending != ".glb"); // has PNG inside
}

ExportOptions MeshPage::options(const QString& ending) const
{
    HandOffExportOptions options;
    options.layout.samplesPerTexel = static_cast<std::uint32_t>(m_samples->value());
    options.layout.padding = static_cast<std::uint32_t>(m_padding->value());
    options.layout.largestPage = m_page->currentData().toUInt();
    options.layout.powerOfTwo = m_powerOfTwo->isChecked();
    options.imageEnding =
        ending == ".glb" ? "png" : m_image->currentData().toString().toStdString();
    return options;
}

void MeshPage::setOptions(const ExportOptions& options)
{
    if (const auto* mesh = std::get_if<HandOffExportOptions>(&options)) {
        m_samples->setValue(static_cast<int>(mesh->layout.samplesPerTexel));
        m_padding->setValue(static_cast<int>(mesh->layout.padding));
        choosePage(m_page, mesh->layout.largestPage);
        m_powerOfTwo->setChecked(mesh->layout.powerOfTwo);
        m_image->setCurrentIndex(
            std::max(0, m_image->findData(QString::fromStdString(mesh->imageEnding))));
    }
}

} // namespace trixel::ui
