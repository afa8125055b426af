// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>

namespace trixel::ui {

/// Room for a label whose text changes with every move of the pointer: as high as a sample of its
/// text, whatever it says, so that panels are not laid out anew for each.
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
    }

    QSize sizeHint() const override { return {1, m_label->fontMetrics().height()}; }
    QSize minimumSizeHint() const override { return sizeHint(); }
    int heightForWidth(int width) const override
    {
        return m_label->fontMetrics()
            .boundingRect(QRect(0, 0, width, 1000), Qt::TextWordWrap, m_sample)
            .height();
    }

protected:
    void resizeEvent(QResizeEvent* /*event*/) override { m_label->setGeometry(rect()); }

private:
    QLabel* m_label;
    QString m_sample;
};

} // namespace trixel::ui
