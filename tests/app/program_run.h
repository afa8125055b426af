// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs the built program as a shell would.
#pragma once

#include <filesystem>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace trixel::test {

/// How a run went. `status` is the exit status, or minus the number of the signal that ended it.
struct ProgramRun
{
    int status = 0;
    std::string out;
    std::string err;
    double cpuSeconds = 0; ///< which, unlike the clock's, other programs do not stretch
};

struct RunOptions
{
    /// Where standard output goes instead of `ProgramRun::out`.
    std::optional<std::filesystem::path> standardOutput;
    /// No file may grow beyond this, as on a full disk; 0 for no limit.
    std::size_t fileSizeLimit = 0;
    /// Sent after so many milliseconds if the program still runs; 0 for none.
    int signal = 0;
    int signalAfterMs = 0;
};

inline std::ostream& operator<<(std::ostream& out, const ProgramRun& run)
{
    return out << "a run of status " << run.status << " that complained '" << run.err << "'";
}

/// Waits for the program, at most a minute: then it is killed and `status` is -SIGKILL.
ProgramRun runTrixel(const std::vector<std::string>& arguments, const RunOptions& options = {});

} // namespace trixel::test
