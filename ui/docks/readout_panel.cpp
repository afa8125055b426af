// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/readout_panel.h"

#include <QApplication>
#include <QClipboard>
#include <QFontDatabase>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/docks/method_box.h"
#include "ui/docks/readout_text.h"
#include "ui/docks/swatches.h"
#include "ui/document/document.h"
#include "ui/viewport/surface_lines.h"

namespace trixel::ui {

namespace {

QString filteredTip()
{
    return ReadoutPanel::tr("The pixel's value by the chosen filter method.");
}

} // namespace

ReadoutPanel::ReadoutPanel(const Document& document, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(8);
    auto* form = new QFormLayout;
    form->setHorizontalSpacing(10);
    form->setVerticalSpacing(3);
    form->setLabelAlignment(Qt::AlignLeft);
    layout->addLayout(form);

    addRow(*form,
           Face,
           tr("Face"),
           tr("Number of the triangle in the mesh file, and of the polygon it was cut from"));
    addRow(*form,
           Resolution,
           tr("Level"),
           tr("The face's level n as shown: 2ⁿ texels along an edge, 4ⁿ in all"));
    addRow(*form,
           Texel,
           tr("Texel"),
           tr("Lattice position (i, j) and which of the cell's two triangles"));
    addRow(*form,
           Storage,
           tr("Stored at"),
           tr("Column and row in the packed square, and the index in it"));
    addRow(*form, Barycentric, tr("u  v  w"), tr("Where the pointer is on the face"));
    addRow(*form, Position, tr("Position"), tr("Where the pointer is, in world units"));
    addRow(*form, Stored, tr("Values"), tr("Every channel as it is stored"));
    addRow(*form, Shown, tr("Colour"), tr("The values as a colour of the screen"));
    addRow(*form,
           FirstVector,
           tr("W1"),
           tr("Footprint: step in (u, v) from this pixel to the next one to the right"));
    addRow(*form,
           SecondVector,
           tr("W2"),
           tr("Footprint: step in (u, v) from this pixel to the next one down"));
    addRow(*form,
           Ellipse,
           tr("Ellipse"),
           tr("Half axes of the footprint's ellipse in world units, and their ratio; "
              "the view draws it %1 times larger")
               .arg(kFootprintMagnification));
    addRow(*form,
           Width,
           tr("Width"),
           tr("Texels of the face's own level that the ellipse is wide, and the level whose texels "
              "are as wide"));
    addRow(*form, Filtered, tr("Filtered"), filteredTip());
    addRow(*form,
           Exact,
           tr("Exact"),
           tr("The pixel's exact value: the Gaussian over every texel, in double precision"));
    addRow(*form,
           Error,
           tr("Error"),
           tr("Largest difference of a channel between the two, in % of the value range"));
    addRow(*form,
           ReadAt,
           tr("Read at"),
           tr("Level that the method read, and how many texels or vertices it read"));

    auto* row = new QHBoxLayout;
    m_chip = new SwatchButton({48, 18});
    m_chip->setPurpose(tr("Colour of the texel; click to copy its code"));
    m_chip->setEnabled(false);
    auto* copy = new QPushButton(tr("&Copy all"));
    copy->setAccessibleName(tr("Copy the readout"));
    copy->setToolTip(tr("Copy every line of the readout to the clipboard"));
    row->addWidget(m_chip);
    row->addStretch(1);
    row->addWidget(copy);
    layout->addLayout(row);
    layout->addStretch(1);
    connect(
        copy, &QPushButton::clicked, this, [this] { QApplication::clipboard()->setText(text()); });
    connect(m_chip, &SwatchButton::clicked, this, [this] {
        QApplication::clipboard()->setText(m_chip->color().name());
    });
    clear();
}

void ReadoutPanel::addRow(QFormLayout& form, Row row, const QString& name, const QString& toolTip)
{
    auto* label = new QLabel(name);
    label->setToolTip(toolTip);
    auto* value = new QLabel;
    value->setToolTip(toolTip);
    value->setAccessibleName(name);
    value->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    value->setTextInteractionFlags(Qt::TextSelectableByMouse);
    // The longest values must not widen the dock.
    value->setMinimumWidth(1);
    value->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    form.addRow(label, value);
    m_names[row] = label;
    m_values[row] = value;
}

void ReadoutPanel::clear()
{
    for (QLabel* value : m_values) {
        value->setText("–");
    }
    m_chip->setColor(Qt::transparent);
    m_chip->setEnabled(false);
}

void ReadoutPanel::show(const std::optional<HoveredTexel>& texel)
{
    if (!texel || !m_document.isOpen()) {
        return;
    }
    const std::uint32_t face = static_cast<std::uint32_t>(texel->point.face);
    const std::uint32_t source = m_document.surface()->mesh().sourceFace(texel->point.face);
    const std::uint32_t resolution = texel->level.resolution();
    const QColor color = shownColor(texel->values);

    m_values[Face]->setText(source == face ? QString::number(face)
                                           : tr("%1 · polygon %2").arg(face).arg(source));
    m_values[Resolution]->setText(tr("%1 · %2 × %2").arg(texel->level.log2()).arg(resolution));
    m_values[Texel]->setText(texelText(texel->texel));
    m_values[Storage]->setText(storageText(*texel));
    m_values[Barycentric]->setText(barycentricText(texel->point.uv));
    m_values[Position]->setText(positionText(texel->point.position, m_document.surface()->size()));
    m_values[Stored]->setText(storedText(m_document.texels().format().type, texel->values));
    m_values[Shown]->setText(shownText(color));
    m_values[FirstVector]->setText(vectorText(texel->footprint.w1));
    m_values[SecondVector]->setText(vectorText(texel->footprint.w2));
    m_values[Ellipse]->setText(ellipseText(texel->ellipse));
    m_values[Width]->setText(
        widthText(describe(texel->footprint,
                           m_document.surface()->mesh().corners(texel->point.face),
                           m_document.texels().face(texel->point.face).level())));
    m_chip->setColor(color);
    m_chip->setEnabled(true);
}

void ReadoutPanel::showFiltered(const FilteredTexel& texel)
{
    const TexelType type = m_document.texels().format().type;
    const bool refused = texel.taps == kRefusedTaps;
    const bool exactRefused = texel.exactTaps == kRefusedTaps;
    m_values[Filtered]->setToolTip(tr("%1 %2").arg(filteredTip(), methodTitle(texel.method)));
    m_values[Filtered]->setText(refused ? tr("refused") : filteredText(type, texel.values));
    m_values[ReadAt]->setText(readAtText(texel));
    if (texel.exact.empty()) {
        m_values[Exact]->setText("…");
        m_values[Error]->setText("…");
        return;
    }
    m_values[Exact]->setText(exactRefused ? tr("refused") : filteredText(type, texel.exact));
    m_values[Error]->setText(refused || exactRefused
                                 ? QString("–")
                                 : QString("%1 %").arg(100 * texel.difference, 0, 'g', 3));
}

void ReadoutPanel::showUnfiltered(const QString& reason)
{
    for (const Row row : {Filtered, Exact, Error, ReadAt}) {
        m_values[row]->setText("–");
    }
    if (!reason.isEmpty()) {
        m_values[Filtered]->setText(tr("not prepared"));
        m_values[Filtered]->setToolTip(reason);
    }
}

QString ReadoutPanel::text() const
{
    QString lines;
    for (std::size_t row = 0; row < RowCount; ++row) {
        lines += m_names[row]->text() + ": " + m_values[row]->text() + "\n";
    }
    return lines;
}

} // namespace trixel::ui
