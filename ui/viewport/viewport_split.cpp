// SPDX-License-Identifier: GPL-3.0-or-later
//
// A view split in two: what its right part shows.
#include "ui/viewport/viewport_private.h"

#include <utility>

namespace trixel::ui {

void Viewport::rememberBefore()
{
    d->texelsBefore = d->document.texels();
    d->otherSideDirty = true;
    d->redraw();
}

SplitBar& Viewport::splitBar()
{
    return *d->splitBar;
}

bool Viewport::Private::hasOtherTexels() const
{
    return comparison.by == ComparedBy::Level || comparison.by == ComparedBy::Before;
}

void Viewport::Private::takeComparison()
{
    const Comparison was = std::exchange(comparison, settings.comparison());
    if (was.by != comparison.by || was.levelsDropped != comparison.levelsDropped) {
        otherSideDirty = true;
    }
    redraw();
}

/// The texels that B shows: the document's, coarser, or those before.
const TexelStore& Viewport::Private::otherSideTexels() const
{
    return comparison.by == ComparedBy::Before ? texelsBefore : texels();
}

/// Of B: another store, or another drop. What B no longer shows is given up.
void Viewport::Private::prepareOtherSide()
{
    if (!std::exchange(otherSideDirty, false)) {
        return;
    }
    if (hasOtherTexels()) {
        const int more = comparison.by == ComparedBy::Level ? comparison.levelsDropped : 0;
        renderer->setTexels(otherSideTexels(), shownView.mipDrop + more, render::Side::B);
    } else {
        renderer->clearOtherTexels();
    }
}

std::optional<render::Split> Viewport::Private::split() const
{
    if (!comparison.isOn()) {
        return std::nullopt;
    }
    render::Split split;
    split.column = static_cast<int>(comparison.split * camera.viewport().x);
    split.ownTexels = hasOtherTexels();
    split.ownPicture = true;
    if (comparison.by == ComparedBy::Filtering) {
        split.otherFiltering = comparison.filtering;
    }
    return split;
}

} // namespace trixel::ui
