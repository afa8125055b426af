// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace trixel {

/// The text with a leading UTF-8 byte order mark removed.
std::string_view withoutByteOrderMark(std::string_view text);

/// A word as an error message shows it: in quotes, short, control characters replaced.
std::string quoted(std::string_view word);

/// Reads words and numbers line by line, whatever the locale. A '#' hides the rest of its line.
/// Lines end with LF or CR LF; the last may lack its end. A line that holds a '#' is never
/// continued: a path that ends with a backslash in a comment must not swallow the next line.
class TextScanner
{
public:
    enum class Continuation { None, Backslash };

    /// \param firstLine     number of the text's first line, for messages
    /// \param continuation  whether a backslash at the end of a line goes on with the next
    explicit TextScanner(std::string_view text,
                         std::size_t firstLine = 1,
                         Continuation continuation = Continuation::None)
        : m_at(text.data())
        , m_end(text.data() + text.size())
        , m_line(firstLine)
        , m_continuation(continuation)
    {
    }

    bool atEnd() const { return m_at == m_end; }
    std::size_t line() const { return m_line; }
    /// What is left, from the current place.
    std::string_view rest() const { return {m_at, static_cast<std::size_t>(m_end - m_at)}; }

    /// Skips blanks; true where nothing but a comment is left of the line.
    bool atLineEnd()
    {
        skipBlanks();
        return m_at == m_end || *m_at == '\n' || *m_at == '#';
    }

    /// Goes to the start of the next line, past continued ones.
    void skipLine();

    /// Goes to the next line that has a word; false at the end of the text.
    bool skipEmptyLines()
    {
        while (atLineEnd()) {
            if (m_at == m_end) {
                return false;
            }
            skipLine();
        }
        return true;
    }

    /// The next word of the line; empty at its end.
    std::string_view word()
    {
        if (atLineEnd()) {
            return {};
        }
        const char* const begin = m_at;
        while (!wordEndsAt(m_at)) {
            ++m_at;
        }
        return {begin, static_cast<std::size_t>(m_at - begin)};
    }

    /// A number that is finite as a float; nothing (and nothing read) if the next word is none.
    std::optional<float> finiteFloat()
    {
        skipBlanks();
        float value = 0;
        const auto [end, error] = std::from_chars(m_at, m_end, value);
        if (error == std::errc{} && std::isfinite(value) && wordEndsAt(end)) [[likely]] {
            m_at = end;
            return value;
        }
        return rareFloat();
    }

    /// Three finite numbers: a position.
    Result<glm::vec3> point()
    {
        glm::vec3 position{0};
        for (int axis = 0; axis < 3; ++axis) {
            const std::optional<float> value = finiteFloat();
            if (!value) {
                return expected("a finite number that fits a float");
            }
            position[axis] = *value;
        }
        return position;
    }

    /// Any number, even infinite or none ("nan"), for values that are skipped; false if the next
    /// word is not a number.
    bool skipNumber();

    /// A decimal integer in [-2^62, 2^62]; nothing (and nothing read) if the next word is none.
    std::optional<std::int64_t> integer()
    {
        skipBlanks();
        const char* at = m_at;
        const auto value = integerAt(at);
        if (!value || !wordEndsAt(at)) {
            return std::nullopt;
        }
        m_at = at;
        return value;
    }

    /// The integer at the current place, which need not end the word ("1" of "1/2/3").
    std::optional<std::int64_t> integerPart() { return integerAt(m_at); }

    /// Skips one character if it is the next.
    bool skipCharacter(char character)
    {
        const bool is = m_at != m_end && *m_at == character;
        m_at += is ? 1 : 0;
        return is;
    }

    /// Whether the current place is the end of a word.
    bool atWordEnd() const { return wordEndsAt(m_at); }

    /// "line 3: expected <what>, found <the next word>".
    tl::unexpected<Error> expected(const std::string& what);

    /// "line 3: expected <what>, found <found>".
    tl::unexpected<Error> expected(const std::string& what, const std::string& found) const;

private:
    static bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
    static bool isSpace(char c) { return isBlank(c) || c == '\n' || c == '\r'; }
    bool continuesAt(const char* backslash) const;
    bool wordEndsAt(const char* at) const
    {
        return at == m_end || isSpace(*at) || *at == '#' || (*at == '\\' && continuesAt(at));
    }

    void skipBlanks()
    {
        do {
            while (m_at != m_end && (isBlank(*m_at) || *m_at == '\r')) {
                ++m_at;
            }
        } while (m_at != m_end && *m_at == '\\' && skipContinuation());
    }

    std::optional<std::int64_t> integerAt(const char*& at) const
    {
        const char* digit = at;
        const bool negative = digit != m_end && *digit == '-';
        digit += digit != m_end && (*digit == '-' || *digit == '+') ? 1 : 0;
        const char* const begin = digit;
        std::int64_t value = 0;
        for (; digit != m_end && *digit >= '0' && *digit <= '9'; ++digit) {
            if (value > (std::int64_t{1} << 58U)) {
                return std::nullopt;
            }
            value = value * 10 + (*digit - '0');
        }
        if (digit == begin) {
            return std::nullopt;
        }
        at = digit;
        return negative ? -value : value;
    }

    bool skipContinuation();
    std::optional<float> rareFloat();

    const char* m_at;
    const char* m_end;
    std::size_t m_line;
    Continuation m_continuation;
};

} // namespace trixel
