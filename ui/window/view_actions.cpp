// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/view_actions.h"

#include <QActionGroup>
#include <QComboBox>
#include <QLabel>
#include <QMenu>
#include <QSignalBlocker>
#include <QToolBar>

#include "ui/document/document.h"
#include "ui/viewport/surface_lines.h"
#include "ui/viewport/viewport.h"
#include "ui/window/actions.h"
#include "ui/window/mnemonics.h"

#include <algorithm>

namespace trixel::ui {

namespace {

/// To choose from, pixels.
constexpr double kLimitErrors[] = {0.25, 0.5, 1, 2, 4};

} // namespace

ViewActions::ViewActions(const Document& document,
                         ViewSettings& settings,
                         Viewport& viewport,
                         QWidget& window)
    : QObject(&window)
    , m_document(document)
    , m_settings(settings)
    , m_window(window)
    , m_viewport(viewport)
{
    ActionMaker make(window);
    m_frame = make(tr("&Frame"), tr("Look at the faces under the pointer"), {Qt::Key_F}, "frame");
    m_frameAll = make(tr("Frame All"), tr("Look at the whole surface"), {Qt::Key_A}, "frame-all");
    connect(m_frame, &QAction::triggered, &viewport, &Viewport::frameHovered);
    connect(m_frameAll, &QAction::triggered, &viewport, &Viewport::frameAll);

    addSwitch(tr("Lit"),
              tr("Shade the surface by a light; off shows the texels' own colours"),
              {Qt::Key_U},
              "lit",
              &ViewOptions::lit);
    addSwitch(tr("&Wireframe"),
              tr("Draw the edges of the faces"),
              {Qt::Key_W},
              "wireframe",
              &ViewOptions::wireframe);
    addSwitch(tr("&Texel Grid"),
              tr("Draw the edges of the texels"),
              {Qt::Key_T},
              "texel-grid",
              &ViewOptions::texelGrid);
    addSwitch(
        tr("F&ootprint"),
        tr("Draw the pixel under the pointer and the ellipse that it averages, %1 times larger")
            .arg(kFootprintMagnification),
        {Qt::Key_O},
        "footprint",
        &ViewOptions::footprint);
    addSwitch(tr("Frame Fig&ures"),
              tr("Show what each frame took and drew, and what lies on the graphics card"),
              QKeySequence(Qt::CTRL | Qt::Key_U),
              {},
              &ViewOptions::hud);
    makeLimit(viewport);
    makeMips();
    connect(&settings, &ViewSettings::viewChanged, this, &ViewActions::follow);
    connect(&document, &Document::opened, this, [this] { listMips(0); });
    connect(
        &document, &Document::levelsChanged, this, [this] { listMips(m_settings.view().mipDrop); });
    listMips(0);
}

QAction* ViewActions::addSwitch(const QString& text,
                                const QString& toolTip,
                                const QKeySequence& shortcut,
                                const QString& iconName,
                                bool ViewOptions::*option)
{
    QAction* action = ActionMaker(m_window).toggle(text, toolTip, shortcut, iconName);
    m_switches.emplace_back(action, option);
    connect(action, &QAction::toggled, this, [this, option](bool on) {
        ViewOptions view = m_settings.view();
        view.*option = on;
        m_settings.setView(view);
    });
    return action;
}

void ViewActions::makeLimit(Viewport& viewport)
{
    m_limit = addSwitch(tr("Limit Surface"), {}, {Qt::Key_L}, {}, &ViewOptions::limitSurface);
    auto* errors = new QActionGroup(this);
    Mnemonics taken;
    const QString text = tr("Limit Surface within %1 Pixels");
    for (const double error : kLimitErrors) {
        QAction* action = ActionMaker(m_window).toggle(
            withMnemonic(text.arg(error), taken, text.indexOf('%')),
            tr("Cut the limit surface into as few triangles as keep it within %1 pixels")
                .arg(error));
        errors->addAction(action);
        m_limitErrors.emplace_back(action, error);
        connect(action, &QAction::triggered, this, [this, error] {
            ViewOptions view = m_settings.view();
            view.limitError = error;
            m_settings.setView(view);
        });
    }
    m_creases = ActionMaker(m_window)(
        tr("Creases by Angle…"),
        tr("Choose which folded edges the limit surface keeps sharp; kept with the project"),
        QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_L));
    connect(m_creases, &QAction::triggered, &viewport, &Viewport::askForCreases);
    connect(&viewport, &Viewport::limitSurfaceRefusalChanged, this, [this] {
        if (!m_viewport.limitSurfaceRefusal().isEmpty()) {
            ViewOptions view = m_settings.view();
            view.limitSurface = false;
            m_settings.setView(view);
        }
        follow();
    });
}

