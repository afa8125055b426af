// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/status_line.h"

#include "ui/dialogs/format_choice.h"
#include "ui/document/document.h"

namespace trixel::ui {

namespace {

constexpr int kPauseMs = 500;

struct Counts
{
    std::uint64_t texels = 0;
    std::uint64_t bytes = 0;
};

} // namespace

StatusLine::StatusLine(Document& document, QWidget* parent)
    : QLabel(parent)
    , m_document(document)
{
    setAccessibleName(tr("Size of the texture"));
    setToolTip(tr("Faces, texels, memory the texels take now, type and channels"));
    m_pause.setSingleShot(true);
    m_pause.setInterval(kPauseMs);
    connect(&m_pause, &QTimer::timeout, this, &StatusLine::count);
    connect(&document, &Document::opened, this, [this] {
        setText(withoutCounts()); // not what was open before, or that nothing was
        count();
    });
    connect(&document, &Document::changed, this, [this] {
        if (!m_pause.isActive()) {
            m_pause.start();
        }
    });
    count();
}

void StatusLine::count()
{
    if (!m_document.isOpen()) {
        setText(withoutCounts());
        return;
    }
    const quint64 generation = ++m_generation;
    m_jobs.run(
        QString(),
        [texels = m_document.texels()](Progress& /*progress*/) -> Result<Counts> {
            return Counts{texels.texelCount(), texels.storedBytes()};
        },
        [this, generation](const Result<Counts>& counts) {
            if (generation != m_generation || !counts) {
                return;
            }
            setText(tr("%1 faces · %2 texels · %3 · %4")
                        .arg(countText(m_document.texels().faceCount()),
                             countText(counts->texels),
                             sizeText(counts->bytes),
                             channelsText()));
        });
}

QString StatusLine::withoutCounts() const
{
    return m_document.isOpen()
               ? tr("%1 faces · %2").arg(countText(m_document.texels().faceCount()), channelsText())
               : tr("Nothing is open");
}

QString StatusLine::channelsText() const
{
    const TexelFormat& format = m_document.texels().format();
    const std::string_view type = nameOf(format.type);
    return tr("%1 × %2")
        .arg(format.channels)
        .arg(QString::fromUtf8(type.data(), static_cast<qsizetype>(type.size())));
}

} // namespace trixel::ui
