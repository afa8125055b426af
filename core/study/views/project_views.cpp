// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/views/project_views.h"

#include "core/io/project_metadata.h"
#include "core/io/ptx_metadata.h"

#include <string>
#include <utility>

namespace trixel {

namespace {

/// Far more than `kMostProjectViews` take; a longer text is not worth the time to parse it.
constexpr std::size_t kLongestText = std::size_t{2} << 20U;

std::size_t countOf(const SceneViews& views)
{
    return views.cameras.size() + views.distant.size();
}

} // namespace

Result<SceneViews> viewsOf(const Project& project)
{
    const PtxMetadata* item = findMetadata(project.metadata, kViewsKey);
    if (item == nullptr) {
        return SceneViews();
    }
    const std::string place = std::string("metadata ") + kViewsKey;
    const auto* text = std::get_if<std::string>(&item->value);
    if (text == nullptr) {
        return contentsError(place + ": expected a text, found numbers");
    }
    if (text->size() > kLongestText) {
        return contentsError(place + ": expected at most " + std::to_string(kLongestText) +
                             " bytes, found " + std::to_string(text->size()));
    }
    auto views = parseCameras(*text);
    if (!views) {
        return prefixed(place, views.error());
    }
    if (countOf(*views) > kMostProjectViews) {
        return contentsError(place + ": expected at most " + std::to_string(kMostProjectViews) +
                             " views, found " + std::to_string(countOf(*views)));
    }
    return views;
}

void keepViews(Project& project, const SceneViews& views)
{
    check(countOf(views) <= kMostProjectViews, "a project keeps no more than so many views");
    if (views.isEmpty()) {
        removeMetadata(project.metadata, kViewsKey);
    } else {
        putMetadata(project.metadata, {kViewsKey, writeCameras(views)});
    }
}

} // namespace trixel
