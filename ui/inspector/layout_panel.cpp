// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspector/layout_panel.h"

#include <QAction>
#include <QLabel>
#include <QPainter>
#include <QResizeEvent>
#include <QSettings>
#include <QSplitter>
#include <QStackedLayout>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/document/document.h"
#include "ui/document/face_selection.h"
#include "ui/inspector/net_filter.h"
#include "ui/viewport/split_bar.h"
#include "ui/viewport/view_settings.h"
#include "ui/window/icons.h"

#include <algorithm>
#include <utility>

namespace trixel::ui {

namespace {

constexpr int kIconSize = 18;
constexpr int kBelowSplit = 24; // the footer
constexpr std::array kKinds{LayoutKind::Net, LayoutKind::Packed, LayoutKind::Rectilinear};
constexpr std::array kViewKeys{"net", "packed", "rectilinear"};

QPalette paper()
{
    QPalette palette;
    palette.setColor(QPalette::Window, Qt::white);
    palette.setColor(QPalette::Base, Qt::white);
    palette.setColor(QPalette::Text, QColor(0x1d1d1d));
    palette.setColor(QPalette::PlaceholderText, QColor(0x5a5a5a));
    return palette;
}

} // namespace

LayoutPanel::LayoutPanel(const Document& document,
                         ViewSettings& settings,
                         Inspection& inspection,
                         const FaceSelection& selection,
                         QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_settings(settings)
    , m_inspection(inspection)
    , m_faces(document, settings, inspection)
    , m_others(document,
               settings,
               {[this]() -> const TexelStore& {
                    const bool before = m_settings.comparison().by == ComparedBy::Before;
                    return before ? m_before : m_document.texels();
                },
                [this](FaceId face) { return otherLevel(face); }})
{
    auto* hint = new QLabel(tr("Point at a face in the view to see its texels laid out"));
    hint->setAlignment(Qt::AlignCenter);
    hint->setWordWrap(true);
    hint->setMargin(12);
    m_tools = new QToolBar;
    m_tools->setIconSize({kIconSize, kIconSize});
    m_tools->setAccessibleName(tr("What the layout shows"));
    m_splitter = new QSplitter;
    m_splitter->setChildrenCollapsible(false);
    makeViews({document, settings, inspection, selection, m_faces, m_others});
    makeSwitches();

    auto* shown = new QWidget;
    auto* column = new QVBoxLayout(shown);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_tools);
    column->addWidget(m_splitter, 1);
    m_pages = new QStackedLayout(this);
    m_pages->addWidget(hint);
    m_pages->addWidget(shown);
    restore();

    connect(&inspection, &Inspection::changed, this, &LayoutPanel::takeInspection);
    connect(&selection, &FaceSelection::changed, this, &LayoutPanel::refreshViews);
    connect(&m_faces, &ShownFaces::changed, this, &LayoutPanel::refreshViews);
    connect(&m_others, &ShownFaces::changed, this, &LayoutPanel::refreshViews);
    connect(&settings, &ViewSettings::comparisonChanged, this, &LayoutPanel::takeSettings);
    connect(&settings, &ViewSettings::viewChanged, this, &LayoutPanel::takeSettings);
    connect(&document, &Document::opened, this, [this] {
        m_net.reset();
        m_face.reset();
        m_before = m_document.texels();
    });
    LayoutView& net = view(LayoutKind::Net);
    m_split = new SplitBar(settings, &net, kBelowSplit, splitsNet);
    net.installEventFilter(this);
}

LayoutPanel::~LayoutPanel() = default;

void LayoutPanel::useFilters(FilterSceneSource& source)
{
    m_filter = new NetFilter(m_document, m_settings, source, this);
    view(LayoutKind::Net).setFilter(*m_filter);
}

void LayoutPanel::rememberBefore()
{
    m_before = m_document.texels();
    m_others.rest();
    takeSettings();
}

void LayoutPanel::setFaceNumbers(const std::shared_ptr<const FaceNumbers>& numbers)
{
    view(LayoutKind::Net).setNumbers(numbers);
}

/// Of a face as B shows it.
Level LayoutPanel::otherLevel(FaceId face) const
{
    const Comparison& comparison = m_settings.comparison();
    const bool before = comparison.by == ComparedBy::Before;
    const int dropped = m_inspection.levelsDropped() +
                        (comparison.by == ComparedBy::Level ? comparison.levelsDropped : 0);
    const Level own = (before ? m_before : m_document.texels()).face(face).level();
    return own.coarser(std::min(dropped, own.log2()));
}

/// What the other side of the split line shows of the net.
void LayoutPanel::showOther()
{
    const bool hasOther =
        m_net && m_settings.comparison().by != ComparedBy::Nothing && splitsNet(m_settings);
    view(LayoutKind::Net)
        .setOther(hasOther ? std::optional(
                                 netScene(*m_net, [this](FaceId face) { return otherLevel(face); }))
                           : std::nullopt);
}

/// Other sides, or another place of the line between them.
void LayoutPanel::takeSettings()
{
    const auto by = std::pair(m_settings.comparison().by, m_settings.comparison().levelsDropped);
    if (std::exchange(m_compared, by) != by) {
        m_others.rest(); // of other texels or levels
    }
    if (!isVisible()) {
        m_isBehind = true;
        return;
    }
    showOther();
    view(LayoutKind::Net).refresh();
}

bool LayoutPanel::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Resize) {
        m_split->place();
    }
    return QWidget::eventFilter(watched, event);
}

