// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/import/import_panel.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QStackedWidget>
#include <QStandardItemModel>

#include "ui/dialogs/format_choice.h"
#include "ui/import/image_row.h"
#include "ui/import/import_look.h"
#include "ui/import/import_options.h"
#include "ui/import/import_words.h"
#include "ui/import/import_work.h"
#include "ui/import/mapping_pages.h"
#include "ui/import/place_page.h"
#include "ui/import/quad_placement.h"

#include <utility>

namespace trixel::ui {

namespace {

constexpr int kSpace = 6;
constexpr int kMargin = 8;
constexpr int kFewestLetters = 10;
/// Texels that someone paints on are left alone for so long before they are previewed again.
constexpr int kPauseMs = 200;

} // namespace

ImportPanel::ImportPanel(Document& document,
                         const FaceSelection& selection,
                         BackgroundJobs& jobs,
                         Viewport& viewport,
                         ViewSettings& settings,
                         QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_jobs(jobs)
    , m_viewport(viewport)
    , m_fields(new QWidget)
    , m_kind(new QComboBox)
    , m_mappingProblem(new QLabel)
    , m_pages(new QStackedWidget)
    , m_sphere(new SpherePage)
    , m_plane(new PlanePage)
    , m_placement(new QuadPlacement(viewport, this))
    , m_place(new PlacePage(*m_placement))
    , m_look(new ImportLook(viewport, settings))
    , m_state(new QLabel)
    , m_progress(new QProgressBar)
    , m_apply(new QPushButton)
    , m_close(new QPushButton(tr("Close")))
{
    auto* form = new QFormLayout(m_fields);
    form->setContentsMargins(kMargin, kMargin, kMargin, kMargin);
    form->setVerticalSpacing(kSpace);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    m_image = new ImageRow(jobs, *form, this);
    makeMapping(*form);
    m_options = new ImportOptions(selection, *form, this);
    m_image->addMeaning(*form);
    auto* scroll = new QScrollArea;
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setWidget(m_fields);
    for (QComboBox* box : m_fields->findChildren<QComboBox*>()) { // a panel is narrow
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        box->setMinimumContentsLength(kFewestLetters);
    }
    auto* whole = new QVBoxLayout(this);
    whole->setContentsMargins(0, 0, 0, kMargin);
    whole->setSpacing(kSpace);
    whole->addWidget(scroll, 1);
    makeButtons(*whole);
    m_pause.setSingleShot(true);
    m_pause.setInterval(kPauseMs);
    connectAll();
    takeDocument();
}

ImportPanel::~ImportPanel() = default;

void ImportPanel::makeMapping(QFormLayout& form)
{
    const auto add = [this](const QString& text, MapKind kind, const QString& toolTip) {
        m_kind->addItem(text, static_cast<int>(kind));
        m_kind->setItemData(m_kind->count() - 1, toolTip, Qt::ToolTipRole);
    };
    add(tr("By the mesh’s uvs"), MapKind::Uvs, tr("Where the mesh itself says"));
    add(tr("Sphere"), MapKind::Sphere, tr("Round the surface, as a globe's map"));
    add(tr("Plane"), MapKind::Plane, tr("Straight along an axis"));
    add(tr("Quadrilateral"), MapKind::Quad, tr("Straight, between four corners in space"));
    add(tr("Camera"),
        MapKind::Camera,
        tr("From where the view is, in perspective, between four corners of its picture"));
    m_kind->setAccessibleName(tr("How the image lies on the surface"));
    m_kind->setToolTip(tr("How the image is laid onto the surface"));
    m_mappingProblem->setWordWrap(true);
    m_mappingProblem->setAccessibleName(tr("What is wrong with the mapping"));
    m_mappingProblem->setToolTip(tr("Why the image cannot be laid onto the surface like this"));
    m_pages->addWidget(new QWidget);
    m_pages->addWidget(m_sphere);
    m_pages->addWidget(m_plane);
    m_pages->addWidget(m_place);
    m_pages->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
    form.addRow(tr("&Mapping"), m_kind);
    form.addRow(m_pages);
    form.addRow(m_mappingProblem);
}

void ImportPanel::makeButtons(QBoxLayout& column)
{
    m_state->setWordWrap(true);
    m_state->setAccessibleName(tr("State of the import"));
    m_state->setToolTip(tr("What the image reaches and how long it will take"));
    m_state->setMinimumHeight(2 * fontMetrics().lineSpacing());
    m_progress->setAccessibleName(tr("Progress of the import"));
    m_progress->setToolTip(tr("How much of the import is done"));
    m_progress->setTextVisible(false);
    m_progress->setFixedHeight(6);
    m_progress->setRange(0, 1000);
    m_close->setAccessibleName(tr("Close without importing"));
    m_close->setToolTip(tr("Leave everything as it is"));
    auto* inner = new QVBoxLayout;
    inner->setContentsMargins(kMargin, 0, kMargin, 0);
    inner->setSpacing(kSpace);
    inner->addWidget(m_look);
    inner->addWidget(m_state);
    inner->addWidget(m_progress);
    auto* row = new QHBoxLayout;
    row->setSpacing(kSpace);
    row->addWidget(m_apply);
    row->addWidget(m_close);
    inner->addLayout(row);
    column.addLayout(inner);
}

void ImportPanel::connectAll()
{
    connect(m_image, &ImageRow::imageChanged, this, &ImportPanel::takeImage);
    connect(m_image, &ImageRow::meaningChanged, this, &ImportPanel::changed);
    connect(m_kind, &QComboBox::currentIndexChanged, this, &ImportPanel::takeKind);
    connect(m_sphere, &SpherePage::changed, this, &ImportPanel::changed);
    connect(m_plane, &PlanePage::changed, this, &ImportPanel::changed);
    connect(m_placement, &QuadPlacement::changed, this, &ImportPanel::changed);
    connect(m_options, &ImportOptions::changed, this, &ImportPanel::changed);
    connect(m_apply, &QPushButton::clicked, this, &ImportPanel::applyOrCancel);
    connect(m_close, &QPushButton::clicked, this, &ImportPanel::finished);
    connect(&m_preview, &ImportPreview::made, this, &ImportPanel::takePicture);
    connect(&m_preview, &ImportPreview::failed, this, [this](const QString& sentence) {
        m_previewProblem = problemText(Error{ErrorKind::Contents, sentence.toStdString()});
        takePicture(nullptr);
    });
    connect(&m_document, &Document::opened, this, &ImportPanel::takeDocument);
    connect(&m_document, &Document::changed, this, [this] {
        m_picture.reset();
        m_pause.start();
    });
    for (const auto moved : {&Document::layersChanged, &Document::activeLayerChanged}) {
        connect(&m_document, moved, this, &ImportPanel::showState);
    }
    connect(&m_pause, &QTimer::timeout, this, &ImportPanel::refresh);
}

void ImportPanel::begin(const QString& path)
{
    if (!path.isEmpty()) {
        m_image->setPath(path);
    }
    m_image->setFocus();
}

MapKind ImportPanel::kind() const
{
    return static_cast<MapKind>(m_kind->currentData().toInt());
}

ImportSettings ImportPanel::settings() const
{
    ImportSettings settings;
    m_options->fill(settings);
    settings.kind = kind();
    settings.sphere = m_sphere->settings();
    settings.plane = m_plane->settings();
    settings.quad = m_placement->quad();
    settings.camera = m_placement->camera();
    settings.color = m_image->color();
    settings.channel = m_image->channel();
    return settings;
}

std::vector<FaceId> ImportPanel::faces() const
{
    std::vector<FaceId> faces = m_options->chosenFaces();
    if (!m_options->isSelectionOnly()) {
        faces.reserve(m_document.texels().faceCount());
        for (std::uint32_t f = 0; f < m_document.texels().faceCount(); ++f) {
            faces.push_back(faceId(f));
        }
    }
    return faces;
}

ImportInput ImportPanel::input() const
{
    return {m_document.snapshot(), faces(), settings(), m_image->images(), m_samplers};
}

void ImportPanel::takeDocument()
{
    m_picture.reset();
    if (m_job) {
        m_job->cancel();
    }
    const auto& surface = m_document.surface();
    const bool hasUvs = surface && surface->mesh().hasUvs();
    if (auto* model = qobject_cast<QStandardItemModel*>(m_kind->model())) {
        model->item(0)->setEnabled(hasUvs);
        model->item(0)->setToolTip(hasUvs ? tr("Where the mesh itself says")
                                          : tr("This mesh has no uvs"));
    }
    m_kind->setItemText(0, hasUvs ? tr("By the mesh’s uvs") : tr("By uvs (the mesh has none)"));
    const QSignalBlocker silent(m_kind);
    m_kind->setCurrentIndex(
        m_kind->findData(static_cast<int>(hasUvs ? MapKind::Uvs : MapKind::Camera)));
    if (surface) {
        m_sphere->takeSurface(*surface);
        m_plane->takeSurface(*surface);
        m_placement->takeSurface(*surface);
    }
    takeKind();
}

void ImportPanel::takeImage()
{
    if (m_image->images()) {
        const Image& image = m_image->images()->first();
        const double aspect = static_cast<double>(image.width()) / image.height();
        m_plane->setAspect(aspect);
        m_placement->setImage(m_image->images()->small, aspect);
    }
    changed();
}

void ImportPanel::takeKind()
{
    QWidget* const pages[] = {m_pages->widget(0), m_sphere, m_plane, m_place, m_place};
    QWidget* page = pages[static_cast<std::size_t>(kind())];
    for (int k = 0; k < m_pages->count(); ++k) { // the others take no room
        const auto policy =
            m_pages->widget(k) == page ? QSizePolicy::Preferred : QSizePolicy::Ignored;
        m_pages->widget(k)->setSizePolicy(policy, policy);
    }
    m_pages->setCurrentWidget(page);
    m_pages->setVisible(kind() != MapKind::Uvs);
    m_placement->setKind(kind());
    m_place->follow();
    m_options->showFor(kind());
    changed();
}

/// Something that the texels to come depend on.
void ImportPanel::changed()
{
    m_previewProblem.clear();
    refresh();
}

void ImportPanel::refresh()
{
    if (m_document.hasStroke()) {
        m_pause.start();
        return;
    }
    if (isVisible() && !m_job && missing().isEmpty()) {
        const ImportInput wanted = input();
        m_preview.ask(wanted, m_document.state().texels);
        m_look->setInput(wanted);
    } else {
        m_preview.stop();
        m_picture.reset();
        m_look->setInput(std::nullopt);
        m_look->setPicture(nullptr);
    }
    showState();
}

/// Why there is nothing to import yet, in one sentence; empty where there is.
QString ImportPanel::missing() const
{
    if (!m_document.isOpen()) {
        return tr("No mesh is open.");
    }
    if (!m_image->images()) {
        return m_image->isReading()           ? tr("Reading the image…")
               : m_image->problem().isEmpty() ? tr("Choose an image.")
                                              : tr("The image cannot be used.");
    }
    if (m_options->isSelectionOnly() && m_options->chosenFaces().empty()) {
        return tr("No faces are selected.");
    }
    return mappingProblem().isEmpty() ? QString() : tr("The image cannot be laid on like this.");
}

QString ImportPanel::mappingProblem() const
{
    if (!m_document.isOpen()) {
        return {};
    }
    const auto mapping = makeImportMapping(settings(), m_document.surface());
    return mapping ? m_previewProblem : problemText(mapping.error());
}

void ImportPanel::takePicture(const std::shared_ptr<const PreviewPicture>& picture)
{
    m_picture = picture;
    m_look->setPicture(picture);
    showState();
}

void ImportPanel::applyOrCancel()
{
    if (m_job) {
        m_job->cancel();
        m_apply->setEnabled(false); // until the work has heard
        return;
    }
    m_document.endStroke();
    m_document.whenSettled([self = QPointer(this)] {
        if (self && self->missing().isEmpty() && !self->m_job) {
            self->apply();
        }
    });
}

void ImportPanel::apply()
{
    m_preview.stop();
    const QString name = m_image->name();
    m_job = &m_jobs.run(
        tr("Importing %1…").arg(name),
        [input = input(), below = m_document.activeLayer(), name](Progress& progress) {
            return importIntoProject(input, below, name, progress);
        },
        [self = QPointer(this), madeFor = m_document.state(), name](Result<Imported> imported) {
            if (self) {
                self->take(std::move(imported), madeFor, name);
            }
        });
    connect(m_job, &BackgroundJob::progressed, this, [this] {
        if (m_job) {
            m_progress->setValue(static_cast<int>(m_job->fraction() * m_progress->maximum()));
        }
    });
    showState();
}

void ImportPanel::take(Result<Imported> imported, StateId madeFor, const QString& name)
{
    m_job = nullptr;
    if (!imported) {
        if (imported.error().kind != ErrorKind::Cancelled) {
            m_previewProblem = problemText(imported.error());
            emit failed(tr("%1 was not imported: %2").arg(name, m_previewProblem));
        }
        refresh();
        return;
    }
    const QString text = tr("Import image %1").arg(name);
    const bool isDone = imported->layers
                            ? m_document.replaceLayers(std::move(*imported->layers), madeFor, text)
                            : m_document.applyPatch(std::move(imported->patch), madeFor, text);
    if (!isDone) {
        refresh(); // said already
        return;
    }
    m_look->setPicture(nullptr); // the texels are those now
    showState();
    emit applied(tr("Imported %1 onto %2 faces.").arg(name, countText(imported->faces)));
    emit finished();
}

QString ImportPanel::stateText() const
{
    if (m_job) {
        return tr("Importing…");
    }
    if (const QString why = missing(); !why.isEmpty()) {
        return why;
    }
    if (!m_picture) {
        return m_previewProblem.isEmpty() ? tr("Working out what the image reaches…") : QString();
    }
    const QString reach = tr("Reaches %1 faces with %2 texels; Apply takes %3.")
                              .arg(countText(m_picture->facesReached),
                                   countText(m_picture->texelsReached),
                                   secondsText(m_picture->seconds));
    return reach + (m_picture->isComplete ? QString() : tr(" Shown coarser than it will be.")) +
           placeText(m_document.layers(), m_document.activeLayer());
}

void ImportPanel::showState()
{
    const QString problem = mappingProblem();
    m_mappingProblem->setText(problem);
    m_mappingProblem->setVisible(!problem.isEmpty());
    m_state->setText(stateText());
    const bool isRunning = m_job != nullptr;
    m_apply->setText(isRunning ? tr("Cance&l") : tr("A&pply"));
    m_apply->setAccessibleName(isRunning ? tr("Cancel the import") : tr("Apply the import"));
    m_apply->setToolTip(isRunning ? tr("Stop; nothing is changed")
                                  : tr("Lay the image onto the faces, as one step to undo"));
    m_apply->setEnabled(isRunning || missing().isEmpty());
    m_close->setEnabled(!isRunning);
    m_fields->setEnabled(!isRunning);
    m_progress->setVisible(isRunning);
    if (!isRunning) {
        m_progress->setValue(0);
    }
}

void ImportPanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    m_look->setOn(true);
    m_placement->setOn(true);
    refresh();
}

void ImportPanel::hideEvent(QHideEvent* event)
{
    QWidget::hideEvent(event);
    m_preview.stop();
    m_picture.reset();
    m_look->setPicture(nullptr);
    m_look->setOn(false);
    m_placement->setOn(false);
}

} // namespace trixel::ui
