// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/export_project.h"

#include "core/texture/convert.h"

#include <system_error>
#include <utility>

namespace trixel {

namespace {

/// Writes one kind of export; what it answers is what was written.
class Exporter
{
public:
    Exporter(const ImageWorker& worker,
             const Project& project,
             const std::filesystem::path& path,
             Progress& progress)
        : m_worker(worker)
        , m_project(project)
        , m_path(path)
        , m_progress(progress)
    {
    }

    Result<ExportOutcome> operator()(const PtxExportOptions& options) const
    {
        StageProgress converting(m_progress, 0, 0.3);
        auto texels = converted(m_project.texels,
                                options.type.value_or(m_project.texels.format().type),
                                Threads::all(),
                                converting);
        if (!texels) {
            return tl::unexpected(texels.error());
        }
        Project project = m_project;
        project.texels = std::move(*texels);
        StageProgress writing(m_progress, 0.3, 1);
        return exportPtx(m_path, project, PtxWriteOptions{.mips = options.mips}, writing).map([&] {
            return outcome({m_path.filename().string()});
        });
    }

    Result<ExportOutcome> operator()(const PackedExportOptions& options) const
    {
        return PackedExport::plan(m_path, m_project, options)
            .and_then([&](const PackedExport& plan) {
                return plan.write(m_worker, m_progress).map([&] { return outcome(plan.files()); });
            });
    }

    Result<ExportOutcome> operator()(const HandOffExportOptions& options) const
    {
        return HandOffExport::plan(m_path, m_project, options)
            .and_then([&](const HandOffExport& plan) {
                return plan.write(m_worker, m_progress).map([&](const HandOffOutcome& handOff) {
                    ExportOutcome result = outcome(plan.files());
                    result.largestJump = handOff.largestJump;
                    return result;
                });
            });
    }

    Result<ExportOutcome> operator()(const UvExportOptions& options) const
    {
        return exportUvImages(m_worker, m_path, m_project, options, Threads::all(), m_progress)
            .map([&](const std::vector<UvTileOutcome>& tiles) {
                std::vector<std::string> names;
                for (const UvTileOutcome& tile : tiles) {
                    names.push_back(tile.file.filename().string());
                }
                ExportOutcome result = outcome(names);
                for (const UvTileOutcome& tile : tiles) {
                    result.facesLost += tile.facesWithoutPixel;
                }
                return result;
            });
    }

private:
    ExportOutcome outcome(const std::vector<std::string>& names) const
    {
        ExportOutcome result;
        for (const std::string& name : names) {
            result.files.push_back(m_path.parent_path() / name);
            std::error_code gone;
            const std::uintmax_t size = std::filesystem::file_size(result.files.back(), gone);
            result.bytes += gone ? 0 : size;
        }
        return result;
    }

    const ImageWorker& m_worker;
    const Project& m_project;
    const std::filesystem::path& m_path;
    Progress& m_progress;
};

} // namespace

Result<ExportOutcome> exportProject(const ImageWorker& worker,
                                    const Project& project,
                                    const ExportRequest& request,
                                    Progress& progress)
{
    StageProgress parting(progress, 0, 0.1);
    const auto part = partOf(project, request.part, Threads::all(), parting);
    if (!part) {
        return part.error().kind == ErrorKind::Contents
                   ? prefixed(request.path.string(), part.error())
                   : tl::unexpected(part.error());
    }
    StageProgress writing(progress, 0.1, 1);
    return std::visit(Exporter(worker, *part, request.path, writing), request.options);
}

} // namespace trixel
