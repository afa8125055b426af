// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/image/image_worker.h"

#include "core/io/image/worker/job_descriptors.h"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <nlohmann/json.hpp>
#include <optional>
#include <poll.h>
#include <spawn.h>
#include <string>
#include <sys/wait.h>
#include <system_error>
#include <thread>
#include <unistd.h>

extern "C" {
extern char** environ; // NOLINT: POSIX names it so
}

namespace trixel {

namespace {

using Clock = std::chrono::steady_clock;

std::filesystem::path installedWorker()
{
    // Programs that lie elsewhere, tests above all, say where theirs is.
    if (const char* elsewhere = std::getenv("TRIXEL_IMAGES")) {
        return elsewhere;
    }
    std::error_code error;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
    const auto beside = program.parent_path() / "trixel-images";
    const auto installed = program.parent_path() / ".." / "lib" / "trixel" / "trixel-images";
    return std::filesystem::exists(installed, error) ? installed : beside;
}

struct Pipe
{
    Descriptor read;
    Descriptor write;
};

Result<Pipe> makePipe()
{
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
        return pathError(std::string("A pipe cannot be made: ") + std::strerror(errno));
    }
    return Pipe{Descriptor(ends[0]), Descriptor(ends[1])};
}

/// A copy above those that the worker expects, so that putting one in its place covers no other.
Result<Descriptor> lifted(const Descriptor& descriptor)
{
    Descriptor copy(::fcntl(descriptor.get(), F_DUPFD_CLOEXEC, kFirstFreeDescriptor));
    if (!copy.isOpen()) {
        return pathError(std::string("A file cannot be handed on: ") + std::strerror(errno));
    }
    return copy;
}

/// A process of ours. Ended and waited for at the latest when it goes out of scope.
class Process
{
public:
    explicit Process(pid_t id)
        : m_id(id)
    {
    }
    ~Process() { end(); }
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    void end()
    {
        if (m_id > 0) {
            ::kill(m_id, SIGKILL);
            (void)wait();
        }
    }

    /// Gives a process that has said all it has to say a moment to end by itself.
    int endSoon()
    {
        constexpr int kMoments = 200;
        for (int k = 0; k < kMoments; ++k) {
            int status = 0;
            if (::waitpid(m_id, &status, WNOHANG) == m_id) {
                m_id = 0;
                return status;
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(k < 20 ? 1 : 10));
        }
        ::kill(m_id, SIGKILL);
        return wait();
    }

private:
    int wait()
    {
        int status = 0;
        while (::waitpid(m_id, &status, 0) < 0 && errno == EINTR) {
        }
        m_id = 0;
        return status;
    }

    pid_t m_id;
};

Result<pid_t> spawn(const std::filesystem::path& program,
                    const std::string& job,
                    const Descriptor& input,
                    const Descriptor& output,
                    const Descriptor& reply)
{
    const auto in = lifted(input);
    const auto out = lifted(output);
    const auto answer = lifted(reply);
    if (!in || !out || !answer) {
        return tl::unexpected((!in ? in : !out ? out : answer).error());
    }
    posix_spawn_file_actions_t actions{};
    ::posix_spawn_file_actions_init(&actions);
    // Libraries tell standard error what they think of a file; the answer says what matters.
    for (const int standard : {0, 1, 2}) {
        ::posix_spawn_file_actions_addopen(&actions, standard, "/dev/null", O_RDWR, 0);
    }
    ::posix_spawn_file_actions_adddup2(&actions, in->get(), kInputDescriptor);
    ::posix_spawn_file_actions_adddup2(&actions, out->get(), kOutputDescriptor);
    ::posix_spawn_file_actions_adddup2(&actions, answer->get(), kReplyDescriptor);
    std::string name = program.string();
    std::string text = job;
    std::array<char*, 3> arguments{name.data(), text.data(), nullptr};
    pid_t id = 0;
    const int error =
        ::posix_spawn(&id, name.c_str(), &actions, nullptr, arguments.data(), environ);
    ::posix_spawn_file_actions_destroy(&actions);
    if (error != 0) {
        return pathError(name + ": the program that reads and writes images cannot be started: " +
                         std::strerror(error));
    }
    return id;
}

/// All that comes through a pipe until its other end is closed.
Result<std::string>
readReply(const Descriptor& pipe, Clock::time_point deadline, Progress& progress)
{
    constexpr int kLookEveryMs = 50;
    constexpr std::size_t kLongest = std::size_t{1} << 20U;
    std::string reply;
    while (true) {
        if (!progress.report(0)) {
            return cancelled();
        }
        if (Clock::now() > deadline) {
            return contentsError("it takes too long to decode");
        }
        pollfd wait{pipe.get(), POLLIN, 0};
        if (::poll(&wait, 1, kLookEveryMs) <= 0) {
            continue;
        }
        std::array<char, 4096> piece{};
        const ssize_t got = ::read(pipe.get(), piece.data(), piece.size());
        if (got == 0) {
            return reply;
        }
        if (got > 0) {
            reply.append(piece.data(), static_cast<std::size_t>(got));
        }
        if (reply.size() > kLongest) {
            return contentsError("the decoder answers without end");
        }
    }
}

Status endOf(int status)
{
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) {
        return {};
    }
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU) {
        return contentsError("it takes too long to decode");
    }
    return contentsError("it is damaged: its decoder failed");
}

} // namespace

ImageWorker::ImageWorker()
    : m_program(installedWorker())
{
}

ImageWorker::ImageWorker(std::filesystem::path program)
    : m_program(std::move(program))
{
}

Result<nlohmann::json> ImageWorker::run(const nlohmann::json& job,
                                        const Descriptor& input,
                                        const Descriptor& output,
                                        const ImageLimits& limits,
                                        Progress& progress) const
{
    nlohmann::json whole = job;
    whole["limits"] = {{"pixelsAcross", limits.mostPixelsAcross},
                       {"bytes", limits.mostBytes},
                       {"channels", limits.mostChannels},
                       {"bytesPerByte", limits.mostBytesPerByte},
                       {"memory", limits.memoryBytes},
                       {"seconds", limits.processorTime.count()}};
    auto pipe = makePipe();
    if (!pipe) {
        return tl::unexpected(pipe.error());
    }
    const auto id = spawn(m_program, whole.dump(), input, output, pipe->write);
    if (!id) {
        return tl::unexpected(id.error());
    }
    Process process(*id);
    pipe->write.close();
    const auto reply = readReply(pipe->read, Clock::now() + limits.wallTime, progress);
    if (!reply) {
        return tl::unexpected(reply.error());
    }
    if (const Status end = endOf(process.endSoon()); !end) {
        return tl::unexpected(end.error());
    }
    nlohmann::json answer = nlohmann::json::parse(*reply, nullptr, false);
    if (!answer.is_object()) {
        return contentsError("it is damaged: its decoder failed");
    }
    if (const auto error = answer.find("error"); error != answer.end() && error->is_string()) {
        return contentsError(error->get<std::string>());
    }
    return answer;
}

} // namespace trixel