void LayoutPanel::makeViews(const LayoutSources& sources)
{
    for (const LayoutKind kind : kKinds) {
        auto* made = new LayoutView(kind, sources);
        made->setObjectName(QString("%1View").arg(kViewKeys[static_cast<std::size_t>(kind)]));
        made->setToolTip(tr("<b>%1</b>: %2.<br>V0, V1, V2 have (u, v) = (0, 0), (1, 0), (0, 1); "
                            "along E0 v is 0, "
                            "along E1 w = 1 − u − v, along E2 u.<br>Drag to move, wheel to zoom, "
                            "click to hold a texel, "
                            "double-click to frame its face. Arrows step, + − zoom, F frames, "
                            "1 shows a texel a pixel, Space holds.")
                             .arg(titleOf(kind), captionOf(kind)));
        m_views[static_cast<std::size_t>(kind)] = made;
        m_splitter->addWidget(made);
        connectView(*made);
    }
}

void LayoutPanel::connectView(LayoutView& from)
{
    LayoutView* own = &from;
    connect(own, &LayoutView::pointedAt, this, [this, own](const TexelPlace& place) {
        say(own, Origin::Pointer, [&] { m_inspection.pointAt(place); });
    });
    connect(own, &LayoutView::pointedAway, this, [this, own] {
        say(own, Origin::Pointer, [&] { m_inspection.pointAway(); });
    });
    connect(own, &LayoutView::chosen, this, [this, own](const TexelPlace& place) {
        say(own, Origin::Choice, [&] {
            const auto& texel = m_inspection.texel();
            const bool again = m_inspection.isHeld() && texel && texel->place == place;
            if (again) {
                m_inspection.letGo();
            } else {
                m_inspection.hold(place);
            }
        });
    });
    connect(own, &LayoutView::framed, this, [this, own](const TexelPlace& place) {
        say(own, Origin::Choice, [&] { m_inspection.hold(place); });
        own->frame();
    });
    connect(own, &LayoutView::stepped, this, [this](Inspection::Step step) {
        say(nullptr, Origin::Choice, [&] { m_inspection.step(step); });
    });
    connect(own, &LayoutView::holdToggled, this, [this, own] {
        say(own, Origin::Choice, [&] {
            if (m_inspection.isHeld()) {
                m_inspection.letGo();
            } else {
                m_inspection.hold();
            }
        });
    });
    connect(own, &LayoutView::letGo, this, [this, own] {
        say(own, Origin::Choice, [&] { m_inspection.letGo(); });
    });
    connect(own, &LayoutView::zoomed, this, [this, own](double factor) {
        for (LayoutView* view : m_views) {
            if (view != own && m_linkZoom->isChecked()) {
                view->zoomBy(factor);
            }
        }
    });
    connect(own, &LayoutView::framedAll, this, &LayoutPanel::frameAll);
}

template <class Act>
void LayoutPanel::say(LayoutView* from, Origin origin, Act act)
{
    m_from = from;
    m_origin = origin;
    act();
    m_from = nullptr;
    m_origin = Origin::Elsewhere;
}

QAction*
LayoutPanel::addSwitch(const QString& iconName, const QString& text, const QString& toolTip)
{
    auto* action = new QAction(icon(iconName), text, this);
    action->setToolTip(toolTip);
    action->setStatusTip(toolTip);
    action->setCheckable(true);
    action->setObjectName(iconName);
    m_tools->addAction(action);
    m_switches += action;
    connect(action, &QAction::triggered, this, &LayoutPanel::remember);
    return action;
}

