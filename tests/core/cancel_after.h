// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"

#include <gtest/gtest.h>

namespace trixel {

/// Lets so many reports pass and cancels at the next; what is done may not shrink between them.
class CancelAfter final : public Progress
{
public:
    explicit CancelAfter(int reports)
        : m_left(reports)
    {
    }
    bool report(double fraction) override
    {
        EXPECT_GE(fraction, m_last);
        m_last = fraction;
        return m_left-- > 0;
    }

private:
    int m_left;
    double m_last = 0;
};

} // namespace trixel
