// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspector/mip_panel.h"

#include <QBoxLayout>
#include <QButtonGroup>
#include <QCheckBox>
#include <QEvent>
#include <QHeaderView>
#include <QLabel>
#include <QPainter>
#include <QRadioButton>
#include <QSplitter>
#include <QTableView>

#include "ui/docks/steady_label.h"
#include "ui/inspector/difference_legend.h"
#include "ui/inspector/mip_model.h"
#include "ui/inspector/mip_text.h"

#include <algorithm>
#include <utility>

namespace trixel::ui {

namespace {

constexpr int kSpace = 6;
constexpr int kMargin = 8;
/// Choices share one line from here on.
constexpr int kWideEnough = 560;
/// So much wider than high, the table stands beside the pictures.
constexpr double kBroad = 1.6;
constexpr int kTableWidth = 470;
constexpr int kTableHeight = 150;

void makeChoice(
    QButtonGroup& group, QBoxLayout& row, int id, const QString& text, const QString& toolTip)
{
    auto* button = new QRadioButton(text);
    button->setToolTip(toolTip);
    button->setAccessibleName(QString(text).remove('&'));
    group.addButton(button, id);
    row.addWidget(button);
}

QBoxLayout* makeRow()
{
    auto* row = new QHBoxLayout;
    row->setSpacing(kSpace);
    return row;
}

} // namespace

MipPanel::MipPanel(Document& document,
                   Inspection& inspection,
                   const ViewSettings& settings,
                   QWidget* parent)
    : QWidget(parent)
    , m_focus(document, inspection)
    , m_model(new MipModel(m_focus, this))
    , m_view(new MipView(m_focus, settings))
    , m_table(new QTableView)
    , m_splitter(new QSplitter(Qt::Vertical))
    , m_legend(new DifferenceLegend)
    , m_texel(new QLabel)
    , m_caption(new QLabel)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(kMargin, kMargin, kMargin, kMargin);
    column->setSpacing(kSpace);
    makeChoices(*column);
    makeTable();
    m_splitter->setChildrenCollapsible(false);
    m_splitter->addWidget(m_view);
    m_splitter->addWidget(m_table);
    m_splitter->setStretchFactor(0, 1);
    m_splitter->setStretchFactor(1, 0);
    column->addWidget(m_splitter, 1);
    column->addWidget(m_legend);
    m_texel->setAccessibleName(tr("The texel looked at"));
    m_texel->setToolTip(tr("The texel of the chosen level, and what it is the mean of"));
    m_texel->setWordWrap(true);
    m_texel->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_texelRoom = new SteadyLabel(
        m_texel, tr("Face 1234567, level 10, texel (1023, 1023) upper   ■ averaged into   ■ mean"));
    column->addWidget(m_texelRoom);
    column->addWidget(m_caption);
    m_caption->setAccessibleName(tr("What is shown"));
    m_caption->setToolTip(tr("How this reduction makes a coarser texel"));
    m_caption->setWordWrap(true);
    connect(&m_focus, &MipFocus::faceChanged, this, &MipPanel::showFace);
    connect(&m_focus, &MipFocus::texelChanged, this, &MipPanel::showTexel);
    showOptions();
    showFace();
}

void MipPanel::makeChoices(QBoxLayout& column)
{
    auto* choices = new QWidget;
    choices->setMinimumWidth(1); // on one line they would keep the panel from getting narrow
    m_choices = new QVBoxLayout(choices);
    m_choices->setContentsMargins(0, 0, 0, 0);
    m_choices->setSpacing(kSpace);
    QBoxLayout* contents = makeRow();
    m_content = new QButtonGroup(this);
    makeChoice(*m_content,
               *contents,
               static_cast<int>(MipContent::Right),
               tr("&Right"),
               tr("Levels as they are: every texel the mean of the four it covers"));
    makeChoice(*m_content,
               *contents,
               static_cast<int>(MipContent::Box),
               tr("2×2 &box"),
               tr("Levels as an image's reduction of the packed square would make them"));
    makeChoice(*m_content,
               *contents,
               static_cast<int>(MipContent::Difference),
               tr("&Difference"),
               tr("What the 2×2 box gets wrong"));
    contents->addStretch(1);
    QBoxLayout* forms = makeRow();
    m_texels = new QButtonGroup(this);
    makeChoice(*m_texels,
               *forms,
               static_cast<int>(FaceLayout::Texels::Triangles),
               tr("&Triangles"),
               tr("Texels as they lie on the face"));
    makeChoice(*m_texels,
               *forms,
               static_cast<int>(FaceLayout::Texels::Pixels),
               tr("Pac&ked"),
               tr("Texels as pixels of the square that a file stores: upper ones beyond the "
                  "diagonal"));
    m_trueSize = new QCheckBox(tr("True si&ze"));
    m_trueSize->setAccessibleName(tr("Levels in true size"));
    m_trueSize->setToolTip(tr("Draw each level half as wide as the finer one, all texels alike"));
    forms->addWidget(m_trueSize);
    forms->addStretch(1);
    m_choices->addLayout(contents);
    m_choices->addLayout(forms);
    column.addWidget(choices);
    connect(m_content, &QButtonGroup::idClicked, this, [this](int id) {
        MipOptions next = options();
        next.content = static_cast<MipContent>(id);
        setOptions(next);
    });
    connect(m_texels, &QButtonGroup::idClicked, this, [this](int id) {
        MipOptions next = options();
        next.arrangement.texels = static_cast<FaceLayout::Texels>(id);
        setOptions(next);
    });
    connect(m_trueSize, &QCheckBox::toggled, this, [this](bool on) {
        MipOptions next = options();
        next.arrangement.trueSize = on;
        setOptions(next);
    });
}