void LayoutPanel::addMark(const QString& iconName,
                          const QString& text,
                          const QString& toolTip,
                          bool LayoutMarks::*mark)
{
    QAction* action = addSwitch(iconName, text, toolTip);
    m_markSwitches += {action, mark};
    connect(action, &QAction::toggled, this, [this, mark](bool on) {
        LayoutMarks marks = m_marks;
        marks.*mark = on;
        setMarks(marks);
    });
}

void LayoutPanel::addViewSwitch(LayoutKind kind, const QString& iconName)
{
    QAction* action = addSwitch(iconName,
                                tr("Layout: &%1").arg(titleOf(kind)),
                                tr("%1: %2").arg(titleOf(kind), captionOf(kind)));
    action->setChecked(true);
    m_viewSwitches[static_cast<std::size_t>(kind)] = action;
    connect(action, &QAction::toggled, &view(kind), &QWidget::setVisible);
}

void LayoutPanel::makeSwitches()
{
    addViewSwitch(LayoutKind::Net, "layout-net");
    addViewSwitch(LayoutKind::Packed, "layout-packed");
    addViewSwitch(LayoutKind::Rectilinear, "layout-rows");
    m_tools->addSeparator();
    addMark("texel-grid",
            tr("Layout: &Grid"),
            tr("Grid: lines between texels, once they are large enough"),
            &LayoutMarks::grid);
    addMark("mark-tint",
            tr("Layout: &Tint Lower and Upper"),
            tr("Tint: lower texels yellow, upper texels blue"),
            &LayoutMarks::tint);
    addMark("mark-centres",
            tr("Layout: Texel &Centres"),
            tr("Centres: where texels are sampled; in the packed square the triangle that each "
               "pixel stands for, 1/6 texel off so that its centroid meets the pixel's centre"),
            &LayoutMarks::centres);
    addMark("mark-values",
            tr("Layout: &Values"),
            tr("Values: what is stored, one number a channel, in texels that have room"),
            &LayoutMarks::values);
    addMark("mark-indices",
            tr("Layout: &Indices"),
            tr("Indices: a texel's place in the face's storage, row by row of the packed square"),
            &LayoutMarks::indices);
    m_tools->addSeparator();
    m_linkZoom = addSwitch("layout-link",
                           tr("Layout: &Zoom Together"),
                           tr("Zoom all three views together, about the same texel"));
    m_linkZoom->setChecked(true);
    auto* frame = new QAction(icon("frame-all"), tr("Layout: Show &Whole Face"), this);
    frame->setToolTip(tr("Show the whole face in every view (F)"));
    frame->setStatusTip(frame->toolTip());
    m_tools->addAction(frame);
    m_switches += frame;
    connect(frame, &QAction::triggered, this, &LayoutPanel::frameAll);
    for (QToolButton* button : m_tools->findChildren<QToolButton*>()) {
        button->setFocusPolicy(Qt::TabFocus);
        if (const QAction* action = button->defaultAction()) {
            button->setAccessibleName(action->text().remove('&'));
        }
    }
}

void LayoutPanel::setMarks(const LayoutMarks& marks)
{
    m_marks = marks;
    for (const auto& [action, mark] : m_markSwitches) {
        action->setChecked(marks.*mark);
    }
    for (LayoutView* view : m_views) {
        view->setMarks(marks);
    }
}

void LayoutPanel::frameAll()
{
    for (LayoutView* view : m_views) {
        view->frame();
    }
}

void LayoutPanel::complete()
{
    for (LayoutView* view : m_views) {
        if (view->scene()) {
            for (const SceneFace& face : view->scene()->faces) {
                m_faces.complete(face.face);
            }
        }
        view->refresh();
    }
}

void LayoutPanel::takeInspection()
{
    if (!isVisible()) {
        m_isBehind = true;
        return;
    }
    m_isBehind = false;
    const auto& texel = m_inspection.texel();
    m_pages->setCurrentIndex(texel ? 1 : 0);
    if (texel) {
        showTexel(*texel, m_origin);
        return;
    }
    m_net.reset();
    m_face.reset();
    for (LayoutView* view : m_views) {
        view->clear();
    }
}

