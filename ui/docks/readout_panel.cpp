// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/readout_panel.h"

#include <QApplication>
#include <QClipboard>
#include <QFontDatabase>
#include <QFormLayout>
#include <QLabel>
#include <QMenu>
#include <QScrollArea>
#include <QSettings>
#include <QToolButton>
#include <QVBoxLayout>

#include "core/texture/texel_address.h"
#include "ui/docks/readout_text.h"
#include "ui/docks/steady_label.h"
#include "ui/docks/swatches.h"
#include "ui/document/document.h"
#include "ui/document/inspection.h"
#include "ui/viewport/method_title.h"
#include "ui/viewport/surface_lines.h"

#include <array>
#include <utility>

namespace trixel::ui {

namespace {

constexpr auto kHexKey = "readout/bytes";

// Rows that hold what only the view knows; the others are named by `linesOf`.
constexpr auto kFirstVector = "W1";
constexpr auto kSecondVector = "W2";
constexpr auto kEllipse = "Ellipse";
constexpr auto kWidth = "Width";
constexpr auto kFiltered = "Filtered";
constexpr auto kExact = "Exact";
constexpr auto kError = "Error";
constexpr auto kReadAt = "Read at";
constexpr std::array kFootprintRows{kFirstVector, kSecondVector, kEllipse, kWidth};
constexpr std::array kFilterRows{kFiltered, kExact, kError, kReadAt};

QString nothing()
{
    return QStringLiteral("–");
}

QString filteredTip()
{
    return ReadoutPanel::tr("The pixel's value by the chosen filter method.");
}

QString lineOf(const QString& name, const QString& value)
{
    return name + ": " + value + "\n";
}

QString edgeName(std::size_t edge)
{
    return QString("Edge %1").arg(edge);
}

} // namespace

ReadoutPanel::ReadoutPanel(const Document& document, Inspection& inspection, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_inspection(inspection)
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(6);
    layout->addLayout(makeHeader());
    auto* rows = new QWidget;
    auto* form = new QFormLayout(rows);
    form->setContentsMargins(0, 0, 0, 0);
    form->setHorizontalSpacing(10);
    form->setVerticalSpacing(2);
    form->setLabelAlignment(Qt::AlignLeft);
    addTexelRows(*form);
    addPixelRows(*form);
    auto* scroll = new QScrollArea; // in low windows alone
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setWidget(rows);
    layout->addWidget(scroll, 1);
    m_soon.setSingleShot(true);
    connect(&m_soon, &QTimer::timeout, this, &ReadoutPanel::refresh);
    connect(&inspection, &Inspection::heldChanged, this, &ReadoutPanel::showHeld);
    clear();
}

QLayout* ReadoutPanel::makeHeader()
{
    auto* row = new QHBoxLayout;
    m_address = new QLabel;
    m_address->setAccessibleName(tr("Address"));
    m_address->setToolTip(tr("Address of the texel: face, then (i, j) and the half of the cell"));
    m_address->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_address->setMargin(2);
    m_hold = new QToolButton;
    m_hold->setCheckable(true);
    m_hold->setToolTip(tr("Hold the texel, so that the pointer can go elsewhere; arrow keys in the "
                          "view step from it"));
    m_copy = new QToolButton;
    m_copy->setText(tr("Copy"));
    m_copy->setAccessibleName(tr("Copy the texel"));
    m_copy->setToolTip(tr("Copy the texel as text, hex bytes or JSON"));
    m_copy->setPopupMode(QToolButton::InstantPopup);
    m_copy->setEnabled(false);
    row->addWidget(new SteadyLabel(m_address, {}), 1);
    row->addWidget(m_hold);
    row->addWidget(m_copy);
    connect(m_hold, &QToolButton::clicked, this, [this](bool wanted) {
        wanted ? m_inspection.hold() : m_inspection.letGo();
        showHeld();
    });
    return row;
}

void ReadoutPanel::addTexelRows(QFormLayout& form)
{
    m_hex = new QToolButton;
    m_hex->setText(tr("hex"));
    m_hex->setCheckable(true);
    m_hex->setAutoRaise(true);
    m_hex->setMaximumHeight(fontMetrics().height()); // as high as a row
    m_hex->setAccessibleName(tr("Show bytes"));
    m_hex->setToolTip(tr("Show the bytes that are stored, in hex and in the file's order"));
    m_hex->setChecked(QSettings().value(kHexKey).toBool());
    connect(m_hex, &QToolButton::toggled, this, [this](bool on) {
        QSettings().setValue(kHexKey, on);
        refresh();
    });
    m_chip = new SwatchButton({40, 14});
    m_chip->setPurpose(tr("Colour of the texel; click to copy its code"));
    connect(m_chip, &SwatchButton::clicked, this, [this] {
        QApplication::clipboard()->setText(m_chip->color().name());
    });

    addRow(form,
           "Face",
           tr("Number of the triangle in the mesh file, and of the polygon it was cut from"));
    addRow(form, "Level", tr("The face's level n as shown: 2ⁿ texels along an edge, 4ⁿ in all"));
    addRow(form, "Texel", tr("Lattice position (i, j) and which of the cell's two triangles"));
    addRow(form, "Stored at", tr("Column and row in the packed square, and the index in it"));
    addRow(form, "u v w", tr("The point looked at, in its face"));
    addRow(form, "Position", tr("The point looked at, in world units"));
    addRow(form, "Stored", tr("Every channel as it is stored"), m_hex);
    addRow(form,
           "Shown",
           tr("Every channel as the view shows it, after exposure and range: 0 is black, 1 white"));
    addRow(form, "Colour", tr("The texel's colour on the screen"), m_chip);
    const std::array names{tr("v = 0"), tr("w = 0"), tr("u = 0")};
    for (std::size_t edge = 0; edge < names.size(); ++edge) {
        QLabel& value = addRow(form,
                               edgeName(edge),
                               tr("Neighbours across the texel's edge %1, which runs as %2 of the "
                                  "face does; click one to hold it")
                                   .arg(edge)
                                   .arg(names[edge]));
        value.setTextFormat(Qt::RichText);
        value.setTextInteractionFlags(Qt::TextBrowserInteraction);
        connect(&value, &QLabel::linkActivated, this, [this](const QString& address) {
            // An address that was shown may be of no texel any more; then nothing is gone to.
            (void)m_inspection.goTo(address.toStdString());
        });
    }
}

void ReadoutPanel::addPixelRows(QFormLayout& form)
{
    addRow(form,
           kFirstVector,
           tr("Footprint: step in (u, v) from this pixel to the next one to the right"));
    addRow(
        form, kSecondVector, tr("Footprint: step in (u, v) from this pixel to the next one down"));
    addRow(form,
           kEllipse,
           tr("Half axes of the footprint's ellipse in world units, and their ratio; "
              "the view draws it %1 times larger")
               .arg(kFootprintMagnification));
    addRow(form,
           kWidth,
           tr("Texels of the face's own level that the ellipse is wide, and the level whose texels "
              "are as wide"));
    addRow(form, kFiltered, filteredTip());
    addRow(form,
           kExact,
           tr("The pixel's exact value: the Gaussian over every texel, in double precision"));
    addRow(form,
           kError,
           tr("Largest difference of a channel between the two, in % of the value range"));
    addRow(
        form, kReadAt, tr("Level that the method read, and how many texels or vertices it read"));
}

QLabel& ReadoutPanel::addRow(QFormLayout& form,
                             const QString& name,
                             const QString& toolTip,
                             QWidget* beside)
{
    auto* label = new QLabel(name);
    label->setToolTip(toolTip);
    auto* value = new QLabel;
    value->setToolTip(toolTip);
    value->setAccessibleName(name);
    value->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    value->setTextInteractionFlags(Qt::TextSelectableByMouse); // while a pointer is on it
    auto* room = new SteadyLabel(value, {});
    if (beside != nullptr) {
        auto* row = new QHBoxLayout;
        row->addWidget(room, 1);
        row->addWidget(beside);
        form.addRow(label, row);
    } else {
        form.addRow(label, room);
    }
    m_rows[name] = {label, value};
    return *value;
}

void ReadoutPanel::set(const QString& name, const QString& value)
{
    if (const auto row = m_rows.constFind(name); row != m_rows.cend()) {
        row->value->setText(value);
    }
}

void ReadoutPanel::clear()
{
    m_texel.reset();
    for (const Row& row : std::as_const(m_rows)) {
        row.value->setText(nothing());
    }
    m_address->setText(tr("Point at a face in the view"));
    m_chip->setColor(Qt::transparent);
    m_chip->setEnabled(false);
    m_copy->setEnabled(false);
    showHeld();
}

void ReadoutPanel::show(const std::optional<HoveredTexel>& texel)
{
    if (!texel || !m_document.isOpen()) {
        return;
    }
    m_texel = texel;
    if (isVisible() && !m_soon.isActive()) {
        m_soon.start();
    }
}

void ReadoutPanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    refresh();
}

