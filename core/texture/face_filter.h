// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which faces a person wants to see, written as one line: "level>=5 density<100 !constant".
#pragma once

#include "core/base/result.h"
#include "core/texture/face_figures.h"

#include <span>
#include <string_view>
#include <vector>

namespace trixel {

/// A column of the table of faces.
enum class FaceColumn : std::uint8_t {
    Face,
    Level,
    Texels,
    Bytes,
    Constant,
    Density,
    Lowest,
    Highest,
    Mean,
    Jump
};

inline constexpr FaceColumn kFaceColumns[] = {FaceColumn::Face,
                                              FaceColumn::Level,
                                              FaceColumn::Texels,
                                              FaceColumn::Bytes,
                                              FaceColumn::Constant,
                                              FaceColumn::Density,
                                              FaceColumn::Lowest,
                                              FaceColumn::Highest,
                                              FaceColumn::Mean,
                                              FaceColumn::Jump};

/// As filters and files call it: "face", "level", "texels", "bytes", "constant", "density", "min",
/// "max", "mean", "jump".
std::string_view nameOf(FaceColumn column);

/// All that columns and filters are about. Refers to what others own.
struct FaceFacts
{
    const FaceFigures& figures;
    /// Largest jump over the edges of each face, a fraction of the value range; NaN for a face that
    /// was not measured, empty where none was.
    std::span<const float> jumps;
    std::span<const FaceId> selected; ///< ascending
};

/// What stands in a column, constant as 1 and 0. NaN where nothing is known.
double valueIn(const FaceFacts& facts, FaceColumn column, FaceId face);

/// One condition of a filter.
struct FaceTerm
{
    enum class Kind : std::uint8_t { Compare, Constant, Selected, Nan };
    enum class Comparison : std::uint8_t { Equal, NotEqual, Less, LessEqual, More, MoreEqual };

    Kind kind = Kind::Compare;
    FaceColumn column = FaceColumn::Face; ///< of a comparison
    Comparison comparison = Comparison::Equal;
    double value = 0;
    bool isNegated = false; ///< of the others

    bool operator==(const FaceTerm&) const = default;
};

/// Conditions that all hold; none for every face.
struct FaceFilter
{
    std::vector<FaceTerm> terms;

    bool isEmpty() const { return terms.empty(); }
    /// Whether it tells faces apart by whether they are selected.
    bool asksForSelection() const;
    /// Whether painting can change which faces pass.
    bool asksForTexels() const;

    bool operator==(const FaceFilter&) const = default;
};

/// Conditions with blanks or commas between them: a column, one of = != < <= > >=, and a number
/// (1k, 1M, 1G count thousands; 5% hundredths); or `constant`, `selected`, `nan`, each also with !
/// before it; or a number alone, which means that face. Case does not count.
/// Errors: one sentence that tells what was found and what would do (Contents).
Result<FaceFilter> parseFaceFilter(std::string_view text);

/// Whether a face passes. NaN passes no comparison but !=.
bool passes(const FaceFilter& filter, const FaceFacts& facts, FaceId face);

} // namespace trixel
