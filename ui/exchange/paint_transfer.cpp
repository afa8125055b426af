// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/exchange/paint_transfer.h"

#include <QFileInfo>

#include "core/io/channel_colors.h"
#include "core/layers/layer_edits.h"
#include "ui/dialogs/format_choice.h"
#include "ui/document/made_layers.h"
#include "ui/exchange/other_file.h"

#include <optional>
#include <utility>

namespace trixel::ui {

namespace {

Result<Transfer>
transfer(const Project& from, const Project& to, TransferOptions options, Progress& progress)
{
    TransferColors colors = transferColors(
        channelColors(from), from.texels.format(), channelColors(to), to.texels.format());
    options.colors = std::move(colors.texels);
    StageProgress preparing(progress, 0, 0.3);
    const auto paint =
        transferScene(*from.surface, from.texels, colors.paint, options.threads, preparing);
    if (!paint) {
        return tl::unexpected(paint.error());
    }
    StageProgress working(progress, 0.3, 1);
    return transferPaint(*from.surface, *paint, *to.surface, to.texels, options, working);
}

} // namespace

/// What comes of a transfer.
struct PaintTransfer::Made
{
    Transfer transfer;
    std::optional<LayersEdit> layers; ///< in the place of its texels
};

Result<PaintTransfer::Made> PaintTransfer::make(const Project& from,
                                                const Project& to,
                                                LayerId active,
                                                const QString& file,
                                                const TransferOptions& options,
                                                Progress& progress)
{
    if (to.layers.isPlain()) {
        return transfer(from, to, options, progress).transform([](Transfer&& done) {
            return Made{std::move(done), std::nullopt};
        });
    }
    StageProgress transferring(progress, 0, 0.8);
    Result<Transfer> done = transfer(from, to, options, transferring);
    if (!done) {
        return tl::unexpected(done.error());
    }
    StageProgress layering(progress, 0.8, 1);
    const TexelPatch patch = patchTo(done->texels, to.texels);
    return withPatchAsLayer(to, active, patch, file, layering).transform([&](LayersEdit&& edit) {
        return Made{std::move(*done), std::move(edit)};
    });
}

PaintTransfer::PaintTransfer(Document& document, BackgroundJobs& jobs, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_jobs(jobs)
{
}

void PaintTransfer::begin(std::shared_ptr<const Project> from,
                          const QString& path,
                          const TransferOptions& options)
{
    m_document.endStroke();
    const StateId opened = m_document.openedState();
    m_document.whenSettled([this, from = std::move(from), path, options, opened] {
        if (m_document.openedState() == opened) { // no other project meanwhile
            beginNow(from, path, options);
        }
    });
}

void PaintTransfer::beginNow(std::shared_ptr<const Project> from,
                             const QString& path,
                             const TransferOptions& options)
{
    if (m_job) {
        m_job->cancel();
    }
    m_job = &m_jobs.run(
        tr("Transferring paint from %1…").arg(QFileInfo(path).fileName()),
        [from = std::move(from),
         to = m_document.snapshot(),
         active = m_document.activeLayer(),
         path,
         options](Progress& progress) { return make(*from, to, active, path, options, progress); },
        [this, path, state = m_document.state()](Result<Made> made) {
            take(std::move(made), path, state);
        });
}

void PaintTransfer::take(Result<Made> made, const QString& path, StateId madeFor)
{
    const QString name = QFileInfo(path).fileName();
    if (!made) {
        if (made.error().kind != ErrorKind::Cancelled) {
            emit failed(tr("%1: %2").arg(name, sentenceOf(made.error(), path)));
        }
        return;
    }
    Transfer& transfer = made->transfer;
    if (transfer.reached == 0) {
        emit failed(tr("%1: no texel is near enough to take paint from it.").arg(name));
        return;
    }
    const QString told = tr("%1 of %2 texels took paint from %3.")
                             .arg(countText(transfer.reached), countText(transfer.total), name);
    const QString text = tr("Transfer paint from %1").arg(name);
    const bool isDone = made->layers
                            ? m_document.replaceLayers(std::move(*made->layers), madeFor, text)
                            : m_document.replaceTexels(std::move(transfer.texels), madeFor, text);
    if (isDone) {
        emit transferred(told);
    }
}

} // namespace trixel::ui
