// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/fit_views.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "render/camera_view.h"
#include "ui/docks/value_row.h"
#include "ui/document/document.h"
#include "ui/document/view_bookmarks.h"
#include "ui/viewport/viewport.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace trixel::ui {

namespace {

constexpr int kSpace = 6;
constexpr int kRowsShown = 3;
constexpr double kLeastDistance = 0.05; // of the surface's size, proposed
constexpr double kLargestDistance = 1e9;

/// World units from a texel to the next, if all were equilateral and of one size.
double meanTexelSpacing(const TriangleMesh& mesh, const TexelStore& texels)
{
    double area = 0;
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        const auto corners = mesh.corners(faceId(f));
        const glm::dvec3 edge(corners[1] - corners[0]);
        area += glm::length(glm::cross(edge, glm::dvec3(corners[2] - corners[0]))) / 2;
    }
    const double spacing = std::sqrt(area / static_cast<double>(texels.texelCount()));
    return std::isfinite(spacing) ? spacing : 0;
}

double inThreeDigits(double number)
{
    return QString::number(number, 'g', 3).toDouble();
}

QString threeDigits(double number)
{
    return QLocale().toString(number, 'g', 3);
}

QString describe(const ViewCamera& camera)
{
    return FitViews::tr("%1 × %2 pixels, %3° high")
        .arg(camera.width)
        .arg(camera.height)
        .arg(threeDigits(camera.fovY));
}

QString describe(const DistantViews& views)
{
    return FitViews::tr("Every view beyond %1 world units of %2 × %3 pixels, %4° high")
        .arg(threeDigits(views.distance))
        .arg(views.width)
        .arg(views.height)
        .arg(threeDigits(views.fovY));
}

} // namespace

FitViews::FitViews(Document& document, const Viewport& viewport, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_viewport(viewport)
    , m_list(new QListWidget)
    , m_add(new QPushButton(tr("&Add present view")))
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kSpace);
    makeList();
    column->addWidget(m_list);
    column->addWidget(m_add);
    column->addWidget(makeDistance());
    column->addWidget(m_spacing);
    connect(&document, &Document::opened, this, &FitViews::takeDocument);
    connect(&document.bookmarks(), &ViewBookmarks::changed, this, [this] {
        listViews();
        emit changed();
    });
    connect(&document, &Document::levelsChanged, this, &FitViews::measureTexels);
    takeDocument();
}

void FitViews::makeList()
{
    m_list->setAccessibleName(tr("Views to keep"));
    m_list->setToolTip(tr("What the checked views show stays within the tolerance, and so does "
                          "every view that comes no closer"));
    m_list->setUniformItemSizes(true);
    const int row = fontMetrics().height() + 6;
    m_list->setFixedHeight(kRowsShown * row + 2 * m_list->frameWidth());
    m_add->setAccessibleName(tr("Add the present view"));
    m_add->setToolTip(tr("Bookmark what the 3D view shows now, to keep it"));
    connect(m_list, &QListWidget::itemChanged, this, &FitViews::takeChecks);
    connect(m_add, &QPushButton::clicked, this, &FitViews::addPresent);
}

QWidget* FitViews::makeDistance()
{
    auto* whole = new QWidget;
    auto* row = new QHBoxLayout(whole);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(kSpace);
    m_beyond = new QCheckBox(tr("&Every view beyond"));
    m_beyond->setAccessibleName(tr("Keep every view beyond a distance"));
    m_distance = new ScaledSpinBox(Scale::Logarithmic);
    m_distance->setRange(0, kLargestDistance);
    m_distance->setSuffix(tr(" units"));
    m_distance->setAccessibleName(tr("Distance of the nearest view"));
    m_spacing = new QLabel;
    m_spacing->setWordWrap(true);
    m_spacing->setForegroundRole(QPalette::PlaceholderText);
    row->addWidget(m_beyond);
    row->addWidget(m_distance, 1);
    connect(m_beyond, &QCheckBox::toggled, this, [this](bool on) {
        if (on && !m_distanceIsChosen) {
            proposeDistance();
        }
        m_distance->setEnabled(on);
        explainDistance();
        emit changed();
    });
    connect(m_distance, &QDoubleSpinBox::valueChanged, this, [this] {
        m_distanceIsChosen = true;
        explainDistance();
        emit changed();
    });
    m_distance->setEnabled(false);
    return whole;
}