void ReadoutPanel::refresh()
{
    if (!m_texel) {
        return;
    }
    const TexelReport& report = m_texel->report;
    const bool isRead = !report.stored.empty();
    for (const char* name : {"Stored", "Shown", "Colour"}) {
        set(name, isRead ? nothing() : tr("reading…"));
    }
    for (const ReportLine& line : linesOf(report)) {
        set(QString::fromStdString(line.name), QString::fromStdString(line.value));
    }
    m_address->setText(QString::fromStdString(toText(report.place)));
    set("Position", positionText(m_texel->point.position, m_document.surface()->size()));
    if (isRead && m_hex->isChecked()) {
        set("Stored", QString::fromStdString(toHex(report)));
    }
    if (report.display) {
        const auto& color = report.display->color;
        m_chip->setColor(QColor(color[0], color[1], color[2], color[3]));
    } else if (!isRead) {
        m_chip->setColor(Qt::transparent);
    }
    m_chip->setEnabled(isRead);
    m_copy->setEnabled(isRead);
    showNeighbours();
    const auto values = footprintValues();
    for (std::size_t row = 0; row < kFootprintRows.size(); ++row) {
        set(kFootprintRows[row], values[row]);
    }
    showHeld();
}

void ReadoutPanel::showNeighbours()
{
    for (std::size_t edge = 0; edge < m_texel->report.neighbours.size(); ++edge) {
        set(edgeName(edge), neighbourLinks(m_texel->report.neighbours[edge]));
    }
}

