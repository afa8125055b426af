// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/exchange/paint_transfer.h"

#include <QFileInfo>

#include "core/io/channel_colors.h"
#include "ui/dialogs/format_choice.h"
#include "ui/exchange/other_file.h"

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
        [from = std::move(from), to = m_document.snapshot(), options](Progress& progress) {
            return transfer(*from, to, options, progress);
        },
        [this, path, state = m_document.state()](Result<Transfer> result) {
            take(std::move(result), path, state);
        });
}

void PaintTransfer::take(Result<Transfer> transfer, const QString& path, StateId madeFor)
{
    const QString name = QFileInfo(path).fileName();
    if (!transfer) {
        if (transfer.error().kind != ErrorKind::Cancelled) {
            emit failed(tr("%1: %2").arg(name, sentenceOf(transfer.error(), path)));
        }
        return;
    }
    if (transfer->reached == 0) {
        emit failed(tr("%1: no texel is near enough to take paint from it.").arg(name));
        return;
    }
    const QString told = tr("%1 of %2 texels took paint from %3.")
                             .arg(countText(transfer->reached), countText(transfer->total), name);
    if (m_document.replaceTexels(
            std::move(transfer->texels), madeFor, tr("Transfer paint from %1").arg(name))) {
        emit transferred(told);
    }
}

} // namespace trixel::ui
