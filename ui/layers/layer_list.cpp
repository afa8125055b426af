// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/layers/layer_list.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPainter>
#include <QStyledItemDelegate>

#include "ui/layers/layer_commands.h"
#include "ui/layers/layer_model.h"
#include "ui/window/icons.h"

#include <algorithm>
#include <utility>

namespace trixel::ui {

namespace {

constexpr int kEyeSize = 16;
constexpr int kEyeWidth = 28;
constexpr int kRowRoom = 12; ///< above and below the text together: easy to hit and to drag
constexpr int kGap = 8;

QRect eyeIn(const QRect& row)
{
    return {row.left(), row.top(), kEyeWidth, row.height()};
}

QRect nameIn(const QRect& row)
{
    return row.adjusted(kEyeWidth, 0, -kGap, 0);
}

class LayerDelegate : public QStyledItemDelegate
{
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override
    {
        const QString name = index.data().toString();
        return {kEyeWidth + option.fontMetrics.horizontalAdvance(name) + kGap,
                option.fontMetrics.height() + kRowRoom};
    }

    void paint(QPainter* painter,
               const QStyleOptionViewItem& option,
               const QModelIndex& index) const override
    {
        QStyleOptionViewItem item = option;
        initStyleOption(&item, index);
        const QStyle& style = *item.widget->style();
        style.drawPrimitive(QStyle::PE_PanelItemViewItem, &item, painter, item.widget);
        const QVariant eye = index.data(Qt::CheckStateRole);
        const bool isHidden = eye.isValid() && eye.toInt() == Qt::Unchecked;
        const bool isSelected = (item.state & QStyle::State_Selected) != 0;
        if (eye.isValid()) {
            QRect place(0, 0, kEyeSize, kEyeSize);
            place.moveCenter(eyeIn(item.rect).center());
            icon(isHidden ? "eye-off" : "eye")
                .paint(painter,
                       place,
                       Qt::AlignCenter,
                       isSelected ? QIcon::Selected
                       : isHidden ? QIcon::Disabled
                                  : QIcon::Normal);
        }
        QColor color = item.palette.color(QPalette::Active,
                                          isSelected ? QPalette::HighlightedText : QPalette::Text);
        if (isHidden && !isSelected) {
            color = item.palette.color(QPalette::Disabled, QPalette::Text);
        }
        painter->save();
        painter->setPen(color);
        paintTexts(*painter, item, index);
        painter->restore();
    }

    QWidget* createEditor(QWidget* parent,
                          const QStyleOptionViewItem& option,
                          const QModelIndex& index) const override
    {
        QWidget* editor = QStyledItemDelegate::createEditor(parent, option, index);
        if (auto* line = qobject_cast<QLineEdit*>(editor)) {
            line->setMaxLength(LayerCommands::kLongestName);
            line->setAccessibleName(LayerList::tr("Name of the layer"));
            line->setToolTip(LayerList::tr("Enter takes the name, Esc leaves it as it was"));
        }
        return editor;
    }

    void updateEditorGeometry(QWidget* editor,
                              const QStyleOptionViewItem& option,
                              const QModelIndex& /*index*/) const override
    {
        editor->setGeometry(nameIn(option.rect).adjusted(-3, 1, 0, -1));
    }

private:
    /// The hint at the right, the name in what it leaves, half at least.
    static void
    paintTexts(QPainter& painter, const QStyleOptionViewItem& item, const QModelIndex& index)
    {
        const QRect room = nameIn(item.rect);
        const QFontMetrics metrics(item.font);
        const QString hint = metrics.elidedText(
            index.data(LayerModel::Hint).toString(), Qt::ElideRight, room.width() / 2);
        const int taken = hint.isEmpty() ? 0 : metrics.horizontalAdvance(hint) + kGap;
        const QString name =
            metrics.elidedText(index.data().toString(), Qt::ElideRight, room.width() - taken);
        painter.setFont(item.font);
        painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter, name);
        painter.setOpacity(0.75);
        painter.drawText(room, Qt::AlignRight | Qt::AlignVCenter, hint);
    }
};

} // namespace

LayerList::LayerList(QWidget* parent)
    : QListView(parent)
{
    setItemDelegate(new LayerDelegate(this));
    setAccessibleName(tr("Layers"));
    setToolTip(tr("Click chooses the layer to paint on, the eye shows and hides, double click or "
                  "F2 renames, dragging moves"));
    setSelectionMode(SingleSelection);
    setEditTriggers(EditKeyPressed | DoubleClicked);
    setDragDropMode(InternalMove);
    setDefaultDropAction(Qt::MoveAction);
    setDropIndicatorShown(true);
    setUniformItemSizes(true);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollMode(ScrollPerPixel);
}

QRect LayerList::eyeRect(const QModelIndex& index) const
{
    return eyeIn(visualRect(index));
}

int LayerList::rowHeight() const
{
    return fontMetrics().height() + kRowRoom;
}

/// F2 and Delete mean the list while it has the keyboard, whatever they mean to the window.
bool LayerList::event(QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (key->modifiers() == Qt::NoModifier &&
            (key->key() == Qt::Key_F2 || key->key() == Qt::Key_Delete)) {
            event->accept();
            return true;
        }
    }
    return QListView::event(event);
}

void LayerList::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Delete && event->modifiers() == Qt::NoModifier) {
        emit deleteWanted();
    } else if (event->key() == Qt::Key_F2) {
        if ((currentIndex().flags() & Qt::ItemIsEditable) != 0) {
            edit(currentIndex());
        }
    } else {
        QListView::keyPressEvent(event);
    }
}

bool LayerList::toggleEye(const QMouseEvent& event)
{
    const QModelIndex index = indexAt(event.position().toPoint());
    const QVariant eye = index.data(Qt::CheckStateRole);
    if (event.button() != Qt::LeftButton || !eye.isValid() ||
        !eyeRect(index).contains(event.position().toPoint())) {
        return false;
    }
    const bool isShown = eye.toInt() == Qt::Checked;
    model()->setData(index, isShown ? Qt::Unchecked : Qt::Checked, Qt::CheckStateRole);
    return true;
}

void LayerList::mousePressEvent(QMouseEvent* event)
{
    m_isOnEye = toggleEye(*event);
    if (!m_isOnEye) {
        QListView::mousePressEvent(event);
    }
}

void LayerList::mouseMoveEvent(QMouseEvent* event)
{
    if (!m_isOnEye) {
        QListView::mouseMoveEvent(event);
    }
}

void LayerList::mouseReleaseEvent(QMouseEvent* event)
{
    if (!std::exchange(m_isOnEye, false)) {
        QListView::mouseReleaseEvent(event);
    }
}

/// Two quick clicks on an eye are two clicks.
void LayerList::mouseDoubleClickEvent(QMouseEvent* event)
{
    m_isOnEye = toggleEye(*event);
    if (!m_isOnEye) {
        QListView::mouseDoubleClickEvent(event);
    }
}

} // namespace trixel::ui
