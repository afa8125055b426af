// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/exchange/file_field.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QStyle>
#include <QVBoxLayout>

#include "ui/dialogs/path_row.h"

namespace trixel::ui {

namespace {

constexpr int kTypingPauseMs = 350;

} // namespace

FileField::FileField(const QString& name, const QString& filter, const QString& hint)
    : m_row(new PathRow(PathRow::Purpose::Open, name, filter))
    , m_about(new QLabel)
    , m_hint(hint)
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(m_row);
    layout->addWidget(m_about);
    m_about->setWordWrap(true);
    m_about->setAlignment(Qt::AlignTop);
    // Two lines from the start, so that answers move nothing.
    m_about->setMinimumHeight(2 * fontMetrics().lineSpacing());
    m_about->setAccessibleName(tr("About the %1").arg(name.toLower()));
    m_about->setToolTip(tr("What was found in the file"));
    setFocusProxy(m_row);
    m_typing.setSingleShot(true);
    m_typing.setInterval(kTypingPauseMs);
    connect(&m_typing, &QTimer::timeout, this, &FileField::look);
    connect(m_row, &PathRow::pathChanged, this, [this] {
        emit left();
        say(path().isEmpty() ? m_hint : tr("Reading…"), false);
        m_typing.start();
    });
    say(m_hint, false);
}

QString FileField::path() const
{
    return m_row->path();
}

void FileField::setPath(const QString& path)
{
    m_row->setPath(path);
    m_typing.stop();
    look();
}

void FileField::look()
{
    if (!path().isEmpty()) {
        emit lookWanted(path());
    }
}

void FileField::showFound(const QString& sentence)
{
    say(sentence, false);
}

void FileField::showError(const QString& sentence)
{
    say(sentence, true);
}

/// Told by a sign as well as by words: colours alone are not seen by all.
void FileField::say(const QString& sentence, bool isError)
{
    m_hasError = isError;
    m_about->setText(isError ? QString::fromUtf8("⚠ ") + sentence : sentence);
}

} // namespace trixel::ui
