// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/face_filter.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

namespace trixel {

namespace {

using Kind = FaceTerm::Kind;
using Comparison = FaceTerm::Comparison;

constexpr std::size_t kMostShown = 40;

/// A word of what was typed, short enough for a sentence.
std::string shown(std::string_view text)
{
    std::string quoted = "'";
    quoted.append(text.substr(0, kMostShown));
    return quoted.append(text.size() > kMostShown ? "…'" : "'");
}

std::string lowered(std::string_view text)
{
    std::string low(text);
    std::ranges::transform(
        low, low.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return low;
}

constexpr bool separates(char c)
{
    return c == ' ' || c == ',' || c == ';' || c == '\t' || c == '\n' || c == '\r';
}

constexpr bool compares(char c)
{
    return c == '<' || c == '>' || c == '=' || c == '!';
}

/// Takes text from the front of a line.
class Scanner
{
public:
    explicit Scanner(std::string_view text)
        : m_rest(text)
    {
    }

    void skipBlanks()
    {
        skipWhile([](char c) { return separates(c); });
    }
    bool atEnd() const { return m_rest.empty(); }
    std::string_view rest() const { return m_rest; }
    bool skip(std::string_view word)
    {
        const bool there = m_rest.starts_with(word);
        m_rest.remove_prefix(there ? word.size() : 0);
        return there;
    }
    /// Up to a blank or a comparison.
    std::string_view word()
    {
        return takeWhile([](char c) { return !separates(c) && !compares(c); });
    }

private:
    template <class Holds>
    std::string_view takeWhile(const Holds& holds)
    {
        const auto end = std::ranges::find_if_not(m_rest, holds);
        const auto count = static_cast<std::size_t>(end - m_rest.begin());
        const std::string_view taken = m_rest.substr(0, count);
        m_rest.remove_prefix(count);
        return taken;
    }
    template <class Holds>
    void skipWhile(const Holds& holds)
    {
        static_cast<void>(takeWhile(holds));
    }

    std::string_view m_rest;
};

std::optional<FaceColumn> columnNamed(std::string_view name)
{
    for (const FaceColumn column : kFaceColumns) {
        if (nameOf(column) == name) {
            return column;
        }
    }
    return std::nullopt;
}

std::optional<Kind> flagNamed(std::string_view name)
{
    for (const auto& [flag, kind] : {std::pair("constant", Kind::Constant),
                                     std::pair("selected", Kind::Selected),
                                     std::pair("nan", Kind::Nan)}) {
        if (name == flag) {
            return kind;
        }
    }
    return std::nullopt;
}

std::optional<Comparison> takeComparison(Scanner& scanner)
{
    // The longer ones first.
    for (const auto& [sign, comparison] : {std::pair("<=", Comparison::LessEqual),
                                           std::pair(">=", Comparison::MoreEqual),
                                           std::pair("!=", Comparison::NotEqual),
                                           std::pair("==", Comparison::Equal),
                                           std::pair("<", Comparison::Less),
                                           std::pair(">", Comparison::More),
                                           std::pair("=", Comparison::Equal)}) {
        if (scanner.skip(sign)) {
            return comparison;
        }
    }
    return std::nullopt;
}

double factorOf(std::string_view suffix)
{
    // K and M as people write them for counts and bytes alike.
    return suffix == "k"    ? 1e3
           : suffix == "m"  ? 1e6
           : suffix == "g"  ? 1e9
           : suffix == "%"  ? 1e-2
           : suffix.empty() ? 1
                            : std::numeric_limits<double>::quiet_NaN();
}

std::optional<double> numberFrom(std::string_view word)
{
    const std::string low = lowered(word.starts_with('+') ? word.substr(1) : word);
    double value = 0;
    const auto [end, error] = std::from_chars(low.data(), low.data() + low.size(), value);
    if (error != std::errc() || !std::isfinite(value)) {
        return std::nullopt;
    }
    value *= factorOf({end, low.data() + low.size()});
    return std::isnan(value) ? std::nullopt : std::optional(value);
}

Result<FaceTerm> comparison(FaceColumn column, Scanner& scanner)
{
    const std::string name(nameOf(column));
    scanner.skipBlanks();
    const auto sign = takeComparison(scanner);
    if (!sign) {
        return contentsError("Filter: expected = != < <= > or >= after '" + name + "', found " +
                             (scanner.atEnd() ? "nothing" : shown(scanner.rest())) + ".");
    }
    scanner.skipBlanks();
    const std::string_view word = scanner.word();
    const auto value = numberFrom(word);
    if (!value) {
        return contentsError("Filter: expected a number to compare '" + name + "' with, found " +
                             (word.empty() ? "none" : shown(word)) + ".");
    }
    return FaceTerm{Kind::Compare, column, *sign, *value, false};
}

Result<FaceTerm> term(Scanner& scanner)
{
    const bool negated = scanner.skip("!");
    const std::string_view found = scanner.word();
    const std::string word = lowered(found);
    if (const auto flag = flagNamed(word)) {
        return FaceTerm{*flag, FaceColumn::Face, Comparison::Equal, 0, negated};
    }
    if (!negated) {
        if (const auto column = columnNamed(word)) {
            return comparison(*column, scanner);
        }
        if (const auto number = numberFrom(word)) {
            return FaceTerm{Kind::Compare, FaceColumn::Face, Comparison::Equal, *number, false};
        }
    }
    return contentsError(
        "Filter: expected face, level, texels, bytes, density, min, max, mean, jump, constant, "
        "selected or nan, found " +
        shown(found.empty() ? scanner.rest() : found) + ".");
}

bool compare(double found, Comparison comparison, double wanted)
{
    switch (comparison) {
    case Comparison::Equal:
        return found == wanted;
    case Comparison::NotEqual:
        return found != wanted;
    case Comparison::Less:
        return found < wanted;
    case Comparison::LessEqual:
        return found <= wanted;
    case Comparison::More:
        return found > wanted;
    case Comparison::MoreEqual:
        break;
    }
    return found >= wanted;
}

bool holds(const FaceTerm& term, const FaceFacts& facts, FaceId face)
{
    switch (term.kind) {
    case Kind::Compare: {
        // Figures are floats: 0.1 means the float that is meant by it.
        const double found = valueIn(facts, term.column, face);
        const bool isFloat = term.column >= FaceColumn::Density;
        return compare(found,
                       term.comparison,
                       isFloat ? static_cast<double>(static_cast<float>(term.value)) : term.value);
    }
    case Kind::Constant:
        return facts.figures.isConstant(face) != term.isNegated;
    case Kind::Selected:
        return std::ranges::binary_search(facts.selected, face) != term.isNegated;
    case Kind::Nan:
        break;
    }
    return facts.figures.holdsNan(face) != term.isNegated;
}

} // namespace

std::string_view nameOf(FaceColumn column)
{
    constexpr std::string_view kNames[] = {
        "face", "level", "texels", "bytes", "constant", "density", "min", "max", "mean", "jump"};
    return kNames[static_cast<std::size_t>(column)];
}

double valueIn(const FaceFacts& facts, FaceColumn column, FaceId face)
{
    const FaceFigures& figures = facts.figures;
    switch (column) {
    case FaceColumn::Face:
        return static_cast<double>(indexOf(face));
    case FaceColumn::Level:
        return figures.level(face).log2();
    case FaceColumn::Texels:
        return figures.level(face).texelCount();
    case FaceColumn::Bytes:
        return static_cast<double>(figures.bytes(face));
    case FaceColumn::Constant:
        return figures.isConstant(face) ? 1 : 0;
    case FaceColumn::Density:
        return static_cast<double>(figures.density(face));
    case FaceColumn::Lowest:
        return static_cast<double>(figures.lowest(face));
    case FaceColumn::Highest:
        return static_cast<double>(figures.highest(face));
    case FaceColumn::Mean:
        return static_cast<double>(figures.mean(face));
    case FaceColumn::Jump:
        break;
    }
    return indexOf(face) < facts.jumps.size() ? static_cast<double>(facts.jumps[indexOf(face)])
                                              : std::numeric_limits<double>::quiet_NaN();
}

bool FaceFilter::asksForSelection() const
{
    return std::ranges::any_of(terms,
                               [](const FaceTerm& term) { return term.kind == Kind::Selected; });
}

bool FaceFilter::asksForTexels() const
{
    return std::ranges::any_of(terms, [](const FaceTerm& term) {
        return term.kind != Kind::Selected &&
               !(term.kind == Kind::Compare &&
                 (term.column == FaceColumn::Face || term.column == FaceColumn::Jump));
    });
}

Result<FaceFilter> parseFaceFilter(std::string_view text)
{
    FaceFilter filter;
    Scanner scanner(text);
    for (scanner.skipBlanks(); !scanner.atEnd(); scanner.skipBlanks()) {
        const Result<FaceTerm> next = term(scanner);
        if (!next) {
            return tl::unexpected(next.error());
        }
        filter.terms.push_back(*next);
    }
    return filter;
}

bool passes(const FaceFilter& filter, const FaceFacts& facts, FaceId face)
{
    return std::ranges::all_of(filter.terms,
                               [&](const FaceTerm& term) { return holds(term, facts, face); });
}

} // namespace trixel