void LayoutPanel::showTexel(const InspectedTexel& texel, Origin origin)
{
    const FaceId face = texel.place.face;
    const bool isOther = m_face != face;
    m_face = face;
    const bool chosen = origin == Origin::Choice && m_net && m_net->centre.face != face;
    if (!m_net || isOther || chosen) {
        layNetAround(face, origin);
    }
    const auto levelOf = [this](FaceId shown) { return m_faces.level(shown); };
    const LayoutScene net = netScene(*m_net, levelOf);
    LayoutView& netView = view(LayoutKind::Net);
    const bool afresh = !netView.scene() || origin == Origin::Elsewhere;
    netView.setScene(net, afresh ? LayoutView::Follow::GoHome : LayoutView::Follow::Stay);
    for (const LayoutKind kind : {LayoutKind::Packed, LayoutKind::Rectilinear}) {
        view(kind).setScene(faceScene(kind, face, m_faces.level(face)), LayoutView::Follow::GoHome);
    }
    showOther();
    for (LayoutView* view : m_views) {
        view->refreshInspected(view != m_from);
    }
}

/// The net stays under a pointer of the panel's own; a face that is chosen in it stays in place.
void LayoutPanel::layNetAround(FaceId face, Origin origin)
{
    const Surface& surface = *m_document.surface();
    if (m_net && origin != Origin::Elsewhere) {
        if (m_net->centre.face == face) {
            return;
        }
        for (const auto& laid : m_net->across) {
            if (laid && laid->face == face) {
                if (origin == Origin::Choice) {
                    m_net = layNet(surface.mesh(), surface.adjacency(), LaidFace(*laid));
                }
                return;
            }
        }
    }
    m_net = layNet(surface.mesh(), surface.adjacency(), face);
}

void LayoutPanel::refreshViews()
{
    if (!isVisible()) {
        m_isBehind = true;
        return;
    }
    for (LayoutView* view : m_views) {
        view->refresh();
    }
}

QSize LayoutPanel::sizeHint() const
{
    return {310, 300};
}

QSize LayoutPanel::pictureSize() const
{
    if (!m_inspection.texel()) {
        return {};
    }
    constexpr int kSide = 360;
    const auto shown =
        std::ranges::count_if(m_views, [](const auto* view) { return !view->isHidden(); });
    return {kSide * std::max(1, static_cast<int>(shown)), kSide + kSide / 8};
}

void LayoutPanel::paintPicture(QPainter& painter, QSize size)
{
    const LayoutInk ink(paper(), font());
    painter.fillRect(QRect(QPoint(0, 0), size), ink.background);
    QList<LayoutView*> shown;
    for (LayoutView* view : m_views) {
        if (!view->isHidden()) {
            shown += view;
        }
    }
    const double width = size.width() / std::max(1.0, static_cast<double>(shown.size()));
    for (qsizetype k = 0; k < shown.size(); ++k) {
        const QRectF area(static_cast<double>(k) * width, 0, width, size.height());
        shown[k]->paintInto(painter, area, ink, true);
    }
}

void LayoutPanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    if (m_isBehind) {
        takeInspection();
        refreshViews();
    }
}

void LayoutPanel::hideEvent(QHideEvent* event)
{
    QWidget::hideEvent(event);
    m_isBehind = true;
    m_faces.rest();
    m_others.rest();
    if (m_filter != nullptr) {
        m_filter->show(std::nullopt);
    }
}

void LayoutPanel::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    arrange();
}

/// Side by side, or one below the other where the panel is narrow.
void LayoutPanel::arrange()
{
    const Qt::Orientation wanted = width() >= height() ? Qt::Horizontal : Qt::Vertical;
    if (m_splitter->orientation() != wanted) {
        m_splitter->setOrientation(wanted);
    }
}

void LayoutPanel::remember() const
{
    QSettings settings;
    settings.beginGroup("layout");
    for (const LayoutKind kind : kKinds) {
        const auto k = static_cast<std::size_t>(kind);
        settings.setValue(kViewKeys[k], m_viewSwitches[k]->isChecked());
    }
    settings.setValue("zoomTogether", m_linkZoom->isChecked());
    for (const auto& [action, mark] : m_markSwitches) {
        settings.setValue(action->objectName(), m_marks.*mark);
    }
}

void LayoutPanel::restore()
{
    QSettings settings;
    settings.beginGroup("layout");
    for (const LayoutKind kind : kKinds) {
        const auto k = static_cast<std::size_t>(kind);
        m_viewSwitches[k]->setChecked(settings.value(kViewKeys[k], true).toBool());
    }
    m_linkZoom->setChecked(settings.value("zoomTogether", true).toBool());
    LayoutMarks marks;
    for (const auto& [action, mark] : m_markSwitches) {
        marks.*mark = settings.value(action->objectName(), marks.*mark).toBool();
    }
    setMarks(marks);
}

} // namespace trixel::ui