void ViewActions::followLimit()
{
    const QString refusal = m_viewport.limitSurfaceRefusal();
    const QString what =
        refusal.isEmpty()
            ? tr("Show the smooth surface that the mesh is the cage of, and paint on it")
            : tr("Not for this mesh: %1").arg(refusal);
    m_limit->setToolTip(QStringLiteral("%1 (%2)").arg(
        what, m_limit->shortcut().toString(QKeySequence::NativeText)));
    m_limit->setStatusTip(what);
    m_limit->setEnabled(refusal.isEmpty());
    m_creases->setEnabled(refusal.isEmpty() && m_document.isOpen());
    for (const auto& [action, error] : m_limitErrors) {
        action->setChecked(m_settings.view().limitError == error);
        action->setEnabled(refusal.isEmpty());
    }
}

void ViewActions::makeMips()
{
    ActionMaker make(m_window);
    m_coarser =
        make(tr("&Coarser Mip Level"), tr("Show every face one level coarser"), {Qt::Key_PageDown});
    m_finer = make(tr("F&iner Mip Level"), tr("Show every face one level finer"), {Qt::Key_PageUp});
    connect(m_coarser, &QAction::triggered, this, [this] {
        setMipDrop(m_settings.view().mipDrop + 1);
    });
    connect(
        m_finer, &QAction::triggered, this, [this] { setMipDrop(m_settings.view().mipDrop - 1); });
    m_mips = new QComboBox(&m_window);
    m_mips->setAccessibleName(tr("Mip level"));
    m_mips->setToolTip(
        tr("How many levels coarser every face is shown (Page Down coarser, Page Up finer)"));
    m_mips->setFocusPolicy(Qt::TabFocus);
    connect(m_mips, &QComboBox::activated, this, &ViewActions::setMipDrop);
}

/// Three commands, of which one is chosen.
void ViewActions::listMips(int drop)
{
    // The finest level decides how many steps change anything.
    int most = 0;
    for (std::size_t k = 0; k < m_document.texels().faceCount(); ++k) {
        most = std::max(most, m_document.texels().face(faceId(k)).level().log2());
    }
    const QSignalBlocker quiet(m_mips);
    m_mips->clear();
    for (int mip = 0; mip <= most; ++mip) {
        m_mips->addItem(mip == 0 ? tr("Full resolution") : tr("Mip %1 of %2").arg(mip).arg(most));
    }
    setMipDrop(drop);
    follow();
}

void ViewActions::setMipDrop(int drop)
{
    ViewOptions view = m_settings.view();
    view.mipDrop = std::clamp(drop, 0, m_mips->count() - 1);
    m_settings.setView(view);
}

void ViewActions::follow()
{
    for (const auto& [action, option] : m_switches) {
        action->setChecked(m_settings.view().*option);
    }
    followLimit();
    const int drop = m_settings.view().mipDrop;
    m_mips->setCurrentIndex(drop);
    m_mips->setEnabled(m_document.isOpen());
    m_coarser->setEnabled(drop + 1 < m_mips->count());
    m_finer->setEnabled(drop > 0);
    m_frame->setEnabled(m_document.isOpen());
    m_frameAll->setEnabled(m_document.isOpen());
}

void ViewActions::fillMenu(QMenu& menu)
{
    menu.addAction(m_frame);
    menu.addAction(m_frameAll);
    menu.addSeparator();
    for (const auto& [action, option] : m_switches) {
        menu.addAction(action);
    }
    QMenu* errors = menu.addMenu(tr("&Limit Surface Error"));
    for (const auto& [action, error] : m_limitErrors) {
        errors->addAction(action);
    }
    menu.addAction(m_creases);
    menu.addSeparator();
    menu.addAction(m_coarser);
    menu.addAction(m_finer);
}

void ViewActions::fillToolBar(QToolBar& bar)
{
    bar.addAction(m_frameAll);
    bar.addSeparator();
    for (const auto& [action, option] : m_switches) {
        if (!action->icon().isNull()) { // the bar has those that are switched often
            bar.addAction(action);
        }
    }
    bar.addSeparator();
    bar.addWidget(m_mips);
}

} // namespace trixel::ui