SceneViews FitViews::chosen() const
{
    SceneViews views = m_document.bookmarks().views();
    const auto isLeftOut = [this](const auto& view) {
        return m_leftOut.contains(QString::fromStdString(view.name));
    };
    std::erase_if(views.cameras, isLeftOut);
    std::erase_if(views.distant, isLeftOut);
    if (m_beyond->isChecked()) {
        views.distant.push_back(beyond());
    }
    const auto forgetName = [](auto& view) { view.name.clear(); };
    std::ranges::for_each(views.cameras, forgetName);
    std::ranges::for_each(views.distant, forgetName);
    return views;
}

DistantViews FitViews::beyond() const
{
    return {.name = {}, .distance = m_distance->value()};
}

/// As far away as the present view is.
void FitViews::proposeDistance()
{
    const Surface& surface = *m_document.surface();
    const glm::dvec3 eye = m_viewport.camera().eye();
    const glm::dvec3 nearest =
        glm::clamp(eye, glm::dvec3(surface.low()), glm::dvec3(surface.high()));
    const double least = kLeastDistance * static_cast<double>(surface.size());
    const QSignalBlocker quiet(m_distance);
    m_distance->setValue(inThreeDigits(std::max(glm::length(eye - nearest), least)));
}

void FitViews::addPresent()
{
    m_document.bookmarks().add(render::viewOf(m_viewport.camera()));
}

void FitViews::listViews()
{
    const QSignalBlocker quiet(m_list);
    const int current = m_list->currentRow();
    m_list->clear();
    const auto add = [this](const auto& view) {
        const QString name = QString::fromStdString(view.name);
        auto* item = new QListWidgetItem(name, m_list);
        item->setToolTip(describe(view));
        item->setFlags(item->flags() | Qt::ItemIsUserCheckable);
        item->setCheckState(m_leftOut.contains(name) ? Qt::Unchecked : Qt::Checked);
    };
    const SceneViews& views = m_document.bookmarks().views();
    std::ranges::for_each(views.cameras, add);
    std::ranges::for_each(views.distant, add);
    m_list->setCurrentRow(
        std::clamp(current, std::min(0, m_list->count() - 1), m_list->count() - 1));
}

void FitViews::takeChecks()
{
    m_leftOut.clear();
    for (int row = 0; row < m_list->count(); ++row) {
        if (m_list->item(row)->checkState() != Qt::Checked) {
            m_leftOut += m_list->item(row)->text();
        }
    }
    emit changed();
}

void FitViews::takeDocument()
{
    m_add->setEnabled(m_document.isOpen());
    m_beyond->setEnabled(m_document.isOpen());
    m_leftOut.clear();
    listViews();
    m_distanceIsChosen = false;
    if (m_document.isOpen()) {
        proposeDistance();
    }
    measureTexels();
    emit changed();
}

void FitViews::measureTexels()
{
    m_texelSpacing = 0;
    explainDistance();
    if (!m_document.isOpen()) {
        return;
    }
    const quint64 generation = ++m_generation;
    m_jobs.run(
        QString(),
        [surface = m_document.surface(), texels = m_document.texels()](Progress& /*progress*/)
            -> Result<double> { return meanTexelSpacing(surface->mesh(), texels); },
        [this, generation](const Result<double>& spacing) {
            if (spacing && generation == m_generation) {
                m_texelSpacing = *spacing;
                explainDistance();
            }
        });
}

void FitViews::explainDistance()
{
    if (!m_document.isOpen()) {
        m_spacing->clear();
        return;
    }
    const QString size =
        tr("The model is %1 units across.").arg(threeDigits(m_document.surface()->size()));
    QString pixel;
    if (m_texelSpacing > 0 && m_distance->value() > 0) {
        pixel = tr("A pixel is as wide as %1 texels there.")
                    .arg(threeDigits(beyond().unitsPerPixel() / m_texelSpacing));
    }
    m_spacing->setText(m_beyond->isChecked() ? size + ' ' + pixel : size);
    m_distance->setToolTip(
        tr("How close views may come to any point of the surface, in world units, with pictures "
           "of %1 × %2 pixels, %3° high. %4 %5")
            .arg(beyond().width)
            .arg(beyond().height)
            .arg(threeDigits(beyond().fovY))
            .arg(size, pixel));
    m_beyond->setToolTip(m_distance->toolTip());
}

} // namespace trixel::ui
