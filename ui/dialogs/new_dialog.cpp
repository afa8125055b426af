// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/new_dialog.h"

#include <QColorDialog>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "core/mesh/mesh_reader.h"
#include "ui/dialogs/format_choice.h"
#include "ui/dialogs/path_row.h"
#include "ui/docks/swatches.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace trixel::ui {

namespace {

constexpr int kWidth = 560;
constexpr int kTypingPauseMs = 350;
constexpr double kMillion = 1e6;
/// Texel counts offered, in millions; the core limits what it can address.
constexpr double kMostMillions = 16'000;

/// Of the box around all vertices.
glm::vec3 extentOf(const TriangleMesh& mesh)
{
    if (mesh.positions.empty()) {
        return glm::vec3(0);
    }
    glm::vec3 low = mesh.positions.front();
    glm::vec3 high = low;
    for (const glm::vec3& position : mesh.positions) {
        low = glm::min(low, position);
        high = glm::max(high, position);
    }
    return high - low;
}

} // namespace

NewDialog::NewDialog(const QString& meshPath, QWidget* parent)
    : QDialog(parent)
    , m_path(new PathRow(PathRow::Purpose::Open,
                         tr("Mesh file"),
                         tr("Meshes (*.obj *.ply *.stl *.off);;All files (*)")))
    , m_mesh(new QLabel)
    , m_by(new QComboBox)
    , m_sizes(new QStackedWidget)
    , m_total(new QDoubleSpinBox)
    , m_density(new QDoubleSpinBox)
    , m_level(new QSpinBox)
    , m_type(new TypeChoice)
    , m_channels(new ChannelChoice)
    , m_fill(new SwatchButton({64, 24}))
    , m_summary(new QLabel)
{
    setWindowTitle(tr("New from Mesh"));
    setMinimumWidth(kWidth);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(makeForm());
    layout->addStretch(1);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    m_create = buttons->addButton(tr("Cre&ate"), QDialogButtonBox::AcceptRole);
    m_create->setToolTip(tr("Start a new project with these texels"));
    m_create->setAccessibleName(tr("Create"));
    m_create->setDefault(true);
    buttons->button(QDialogButtonBox::Cancel)->setToolTip(tr("Start nothing"));
    buttons->button(QDialogButtonBox::Cancel)->setAutoDefault(false);
    layout->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &NewDialog::finish);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connectAll();
    showPlan(contentsError({}));
    m_path->setPath(meshPath);
    m_typing.stop();
    readMesh();
}

QFormLayout* NewDialog::makeForm()
{
    auto* form = new QFormLayout;
    form->setVerticalSpacing(8);
    form->addRow(tr("&Mesh"), m_path);
    form->addRow(QString(), m_mesh);
    form->addRow(tr("&Resolution"), makeSize());
    form->addRow(tr("&Type"), m_type);
    form->addRow(tr("&Channels"), m_channels);
    form->addRow(tr("&Fill colour"), m_fill);
    form->addRow(tr("Result"), m_summary);

    m_mesh->setWordWrap(true);
    m_mesh->setAccessibleName(tr("About the mesh"));
    m_mesh->setToolTip(tr("What was found in the mesh file"));
    m_summary->setWordWrap(true);
    m_summary->setAccessibleName(tr("Result"));
    m_summary->setToolTip(tr("Unpainted faces hold one value each: memory grows as you paint"));
    m_fill->setPurpose(tr("Fill colour"));
    m_fill->setColor(QColor::fromRgbF(0.8F, 0.8F, 0.8F));
    // Two lines each from the start, so that answers move nothing.
    const int twoLines = 2 * fontMetrics().lineSpacing();
    m_mesh->setMinimumHeight(twoLines);
    m_mesh->setAlignment(Qt::AlignTop);
    m_summary->setMinimumHeight(twoLines);
    m_summary->setAlignment(Qt::AlignTop);
    return form;
}

QWidget* NewDialog::makeSize()
{
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    m_by->addItem(tr("Texels in all"), static_cast<int>(SizeChoice::Total));
    m_by->addItem(tr("Texels per unit of length"), static_cast<int>(SizeChoice::Density));
    m_by->addItem(tr("Same level for every face"), static_cast<int>(SizeChoice::Level));
    m_by->setAccessibleName(tr("Resolution by"));
    m_by->setToolTip(tr("How the level of each face is chosen"));

    m_total->setRange(0.001, kMostMillions);
    m_total->setDecimals(3);
    m_total->setValue(4);
    m_total->setSuffix(tr(" million"));
    m_total->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    m_total->setAccessibleName(tr("Texels in all, in millions"));
    m_total->setToolTip(
        tr("Spread over the faces by their size in the world; never more than this"));
    m_density->setRange(1e-6, 1e9);
    m_density->setDecimals(6);
    m_density->setValue(100);
    m_density->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    m_density->setAccessibleName(tr("Texels per unit of length"));
    m_density->setToolTip(tr("Texels along one world unit; each face gets the nearest level"));
    m_level->setRange(0, Level::kMax);
    m_level->setValue(5);
    m_level->setAccessibleName(tr("Level of every face"));
    m_level->setToolTip(tr("Level n has 2ⁿ texels along an edge and 4ⁿ in all"));
    m_sizes->addWidget(m_total);
    m_sizes->addWidget(m_density);
    m_sizes->addWidget(m_level);
    m_sizes->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    layout->addWidget(m_by);
    layout->addWidget(m_sizes, 1);
    row->setFocusProxy(m_by);
    return row;
}

