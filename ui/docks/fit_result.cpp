// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/fit_result.h"

#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPainter>
#include <QPushButton>
#include <QStyledItemDelegate>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "ui/dialogs/format_choice.h"
#include "ui/viewport/method_title.h"
#include "ui/viewport/view_settings.h"

#include <algorithm>
#include <cmath>

namespace trixel::ui {

namespace {

constexpr int kSpace = 6;
constexpr int kShareRole = Qt::UserRole;

enum Column { kLevel, kBefore, kAfter, kColumns };

QString digits(double number, int count)
{
    return QLocale().toString(number, 'g', count);
}

QString share(double before, double after)
{
    return after < before ? FitResult::tr(" (%1 times fewer)").arg(digits(before / after, 3))
                          : QString();
}

/// Draws the share of faces as a bar behind the number.
class ShareDelegate : public QStyledItemDelegate
{
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter,
               const QStyleOptionViewItem& option,
               const QModelIndex& index) const override
    {
        constexpr int kInset = 2;
        constexpr int kAlpha = 110;
        const double part = index.data(kShareRole).toDouble();
        if (part > 0) {
            QRect bar = option.rect.adjusted(kInset, kInset, -kInset, -kInset);
            bar.setLeft(bar.right() - std::max(1, static_cast<int>(part * bar.width())));
            QColor color = option.palette.color(QPalette::Highlight);
            color.setAlpha(kAlpha);
            painter->fillRect(bar, color);
        }
        QStyledItemDelegate::paint(painter, option, index);
    }
};

} // namespace

FitResult::FitResult(ViewSettings& settings, QWidget* parent)
    : QWidget(parent)
    , m_settings(settings)
    , m_use(new QPushButton(tr("&Use this method")))
    , m_levels(new QTreeWidget)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kSpace);
    auto* form = new QFormLayout;
    form->setSpacing(kSpace);
    form->setRowWrapPolicy(QFormLayout::DontWrapRows);
    m_texels = addRow(*form, tr("Texels"), tr("Of all faces, now and when the plan is applied"));
    m_memory = addRow(*form, tr("Memory"), tr("That all texels take, now and when it is applied"));
    m_faces = addRow(*form, tr("Faces"), tr("Those that get a lower level"));
    m_unseen =
        addRow(*form,
               tr("Unseen"),
               tr("Faces that no view sees, outside every picture or hidden in all, and their "
                  "texels now and when the plan is applied"));
    m_error =
        addRow(*form,
               tr("RMS"),
               tr("Between the pictures before and after, over all pixels, over the worst patch of "
                  "some 512 pixels, and over the worst face alone"));
    m_subdivision =
        addRow(*form,
               tr("Mesh"),
               tr("The coarsest subdivision of the mesh, taken as a Loop cage, whose outline "
                  "no view can tell from the limit surface"));
    m_method =
        addRow(*form,
               tr("Filter"),
               tr("The fastest filter method that stays within the tolerance in the checked views, "
                  "measured here and now"));
    column->addLayout(form);
    m_use->setAccessibleName(tr("Use the fastest method"));
    m_use->setToolTip(tr("Make it the method of maps, seams and read-outs"));
    column->addWidget(m_use);
    makeLevels();
    column->addWidget(m_levels);
    connect(m_use, &QPushButton::clicked, this, [this] {
        if (m_choice) {
            m_settings.setMethod(*m_choice);
        }
    });
    connect(&settings, &ViewSettings::methodChanged, this, &FitResult::showUse);
}

QLabel* FitResult::addRow(QFormLayout& form, const QString& title, const QString& toolTip)
{
    auto* label = new QLabel;
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    label->setAccessibleName(title);
    label->setToolTip(toolTip);
    auto* heading = new QLabel(title);
    heading->setToolTip(toolTip);
    form.addRow(heading, label);
    return label;
}

void FitResult::makeLevels()
{
    m_levels->setAccessibleName(tr("Faces by level"));
    m_levels->setToolTip(tr("How many faces have each level, now and when the plan is applied"));
    m_levels->setHeaderLabels({tr("Level"), tr("Now"), tr("Fitted")});
    m_levels->setRootIsDecorated(false);
    m_levels->setUniformRowHeights(true);
    m_levels->setSelectionMode(QAbstractItemView::NoSelection);
    m_levels->setItemDelegate(new ShareDelegate(m_levels));
    m_levels->header()->setStretchLastSection(false);
    for (int column = 0; column < kColumns; ++column) {
        m_levels->header()->setSectionResizeMode(column, QHeaderView::Stretch);
        if (column != kLevel) {
            m_levels->headerItem()->setTextAlignment(column, Qt::AlignRight);
        }
    }
}