/// One a row of `kFootprintRows`.
std::array<QString, 4> ReadoutPanel::footprintValues() const
{
    if (!m_texel->hasFootprint) {
        return {nothing(), nothing(), nothing(), nothing()};
    }
    const FaceId face = m_texel->point.face;
    return {vectorText(m_texel->footprint.w1),
            vectorText(m_texel->footprint.w2),
            ellipseText(m_texel->ellipse),
            widthText(describe(m_texel->footprint,
                               m_document.surface()->mesh().corners(face),
                               m_document.texels().face(face).level()))};
}

void ReadoutPanel::showHeld()
{
    const bool held = m_inspection.isHeld();
    m_hold->setChecked(held);
    m_hold->setText(held ? tr("Held") : tr("Hold"));
    m_hold->setAccessibleName(held ? tr("Let the texel go") : tr("Hold the texel"));
    m_hold->setEnabled(held || m_inspection.texel().has_value());
    QFont font = m_address->font();
    font.setBold(m_texel.has_value());
    m_address->setFont(font);
    m_address->setAutoFillBackground(held);
    m_address->setBackgroundRole(held ? QPalette::Highlight : QPalette::NoRole);
    m_address->setForegroundRole(held ? QPalette::HighlightedText : QPalette::NoRole);
}

void ReadoutPanel::showFiltered(const FilteredTexel& texel)
{
    const TexelType type = m_document.texels().format().type;
    const bool refused = texel.taps == kRefusedTaps;
    const bool exactRefused = texel.exactTaps == kRefusedTaps;
    m_rows[kFiltered].value->setToolTip(tr("%1 %2").arg(filteredTip(), methodTitle(texel.method)));
    set(kFiltered, refused ? tr("refused") : filteredText(type, texel.values));
    set(kReadAt, readAtText(texel));
    if (texel.exact.empty()) {
        set(kExact, "…");
        set(kError, "…");
        return;
    }
    set(kExact, exactRefused ? tr("refused") : filteredText(type, texel.exact));
    set(kError,
        refused || exactRefused ? nothing()
                                : QString("%1 %").arg(100 * texel.difference, 0, 'g', 3));
}

void ReadoutPanel::showUnfiltered(const QString& reason)
{
    for (const char* row : kFilterRows) {
        set(row, nothing());
    }
    if (!reason.isEmpty()) {
        set(kFiltered, tr("not prepared"));
        m_rows[kFiltered].value->setToolTip(reason);
    }
}

QString ReadoutPanel::text() const
{
    if (!m_texel) {
        return {};
    }
    QString lines = QString::fromStdString(toText(m_texel->report));
    const auto values = footprintValues();
    for (std::size_t row = 0; row < kFootprintRows.size(); ++row) {
        lines += lineOf(kFootprintRows[row], values[row]);
    }
    for (const char* row : kFilterRows) {
        lines += lineOf(row, m_rows[row].value->text());
    }
    return lines;
}

void ReadoutPanel::setCopyActions(const QList<QAction*>& actions)
{
    auto* menu = new QMenu(m_copy);
    menu->addActions(actions);
    m_copy->setMenu(menu);
}

} // namespace trixel::ui
