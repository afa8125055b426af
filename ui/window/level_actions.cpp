// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/level_actions.h"

#include <QInputDialog>
#include <QMenu>

#include "ui/dialogs/format_choice.h"
#include "ui/document/background_job.h"
#include "ui/document/face_selection.h"
#include "ui/document/made_layers.h"
#include "ui/window/actions.h"
#include "ui/window/message_bar.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace trixel::ui {

/// What was asked for and what it would cost.
struct LevelActions::Plan
{
    QString text; ///< of the undo step
    StateId state{};
    FaceMap<Level> levels;
    LevelCost cost;
    std::size_t faces = 0;   ///< asked for
    std::size_t stopped = 0; ///< of these, how many have no such level
};

namespace {

bool hasNoSuchLevel(Level level, LevelChange::Kind kind)
{
    return (kind == LevelChange::Kind::Halve && level.log2() == 0) ||
           (kind == LevelChange::Kind::Double && level.log2() == Level::kMax);
}

std::vector<FaceId> facesOrAll(std::vector<FaceId> faces, std::size_t faceCount)
{
    if (faces.empty()) {
        for (std::size_t f = 0; f < faceCount; ++f) {
            faces.push_back(faceId(f));
        }
    }
    return faces;
}

} // namespace

LevelActions::LevelActions(Document& document,
                           const FaceSelection& selection,
                           BackgroundJobs& jobs,
                           MessageBar& messages,
                           QWidget& window)
    : QObject(&window)
    , m_document(document)
    , m_selection(selection)
    , m_jobs(jobs)
    , m_messages(messages)
    , m_window(window)
{
    ActionMaker make(window);
    m_halve = make(tr("&Halve"), tr("A level coarser for the selected faces, or all"));
    m_double = make(tr("&Double"), tr("A level finer for the selected faces, or all"));
    m_set = make(tr("&Set Level…"), tr("One level for the selected faces, or all"));
    connect(m_halve, &QAction::triggered, this, [this] {
        plan({LevelChange::Kind::Halve, {}}, tr("Halve resolution"));
    });
    connect(m_double, &QAction::triggered, this, [this] {
        plan({LevelChange::Kind::Double, {}}, tr("Double resolution"));
    });
    connect(m_set, &QAction::triggered, this, &LevelActions::askForLevel);
    connect(&document, &Document::opened, this, &LevelActions::enable);
    // An offer holds for what it was worked out for.
    connect(&document, &Document::opened, this, &LevelActions::withdraw);
    connect(&document, &Document::changed, this, &LevelActions::withdraw);
    connect(&selection, &FaceSelection::changed, this, &LevelActions::withdraw);
    enable();
}

void LevelActions::enable()
{
    for (QAction* action : {m_halve, m_double, m_set}) {
        action->setEnabled(m_document.isOpen());
    }
}

void LevelActions::fillMenu(QMenu& menu)
{
    QMenu* levels = menu.addMenu(tr("&Levels"));
    levels->addAction(m_halve);
    levels->addAction(m_double);
    levels->addAction(m_set);
}

