// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/filtering_study.h"

#include "core/base/check.h"
#include "core/filter/filter_method.h"
#include "core/study/views/view_map.h"
#include "render/camera_view.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string_view>
#include <thread>

namespace trixel::render {

namespace {

constexpr std::size_t kAll = ~std::size_t{0};

/// A framebuffer, bound while it lives.
class Target
{
public:
    Target(Gl& gl, glm::ivec2 size, GLenum format)
        : m_gl(gl)
    {
        m_gl.glGetIntegerv(GL_FRAMEBUFFER_BINDING, &m_before);
        m_gl.glGenFramebuffers(1, &m_framebuffer);
        m_gl.glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
        m_gl.glGenRenderbuffers(2, m_buffers.data());
        attach(m_buffers[0], format, GL_COLOR_ATTACHMENT0, size);
        attach(m_buffers[1], GL_DEPTH_COMPONENT24, GL_DEPTH_ATTACHMENT, size);
        check(m_gl.glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE,
              "a framebuffer of bytes or floats, which OpenGL 4.1 has");
    }
    ~Target()
    {
        m_gl.glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(m_before));
        m_gl.glDeleteFramebuffers(1, &m_framebuffer);
        m_gl.glDeleteRenderbuffers(2, m_buffers.data());
    }
    Target(const Target&) = delete;
    Target& operator=(const Target&) = delete;

private:
    void attach(GLuint buffer, GLenum format, GLenum place, glm::ivec2 size)
    {
        m_gl.glBindRenderbuffer(GL_RENDERBUFFER, buffer);
        m_gl.glRenderbufferStorage(GL_RENDERBUFFER, format, size.x, size.y);
        m_gl.glFramebufferRenderbuffer(GL_FRAMEBUFFER, place, GL_RENDERBUFFER, buffer);
    }

    Gl& m_gl;
    GLint m_before = 0;
    GLuint m_framebuffer = 0;
    std::array<GLuint, 2> m_buffers{};
};

} // namespace

DrawnPicture drawNumbers(Gl& gl, Renderer& renderer, const Scene& scene)
{
    const glm::ivec2 size = scene.camera.viewport();
    const Target target(gl, size, GL_RGBA32F);
    renderer.draw(scene);
    DrawnPicture picture{size.x, size.y, {}};
    const std::size_t row = 4 * static_cast<std::size_t>(size.x);
    std::vector<float> upward(row * static_cast<std::size_t>(size.y));
    gl.glPixelStorei(GL_PACK_ALIGNMENT, 1);
    gl.glReadPixels(0, 0, size.x, size.y, GL_RGBA, GL_FLOAT, upward.data());
    picture.values.resize(upward.size());
    for (std::size_t y = 0; y < static_cast<std::size_t>(size.y); ++y) {
        std::copy_n(upward.end() - static_cast<std::ptrdiff_t>((y + 1) * row),
                    row,
                    picture.values.begin() + static_cast<std::ptrdiff_t>(y * row));
    }
    return picture;
}

namespace {

/// Mesa's rasterisers ask the clock when they come to a frame, after vertices were worked on.
bool drawsOnTheProcessor(Gl& gl)
{
    const auto* name = reinterpret_cast<const char*>(gl.glGetString(GL_RENDERER));
    const std::string_view renderer = name != nullptr ? name : "";
    return renderer.starts_with("llvmpipe") || renderer.starts_with("softpipe");
}

} // namespace

std::optional<double> cardTime(Gl& gl, Renderer& renderer, const Scene& scene, int frames)
{
    // What is bound may be as small as a pixel.
    const Target target(gl, scene.camera.viewport(), GL_RGBA8);
    std::vector<double> times;
    const bool byTheClock = drawsOnTheProcessor(gl);
    // The renderer has the time of a frame when it begins the next.
    for (int k = 0; k <= frames; ++k) {
        const auto begin = std::chrono::steady_clock::now();
        renderer.draw(scene);
        gl.glFinish();
        const std::chrono::duration<double, std::milli> whole =
            std::chrono::steady_clock::now() - begin;
        if (k > 0 && byTheClock) {
            times.push_back(whole.count());
        } else if (k > 0 && renderer.figures().cardMs) {
            times.push_back(*renderer.figures().cardMs);
        }
    }
    if (times.empty()) {
        return std::nullopt;
    }
    std::ranges::nth_element(times, times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2));
    return times[times.size() / 2];
}

void prepareFilterings(Renderer& renderer,
                       const TexelStore& store,
                       std::span<const Filtering> filterings)
{
    renderer.wantFilterings(filterings);
    renderer.uploadTexels(store, kAll);
    while (renderer.hasFilterWork()) {
        if (renderer.uploadFilters(store, kAll) == 0) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    }
}

Result<ExactPicture> exactPicture(const Surface& surface,
                                  const FilterScene& scene,
                                  const TexelFormat& format,
                                  const Camera& camera,
                                  PixelSubset subset,
                                  Threads threads,
                                  Progress& progress)
{
    auto queries = viewQueries(surface, viewOf(camera), subset, threads, progress);
    if (!queries) {
        return tl::unexpected(queries.error());
    }
    ExactPicture picture{std::move(*queries), {}};
    const std::size_t count = picture.queries.size();
    const auto method = makeMethod({std::string(kExactMethod), std::nullopt});
    ResultArrays answers(count, format.channels);
    constexpr std::size_t kBetweenReports = 1024;
    for (std::size_t begin = 0; begin < count; begin += kBetweenReports) {
        if (!progress.report(static_cast<double>(begin) / static_cast<double>(count))) {
            return cancelled();
        }
        const std::size_t some = std::min(kBetweenReports, count - begin);
        FilterResults results = answers.results();
        results.values = results.values.subspan(begin);
        results.levels = results.levels.subspan(begin, some);
        results.taps = results.taps.subspan(begin, some);
        filterParallel(*method,
                       scene,
                       picture.queries.queries.queries().subspan(begin, some),
                       results,
                       threads);
    }
    const CardChannels channels = usualChannels(format);
    picture.colors.reserve(3 * count);
    for (std::size_t q = 0; q < count; ++q) {
        for (std::size_t c = 0; c < 3; ++c) {
            const auto channel = static_cast<std::size_t>(channels[c]);
            picture.colors.push_back(std::clamp(answers.values[channel * count + q], 0.0F, 1.0F));
        }
    }
    return picture;
}

PictureDifference differenceOf(const DrawnPicture& drawn, const ExactPicture& exact)
{
    PictureDifference difference;
    double squares = 0;
    std::vector<double> offs;
    offs.reserve(3 * exact.queries.size());
    for (std::size_t q = 0; q < exact.queries.size(); ++q) {
        const float* seen = drawn.pixel(exact.queries.pixel[q]);
        for (std::size_t c = 0; c < 3; ++c) {
            const double off = std::abs(double{seen[c]} - double{exact.colors[3 * q + c]});
            squares += off * off;
            offs.push_back(off);
            difference.worst = std::max(difference.worst, off);
        }
    }
    difference.pixels = exact.queries.size();
    if (difference.pixels > 0) {
        difference.rms = std::sqrt(squares / (3.0 * static_cast<double>(difference.pixels)));
        const auto at = offs.begin() + static_cast<std::ptrdiff_t>(offs.size() * 99 / 100);
        std::ranges::nth_element(offs, at);
        difference.p99 = *at;
    }
    return difference;
}

} // namespace trixel::render