void NewDialog::connectAll()
{
    m_typing.setSingleShot(true);
    m_typing.setInterval(kTypingPauseMs);
    connect(&m_typing, &QTimer::timeout, this, &NewDialog::readMesh);
    connect(m_path, &PathRow::pathChanged, this, [this] { m_typing.start(); });
    connect(m_by, &QComboBox::currentIndexChanged, m_sizes, &QStackedWidget::setCurrentIndex);
    connect(m_by, &QComboBox::currentIndexChanged, this, &NewDialog::plan);
    connect(m_total, &QDoubleSpinBox::valueChanged, this, &NewDialog::plan);
    connect(m_density, &QDoubleSpinBox::valueChanged, this, &NewDialog::plan);
    connect(m_level, &QSpinBox::valueChanged, this, &NewDialog::plan);
    connect(m_type, &QComboBox::currentIndexChanged, this, &NewDialog::plan);
    connect(m_channels, &QComboBox::currentIndexChanged, this, &NewDialog::plan);
    connect(m_fill, &SwatchButton::clicked, this, &NewDialog::chooseFill);
}

void NewDialog::readMesh()
{
    const quint64 generation = ++m_meshGeneration;
    if (BackgroundJob* reading = m_jobs.latest()) {
        reading->cancel();
    }
    m_triangles.reset();
    showPlan(contentsError({}));
    const QString path = m_path->path();
    if (path.isEmpty()) {
        m_mesh->setText(tr("An OBJ, PLY, STL or OFF file. It needs no UVs."));
        return;
    }
    m_mesh->setText(tr("Reading…"));
    m_jobs.run(
        tr("Reading the mesh…"),
        [file = std::filesystem::path(path.toStdU16String())](Progress& progress) {
            return trixel::readMesh(file, progress);
        },
        [this, generation](Result<TriangleMesh> mesh) {
            if (generation == m_meshGeneration) {
                takeMesh(std::move(mesh));
            }
        });
}

void NewDialog::takeMesh(Result<TriangleMesh> mesh)
{
    if (!mesh) {
        m_mesh->setText(QString::fromStdString(mesh.error().message));
        return;
    }
    m_triangles = std::make_shared<const TriangleMesh>(std::move(*mesh));
    const glm::vec3 extent = extentOf(*m_triangles);
    const auto length = [](float value) {
        return QString::number(static_cast<double>(value), 'g', 4);
    };
    m_mesh->setText(tr("%1 faces, %2 × %3 × %4 units.")
                        .arg(countText(m_triangles->faceCount()),
                             length(extent.x),
                             length(extent.y),
                             length(extent.z)));
    plan();
}

void NewDialog::plan()
{
    if (!m_triangles) {
        return;
    }
    const quint64 generation = ++m_planGeneration;
    m_jobs.run(
        tr("Counting texels…"),
        [mesh = m_triangles, options = options()](Progress& /*progress*/) {
            return planFor(*mesh, options);
        },
        [this, generation, mesh = m_triangles](const Result<LevelPlan>& plan) {
            if (generation == m_planGeneration && mesh == m_triangles) {
                showPlan(plan);
            }
        });
}

void NewDialog::showPlan(const Result<LevelPlan>& plan)
{
    m_create->setEnabled(plan.has_value());
    if (!plan) {
        m_summary->setText(QString::fromStdString(plan.error().message));
        return;
    }
    const std::span<const Level> levels = plan->levels.values();
    if (levels.empty()) {
        m_create->setEnabled(false);
        m_summary->setText(tr("The mesh has no faces to paint."));
        return;
    }
    const auto [low, high] = std::minmax_element(levels.begin(), levels.end());
    const QString range = *low == *high ? tr("level %1").arg(low->log2())
                                        : tr("levels %1 to %2").arg(low->log2()).arg(high->log2());
    m_summary->setText(tr("%1 faces, %2 texels, %3 when every face is painted; %4.")
                           .arg(countText(levels.size()),
                                countText(plan->texels),
                                sizeText(plan->bytes(options().format)),
                                range));
}

ProjectOptions NewDialog::options() const
{
    ProjectOptions options;
    options.size = static_cast<SizeChoice>(m_by->currentData().toInt());
    options.level = m_level->value();
    options.density = m_density->value();
    options.total = static_cast<std::uint64_t>(std::llround(m_total->value() * kMillion));
    options.format.type = m_type->type();
    options.format.channels = static_cast<std::uint16_t>(m_channels->channels());
    if (m_channels->channels() == 4) {
        options.format.alpha = std::uint16_t{3};
    }
    const QColor fill = m_fill->color();
    options.fill = {fill.redF(), fill.greenF(), fill.blueF(), fill.alphaF()};
    if (m_channels->channels() == 1) {
        options.fill.fill(static_cast<float>(qGray(fill.rgb())) / 255.0F);
    }
    return options;
}

void NewDialog::chooseFill()
{
    auto* dialog = new QColorDialog(m_fill->color(), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setOption(QColorDialog::ShowAlphaChannel, m_channels->channels() == 4);
    dialog->setWindowTitle(tr("Fill Colour"));
    connect(dialog, &QColorDialog::colorSelected, m_fill, &SwatchButton::setColor);
    dialog->open();
}

void NewDialog::finish()
{
    if (m_triangles) {
        emit createWanted(m_triangles, options(), QFileInfo(m_path->path()).completeBaseName());
        accept();
    }
}

} // namespace trixel::ui
