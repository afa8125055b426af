// SPDX-License-Identifier: GPL-3.0-or-later
//
// trixel-images: decodes or encodes one image and ends. Started by ImageWorker only.
#include "core/io/image/worker/job_descriptors.h"
#include "core/io/image/worker/jobs.h"

#include <OpenImageIO/imageio.h>
#include <csignal>
#include <exception>
#include <new>
#include <string>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

namespace {

void limit(int resource, std::uint64_t most)
{
    const rlimit both{most, most};
    ::setrlimit(static_cast<__rlimit_resource_t>(resource), &both);
}

void limitMyself(const nlohmann::json& limits, bool decodes)
{
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
    limit(RLIMIT_CORE, 0);
    if (decodes) { // what is encoded is our own
        limit(RLIMIT_AS, limits.at("memory").get<std::uint64_t>());
        limit(RLIMIT_CPU, limits.at("seconds").get<std::uint64_t>());
        limit(RLIMIT_FSIZE, limits.at("bytes").get<std::uint64_t>());
    }
}

nlohmann::json perform(const nlohmann::json& job)
{
    const bool decodes = job.at("work") == "decode";
    const int threads = decodes ? 1 : job.at("threads").get<int>();
    OIIO::attribute("threads", threads);
    OIIO::attribute("exr_threads", threads);
    limitMyself(job.at("limits"), decodes);
    return decodes ? trixel::worker::decodeImage(job) : trixel::worker::encodeImage(job);
}

void answer(const std::string& text)
{
    std::size_t done = 0;
    while (done < text.size()) {
        const ssize_t put =
            ::write(trixel::kReplyDescriptor, text.data() + done, text.size() - done);
        if (put <= 0) {
            return;
        }
        done += static_cast<std::size_t>(put);
    }
}

std::string outcome(const char* job)
{
    nlohmann::json reply;
    try {
        reply = perform(nlohmann::json::parse(job));
    } catch (const std::bad_alloc&) {
        reply = {{"error", "it needs more memory than one image may take"}};
    } catch (const std::exception& e) {
        reply = {{"error", e.what()}};
    }
    return reply.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

} // namespace

int main(int argc, char** argv)
{
    if (argc != 2) {
        return 2;
    }
    answer(outcome(argv[1]));
    ::_exit(0); // libraries that tidy up could still fail over a damaged file
}
