// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QWidget>

#include "ui/inspector/layout_view.h"
#include "ui/inspector/picture_source.h"

#include <array>
#include <optional>

class QAction;
class QSplitter;
class QStackedLayout;
class QToolBar;

namespace trixel::ui {

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
                const ViewSettings& settings,
                Inspection& inspection,
                const FaceSelection& selection,
                QWidget* parent = nullptr);
    ~LayoutPanel() override;

    LayoutView& view(LayoutKind kind) const { return *m_views[static_cast<std::size_t>(kind)]; }
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
    void refreshViews();
    void remember() const;
    void restore();
    /// Does something that changes the inspection, so that it is known whence the change came.
    template <class Act>
    void say(LayoutView* from, Origin origin, Act act);

    const Document& m_document;
    Inspection& m_inspection;
    ShownFaces m_faces;
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
