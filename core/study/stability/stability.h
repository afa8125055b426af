// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sweeps through every hazard of footprints and filters: the textbook's formula beside ours, each
// judged against the truth, value by value, until one of them leaves the chart.
#pragma once

#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/filter/filter_scene.h"
#include "core/mesh/surface.h"
#include "core/texture/texel_store.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace trixel {

/// One value of what is swept.
struct SweepValue
{
    double at = 0;     ///< may be infinite or NaN: then only the label says what it is
    std::string label; ///< as people read it: "1e-6", "Inf", "w = 0"

    bool operator==(const SweepValue&) const = default;
};

/// How far one form is from the truth at every value.
struct StabilityCurve
{
    std::string form;   ///< the formula in a few words, or the name of a filter method
    bool naive = false; ///< the textbook's: shown beside ours, not bound by anything
    /// One a value. Infinite where there is no usable answer: not a number, of the wrong sign, or
    /// outside of what exists.
    std::vector<double> errors;

    bool operator==(const StabilityCurve&) const = default;
};

enum class SweepAxis {
    Logarithmic, ///< values that are not positive and finite stand beside the axis
    Linear,
    Listed ///< evenly, in their order
};

/// One hazard: what is varied, what has to hold, and who kept it.
struct StabilitySweep
{
    std::string name{};      ///< as files and the command line call it: "parallel-vectors"
    std::string title{};     ///< as people read it
    std::string hazard{};    ///< what goes wrong with the textbook's formula, one sentence
    std::string property{};  ///< what has to hold, one sentence
    std::string axisTitle{}; ///< of what is varied, with its unit
    SweepAxis axis = SweepAxis::Logarithmic;
    std::string errorTitle{}; ///< what the error measures, with its unit
    double bound = 0;         ///< largest error allowed to forms that are not naive
    std::vector<SweepValue> values{};
    std::vector<StabilityCurve> curves{}; ///< naive ones first

    /// Largest error of all naive curves, or of all others.
    double worst(bool naive) const;
    /// Whether every curve that is not naive stays within the bound.
    bool holds() const;
    /// Values at which some naive curve is beyond the bound.
    std::size_t naiveFailures() const;

    bool operator==(const StabilitySweep&) const = default;
};

/// Hazards found on the faces of an asset.
struct AssetFinding
{
    std::string name;           ///< "asset-needles", "asset-valence", …
    std::string title;          ///< as people read it, with the unit of `worst`
    std::uint64_t count = 0;    ///< faces, vertices or edges concerned
    double worst = 0;           ///< of the worst one
    std::optional<FaceId> face; ///< where the worst one is
    /// On the worst faces, of filters that are continuous: the largest jump across an edge between
    /// faces that are no needles, of the value range; infinite where one gives no number for a
    /// footprint of any length. Nothing where there is no such face.
    std::optional<double> error;
    double bound = 0; ///< that the error has to keep

    bool holds() const { return !error || *error <= bound; }
    bool operator==(const AssetFinding&) const = default;
};

struct StabilityReport
{
    std::string subject;    ///< the asset's name, or "no asset"
    std::string conditions; ///< what one needs to repeat it
    std::vector<StabilitySweep> sweeps;
    std::vector<AssetFinding> findings;

    /// Whether every sweep and finding keeps its bound.
    bool holds() const;
};

/// A row of the table of hazards.
struct SweepEntry
{
    std::string_view name;
    /// Deterministic, well under a second.
    StabilitySweep (*run)() = nullptr;
};

/// All of them: footprints, cameras, mappings, lattice, weights, filters.
std::span<const SweepEntry> stabilitySweeps();

/// Runs one. \param name  of an entry (checked)
StabilitySweep runSweep(std::string_view name);

/// Hears of sweeps as they are done; from the thread that runs the study.
class StabilityWatcher : public Progress
{
public:
    virtual void swept(const StabilitySweep& sweep) = 0;
};

/// An asset whose own faces are to be looked at. Refers to what it is made of.
class StabilityAsset
{
public:
    /// \param mesh  null: every face counts as equilateral
    StabilityAsset(std::string name, const FilterScene& scene, const TriangleMesh* mesh);
    /// The scene to filter is built by `findHazards`. \param texels  of the surface; not null
    StabilityAsset(std::string name, const Surface& surface, const TexelStore* texels);

    const std::string& name() const { return m_name; }
    const TriangleMesh* mesh() const { return m_mesh; }
    /// What was given, or is built now. Fails only when cancelled.
    Result<std::shared_ptr<const FilterScene>> scene(Threads threads, Progress& progress) const;

private:
    std::string m_name;
    const TriangleMesh* m_mesh = nullptr;
    const FilterScene* m_scene = nullptr;
    const Surface* m_surface = nullptr;
    const TexelStore* m_texels = nullptr;
};

/// Runs every sweep, and looks for the worst faces of the asset where there is one. Seconds. Fails
/// only when cancelled.
Result<StabilityReport>
runStability(const StabilityAsset* asset, Threads threads, StabilityWatcher& watcher);

/// What an asset's own faces hold of the hazards. Fails only when cancelled.
Result<std::vector<AssetFinding>>
findHazards(const StabilityAsset& asset, Threads threads, Progress& progress);

} // namespace trixel
