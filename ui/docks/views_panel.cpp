// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/views_panel.h"

#include <QGridLayout>
#include <QHeaderView>
#include <QItemSelectionModel>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QStyledItemDelegate>
#include <QTreeView>
#include <QVBoxLayout>

#include "core/mesh/surface.h"
#include "ui/docks/camera_files.h"
#include "ui/docks/value_row.h"
#include "ui/docks/views_model.h"
#include "ui/document/document.h"
#include "ui/document/view_bookmarks.h"
#include "ui/viewport/viewport.h"

#include <glm/geometric.hpp>
#include <limits>

namespace trixel::ui {

namespace {

/// World units from a point to the nearest of the surface.
double distanceTo(const Surface& surface, glm::dvec3 point)
{
    const auto nearest =
        surface.bvh().closestPoint(glm::vec3(point), std::numeric_limits<float>::infinity());
    return nearest ? glm::length(glm::dvec3(nearest->position) - point) : 0;
}

/// Every view no closer than the present one, with a picture like its.
DistantViews asFarAs(const ViewCamera& view, const Surface& surface)
{
    DistantViews distant;
    const double distance = distanceTo(surface, view.position);
    // From within the surface: any view at all would be beyond nothing.
    distant.distance = distance > 0 ? distance : glm::length(view.target - view.position);
    distant.fovY = view.fovY;
    distant.width = view.width;
    distant.height = view.height;
    return distant;
}

/// Rows with room for the field in which a name is edited.
class RoomyRows : public QStyledItemDelegate
{
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override
    {
        constexpr int kRoom = 6;
        return QStyledItemDelegate::sizeHint(option, index) + QSize(0, kRoom);
    }
};

} // namespace

ViewsPanel::ViewsPanel(Document& document,
                       BackgroundJobs& jobs,
                       const Viewport& viewport,
                       QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_viewport(viewport)
    , m_files(new CameraFiles(document, jobs, *this))
    , m_model(new ViewsModel(document, this))
    , m_list(new QTreeView)
    , m_empty(new QLabel)
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(6);
    m_empty->setWordWrap(true);
    m_empty->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    makeList();
    layout->addWidget(m_empty, 1);
    layout->addWidget(m_list, 1);
    layout->addWidget(makeDistance());
    layout->addWidget(makeButtons());

    connect(&document, &Document::opened, this, &ViewsPanel::showState);
    connect(&document.bookmarks(), &ViewBookmarks::changed, this, &ViewsPanel::showState);
    connect(m_list->selectionModel(),
            &QItemSelectionModel::currentChanged,
            this,
            &ViewsPanel::showState);
    showState();
}

void ViewsPanel::makeList()
{
    m_list->setModel(m_model);
    m_list->setItemDelegate(new RoomyRows(m_list));
    m_list->setAccessibleName(tr("Bookmarked views"));
    m_list->setToolTip(
        tr("Double click or Enter goes to a view, F2 renames it, Delete removes it"));
    m_list->setRootIsDecorated(false);
    m_list->setUniformRowHeights(true);
    m_list->setAlternatingRowColors(true);
    m_list->setSelectionMode(QAbstractItemView::SingleSelection);
    m_list->setEditTriggers(QAbstractItemView::EditKeyPressed);
    m_list->setAllColumnsShowFocus(true);
    QHeaderView* header = m_list->header();
    header->setStretchLastSection(false);
    header->setSectionResizeMode(ViewsModel::Name, QHeaderView::Stretch);
    header->setSectionResizeMode(ViewsModel::Picture, QHeaderView::ResizeToContents);
    m_list->installEventFilter(this);
    connect(m_list, &QTreeView::activated, this, [this](const QModelIndex& index) {
        goTo(index.row());
    });
}

QWidget* ViewsPanel::makeDistance()
{
    m_distanceRow = new QWidget;
    auto* row = new QHBoxLayout(m_distanceRow);
    row->setContentsMargins(0, 0, 0, 0);
    auto* label = new QLabel(tr("&Distance"));
    m_distance = new ScaledSpinBox(Scale::Logarithmic);
    m_distance->setRange(1e-30, 1e30);
    m_distance->setKeyboardTracking(false);
    m_distance->setAccessibleName(tr("Least distance from the surface"));
    m_distance->setToolTip(tr("The views stand at least so many world units from the surface"));
    label->setBuddy(m_distance);
    m_inDiagonals = new QLabel;
    m_inDiagonals->setToolTip(tr("The diagonal of the box around the model"));
    row->addWidget(label);
    row->addWidget(m_distance, 1);
    row->addWidget(m_inDiagonals);
    connect(m_distance, &QDoubleSpinBox::editingFinished, this, &ViewsPanel::setDistance);
    connect(m_distance, &QDoubleSpinBox::valueChanged, this, &ViewsPanel::showDistance);
    return m_distanceRow;
}

QPushButton* ViewsPanel::addButton(const QString& text, const QString& name, const QString& toolTip)
{
    auto* button = new QPushButton(text);
    button->setAccessibleName(name);
    button->setToolTip(toolTip);
    return button;
}

QWidget* ViewsPanel::makeButtons()
{
    m_bookmark = addButton(
        tr("Book&mark"), tr("Bookmark the view"), tr("Keep what the view shows now (Ctrl+B)"));
    m_addDistant = addButton(tr("Any view be&yond"),
                             tr("Add any view beyond a distance"),
                             tr("Add every view that is no closer to the surface than this one"));
    m_update = addButton(tr("&Update"),
                         tr("Update the chosen view"),
                         tr("Give the chosen view the camera of what is shown now"));
    m_remove =
        addButton(tr("&Remove"), tr("Remove the chosen view"), tr("Remove the chosen view (Del)"));
    m_load =
        addButton(tr("&Load…"), tr("Load cameras"), tr("Add the views of a cameras file (JSON)"));
    m_save = addButton(tr("&Save…"), tr("Save cameras"), tr("Write the views to a cameras file"));
    connect(m_bookmark, &QPushButton::clicked, this, &ViewsPanel::bookmark);
    connect(m_addDistant, &QPushButton::clicked, this, &ViewsPanel::addDistant);
    connect(m_update, &QPushButton::clicked, this, &ViewsPanel::update);
    connect(m_remove, &QPushButton::clicked, this, &ViewsPanel::remove);
    connect(m_load, &QPushButton::clicked, m_files, &CameraFiles::askForLoad);
    connect(m_save, &QPushButton::clicked, m_files, &CameraFiles::askForSave);

    auto* whole = new QWidget;
    auto* grid = new QGridLayout(whole);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(6);
    int place = 0;
    for (QPushButton* button : {m_bookmark, m_addDistant, m_update, m_remove, m_load, m_save}) {
        grid->addWidget(button, place / 2, place % 2);
        ++place;
    }
    return whole;
}

/// F2 and Delete mean the list while it has the keyboard, whatever they mean to the window.
bool ViewsPanel::eventFilter(QObject* watched, QEvent* event)
{
    const bool overrides = event->type() == QEvent::ShortcutOverride;
    if (watched == m_list && (overrides || event->type() == QEvent::KeyPress)) {
        const auto* key = static_cast<QKeyEvent*>(event);
        const bool plain = key->modifiers() == Qt::NoModifier;
        if (overrides && plain && (key->key() == Qt::Key_F2 || key->key() == Qt::Key_Delete)) {
            event->accept();
            return true;
        }
        if (!overrides && plain && key->key() == Qt::Key_Delete) {
            remove();
            return true;
        }
        if (!overrides && plain && key->key() == Qt::Key_F2 && current() >= 0) {
            m_list->edit(m_model->index(current(), ViewsModel::Name));
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

int ViewsPanel::current() const
{
    const QModelIndex index = m_list->currentIndex();
    return index.isValid() ? index.row() : -1;
}

void ViewsPanel::choose(int view)
{
    m_list->setCurrentIndex(m_model->index(view, ViewsModel::Name));
}

void ViewsPanel::bookmark()
{
    if (m_document.isOpen() && m_document.bookmarks().add(m_viewport.view())) {
        choose(static_cast<int>(m_document.bookmarks().views().cameras.size()) - 1);
    }
}

void ViewsPanel::addDistant()
{
    if (m_document.isOpen() &&
        m_document.bookmarks().addDistant(asFarAs(m_viewport.view(), *m_document.surface()))) {
        choose(m_document.bookmarks().count() - 1);
    }
}

void ViewsPanel::goTo(int view)
{
    const ViewBookmarks& bookmarks = m_document.bookmarks();
    if (view < 0 || view >= bookmarks.count()) {
        return;
    }
    choose(view);
    if (bookmarks.isDistant(view)) {
        m_distance->setFocus();
        m_distance->selectAll();
    } else {
        emit viewChosen(bookmarks.views().cameras[static_cast<std::size_t>(view)]);
    }
}

void ViewsPanel::update()
{
    const int view = current();
    if (view < 0) {
        return;
    }
    const ViewCamera now = m_viewport.view();
    if (m_document.bookmarks().isDistant(view)) {
        m_document.bookmarks().update(view, asFarAs(now, *m_document.surface()));
    } else {
        m_document.bookmarks().update(view, now);
    }
}

void ViewsPanel::remove()
{
    if (current() >= 0) {
        m_document.bookmarks().remove(current());
    }
}

void ViewsPanel::setDistance()
{
    const int view = current();
    ViewBookmarks& bookmarks = m_document.bookmarks();
    if (view < 0 || !bookmarks.isDistant(view)) {
        return;
    }
    const std::size_t number = static_cast<std::size_t>(view) - bookmarks.views().cameras.size();
    DistantViews views = bookmarks.views().distant[number];
    // What is shown is rounded: only a number that the user changed takes its place.
    if (m_distance->text() != m_distance->textFromValue(views.distance)) {
        views.distance = m_distance->value();
        bookmarks.update(view, views);
    }
}

/// In the unit that is easier to judge.
void ViewsPanel::showDistance(double distance)
{
    const double diagonal = m_document.isOpen() ? m_document.surface()->size() : 0;
    m_inDiagonals->setText(
        diagonal > 0 ? tr("%1 diagonals").arg(QString::number(distance / diagonal, 'g', 3))
                     : QString());
}

void ViewsPanel::showState()
{
    const ViewBookmarks& bookmarks = m_document.bookmarks();
    const bool open = m_document.isOpen();
    const int view = current();
    m_empty->setText(open ? tr("No views yet: look at the model as it will be seen and press "
                               "Ctrl+B, or load a cameras file.")
                          : tr("No mesh is open."));
    m_empty->setVisible(bookmarks.isEmpty());
    m_list->setVisible(!bookmarks.isEmpty());
    m_bookmark->setEnabled(open);
    m_addDistant->setEnabled(open);
    m_load->setEnabled(open);
    m_update->setEnabled(view >= 0);
    m_remove->setEnabled(view >= 0);
    m_save->setEnabled(!bookmarks.isEmpty());
    const bool distant = view >= 0 && view < bookmarks.count() && bookmarks.isDistant(view);
    m_distanceRow->setVisible(distant);
    if (distant) {
        const std::size_t number =
            static_cast<std::size_t>(view) - bookmarks.views().cameras.size();
        m_distance->setValue(bookmarks.views().distant[number].distance);
        showDistance(m_distance->value());
    }
}

} // namespace trixel::ui
