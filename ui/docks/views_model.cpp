// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/views_model.h"

#include <QFont>

#include "ui/document/document.h"
#include "ui/document/view_bookmarks.h"

#include <algorithm>

namespace trixel::ui {

namespace {

QString number(double value)
{
    return QString::number(value, 'g', 3);
}

QString pointText(const glm::dvec3& point)
{
    return QString("%1, %2, %3").arg(number(point.x), number(point.y), number(point.z));
}

/// In world units, and in the unit that is easier to judge.
QString distanceText(double distance, double diagonal)
{
    return diagonal > 0 ? ViewsModel::tr("%1 (%2 diagonals)")
                              .arg(number(distance), number(distance / diagonal))
                        : number(distance);
}

QString lensText(double fovY, int width, int height)
{
    return ViewsModel::tr("%1 × %2, %3°").arg(width).arg(height).arg(number(fovY));
}

std::string nameOf(const std::variant<ViewCamera, DistantViews>& view)
{
    return std::visit([](const auto& one) { return one.name; }, view);
}

QString pictureText(const ViewCamera& camera)
{
    return lensText(camera.fovY, camera.width, camera.height);
}

QString pictureText(const DistantViews& views)
{
    return ViewsModel::tr("any beyond %1").arg(number(views.distance));
}

QString explanation(const ViewCamera& camera, double /*diagonal*/)
{
    return ViewsModel::tr("From %1 towards %2: %3 × %4 pixels, %5° high")
        .arg(pointText(camera.position), pointText(camera.target))
        .arg(camera.width)
        .arg(camera.height)
        .arg(number(camera.fovY));
}

QString explanation(const DistantViews& views, double diagonal)
{
    return ViewsModel::tr("Every view at least %1 away from the surface: %2 × %3 pixels, %4° high")
        .arg(distanceText(views.distance, diagonal))
        .arg(views.width)
        .arg(views.height)
        .arg(number(views.fovY));
}

} // namespace

ViewsModel::ViewsModel(Document& document, QObject* parent)
    : QAbstractTableModel(parent)
    , m_document(document)
{
    connect(&document.bookmarks(), &ViewBookmarks::changed, this, &ViewsModel::follow);
    follow();
}

void ViewsModel::follow()
{
    const SceneViews& views = m_document.bookmarks().views();
    std::vector<View> next(views.cameras.begin(), views.cameras.end());
    next.insert(next.end(), views.distant.begin(), views.distant.end());

    const std::size_t shorter = std::min(m_views.size(), next.size());
    std::size_t first = 0;
    while (first < shorter && m_views[first] == next[first]) {
        ++first;
    }
    std::size_t same = 0; // at the end
    while (same < shorter - first &&
           m_views[m_views.size() - 1 - same] == next[next.size() - 1 - same]) {
        ++same;
    }
    const int begin = static_cast<int>(first);
    const int oldEnd = static_cast<int>(m_views.size() - same);
    const int newEnd = static_cast<int>(next.size() - same);
    const int changedEnd = std::min(oldEnd, newEnd);
    if (newEnd < oldEnd) {
        beginRemoveRows({}, newEnd, oldEnd - 1);
        m_views.erase(m_views.begin() + newEnd, m_views.begin() + oldEnd);
        endRemoveRows();
    } else if (oldEnd < newEnd) {
        beginInsertRows({}, oldEnd, newEnd - 1);
        m_views.insert(m_views.begin() + oldEnd, next.begin() + oldEnd, next.begin() + newEnd);
        endInsertRows();
    }
    if (begin < changedEnd) {
        m_views = std::move(next);
        emit dataChanged(index(begin, 0), index(changedEnd - 1, ColumnCount - 1));
    }
}

int ViewsModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_views.size());
}

int ViewsModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant ViewsModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) {
        return {};
    }
    const View& view = m_views[static_cast<std::size_t>(index.row())];
    const double diagonal = m_document.isOpen() ? m_document.surface()->size() : 0;
    if (role == Qt::ToolTipRole) {
        return std::visit([&](const auto& one) { return explanation(one, diagonal); }, view);
    }
    if (role != Qt::DisplayRole && role != Qt::EditRole) {
        return {};
    }
    return index.column() == Name
               ? QString::fromStdString(nameOf(view))
               : std::visit([&](const auto& one) { return pictureText(one); }, view);
}

QVariant ViewsModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) {
        return {};
    }
    return section == Name ? tr("View") : tr("Picture");
}

Qt::ItemFlags ViewsModel::flags(const QModelIndex& index) const
{
    const Qt::ItemFlags common = QAbstractTableModel::flags(index);
    return index.isValid() && index.column() == Name ? common | Qt::ItemIsEditable : common;
}

bool ViewsModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
    if (role != Qt::EditRole || index.column() != Name ||
        !checkIndex(index, CheckIndexOption::IndexIsValid)) {
        return false;
    }
    m_document.bookmarks().rename(index.row(), value.toString());
    return true;
}

} // namespace trixel::ui
