// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/texel_reading.h"

#include <utility>

namespace trixel::ui {

void TexelReading::want(const TexelStore& store, FaceId face, int levelsDropped)
{
    if (m_shown.has(store, face, levelsDropped) || !m_jobs.isIdle()) {
        return;
    }
    using Made = std::optional<ShownTexels::Reduced>;
    m_jobs.run(
        QString(),
        [format = store.format(), face, texels = store.face(face), levelsDropped](
            Progress& /*progress*/) -> Result<Made> {
            return ShownTexels::prepare(format, face, texels, levelsDropped);
        },
        [this, number = m_number](Result<Made> made) {
            if (!made) {
                return; // want of memory: tried again when the pointer moves
            }
            if (*made && number == m_number) {
                m_shown.keep(std::move(**made));
            }
            emit read();
        });
}

void TexelReading::forget()
{
    ++m_number;
    m_shown.forget();
}

} // namespace trixel::ui
