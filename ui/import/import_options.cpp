// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/import/import_options.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>

#include "ui/dialogs/format_choice.h"
#include "ui/docks/value_row.h"

#include <algorithm>

namespace trixel::ui {

ImportOptions::ImportOptions(const FaceSelection& selection, QFormLayout& form, QObject* parent)
    : QObject(parent)
    , m_selection(selection)
    , m_faces(new QComboBox)
    , m_frontOnly(new QCheckBox(tr("Only faces that turn &to it")))
    , m_visibleOnly(new QCheckBox(tr("Only what nothing &hides")))
    , m_repeats(new QCheckBox(tr("Repeat be&yond its borders")))
    , m_lookup(new QComboBox)
    , m_index(new QComboBox)
    , m_opacity(new ValueRow(Scale::Linear,
                             0,
                             100,
                             {tr("Opacity of the image"),
                              tr("How much of the paint below the image covers, in percent"),
                              tr(" %")}))
{
    m_opacity->setValue(100);
    m_faces->setAccessibleName(tr("Faces that the image is laid onto"));
    m_faces->setToolTip(
        tr("All faces that the image reaches, or of these the selected ones alone"));
    m_faces->addItems({QString(), QString()});
    makeReach(form);
    form.addRow(tr("&Faces"), m_faces);
    makeLookup(form);
    auto* opacity = new QLabel(tr("Opa&city"));
    opacity->setBuddy(m_opacity->buddy());
    form.addRow(opacity, m_opacity);
    connect(m_opacity, &ValueRow::edited, this, &ImportOptions::changed);
    connect(m_faces, &QComboBox::currentIndexChanged, this, &ImportOptions::changed);
    connect(&selection, &FaceSelection::changed, this, &ImportOptions::takeSelection);
    takeSelection();
}

void ImportOptions::makeReach(QFormLayout& form)
{
    m_frontOnly->setChecked(true);
    m_frontOnly->setAccessibleName(tr("Only faces that turn to the image"));
    m_frontOnly->setToolTip(
        tr("Leave out the back of the surface; off, the image goes right through "
           "it"));
    m_visibleOnly->setChecked(true);
    m_visibleOnly->setAccessibleName(tr("Only what nothing hides"));
    m_visibleOnly->setToolTip(tr("Leave out what other faces stand in front of, texel for texel"));
    m_repeats->setAccessibleName(tr("Repeat the image beyond its borders"));
    m_repeats->setToolTip(tr("Where the mesh's uvs leave the image it begins again; off, they must "
                             "not leave it"));
    for (QCheckBox* box : {m_frontOnly, m_visibleOnly, m_repeats}) {
        form.addRow(box);
        connect(box, &QCheckBox::toggled, this, &ImportOptions::changed);
    }
}

void ImportOptions::makeLookup(QFormLayout& form)
{
    const auto add = [this](const QString& text, ImageLookup lookup, const QString& toolTip) {
        m_lookup->addItem(text, static_cast<int>(lookup));
        m_lookup->setItemData(m_lookup->count() - 1, toolTip, Qt::ToolTipRole);
    };
    add(tr("Footprint"),
        ImageLookup::Footprint,
        tr("The average over each texel's own area, however long and narrow it is in the image: "
           "the best and the slowest"));
    add(tr("Mip-mapped"),
        ImageLookup::Mip,
        tr("Between two halvings of the image: never noisy, soft where texels are long and "
           "narrow"));
    add(tr("Bilinear"),
        ImageLookup::Bilinear,
        tr("Between four pixels: sharp, noisy where texels are larger than pixels"));
    add(tr("Nearest"),
        ImageLookup::Nearest,
        tr("One pixel, unchanged: for masks, numbers and pixel art"));
    m_lookup->setAccessibleName(tr("How the image is looked up"));
    m_lookup->setToolTip(tr("Which of the image's pixels make a texel"));
    m_index->addItem(tr("At pixel borders (texel centres)"), static_cast<int>(TableIndex::Centres));
    m_index->addItem(tr("At pixel centres (corner-aligned)"),
                     static_cast<int>(TableIndex::Corners));
    m_index->setAccessibleName(tr("Where the image ends"));
    m_index->setToolTip(tr("At the borders of its outermost pixels, as graphics cards have it "
                           "(texel centres); or at their middles, as textbooks have tables of "
                           "values (corner-aligned)"));
    form.addRow(tr("&Lookup"), m_lookup);
    form.addRow(tr("E&dges"), m_index);
    connect(m_lookup, &QComboBox::currentIndexChanged, this, &ImportOptions::changed);
    connect(m_index, &QComboBox::currentIndexChanged, this, &ImportOptions::changed);
}

void ImportOptions::fill(ImportSettings& settings) const
{
    settings.frontOnly = m_frontOnly->isChecked();
    settings.visibleOnly = m_visibleOnly->isChecked();
    settings.repeats = m_repeats->isChecked();
    settings.lookup = static_cast<ImageLookup>(m_lookup->currentData().toInt());
    settings.index = static_cast<TableIndex>(m_index->currentData().toInt());
    settings.opacity = m_opacity->value() / 100;
}

void ImportOptions::showFor(MapKind kind)
{
    const bool projects =
        kind == MapKind::Plane || kind == MapKind::Quad || kind == MapKind::Camera;
    m_frontOnly->setVisible(projects);
    m_visibleOnly->setVisible(projects);
    m_repeats->setVisible(kind == MapKind::Uvs);
}

bool ImportOptions::isSelectionOnly() const
{
    return m_faces->currentIndex() == 1;
}

std::vector<FaceId> ImportOptions::chosenFaces() const
{
    const auto faces = m_selection.faces();
    return isSelectionOnly() ? std::vector<FaceId>(faces.begin(), faces.end())
                             : std::vector<FaceId>();
}

void ImportOptions::takeSelection()
{
    m_faces->setItemText(0, tr("All"));
    m_faces->setItemText(
        1,
        tr("Selected: %1").arg(countText(static_cast<std::uint64_t>(m_selection.faces().size()))));
    if (isSelectionOnly()) {
        emit changed();
    }
}

} // namespace trixel::ui
