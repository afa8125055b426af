// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/terminal_progress.h"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <unistd.h>

namespace trixel::app {
namespace {

// Short work shows nothing.
constexpr std::chrono::milliseconds kDelay{300};
constexpr std::chrono::milliseconds kInterval{100};

volatile std::sig_atomic_t interrupted = 0;

void interrupt(int /*signal*/)
{
    interrupted = 1;
}

/// Leaves a signal ignored that the program was started to ignore (in the background of a shell).
void (*catchSignal(int signal))(int)
{
    const auto before = std::signal(signal, interrupt);
    if (before == SIG_IGN) {
        std::signal(signal, SIG_IGN);
    }
    return before;
}

} // namespace

TerminalProgress::TerminalProgress()
    : m_isTerminal(isatty(STDERR_FILENO) == 1)
    , m_next(Clock::now() + kDelay)
    , m_onInterrupt(catchSignal(SIGINT))
    , m_onTerminate(catchSignal(SIGTERM))
{
}

TerminalProgress::~TerminalProgress()
{
    if (m_shown) {
        std::fputs("\r\033[K", stderr);
    }
    std::signal(SIGINT, m_onInterrupt);
    std::signal(SIGTERM, m_onTerminate);
}

bool TerminalProgress::report(double fraction)
{
    if (m_isTerminal) {
        const Clock::time_point now = Clock::now();
        if (now >= m_next) {
            std::fprintf(stderr, "\r%3.0f %%", 100.0 * std::clamp(fraction, 0.0, 1.0));
            m_shown = true;
            m_next = now + kInterval;
        }
    }
    return interrupted == 0;
}

} // namespace trixel::app