void FitResult::show(const FitOutcome& outcome)
{
    const FitPlan& plan = outcome.fit.plan;
    const LevelCost& cost = plan.cost;
    m_texels->setText(tr("%1 → %2%3")
                          .arg(countText(cost.texelsBefore),
                               countText(cost.texelsAfter),
                               share(static_cast<double>(cost.texelsBefore),
                                     static_cast<double>(cost.texelsAfter))));
    m_memory->setText(tr("%1 → %2").arg(sizeText(cost.bytesBefore), sizeText(cost.bytesAfter)));
    m_faces->setText(tr("%1 change").arg(countText(cost.changedFaces)));
    showUnseen(outcome);
    m_error->setText(tr("%1, worst patch %2, worst face %3, in 1/255")
                         .arg(digits(255 * plan.rms, 2),
                              digits(255 * plan.worstPart, 2),
                              digits(255 * plan.worstFace, 2)));
    showSubdivision(outcome);
    showMethod(outcome);
    showLevels(outcome);
}

void FitResult::showUnseen(const FitOutcome& outcome)
{
    const FitPlan& plan = outcome.fit.plan;
    if (plan.unseenFaces == 0) {
        m_unseen->setText(tr("every face is in a view"));
        return;
    }
    m_unseen->setText(tr("%1 faces, %2 → %3 texels")
                          .arg(countText(plan.unseenFaces),
                               countText(plan.unseenTexelsBefore),
                               countText(plan.unseenTexelsAfter)));
}

void FitResult::showSubdivision(const FitOutcome& outcome)
{
    if (outcome.fit.subdivision.empty()) {
        m_subdivision->setText(tr("cannot be subdivided"));
        return;
    }
    const SubdivisionError& last = outcome.fit.subdivision.back();
    const QString faces = countText(last.faces);
    if (last.pixels > kSubdivisionPixels) {
        m_subdivision->setText(
            tr("needs more than %n subdivision(s) (%1 faces)", nullptr, last.steps).arg(faces));
    } else if (last.steps == 0) {
        m_subdivision->setText(tr("fine enough as it is"));
    } else {
        m_subdivision->setText(
            tr("%n subdivision(s) will do (%1 faces)", nullptr, last.steps).arg(faces));
    }
}

void FitResult::showMethod(const FitOutcome& outcome)
{
    const auto& method = outcome.fit.method;
    m_choice = method ? std::optional(method->method) : std::nullopt;
    if (method) {
        m_method->setText(
            tr("%1: %2 ns a sample, RMS %3 / 255")
                .arg(methodTitle(method->method),
                     countText(static_cast<std::uint64_t>(std::lround(method->nanoseconds))),
                     digits(255 * method->rms, 2)));
    } else if (outcome.settings.views.cameras.empty()) {
        m_method->setText(tr("needs a view to be measured in"));
    } else {
        m_method->setText(tr("none but Exact stays within the tolerance"));
    }
    showUse();
}

void FitResult::showUse()
{
    m_use->setVisible(m_choice.has_value());
    m_use->setEnabled(m_choice && m_settings.method() != *m_choice);
}

/// The levels that occur, the finest first.
void FitResult::showLevels(const FitOutcome& outcome)
{
    m_levels->clear();
    const double faces = std::max<double>(1, static_cast<double>(outcome.fit.plan.levels.size()));
    for (int level = Level::kMax; level >= 0; --level) {
        const auto at = static_cast<std::size_t>(level);
        if (outcome.before[at] == 0 && outcome.after[at] == 0) {
            continue;
        }
        auto* item = new QTreeWidgetItem(m_levels);
        item->setText(kLevel, QString::number(level));
        item->setToolTip(kLevel, tr("%1 texels a face").arg(countText(Level(level).texelCount())));
        const auto put = [&](Column column, std::uint32_t count) {
            item->setText(column, countText(count));
            item->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
            item->setData(column, kShareRole, count / faces);
        };
        put(kBefore, outcome.before[at]);
        put(kAfter, outcome.after[at]);
    }
    const int rows = m_levels->topLevelItemCount();
    const int row = rows > 0 ? m_levels->visualItemRect(m_levels->topLevelItem(0)).height() : 0;
    m_levels->setFixedHeight(m_levels->header()->sizeHint().height() +
                             rows * std::max(row, fontMetrics().height() + 4) +
                             2 * m_levels->frameWidth());
}

} // namespace trixel::ui