void MipPanel::makeTable()
{
    m_table->setModel(m_model);
    m_table->setAccessibleName(tr("Levels in numbers"));
    m_table->setToolTip(tr("Choose the level whose texel counts"));
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setAlternatingRowColors(true);
    m_table->setShowGrid(false);
    m_table->setWordWrap(false);
    m_table->setTabKeyNavigation(false);
    m_table->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_table->setMinimumHeight(kTableHeight / 2);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    m_table->verticalHeader()->setDefaultSectionSize(fontMetrics().lineSpacing() + 4);
    QHeaderView* header = m_table->horizontalHeader();
    header->setHighlightSections(false);
    header->setMinimumSectionSize(36);
    // As wide as what they hold may be: numbers that change must not move columns.
    const std::pair<int, QString> widths[] = {{MipModel::LevelNumber, "12 · 4096 × 4096"},
                                              {MipModel::Kept, "computed"},
                                              {MipModel::Memory, "16.8 MB"},
                                              {MipModel::File, "16.8 MB"},
                                              {MipModel::Right, "255  255  255"},
                                              {MipModel::Box, "255  255  255"},
                                              {MipModel::Difference, "-255  +255  +255"},
                                              {MipModel::Parts, "+255.0"},
                                              {MipModel::Worst, "+255.0"},
                                              {MipModel::Rms, "+255.0"},
                                              {MipModel::Texels, "16,777,216"}};
    for (const auto& [column, widest] : widths) {
        const QString title =
            m_model->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString();
        const int wide = std::max(fontMetrics().horizontalAdvance(widest),
                                  fontMetrics().horizontalAdvance(title));
        header->resizeSection(column, wide + 14);
    }
    connect(m_table->selectionModel(),
            &QItemSelectionModel::currentRowChanged,
            this,
            [this](const QModelIndex& current) {
                if (!m_isFollowing && current.isValid()) {
                    m_focus.choose(m_model->levelAt(current.row()));
                }
            });
}

void MipPanel::setOptions(const MipOptions& options)
{
    if (!(options == this->options())) {
        m_view->setOptions(options);
        showOptions();
        emit optionsChanged();
    }
}

void MipPanel::showOptions()
{
    const MipOptions& options = this->options();
    m_content->button(static_cast<int>(options.content))->setChecked(true);
    m_texels->button(static_cast<int>(options.arrangement.texels))->setChecked(true);
    m_trueSize->setChecked(options.arrangement.trueSize);
    m_legend->setVisible(options.content == MipContent::Difference);
    const auto captionOf = [](MipContent content) {
        switch (content) {
        case MipContent::Right:
            return tr("A coarser texel is the mean of the four it covers: three as it lies and, "
                      "between them, one turned over.");
        case MipContent::Box:
            return tr(
                "An image's reduction takes 2×2 pixels of the packed square. Off its diagonal "
                "one of them lies beside the texel, and the one in its middle is left out.");
        case MipContent::Difference:
            break;
        }
        return tr("The 2×2 box less the right mean: it errs wherever a texel from beside differs "
                  "from the one in the middle, and errors grow from level to level.");
    };
    m_caption->setText(captionOf(options.content));
}

void MipPanel::showFace()
{
    const bool hasFace = m_focus.face().has_value();
    m_table->setVisible(hasFace);
    m_texelRoom->setVisible(hasFace);
    m_legend->setRange(m_focus.levels() != nullptr ? m_focus.levels()->worstDifference() : 0);
    showTexel();
}

