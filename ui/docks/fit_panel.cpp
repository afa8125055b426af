// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/fit_panel.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QLabel>
#include <QPointer>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>

#include "ui/dialogs/format_choice.h"
#include "ui/docks/fit_compare.h"
#include "ui/docks/fit_result.h"
#include "ui/docks/fit_views.h"
#include "ui/docks/value_row.h"
#include "ui/document/made_layers.h"

#include <utility>

namespace trixel::ui {

namespace {

constexpr int kSpace = 6;
constexpr int kMargin = 8;
constexpr double kUnit = 1.0 / 255;
constexpr double kLargestTolerance = 255;

} // namespace

FitPanel::FitPanel(Document& document,
                   ViewSettings& settings,
                   BackgroundJobs& jobs,
                   Viewport& viewport,
                   ViewMap& map,
                   FitWork work,
                   QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_jobs(jobs)
    , m_run(jobs, std::move(work))
    , m_views(new FitViews(document, viewport))
    , m_tolerance(new ScaledSpinBox(Scale::Logarithmic))
    , m_unseen(new QCheckBox(tr("Faces no &view sees: one texel")))
    , m_result(new FitResult(settings))
    , m_compare(new FitCompare(settings, viewport, map))
{
    auto* content = new QWidget;
    auto* column = new QVBoxLayout(content);
    column->setContentsMargins(kMargin, kMargin, kMargin, kMargin);
    column->setSpacing(kSpace);
    column->addWidget(m_views);
    makeTolerance(*column);
    makeUnseen(*column);
    column->addWidget(m_result);
    column->addStretch(1);
    auto* scroll = new QScrollArea;
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setWidget(content);
    auto* whole = new QVBoxLayout(this);
    whole->setContentsMargins(0, 0, 0, kMargin);
    whole->setSpacing(kSpace);
    whole->addWidget(scroll, 1);
    makeButtons(*whole);
    connectRun();
    connect(m_views, &FitViews::changed, this, &FitPanel::showState);
    connect(m_tolerance, &QDoubleSpinBox::valueChanged, this, &FitPanel::showState);
    connect(m_unseen, &QCheckBox::toggled, this, &FitPanel::showState);
    connect(&m_document, &Document::opened, this, [this] {
        m_applied.reset();
        m_shown.reset();
        m_run.forget();
        showState();
    });
    connect(&m_document.undoStack(), &QUndoStack::indexChanged, this, &FitPanel::showState);
    showState();
}

void FitPanel::makeTolerance(QBoxLayout& column)
{
    auto* row = new QHBoxLayout;
    row->setSpacing(kSpace);
    m_tolerance->setRange(0, kLargestTolerance);
    m_tolerance->setValue(1);
    m_tolerance->setSuffix(tr(" / 255"));
    m_tolerance->setAccessibleName(tr("Tolerance of the fit"));
    m_tolerance->setToolTip(
        tr("How far pictures may differ before and after: RMS over the pixels that see the mesh "
           "and "
           "over all channels, filtered by Exact, in every view that comes no closer than the "
           "chosen ones and shows at least %1 pixels of the mesh")
            .arg(countText(kFewestPixels)));
    auto* label = new QLabel(tr("&Tolerance"));
    label->setBuddy(m_tolerance);
    label->setToolTip(m_tolerance->toolTip());
    row->addWidget(label);
    row->addWidget(m_tolerance, 1);
    column.addLayout(row);
}

/// Off at first: whoever plans from one view of the front would not expect the paint on the back to
/// go. What it would save is told with the plan.
void FitPanel::makeUnseen(QBoxLayout& column)
{
    m_unseen->setAccessibleName(tr("Faces no view sees keep one texel"));
    m_unseen->setToolTip(
        tr("Faces outside every picture or hidden in all of them keep one texel, their mean, and "
           "their paint is lost; otherwise they are fitted as if each view turned to them and "
           "nothing stood in between"));
    column.addWidget(m_unseen);
}

void FitPanel::makeButtons(QBoxLayout& column)
{
    m_state = new QLabel;
    m_state->setWordWrap(true);
    m_state->setAccessibleName(tr("State of the plan"));
    m_state->setToolTip(tr("Whether there is a plan and what it holds for"));
    m_progress = new QProgressBar;
    m_progress->setAccessibleName(tr("Progress of the plan"));
    m_progress->setToolTip(tr("How much of the planning is done"));
    m_progress->setTextVisible(false);
    m_progress->setFixedHeight(6);
    m_progress->setRange(0, 1000);
    m_plan = new QPushButton;
    m_apply = new QPushButton(tr("A&pply"));
    m_apply->setAccessibleName(tr("Apply the plan"));
    m_apply->setToolTip(tr("Give the faces the planned levels, as one step to undo"));
    auto* inner = new QVBoxLayout;
    inner->setContentsMargins(kMargin, 0, kMargin, 0);
    inner->setSpacing(kSpace);
    inner->addWidget(m_compare);
    inner->addWidget(m_state);
    inner->addWidget(m_progress);
    auto* row = new QHBoxLayout;
    row->setSpacing(kSpace);
    row->addWidget(m_plan);
    row->addWidget(m_apply);
    inner->addLayout(row);
    column.addLayout(inner);
    connect(m_plan, &QPushButton::clicked, this, &FitPanel::planOrCancel);
    connect(m_apply, &QPushButton::clicked, this, &FitPanel::apply);
}

void FitPanel::connectRun()
{
    connect(&m_run, &FitRun::started, this, &FitPanel::showState);
    connect(&m_run, &FitRun::ended, this, &FitPanel::showOutcome);
    connect(&m_run, &FitRun::failed, this, &FitPanel::failed);
    connect(&m_run, &FitRun::progressed, this, [this] {
        m_progress->setValue(static_cast<int>(m_run.fraction() * m_progress->maximum()));
    });
}

void FitPanel::showOutcome()
{
    showState();
    if (m_run.outcome() && m_run.outcome() != m_shown) {
        m_shown = m_run.outcome();
        m_result->show(*m_shown);
        m_compare->showErrors();
    }
}

void FitPanel::begin()
{
    m_views->setFocus(Qt::ShortcutFocusReason);
}

FitSettings FitPanel::settings() const
{
    return {m_views->chosen(),
            m_tolerance->value() * kUnit,
            m_unseen->isChecked() ? UnseenFaces::OneTexel : UnseenFaces::ByDistance};
}

/// Whether the texels are those that the plan was made for.
bool FitPanel::hasItsTexels() const
{
    const auto& outcome = m_run.outcome();
    return outcome && outcome->state.texels == m_document.state().texels;
}

bool FitPanel::isCurrent() const
{
    if (!hasItsTexels()) {
        return false;
    }
    const FitSettings& planned = m_run.outcome()->settings;
    const FitSettings now = settings();
    return planned.views == now.views && planned.tolerance == now.tolerance &&
           planned.unseen == now.unseen;
}

void FitPanel::planOrCancel()
{
    if (m_run.isRunning()) {
        m_run.cancel();
        m_plan->setEnabled(false); // until the work has heard
        return;
    }
    if (!problem().isEmpty()) {
        return;
    }
    m_document.endStroke();
    m_applied.reset();
    m_document.whenSettled([this] {
        m_run.start({m_document.snapshot(), m_document.state(), settings()});
    });
}

void FitPanel::apply()
{
    if (!isCurrent()) {
        return;
    }
    const auto outcome = m_run.outcome();
    if (!m_document.layers().isPlain()) {
        applyToLayers(outcome);
    } else if (m_document.replaceTexels(outcome->fit.fitted, outcome->state, applyText())) {
        tellApplied(outcome->fit.plan.cost);
    }
}

QString FitPanel::applyText()
{
    return tr("Fit levels to scene");
}

/// What was fitted is what layers look like together; they get its levels one by one.
void FitPanel::applyToLayers(const std::shared_ptr<const FitOutcome>& outcome)
{
    m_apply->setEnabled(false);
    m_jobs.run(
        tr("Fitting the levels of the layers…"),
        [project = m_document.snapshot(), active = m_document.activeLayer(), outcome](
            Progress& progress) {
            return withOtherLevels(project, active, outcome->fit.plan.levels, progress);
        },
        [self = QPointer(this), outcome](Result<LayersEdit> edit) {
            if (!self) {
                return;
            }
            if (!edit) {
                if (edit.error().kind != ErrorKind::Cancelled) {
                    emit self->failed(QString::fromStdString(edit.error().message));
                }
            } else if (self->m_document.replaceLayers(
                           std::move(*edit), outcome->state, applyText())) {
                self->tellApplied(outcome->fit.plan.cost);
            }
            self->showState();
        });
}

void FitPanel::tellApplied(const LevelCost& cost)
{
    m_applied = m_document.state().texels;
    m_compare->showTexels(); // which are the fitted ones now
    showState();
    emit applied(tr("Fitted %1 faces: %2 → %3 texels, %4 → %5.")
                     .arg(countText(cost.changedFaces),
                          countText(cost.texelsBefore),
                          countText(cost.texelsAfter),
                          sizeText(cost.bytesBefore),
                          sizeText(cost.bytesAfter)));
}

/// Why no plan can be made with the choices as they are; empty where one can.
QString FitPanel::problem() const
{
    if (!m_document.isOpen()) {
        return tr("No mesh is open.");
    }
    const FitSettings now = settings();
    if (now.views.isEmpty()) {
        return tr("Add or check a view to keep, or choose a distance.");
    }
    if (!(now.tolerance > 0)) {
        return tr("The tolerance has to be above 0.");
    }
    for (const DistantViews& views : now.views.distant) {
        if (!validate(views)) {
            return tr("The distance has to be above 0.");
        }
    }
    return {};
}

QString FitPanel::stateText() const
{
    if (m_run.isRunning()) {
        return tr("Planning…");
    }
    const auto& outcome = m_run.outcome();
    if (m_applied && m_document.state().texels == *m_applied) {
        return tr("The plan is applied; undo brings everything back.");
    }
    if (const QString why = problem(); !why.isEmpty()) {
        return why;
    }
    if (!outcome) {
        return tr("Plan finds the lowest levels that keep what these views show.");
    }
    if (!hasItsTexels()) {
        return tr("The texels have changed since this plan: plan again.");
    }
    if (!isCurrent()) {
        return tr("The views, the tolerance or the choice for faces that no view sees are others "
                  "than the plan's: plan again.");
    }
    if (outcome->fit.plan.fitted.isEmpty()) {
        return tr("There is nothing to save: every face needs the texels that it has.");
    }
    return tr("Nothing is changed until the plan is applied.");
}

void FitPanel::showState()
{
    const bool running = m_run.isRunning();
    const auto& outcome = m_run.outcome();
    m_state->setText(stateText());
    m_plan->setText(running ? tr("Cance&l") : outcome ? tr("P&lan again") : tr("P&lan"));
    m_plan->setAccessibleName(running ? tr("Cancel the plan") : tr("Plan the fit"));
    m_plan->setToolTip(running ? tr("Stop; nothing is changed")
                               : tr("Work out in the background what could be saved"));
    m_plan->setEnabled(running || problem().isEmpty());
    m_apply->setEnabled(!running && isCurrent() && !outcome->fit.plan.fitted.isEmpty());
    m_progress->setVisible(running);
    if (!running) {
        m_progress->setValue(0);
    }
    m_compare->setOutcome(outcome, hasItsTexels());
    m_compare->setVisible(outcome != nullptr);
    m_result->setVisible(outcome != nullptr);
    m_result->setEnabled(!running && isCurrent());
}

} // namespace trixel::ui
