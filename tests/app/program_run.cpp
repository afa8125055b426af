// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/program_run.h"

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <fstream>
#include <sstream>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace trixel::test {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::seconds kPatience{60};

std::string take(const std::filesystem::path& file)
{
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    std::filesystem::remove(file);
    return text.str();
}

void redirect(int descriptor, const std::filesystem::path& target)
{
    const int file = open(target.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    if (file < 0 || dup2(file, descriptor) < 0) {
        _exit(127);
    }
    close(file);
}

[[noreturn]] void becomeTrixel(std::vector<std::string> arguments,
                               const std::filesystem::path& out,
                               const std::filesystem::path& err,
                               const RunOptions& options)
{
    // A test started in the background ignores them, and the program would inherit that.
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
    unsetenv("DISPLAY"); // a verb needs no display
    unsetenv("WAYLAND_DISPLAY");
    unsetenv("QT_QPA_PLATFORM");
    redirect(STDOUT_FILENO, options.standardOutput.value_or(out));
    redirect(STDERR_FILENO, err);
    if (options.fileSizeLimit > 0) {
        const rlimit limit{options.fileSizeLimit, options.fileSizeLimit};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    arguments.insert(arguments.begin(), TRIXEL_PROGRAM);
    std::vector<char*> argv;
    for (std::string& argument : arguments) {
        argv.push_back(argument.data());
    }
    argv.push_back(nullptr);
    execv(TRIXEL_PROGRAM, argv.data());
    _exit(127);
}

double secondsOf(const timeval& time)
{
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * 1e-6;
}

/// Fills in status and time; signals and kills the program when it is time for that.
void await(pid_t program, const RunOptions& options, ProgramRun& run)
{
    const Clock::time_point begin = Clock::now();
    bool toSignal = options.signal != 0;
    for (int status = 0;;) {
        rusage usage{};
        if (wait4(program, &status, WNOHANG, &usage) == program) {
            run.status = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
            run.cpuSeconds = secondsOf(usage.ru_utime) + secondsOf(usage.ru_stime);
            return;
        }
        const auto waited = Clock::now() - begin;
        if (toSignal && waited >= std::chrono::milliseconds(options.signalAfterMs)) {
            kill(program, options.signal);
            toSignal = false;
        }
        if (waited > kPatience) {
            kill(program, SIGKILL);
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
}

} // namespace

ProgramRun runTrixel(const std::vector<std::string>& arguments, const RunOptions& options)
{
    const auto folder = std::filesystem::temp_directory_path();
    const std::string name = "trixel-run-" + std::to_string(getpid());
    const auto out = folder / (name + ".out");
    const auto err = folder / (name + ".err");

    const pid_t program = fork();
    if (program == 0) {
        becomeTrixel(arguments, out, err, options);
    }
    ProgramRun run;
    await(program, options, run);
    run.out = options.standardOutput ? std::string() : take(out);
    run.err = take(err);
    return run;
}

} // namespace trixel::test
