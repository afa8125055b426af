// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace trixel {

/// How long work tells how far it is and learns whether to go on. Called from one thread at a time.
class Progress
{
public:
    virtual ~Progress() = default;

    /// \param fraction  done so far, in [0, 1]
    /// \return          false when the work is to stop and leave everything as it was
    [[nodiscard]] virtual bool report(double fraction) = 0;
};

/// For callers who neither watch nor cancel.
class NoProgress final : public Progress
{
public:
    bool report(double /*fraction*/) override { return true; }
};

/// One stage of a longer work: [0, 1] of the stage is [begin, end] of the whole.
class StageProgress final : public Progress
{
public:
    StageProgress(Progress& whole, double begin, double end)
        : m_whole(whole)
        , m_begin(begin)
        , m_end(end)
    {
    }

    bool report(double fraction) override
    {
        return m_whole.report(m_begin + (m_end - m_begin) * fraction);
    }

private:
    Progress& m_whole;
    double m_begin;
    double m_end;
};

} // namespace trixel
