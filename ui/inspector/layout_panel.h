// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QWidget>

#include "ui/inspector/layout_view.h"
#include "ui/inspector/picture_source.h"
#include "ui/viewport/comparison.h"

#include <array>
#include <memory>
#include <optional>
#include <utility>

class QAction;
class QEvent;
class QSplitter;
class QStackedLayout;
class QToolBar;

namespace trixel::ui {

class FilterSceneSource;
class SplitBar;

/// The face that is looked at, laid out in three ways side by side: as on the mesh with its
/// neighbours, as the file stores it, and in rows. A texel under the pointer in one of them, or in
/// the 3D view, is marked in all.
///
/// The net stays where it is while the pointer goes over its neighbours; a click there holds the
/// texel and lays the net around its face, which stays in its place. Steps by the arrow keys do the
/// same. When another face is pointed at elsewhere, it is laid afresh.
class LayoutPanel : public QWidget, public PictureSource
{
    Q_OBJECT

public:
    LayoutPanel(const Document& document,
                ViewSettings& settings,
                Inspection& inspection,
                const FaceSelection& selection,
                QWidget* parent = nullptr);
    ~LayoutPanel() override;

    LayoutView& view(LayoutKind kind) const { return *m_views[static_cast<std::size_t>(kind)]; }
    /// Without it the net is never drawn filtered.
    void useFilters(FilterSceneSource& source);
    const NetFilter* filter() const { return m_filter; }
    /// From now on Before and After shows the present texels as before; at first those opened.
    void rememberBefore();
    /// The net's faces in the colours of the view's map, or their texels again.
    void setFaceNumbers(const std::shared_ptr<const FaceNumbers>& numbers);

    const LayoutMarks& marks() const { return m_marks; }
    void setMarks(const LayoutMarks& marks);
    /// What is switched here, for menus and the command palette.
    const QList<QAction*>& switches() const { return m_switches; }
    /// Every view shows all of its face.
    void frameAll();
    /// Draws levels that are being reduced in the background at once, for pictures.
    void complete();

    QString pictureName() const override { return "layout"; }
    QSize pictureSize() const override;
    bool isVectorPicture() const override { return true; }
    void paintPicture(QPainter& painter, QSize size) override;

    QSize sizeHint() const override;

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    /// Who made the texel looked at another one.
    enum class Origin { Elsewhere, Pointer, Choice };

    void makeViews(const LayoutSources& sources);
    void makeSwitches();
    void connectView(LayoutView& view);
    QAction* addSwitch(const QString& iconName, const QString& text, const QString& toolTip);
    void addMark(const QString& iconName,
                 const QString& text,
                 const QString& toolTip,
                 bool LayoutMarks::*mark);
    void addViewSwitch(LayoutKind kind, const QString& iconName);
    void arrange();
    void takeInspection();
    void showTexel(const InspectedTexel& texel, Origin origin);
    void layNetAround(FaceId face, Origin origin);
    Level otherLevel(FaceId face) const;
    void showOther();
    void takeSettings();
    void refreshViews();
    void remember() const;
    void restore();
    /// Does something that changes the inspection, so that it is known whence the change came.
    template <class Act>
    void say(LayoutView* from, Origin origin, Act act);

    const Document& m_document;
    ViewSettings& m_settings;
    Inspection& m_inspection;
    TexelStore m_before; ///< shares with the document's texels what has not changed since
    ShownFaces m_faces;
    ShownFaces m_others; ///< as B shows them
    NetFilter* m_filter = nullptr;
    SplitBar* m_split = nullptr;
    std::pair<ComparedBy, int> m_compared{ComparedBy::Nothing, 0}; ///< and by how many levels
    std::array<LayoutView*, 3> m_views{};
    QStackedLayout* m_pages = nullptr;
    QSplitter* m_splitter = nullptr;
    QToolBar* m_tools = nullptr;
    QList<QAction*> m_switches;
    std::array<QAction*, 3> m_viewSwitches{};
    QList<std::pair<QAction*, bool LayoutMarks::*>> m_markSwitches;
    QAction* m_linkZoom = nullptr;
    LayoutMarks m_marks;
    std::optional<FaceNet> m_net;
    std::optional<FaceId> m_face; ///< that was shown last
    Origin m_origin = Origin::Elsewhere;
    LayoutView* m_from = nullptr; ///< whose pointer or keys are speaking
    bool m_isBehind = true;       ///< hidden while something changed
};

} // namespace trixel::ui
