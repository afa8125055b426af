// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/text_scanner.h"

#include <algorithm>
#include <limits>

namespace trixel {
namespace {

constexpr std::size_t kLongestQuote = 24;

// Position of the decimal point relative to the first significant digit, plus the exponent: a
// number too large for double is far above zero here, one too small far below.
std::int64_t decimalMagnitude(std::string_view number)
{
    const std::size_t exponentAt = std::min(number.find_first_of("eE"), number.size());
    const std::string_view mantissa = number.substr(0, exponentAt);
    std::int64_t exponent = 0;
    if (exponentAt < number.size()) {
        std::string_view digits = number.substr(exponentAt + 1);
        const bool negative = digits.starts_with('-');
        digits.remove_prefix(digits.starts_with('-') || digits.starts_with('+') ? 1 : 0);
        for (const char digit : digits.substr(0, 12)) {
            exponent = exponent * 10 + (digit - '0');
        }
        exponent = negative ? -exponent : exponent;
    }
    const auto point = static_cast<std::int64_t>(std::min(mantissa.find('.'), mantissa.size()));
    const auto first =
        static_cast<std::int64_t>(std::min(mantissa.find_first_of("123456789"), mantissa.size()));
    return exponent + point - first;
}

struct AnyNumber
{
    double value = 0; // infinity where it is too large
    bool isNumber = false;
};

AnyNumber numberOf(std::string_view word)
{
    if (word.starts_with('+')) {
        word.remove_prefix(1);
        if (word.starts_with('-')) {
            return {};
        }
    }
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (word.empty() || end != word.data() + word.size() || error == std::errc::invalid_argument) {
        return {};
    }
    if (error == std::errc::result_out_of_range) {
        value = decimalMagnitude(word) > 0 ? std::numeric_limits<double>::infinity() : 0.0;
    }
    return {value, true};
}

} // namespace

std::string_view withoutByteOrderMark(std::string_view text)
{
    return text.starts_with("\xEF\xBB\xBF") ? text.substr(3) : text;
}

std::string quoted(std::string_view word)
{
    std::string text(word.substr(0, kLongestQuote));
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    return "'" + text + (word.size() > kLongestQuote ? "…'" : "'");
}

bool TextScanner::continuesAt(const char* backslash) const
{
    if (m_continuation == Continuation::None) {
        return false;
    }
    const char* at = backslash + 1;
    at += at != m_end && *at == '\r' ? 1 : 0;
    return at == m_end || *at == '\n';
}

bool TextScanner::skipContinuation()
{
    if (!continuesAt(m_at)) {
        return false;
    }
    ++m_at;
    m_at += m_at != m_end && *m_at == '\r' ? 1 : 0;
    if (m_at != m_end) {
        ++m_at;
        ++m_line;
    }
    return true;
}

void TextScanner::skipLine()
{
    bool continued = true;
    while (continued && m_at != m_end) {
        const std::string_view text = rest();
        const std::string_view line = text.substr(0, text.find('\n'));
        m_at += line.size();
        if (m_at != m_end) {
            ++m_at;
            ++m_line;
        }
        std::string_view content = line;
        content.remove_suffix(content.ends_with('\r') ? 1 : 0);
        continued = m_continuation == Continuation::Backslash && content.ends_with('\\') &&
                    content.find('#') == std::string_view::npos;
    }
}

std::optional<float> TextScanner::rareFloat()
{
    const char* const begin = m_at;
    const AnyNumber number = numberOf(word());
    if (number.isNumber && std::abs(number.value) <= std::numeric_limits<float>::max()) {
        return static_cast<float>(number.value);
    }
    m_at = begin;
    return std::nullopt;
}

bool TextScanner::skipNumber()
{
    const char* const begin = m_at;
    const bool isNumber = numberOf(word()).isNumber;
    m_at = isNumber ? m_at : begin;
    return isNumber;
}

tl::unexpected<Error> TextScanner::expected(const std::string& what)
{
    if (!atLineEnd()) {
        return expected(what, quoted(word()));
    }
    return expected(what, rest().empty() ? "the end of the file" : "the end of the line");
}

tl::unexpected<Error> TextScanner::expected(const std::string& what, const std::string& found) const
{
    return contentsError("line " + std::to_string(m_line) + ": expected " + what + ", found " +
                         found);
}

} // namespace trixel
