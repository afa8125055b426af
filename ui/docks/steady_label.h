// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QEnterEvent>
#include <QLabel>

namespace trixel::ui {

/// Room for a label whose text changes with every move of the pointer: as high as a sample of its
/// text, whatever it says, so that panels are not laid out anew for each. What can be done with its
/// text can be done while a pointer is on it: labels whose text can be selected keep a document,
/// which takes ten times as long to set and to draw.
class SteadyLabel : public QWidget
{
public:
    /// \param label   taken over
    /// \param sample  as long as its text usually gets; wrapped if the label wraps
    SteadyLabel(QLabel* label, const QString& sample, QWidget* parent = nullptr)
        : QWidget(parent)
        , m_label(label)
        , m_sample(sample)
    {
        label->setParent(this);
        label->setAlignment(Qt::AlignLeft | Qt::AlignTop);
        QSizePolicy policy(QSizePolicy::Ignored, QSizePolicy::Fixed);
        policy.setHeightForWidth(label->wordWrap());
        setSizePolicy(policy);
        setMinimumWidth(1);
        setFocusPolicy(Qt::NoFocus);
        m_interaction = label->textInteractionFlags();
        label->setTextInteractionFlags(Qt::NoTextInteraction);
    }

    QSize sizeHint() const override
    {
        return {1, m_label->fontMetrics().height() + 2 * m_label->margin()};
    }
    QSize minimumSizeHint() const override { return sizeHint(); }
    int heightForWidth(int width) const override
    {
        return m_label->fontMetrics()
            .boundingRect(QRect(0, 0, width, 1000), Qt::TextWordWrap, m_sample)
            .height();
    }

protected:
    void resizeEvent(QResizeEvent* /*event*/) override { m_label->setGeometry(rect()); }
    void enterEvent(QEnterEvent* event) override
    {
        QWidget::enterEvent(event);
        if (!hasLinks()) {
            m_label->setTextInteractionFlags(m_interaction);
        }
    }
    void leaveEvent(QEvent* event) override
    {
        QWidget::leaveEvent(event);
        if (!hasLinks() && !m_label->hasSelectedText()) { // what is selected can be copied
            m_label->setTextInteractionFlags(Qt::NoTextInteraction);
        }
    }

private:
    /// Which are there before anyone points at them.
    bool hasLinks() const { return m_label->textFormat() == Qt::RichText; }

    QLabel* m_label;
    QString m_sample;
    Qt::TextInteractionFlags m_interaction; ///< while a pointer is on it
};

} // namespace trixel::ui
