// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/mark_table.h"

#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QPainter>
#include <QToolButton>

#include "core/lattice/texel.h"
#include "core/texture/texel_search.h"
#include "ui/document/document.h"
#include "ui/document/inspection.h"
#include "ui/look/look_words.h"
#include "ui/look/mark_brush.h"
#include "ui/look/value_survey.h"
#include "ui/viewport/view_settings.h"

#include <algorithm>

namespace trixel::ui {

namespace {

constexpr QSize kSwatch(26, 16);

QPixmap swatchOf(render::Mark mark)
{
    QPixmap picture(kSwatch);
    QPainter painter(&picture);
    painter.setBrush(markBrush(mark));
    painter.setPen(QColor(0x50, 0x50, 0x50));
    painter.drawRect(0, 0, kSwatch.width() - 1, kSwatch.height() - 1);
    return picture;
}

bool isFloating(TexelType type)
{
    return type == TexelType::Half || type == TexelType::Float;
}

/// Whether texels of a type can deserve a mark at all.
bool isPossible(TexelType type, render::Mark mark)
{
    return mark == render::Mark::Clipped || isFloating(type);
}

/// Finite values and infinite ones alike.
std::uint64_t countOf(const ValueHistogram& histogram, render::Mark mark, float most)
{
    switch (mark) {
    case render::Mark::NotANumber:
        return histogram.summary().notANumber;
    case render::Mark::Infinite:
        return histogram.summary().infinite;
    case render::Mark::Negative:
        return histogram.summary().negative;
    case render::Mark::Clipped:
        return histogram.above(most);
    case render::Mark::None:
        break;
    }
    return 0;
}

TexelTest testFor(const TexelFormat& format, const render::Look& look, render::Mark mark)
{
    return [format, rule = render::LookRule::of(format, look), mark](
               std::span<const float> values) -> std::optional<std::size_t> {
        const std::size_t channels = format.channels;
        for (std::size_t k = 0; k < values.size() / channels; ++k) {
            if (render::deserves(rule, values.subspan(k * channels, channels), mark)) {
                return k;
            }
        }
        return std::nullopt;
    };
}

} // namespace

MarkTable::MarkTable(const Document& document,
                     const ViewSettings& settings,
                     const ValueSurvey& survey,
                     Inspection& inspection,
                     QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_settings(settings)
    , m_survey(survey)
    , m_inspection(inspection)
    , m_message(new QLabel)
{
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(3);
    grid->setColumnStretch(2, 1);
    for (std::size_t k = 0; k < m_rows.size(); ++k) {
        addRow(*grid, static_cast<int>(k), render::kMarks[k]);
    }
    m_message->setWordWrap(true);
    m_message->hide();
    grid->addWidget(m_message, static_cast<int>(m_rows.size()), 0, 1, 4);
    connect(&document, &Document::opened, this, [this] {
        if (m_job != nullptr) {
            m_job->cancel();
        }
        m_message->hide();
    });
    showCounts();
}

void MarkTable::addRow(QGridLayout& grid, int row, render::Mark mark)
{
    Row& cells = m_rows[static_cast<std::size_t>(row)];
    cells.mark = mark;
    cells.swatch = new QLabel;
    cells.swatch->setPixmap(swatchOf(mark));
    cells.name = new QLabel(markName(mark));
    cells.counts = new QLabel;
    cells.counts->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    cells.counts->setTextInteractionFlags(Qt::TextSelectableByMouse);
    cells.counts->setMinimumWidth(20);
    cells.next = new QToolButton;
    cells.next->setText(tr("Next"));
    cells.next->setAccessibleName(tr("Next texel: %1").arg(markName(mark)));
    cells.next->setToolTip(
        tr("Hold the next texel that has such a value, and bring it into sight; after the last "
           "comes the first"));
    grid.addWidget(cells.swatch, row, 0);
    grid.addWidget(cells.name, row, 1);
    grid.addWidget(cells.counts, row, 2);
    grid.addWidget(cells.next, row, 3);
    connect(cells.next, &QToolButton::clicked, this, [this, mark] { goToNext(mark); });
}

/// "12 R · 3 B", "none", or empty while it is not known.
QString MarkTable::countsOf(render::Mark mark, std::uint64_t& sum, bool& isKnown) const
{
    const TexelFormat& format = m_document.texels().format();
    const render::Look& look = m_settings.look();
    const float most = render::LookRule::of(format, look).most;
    const std::vector<TexelNumber> numbers = numbersMarked(format, look);
    QStringList words;
    sum = 0;
    isKnown = true;
    for (const TexelNumber& number : numbers) {
        const auto histogram = m_survey.histogram(number);
        if (!histogram) {
            isKnown = false;
            continue;
        }
        const bool isOpacity = numbers.size() > 1 && format.alpha == number.channel;
        const float limit = isOpacity ? 1.0F : most;
        const std::uint64_t count = countOf(*histogram, mark, limit);
        sum += count;
        if (count > 0) {
            const bool isClose = mark == render::Mark::Clipped && !histogram->isExactAbove(limit);
            QString word =
                (isClose ? "≈ " : "") + QLocale().toString(static_cast<qulonglong>(count));
            if (numbers.size() > 1) {
                word += " " + channelLetter(format, number.channel);
            }
            words += word;
        }
    }
    return isKnown && words.isEmpty() ? tr("none") : words.join(" · ");
}

void MarkTable::showCounts()
{
    setEnabled(m_document.isOpen());
    if (!m_document.isOpen()) {
        return;
    }
    const TexelFormat& format = m_document.texels().format();
    for (const Row& row : m_rows) {
        const bool isShown = isPossible(format.type, row.mark);
        for (QWidget* cell : {static_cast<QWidget*>(row.swatch),
                              static_cast<QWidget*>(row.name),
                              static_cast<QWidget*>(row.counts),
                              static_cast<QWidget*>(row.next)}) {
            cell->setVisible(isShown);
        }
        std::uint64_t sum = 0;
        bool isKnown = false;
        const QString counts = countsOf(row.mark, sum, isKnown);
        row.counts->setText(isKnown ? counts : tr("…"));
        row.counts->setEnabled(m_survey.isCurrent());
        row.counts->setToolTip(tr("Values in all texels: %1").arg(counts));
        const QString meaning = markMeaning(row.mark, m_settings.look());
        row.name->setToolTip(meaning);
        row.swatch->setToolTip(meaning);
        row.next->setEnabled(sum > 0 || !isKnown || !m_survey.isCurrent());
    }
}

QString MarkTable::message() const
{
    return m_message->isHidden() ? QString() : m_message->text();
}

void MarkTable::goToNext(render::Mark mark)
{
    if (!m_document.isOpen() || m_job != nullptr) {
        return;
    }
    const TexelStore& store = m_document.texels();
    std::optional<TexelSpot> after;
    if (m_inspection.isHeld()) {
        const InspectedTexel& held = *m_inspection.texel();
        const Level level = store.face(held.place.face).level();
        // At a coarser level shown, the texel that holds the same point.
        const TexelCoord texel = m_inspection.levelsDropped() == 0
                                     ? held.place.texel
                                     : texelAt(level, glm::dvec2(held.uv));
        after = TexelSpot{held.place.face, texelIndex(level, texel)};
    }
    m_message->hide();
    m_job = &m_jobs.run(
        QString(),
        [store, after, test = testFor(store.format(), m_settings.look(), mark)](
            Progress& progress) { return nextTexel(store, after, test, progress); },
        [this, mark](const Result<std::optional<TexelSpot>>& found) {
            m_job = nullptr;
            if (found && *found) {
                hold((*found)->face, (*found)->index);
            } else if (found) {
                m_message->setText(tr("No texel is so: %1").arg(markName(mark)));
                m_message->show();
            }
        });
}

void MarkTable::hold(FaceId face, TexelIndex index)
{
    if (!m_document.isOpen() || indexOf(face) >= m_document.texels().faceCount()) {
        return;
    }
    const Level level = m_document.texels().face(face).level();
    if (indexOf(index) >= level.texelCount()) {
        return; // its level is another by now
    }
    const glm::dvec2 uv = centroid(level, texelAt(level, index));
    const QString address =
        QString("%1@%2,%3").arg(indexOf(face)).arg(uv.x, 0, 'g', 9).arg(uv.y, 0, 'g', 9);
    if (const Status gone = m_inspection.goTo(address.toStdString()); !gone) {
        m_message->setText(QString::fromStdString(gone.error().message));
        m_message->show();
    }
}

} // namespace trixel::ui
