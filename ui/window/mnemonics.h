// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSet>
#include <QString>

namespace trixel::ui {

/// The letters that the entries of one menu are reached by.
using Mnemonics = QSet<QChar>;

/// The text with a mnemonic that no entry before has taken: its first free letter or digit, or,
/// where it has none, a digit after it.
/// \param from  where to look first, such as at what tells the entry from others of its kind
QString withMnemonic(QString text, Mnemonics& taken, qsizetype from = 0);

} // namespace trixel::ui
