// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/mnemonics.h"

namespace trixel::ui {

QString withMnemonic(QString text, Mnemonics& taken, qsizetype from)
{
    for (qsizetype step = 0; step < text.size(); ++step) {
        const qsizetype k = (from + step) % text.size();
        const QChar letter = text[k].toLower();
        if (letter.isLetterOrNumber() && !taken.contains(letter)) {
            taken += letter;
            return text.insert(k, '&');
        }
    }
    for (char digit = '1'; digit <= '9'; ++digit) {
        if (!taken.contains(QLatin1Char(digit))) {
            taken += QLatin1Char(digit);
            return text + QStringLiteral(" (&%1)").arg(QLatin1Char(digit));
        }
    }
    return text;
}

} // namespace trixel::ui