void MipPanel::showTexel()
{
    if (!m_focus.face()) {
        return;
    }
    const Level level = m_focus.level();
    const int row = m_model->rowOf(level);
    if (m_table->currentIndex().row() != row && row < m_model->rowCount()) {
        m_isFollowing = true;
        m_table->setCurrentIndex(
            m_model->index(row, std::max(0, m_table->currentIndex().column())));
        m_isFollowing = false;
    }
    const QString key = "<font color='%1'>■</font> %2";
    QStringList parts{texelWords()};
    if (level.log2() > 0) {
        parts += key.arg("#d8a800", tr("averaged into"));
    }
    if (level < m_focus.base()) {
        parts += key.arg("#2a9fe0", tr("mean of"));
    }
    m_texel->setText(parts.join(" &nbsp; "));
    m_view->setAccessibleDescription(parts.front());
}

QString MipPanel::texelWords() const
{
    const Level level = m_focus.level();
    return tr("Face %1, %2, texel %3")
        .arg(indexOf(*m_focus.face()))
        .arg(levelText(level).toLower(), texelText(m_focus.texel(level)));
}

QString MipPanel::pictureName() const
{
    return "mips";
}

QSize MipPanel::pictureSize() const
{
    constexpr QSize kLeast(560, 200);
    if (!m_focus.face()) {
        return {};
    }
    const int rows = 2 * fontMetrics().lineSpacing() + m_legend->sizeHint().height();
    return m_view->size().expandedTo(kLeast) + QSize(0, rows + 4 * kMargin);
}

bool MipPanel::isVectorPicture() const
{
    return false; // texels are pictures
}

/// On white, as paper is: what is shown, the levels, and what the colours mean.
void MipPanel::paintPicture(QPainter& painter, QSize size)
{
    if (!m_focus.face()) {
        return;
    }
    const MipInk ink{Qt::black, QColor(90, 90, 90), QColor(200, 200, 200), font()};
    const double line = fontMetrics().lineSpacing();
    painter.fillRect(QRect(QPoint(), size), Qt::white);
    painter.setFont(ink.font);
    QRectF row(kMargin, kMargin, size.width() - 2 * kMargin, line);
    const QString contents[] = {tr("right reduction"), tr("2×2 box"), tr("2×2 box less right")};
    painter.setPen(ink.text);
    painter.drawText(
        row, Qt::AlignLeft, texelWords() + " – " + contents[static_cast<int>(options().content)]);
    row.translate(0, line + kMargin);
    paintKeys(painter, row);
    const bool hasLegend = options().content == MipContent::Difference;
    const double legend = hasLegend ? m_legend->sizeHint().height() + kMargin : 0;
    const double top = row.bottom() + kMargin;
    painter.save();
    painter.translate(0, top);
    m_view->paintOnto(
        painter,
        QSizeF(size.width(), size.height() - top - legend),
        ink,
        std::clamp(
            painter.worldTransform().m11() * painter.device()->devicePixelRatioF(), 1.0, 4.0));
    painter.restore();
    if (hasLegend) {
        m_legend->paint(painter,
                        QRectF(kMargin, size.height() - legend, row.width(), legend - kMargin),
                        ink.text);
    }
}

void MipPanel::paintKeys(QPainter& painter, const QRectF& row) const
{
    const std::pair<QColor, QString> keys[] = {{kItselfLight, tr("the texel")},
                                               {kParentLight, tr("averaged into")},
                                               {kChildLight, tr("mean of")}};
    const double side = row.height() * 0.6;
    double left = row.left();
    for (const auto& [color, words] : keys) {
        painter.setPen(Qt::black);
        painter.setBrush(color);
        painter.drawRect(QRectF(left, row.center().y() - side / 2, side, side));
        left += side + kSpace;
        painter.drawText(QRectF(left, row.top(), row.right() - left, row.height()), words);
        left += QFontMetricsF(font()).horizontalAdvance(words) + 3 * kSpace;
    }
}

void MipPanel::arrange()
{
    const bool wide = width() >= kWideEnough;
    m_choices->setDirection(wide ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    const bool beside = width() > kBroad * height();
    const Qt::Orientation orientation = beside ? Qt::Horizontal : Qt::Vertical;
    if (m_splitter->orientation() != orientation || !m_isArranged) {
        m_isArranged = true;
        m_splitter->setOrientation(orientation);
        const int whole = beside ? width() : height();
        const int table = beside ? std::min(kTableWidth, whole * 2 / 5) : kTableHeight;
        m_splitter->setSizes({whole - table, table});
    }
}

void MipPanel::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    arrange();
}

void MipPanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    m_focus.setActive(true);
}

void MipPanel::hideEvent(QHideEvent* event)
{
    QWidget::hideEvent(event);
    m_focus.setActive(false);
}

void MipPanel::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) {
        m_view->update();
    }
}

} // namespace trixel::ui
