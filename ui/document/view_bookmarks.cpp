// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/view_bookmarks.h"

#include <QSet>

#include "core/base/check.h"
#include "core/study/views/project_views.h"
#include "ui/document/document.h"

#include <algorithm>
#include <utility>

namespace trixel::ui {

namespace {

/// One line of bounded length, as a name is shown and kept.
std::string usableName(const std::string& name)
{
    return QString::fromStdString(name)
        .simplified()
        .left(ViewBookmarks::kLongestName)
        .trimmed()
        .toStdString();
}

void makeNamesUsable(SceneViews& views)
{
    for (ViewCamera& camera : views.cameras) {
        camera.name = usableName(camera.name);
    }
    for (DistantViews& distant : views.distant) {
        distant.name = usableName(distant.name);
    }
}

std::size_t total(const SceneViews& views)
{
    return views.cameras.size() + views.distant.size();
}

/// The name of a view of `views`, which may be const.
template <class Views>
auto& nameIn(Views& views, int index)
{
    const auto at = static_cast<std::size_t>(index);
    check(index >= 0 && at < total(views), "the view exists");
    return at < views.cameras.size() ? views.cameras[at].name
                                     : views.distant[at - views.cameras.size()].name;
}

Status validateAll(const SceneViews& views)
{
    for (const ViewCamera& camera : views.cameras) {
        if (Status valid = validate(camera); !valid) {
            return valid;
        }
    }
    for (const DistantViews& distant : views.distant) {
        if (Status valid = validate(distant); !valid) {
            return valid;
        }
    }
    return {};
}

} // namespace

ViewBookmarks::ViewBookmarks(Document& document)
    : QObject(&document)
    , m_document(document)
{
}

int ViewBookmarks::count() const
{
    return static_cast<int>(total(m_views));
}

bool ViewBookmarks::isDistant(int index) const
{
    return index >= static_cast<int>(m_views.cameras.size());
}

QString ViewBookmarks::name(int index) const
{
    return QString::fromStdString(nameIn(m_views, index));
}

QString ViewBookmarks::freeName(const QString& pattern) const
{
    QSet<QString> taken;
    for (int k = 0; k < count(); ++k) {
        taken += name(k);
    }
    int number = 1;
    while (taken.contains(pattern.arg(number))) {
        ++number;
    }
    return pattern.arg(number);
}

bool ViewBookmarks::add(ViewCamera camera)
{
    camera.name = usableName(camera.name);
    if (camera.name.empty()) {
        camera.name = freeName(tr("View %1")).toStdString();
    }
    SceneViews next = m_views;
    next.cameras.push_back(camera);
    return change(std::move(next), tr("Bookmark %1").arg(QString::fromStdString(camera.name)));
}

bool ViewBookmarks::addDistant(DistantViews views)
{
    views.name = usableName(views.name);
    if (views.name.empty()) {
        views.name = freeName(tr("Any view %1")).toStdString();
    }
    SceneViews next = m_views;
    next.distant.push_back(views);
    return change(std::move(next), tr("Bookmark %1").arg(QString::fromStdString(views.name)));
}

bool ViewBookmarks::addAll(SceneViews more)
{
    makeNamesUsable(more);
    SceneViews next = m_views;
    const auto addNew = [](auto& list, const auto& others) {
        for (const auto& other : others) {
            if (std::ranges::find(list, other) == list.end()) {
                list.push_back(other);
            }
        }
    };
    addNew(next.cameras, more.cameras);
    addNew(next.distant, more.distant);
    const int added = static_cast<int>(total(next) - total(m_views));
    return change(std::move(next), added == 1 ? tr("Add 1 view") : tr("Add %1 views").arg(added));
}

bool ViewBookmarks::replaceAll(SceneViews views)
{
    return change(std::move(views), tr("Replace views"));
}

void ViewBookmarks::rename(int index, const QString& name)
{
    SceneViews next = m_views;
    const std::string usable = usableName(name.toStdString());
    if (!usable.empty()) {
        nameIn(next, index) = usable;
        change(std::move(next), tr("Rename to %1").arg(QString::fromStdString(usable)));
    }
}

bool ViewBookmarks::update(int index, ViewCamera camera)
{
    check(!isDistant(index), "the view is a camera");
    camera.name = nameIn(m_views, index);
    SceneViews next = m_views;
    next.cameras[static_cast<std::size_t>(index)] = std::move(camera);
    return change(std::move(next), tr("Change %1").arg(name(index)));
}

bool ViewBookmarks::update(int index, DistantViews views)
{
    check(isDistant(index), "the views are distant");
    views.name = nameIn(m_views, index);
    SceneViews next = m_views;
    next.distant[static_cast<std::size_t>(index) - next.cameras.size()] = std::move(views);
    return change(std::move(next), tr("Change %1").arg(name(index)));
}

void ViewBookmarks::remove(int index)
{
    const QString text = tr("Remove %1").arg(name(index));
    SceneViews next = m_views;
    if (isDistant(index)) {
        next.distant.erase(next.distant.begin() + index -
                           static_cast<std::ptrdiff_t>(next.cameras.size()));
    } else {
        next.cameras.erase(next.cameras.begin() + index);
    }
    change(std::move(next), text);
}

void ViewBookmarks::take(SceneViews views)
{
    makeNamesUsable(views);
    if (m_views != views) {
        m_views = std::move(views);
        emit changed();
    }
}

/// Nothing is done, but all is well, when `next` is what there is.
bool ViewBookmarks::change(SceneViews next, const QString& text)
{
    makeNamesUsable(next);
    const auto refuse = [&](const QString& why) {
        emit m_document.notice(tr("%1: %2").arg(text, why));
        return false;
    };
    if (!m_document.isOpen()) {
        return refuse(tr("no mesh is open."));
    }
    if (const Status valid = validateAll(next); !valid) {
        return refuse(QString::fromStdString(valid.error().message) + '.');
    }
    if (total(next) > kMostProjectViews) {
        return refuse(tr("a project keeps at most %1 views, these would be %2.")
                          .arg(kMostProjectViews)
                          .arg(total(next)));
    }
    if (next != m_views) {
        m_document.pushViews(std::move(next), text);
    }
    return true;
}

} // namespace trixel::ui
