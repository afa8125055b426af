// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/mip_actions.h"

#include <QActionGroup>
#include <QDockWidget>
#include <QMenu>

#include "ui/inspector/mip_panel.h"
#include "ui/window/actions.h"

namespace trixel::ui {

MipActions::MipActions(MipPanel& panel, QDockWidget& dock, QWidget& window)
    : QObject(&window)
    , m_panel(panel)
    , m_dock(dock)
{
    makeContents(window);
    makeArrangements(window);
    connect(&panel, &MipPanel::optionsChanged, this, &MipActions::follow);
    follow();
}

void MipActions::makeContents(QWidget& window)
{
    const ActionMaker make(window);
    m_contents = {
        make.toggle(tr("&Right Reduction"),
                    tr("Show levels as they are: each texel the mean of the four it "
                       "covers")),
        make.toggle(tr("2×2 &Box"), tr("Show levels as an image's reduction would make them")),
        make.toggle(tr("&Difference of Both"),
                    tr("Show what the 2×2 box gets wrong in every level"))};
    auto* group = new QActionGroup(this);
    for (int k = 0; k < m_contents.size(); ++k) {
        group->addAction(m_contents[k]);
        connect(m_contents[k], &QAction::triggered, this, [this, k] {
            MipOptions options = m_panel.options();
            options.content = static_cast<MipContent>(k);
            show(options);
        });
    }
}

void MipActions::makeArrangements(QWidget& window)
{
    const ActionMaker make(window);
    m_texels = {make.toggle(tr("As &Triangles"), tr("Show texels as they lie on the face")),
                make.toggle(tr("As Pac&ked Squares"),
                            tr("Show texels as pixels of the square that a file stores"))};
    auto* group = new QActionGroup(this);
    for (int k = 0; k < m_texels.size(); ++k) {
        group->addAction(m_texels[k]);
        connect(m_texels[k], &QAction::triggered, this, [this, k] {
            MipOptions options = m_panel.options();
            options.arrangement.texels = static_cast<FaceLayout::Texels>(k);
            show(options);
        });
    }
    m_trueSize = make.toggle(tr("In True Si&ze"),
                             tr("Draw each level half as wide as the finer one, texels alike"));
    connect(m_trueSize, &QAction::triggered, this, [this](bool on) {
        MipOptions options = m_panel.options();
        options.arrangement.trueSize = on;
        show(options);
    });
}

void MipActions::fillMenu(QMenu& menu)
{
    QMenu* mips = menu.addMenu(tr("Mips of the Fac&e"));
    mips->addActions(m_contents);
    mips->addSeparator();
    mips->addActions(m_texels);
    mips->addSeparator();
    mips->addAction(m_trueSize);
}

void MipActions::show(const MipOptions& options)
{
    m_panel.setOptions(options);
    m_dock.show();
    m_dock.raise();
}

void MipActions::follow()
{
    const MipOptions& options = m_panel.options();
    m_contents[static_cast<int>(options.content)]->setChecked(true);
    m_texels[static_cast<int>(options.arrangement.texels)]->setChecked(true);
    m_trueSize->setChecked(options.arrangement.trueSize);
}

} // namespace trixel::ui
