// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/io/commit_file.h"

#include <charconv>
#include <concepts>
#include <string>
#include <string_view>

namespace trixel {

/// Text for a file, gathered and written in large pieces. Numbers are as short as they can be and
/// still read back to the bit. After an error nothing more is written.
class TextLines
{
public:
    explicit TextLines(FileWriter& file)
        : m_file(file)
        , m_progress(m_ignored)
    {
    }
    /// \param steps  calls of `step` to come
    TextLines(FileWriter& file, std::size_t steps, Progress& progress)
        : m_file(file)
        , m_progress(progress)
        , m_steps(steps)
    {
    }

    template <class... Parts>
    void add(const Parts&... parts)
    {
        (append(parts), ...);
        if (m_text.size() >= kPiece) {
            flush();
        }
    }

    /// Counts progress, and asks now and then whether to go on.
    void step()
    {
        constexpr std::size_t kStepsAtOnce = 4096;
        if (++m_done % kStepsAtOnce == 0 && m_status &&
            !m_progress.report(static_cast<double>(m_done) / static_cast<double>(m_steps))) {
            m_status = cancelled();
        }
    }

    /// Writes the rest. The first error of all.
    Status finish()
    {
        flush();
        return m_status;
    }

private:
    static constexpr std::size_t kPiece = std::size_t{1} << 20U;

    void append(std::string_view text) { m_text += text; }
    template <class Number>
    requires std::integral<Number> || std::floating_point<Number>
    void append(Number number)
    {
        char digits[32];
        const auto end = std::to_chars(std::begin(digits), std::end(digits), number).ptr;
        m_text.append(std::begin(digits), end);
    }
    void flush()
    {
        if (m_status) {
            m_status = m_file.write(std::string_view(m_text));
        }
        m_text.clear();
    }

    FileWriter& m_file;
    NoProgress m_ignored;
    Progress& m_progress;
    std::size_t m_steps = 1;
    std::size_t m_done = 0;
    std::string m_text;
    Status m_status;
};

} // namespace trixel
