// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/speed/cost_table.h"

#include "core/base/read_file.h"
#include "core/io/commit_file.h"
#include "core/study/speed/speed_accuracy.h"

#include <cstdlib>
#include <system_error>

namespace trixel {
namespace {

/// No table is as large; a file that is was not written by this program.
constexpr std::uint64_t kMostBytes = std::uint64_t{16} << 20U;

class Unwatched final : public StudyWatcher
{
public:
    explicit Unwatched(Progress& progress)
        : m_progress(progress)
    {
    }
    bool report(double fraction) override { return m_progress.report(fraction); }
    void measured(const StudyPoint& /*point*/) override {}

private:
    Progress& m_progress;
};

/// FNV-1a.
void hash(std::uint64_t& state, std::string_view text)
{
    for (const char c : text) {
        state = (state ^ static_cast<unsigned char>(c)) * 0x100000001B3U;
    }
}

/// Reads what is kept; errors say why it does not serve.
Result<CostTable> readKept(const std::filesystem::path& path)
{
    std::error_code unreadable;
    if (path.empty() || !std::filesystem::exists(path, unreadable)) {
        return contentsError("there was none");
    }
    const auto text = readFile(path, kMostBytes);
    if (!text) {
        return contentsError("it could not be read");
    }
    auto table = parseCostTable(*text);
    if (!table) {
        return contentsError("it was damaged");
    }
    if (!(table->machine == thisMachine())) {
        return contentsError("it was made on another machine or by another version");
    }
    if (table->contents != costTableContents()) {
        return contentsError("it was made with other methods");
    }
    return table;
}

/// Whatever fails here, the table is measured again next time.
void keep(const std::filesystem::path& path, const CostTable& table)
{
    if (path.empty()) {
        return;
    }
    std::error_code error;
    std::filesystem::create_directories(path.parent_path(), error);
    if (error) {
        return;
    }
    const std::string text = toJson(table);
    [[maybe_unused]] const Status kept = commitFile(
        path,
        [&](FileWriter& file) { return file.write(std::string_view(text)); },
        [&](const std::filesystem::path& written) -> Status {
            const auto found = readFile(written);
            return found && *found == text ? Status() : pathError("does not read back the same.");
        });
}

} // namespace

std::uint64_t costTableContents()
{
    static const std::uint64_t kContents = [] {
        std::uint64_t state = 0xCBF29CE484222325U;
        for (const MethodEntry& entry : filterMethods()) {
            hash(state, entry.name);
            if (entry.parameter) {
                for (const double value : entry.parameter->curve) {
                    hash(state, std::to_string(value));
                }
            }
            hash(state, ";");
        }
        hash(state, std::to_string(kStudyTiles));
        const TestDataFiles files = storedTestFiles();
        hash(state, files.natural);
        hash(state, files.hardEdged);
        hash(state, files.queries);
        return state;
    }();
    return kContents;
}

CostTable costTableOf(const Study& study)
{
    CostTable table{thisMachine(), costTableContents(), {}};
    for (const StudyPoint& point : study.points) {
        const bool known = !point.partly || point.series == "exact";
        if (point.method && point.footprintClass && point.refused == 0 && known) {
            table.entries.push_back(
                {*point.method, *point.footprintClass, point.cost, point.rms, point.p99});
        }
    }
    return table;
}

Result<CostTable> measureCostTable(Progress& progress)
{
    StageProgress building(progress, 0, 0.4);
    const auto subjects = storedSubjects(kStudyTiles, Threads::all(), building);
    if (!subjects) {
        return tl::unexpected(subjects.error());
    }
    SpeedAccuracyOptions options;
    options.rounds = 2;
    options.secondsAtMost = 0.6;
    options.secondsOfRounds = 0.15;
    options.withAuto = false;
    StageProgress measuring(progress, 0.4, 1);
    Unwatched watcher(measuring);
    return measureSpeedAccuracy(*subjects, tableContestants(*subjects), options, watcher)
        .map([](const Study& study) { return costTableOf(study); });
}

std::filesystem::path costTablePath()
{
    const char* cache = std::getenv("XDG_CACHE_HOME");
    std::filesystem::path base = cache != nullptr ? cache : "";
    if (!base.is_absolute()) {
        const char* home = std::getenv("HOME");
        if (home == nullptr || *home != '/') {
            return {};
        }
        base = std::filesystem::path(home) / ".cache";
    }
    return base / "trixel" / "filter-costs.json";
}

Result<FoundCostTable> findCostTable(const std::filesystem::path& path,
                                     Progress& progress,
                                     const std::function<Result<CostTable>(Progress&)>& measure)
{
    auto kept = readKept(path);
    if (kept) {
        return FoundCostTable{std::move(*kept), false, {}};
    }
    auto table = measure(progress);
    if (!table) {
        return tl::unexpected(table.error());
    }
    keep(path, *table);
    return FoundCostTable{std::move(*table), true, kept.error().message};
}

} // namespace trixel
