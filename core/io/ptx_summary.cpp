// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/ptx_summary.h"

#include "core/io/layers_metadata.h"
#include "core/io/project_metadata.h"
#include "core/io/ptx_file.h"
#include "core/io/ptx_reader.h"

namespace trixel {

namespace {

PtxSummary::Item itemOf(const PtxMetadata& item)
{
    PtxSummary::Item summary;
    summary.key = item.key;
    summary.type = static_cast<std::uint8_t>(item.value.index());
    summary.count = std::visit([](const auto& value) { return value.size(); }, item.value);
    if (const auto* text = std::get_if<std::string>(&item.value)) {
        summary.text = *text;
    }
    return summary;
}

void countFaces(const PtxFile& file, PtxSummary& summary)
{
    for (const PtxFaceInfo& info : file.infos()) {
        ++summary.facesOfLevel[static_cast<std::size_t>(info.level().log2())];
        summary.constantFaces += info.isConstant() ? 1 : 0;
        summary.editedFaces += info.isEdited() ? 1 : 0;
        summary.texelCount += info.level().texelCount();
    }
}

} // namespace

Result<PtxSummary> summarisePtx(const std::filesystem::path& path)
{
    MemoryBudget budget;
    const auto file = openPtxFile(path, budget);
    if (!file) {
        return tl::unexpected(file.error());
    }
    const auto items = file->metadata(budget);
    if (!items) {
        return prefixed(path.string(), items.error());
    }
    auto layers = layersOf(*items);
    const auto format = shownFormat(file->format(), *items);
    if (!layers || !format) {
        return prefixed(path.string(), layers ? format.error() : layers.error());
    }
    PtxSummary summary;
    summary.format = *format;
    summary.layers = std::move(*layers);
    summary.faceCount = file->faceCount();
    summary.levelCount = file->levelCount();
    countFaces(*file, summary);
    summary.fileBytes = file->source().size();
    summary.texelBytes = file->texelBytes();
    for (const PtxMetadata& item : *items) {
        summary.metadata.push_back(itemOf(item));
    }
    summary.carriesMesh = carriesMesh(*items);
    summary.isProject = projectVersionOf(*items).has_value();
    return summary;
}

} // namespace trixel
