// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "ui/inspector/mip_focus.h"
#include "ui/inspector/mip_view.h"
#include "ui/inspector/picture_source.h"

class QBoxLayout;
class QButtonGroup;
class QCheckBox;
class QLabel;
class QSplitter;
class QTableView;

namespace trixel::ui {

class DifferenceLegend;
class MipModel;

/// The mip levels of the face that is looked at: side by side as pictures, in numbers below, by the
/// right reduction and by that of images.
class MipPanel : public QWidget, public PictureSource
{
    Q_OBJECT

public:
    MipPanel(Document& document,
             Inspection& inspection,
             const ViewSettings& settings,
             QWidget* parent = nullptr);

    const MipFocus& focus() const { return m_focus; }
    MipView& view() { return *m_view; }
    const MipModel& model() const { return *m_model; }

    const MipOptions& options() const { return m_view->options(); }
    void setOptions(const MipOptions& options);

    QString pictureName() const override;
    QSize pictureSize() const override;
    bool isVectorPicture() const override;
    void paintPicture(QPainter& painter, QSize size) override;

signals:
    void optionsChanged();

protected:
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void makeChoices(QBoxLayout& column);
    void makeTable();
    void arrange();
    void showOptions();
    void showFace();
    void showTexel();
    QString texelWords() const;
    void paintKeys(QPainter& painter, const QRectF& row) const;

    MipFocus m_focus;
    MipModel* m_model;
    MipView* m_view;
    QTableView* m_table;
    QSplitter* m_splitter;
    DifferenceLegend* m_legend;
    QBoxLayout* m_choices = nullptr;
    QButtonGroup* m_content = nullptr;
    QButtonGroup* m_texels = nullptr;
    QCheckBox* m_trueSize = nullptr;
    QLabel* m_texel;
    QWidget* m_texelRoom = nullptr;
    QLabel* m_caption;
    bool m_isArranged = false;
    bool m_isFollowing = false; ///< the table follows the level, not the other way round
};

} // namespace trixel::ui
