// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"

#include <chrono>

namespace trixel::app {

/// Shows how far work is where standard error is a terminal, and nothing in a pipe. While one
/// exists, Ctrl+C (or a polite kill) stops the work instead of the program, so that the work can
/// leave everything as it was.
class TerminalProgress final : public Progress
{
public:
    TerminalProgress();
    ~TerminalProgress() override;
    TerminalProgress(const TerminalProgress&) = delete;
    TerminalProgress& operator=(const TerminalProgress&) = delete;

    bool report(double fraction) override;

private:
    using Clock = std::chrono::steady_clock;

    using Handler = void (*)(int);

    bool m_isTerminal;
    bool m_shown = false;
    Clock::time_point m_next; ///< when to draw again
    Handler m_onInterrupt;    ///< what was there before
    Handler m_onTerminate;
};

} // namespace trixel::app