void LevelActions::askForLevel()
{
    auto* dialog = new QInputDialog(&m_window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Set Level"));
    dialog->setLabelText(
        tr("&Level, 0 to %1 (a face has 4 to the level texels):").arg(Level::kMax));
    dialog->setInputMode(QInputDialog::IntInput);
    dialog->setIntRange(0, Level::kMax);
    const FaceId first = m_selection.isEmpty() ? faceId(0) : m_selection.faces().front();
    dialog->setIntValue(m_document.texels().face(first).level().log2());
    connect(dialog, &QInputDialog::intValueSelected, this, [this](int level) {
        plan({LevelChange::Kind::Set, Level(level)}, tr("Set level %1").arg(level));
    });
    dialog->open();
}

void LevelActions::plan(LevelChange change, const QString& text)
{
    if (!m_document.isOpen()) {
        return;
    }
    m_document.endStroke();
    withdraw();
    m_document.whenSettled([this, change, text] { count(change, text); });
}

void LevelActions::count(const LevelChange& change, const QString& text)
{
    const std::uint64_t number = ++m_planned;
    std::vector<FaceId> chosen(m_selection.faces().begin(), m_selection.faces().end());
    m_jobs.run(
        tr("Counting texels…"),
        [project = m_document.snapshot(), state = m_document.state(), change, text, chosen](
            Progress& /*progress*/) -> Result<std::shared_ptr<const Plan>> {
            const TexelStore& texels = project.texels;
            auto plan = std::make_shared<Plan>();
            const std::vector<FaceId> faces = facesOrAll(chosen, texels.faceCount());
            plan->text = text;
            plan->state = state;
            plan->faces = faces.size();
            plan->stopped = static_cast<std::size_t>(std::ranges::count_if(faces, [&](FaceId face) {
                return hasNoSuchLevel(texels.face(face).level(), change.kind);
            }));
            plan->levels = changedLevels(texels, faces, change);
            plan->cost = costOfLevels(project, plan->levels);
            return std::shared_ptr<const Plan>(std::move(plan));
        },
        [this, number](const Result<std::shared_ptr<const Plan>>& plan) {
            if (plan && number == m_planned) {
                offer(*plan);
            }
        });
}

void LevelActions::offer(const std::shared_ptr<const Plan>& plan)
{
    const LevelCost& cost = plan->cost;
    const auto refuse = [&](const QString& why) {
        m_messages.showMessage(MessageBar::Kind::Note, tr("%1: %2").arg(plan->text, why));
    };
    if (plan->stopped > 0) {
        refuse(tr("%1 of %2 faces would leave the levels 0 to %3, nothing was done.")
                   .arg(countText(plan->stopped), countText(plan->faces))
                   .arg(Level::kMax));
        return;
    }
    if (cost.bytesAfter > kLevelBudget && cost.bytesAfter > cost.bytesBefore) {
        refuse(tr("the texels would take %1, more than the %2 allowed; nothing was done.")
                   .arg(sizeText(cost.bytesAfter), sizeText(kLevelBudget)));
        return;
    }
    if (cost.changedFaces == 0) {
        refuse(tr("every face has that level already."));
        return;
    }
    m_offered = tr("%1 of %2 faces: %3 → %4 texels, %5 → %6")
                    .arg(plan->text,
                         countText(cost.changedFaces),
                         countText(cost.texelsBefore),
                         countText(cost.texelsAfter),
                         sizeText(cost.bytesBefore),
                         sizeText(cost.bytesAfter));
    m_messages.showMessage(
        MessageBar::Kind::Note, m_offered, {tr("&Apply"), [this, plan] { apply(plan); }});
}

void LevelActions::apply(const std::shared_ptr<const Plan>& plan)
{
    withdraw();
    if (!m_document.layers().isPlain()) {
        applyToLayers(plan);
        return;
    }
    const Project project = m_document.snapshot();
    m_jobs.run(
        tr("%1…").arg(plan->text),
        [texels = project.texels, surface = project.surface, plan](
            Progress& progress) mutable -> Result<TexelPatch> {
            auto patch =
                changeLevels(texels, surface->adjacency(), plan->levels, Threads::all(), progress);
            if (patch) {
                patch->swap(texels); // now it holds the texels to come
            }
            return patch;
        },
        [this, plan](Result<TexelPatch> patch) {
            if (patch) {
                m_document.applyPatch(std::move(*patch), plan->state, plan->text);
            } else {
                complain(patch.error());
            }
        });
}

void LevelActions::applyToLayers(const std::shared_ptr<const Plan>& plan)
{
    m_jobs.run(
        tr("%1…").arg(plan->text),
        [project = m_document.snapshot(), active = m_document.activeLayer(), plan](
            Progress& progress) {
            return withOtherLevels(project, active, plan->levels, progress);
        },
        [this, plan](Result<LayersEdit> edit) {
            if (edit) {
                m_document.replaceLayers(std::move(*edit), plan->state, plan->text);
            } else {
                complain(edit.error());
            }
        });
}

void LevelActions::complain(const Error& error)
{
    if (error.kind != ErrorKind::Cancelled) {
        m_messages.showMessage(MessageBar::Kind::Error, QString::fromStdString(error.message));
    }
}

void LevelActions::withdraw()
{
    ++m_planned;
    if (!m_offered.isEmpty() && m_messages.sentence() == std::exchange(m_offered, {})) {
        m_messages.dismiss();
    }
}

} // namespace trixel::ui
