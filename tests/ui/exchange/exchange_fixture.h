// SPDX-License-Identifier: GPL-3.0-or-later
//
// Files beside the open project, and a dialog to type their names into.
#pragma once

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include "core/io/project.h"
#include "tests/ui/window/window_fixture.h"

#include <algorithm>
#include <array>

namespace trixel::ui {

/// Each face of a colour of its own, one of them varied.
inline void paintFaces(TexelStore& texels)
{
    for (std::uint32_t k = 0; k < texels.faceCount(); ++k) {
        const std::array<std::byte, 3> color{
            static_cast<std::byte>(2 * k), std::byte{100}, std::byte{50}};
        texels.exchange(faceId(k), FaceTexels::constant(texels.face(faceId(k)).level(), color));
    }
    texels.writable(FaceId{3})[7] = std::byte{255};
}

class ExchangeTest : public WindowTest
{
protected:
    void openPainted()
    {
        Project project = gridProject();
        paintFaces(project.texels);
        m_window->document().open(std::move(project), {}, "grid");
        m_window->viewport().setFocus();
    }
    /// Writes a project as a .ptx that carries its mesh.
    QString writePtx(const QString& name, const Project& project) const
    {
        NoProgress progress;
        const Status written = exportPtx(path(name).toStdString(), project, {}, progress);
        check(written.has_value(), "the .ptx is written");
        return path(name);
    }
    /// Types into the field of a dialog that has the keyboard.
    static void type(QLineEdit& field, const QString& text)
    {
        field.setFocus();
        field.selectAll();
        QTest::keyClicks(&field, text);
    }
    static QString textOf(const QWidget& parent, const QString& name)
    {
        const auto* label = widgetNamed<QLabel>(parent, name);
        return label != nullptr ? label->text() : QString();
    }
};

} // namespace trixel::ui
