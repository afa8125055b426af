// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "ui/document/background_job.h"
#include "ui/viewport/hovered_texel.h"

namespace trixel::ui {

/// Has texels looked at that are not there at once read on another thread, one face after the
/// other: of whichever is wanted when the one before is done.
class TexelReading : public QObject
{
    Q_OBJECT

public:
    /// What is there of them.
    ShownTexels& shown() { return m_shown; }

    /// Begins to read what `shown` is short of for texels of a face, unless something is being read
    /// already. Works on a copy of the face.
    void want(const TexelStore& store, FaceId face, int levelsDropped);
    /// To be called when texels changed.
    void forget();

signals:
    void read(); ///< what is wanted now may be asked for again

private:
    ShownTexels m_shown;
    int m_number = 0; ///< of what the texels are; what was made of others is not kept
    BackgroundJobs m_jobs;
};

} // namespace trixel::ui
