// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/filtering_words.h"

#include <QCoreApplication>

#include "core/base/check.h"

namespace trixel::ui {

namespace {

struct Words
{
    const char* title;
    const char* about;
};

Words wordsOf(render::Filtering filtering)
{
    switch (filtering) {
    case render::Filtering::Texels:
        return {QT_TRANSLATE_NOOP("Filtering", "Texels"),
                QT_TRANSLATE_NOOP("Filtering", "Show the texel under each pixel, with its edges")};
    case render::Filtering::LowerHalf:
        return {QT_TRANSLATE_NOOP("Filtering", "Lower half"),
                QT_TRANSLATE_NOOP("Filtering",
                                  "Show the lower texels alone, as programs do that take a face's "
                                  "square for a picture: half of what was painted is never seen")};
    case render::Filtering::PackedAtlas:
        return {QT_TRANSLATE_NOOP("Filtering", "Packed atlas"),
                QT_TRANSLATE_NOOP("Filtering",
                                  "Let the hardware interpolate in the packed squares: across the "
                                  "diagonal and at most edges it mixes texels that are no "
                                  "neighbours")};
    case render::Filtering::Seamless:
        return {QT_TRANSLATE_NOOP("Filtering", "Seamless"),
                QT_TRANSLATE_NOOP("Filtering",
                                  "Interpolate between averages at the corners of texels, at two "
                                  "levels: no edge shows, whatever the levels on its sides")};
    case render::Filtering::Anisotropic:
        return {QT_TRANSLATE_NOOP("Filtering", "Anisotropic"),
                QT_TRANSLATE_NOOP("Filtering",
                                  "As Seamless, at several places along each pixel's footprint: "
                                  "sharper where the surface turns away")};
    }
    checkFailed("a way of filtering", CallPlace::current());
}

} // namespace

QString filteringTitle(render::Filtering filtering)
{
    return QCoreApplication::translate("Filtering", wordsOf(filtering).title);
}

QString filteringAbout(render::Filtering filtering)
{
    return QCoreApplication::translate("Filtering", wordsOf(filtering).about);
}

} // namespace trixel::ui
