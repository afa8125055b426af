// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/off_header.h"

namespace trixel {
namespace {

bool skipPrefix(std::string_view& word, std::string_view prefix)
{
    if (!word.starts_with(prefix)) {
        return false;
    }
    word.remove_prefix(prefix.size());
    return true;
}

} // namespace

Result<OffHeader> parseOffHeader(TextScanner& scanner)
{
    scanner.skipEmptyLines();
    TextScanner start = scanner;
    OffHeader header;
    if (TextScanner(start).integer()) {
        return header; // the counts come at once: the word may be missing
    }
    std::string_view word = scanner.word();
    header.textureCoordinates = skipPrefix(word, "ST");
    header.colours = skipPrefix(word, "C");
    header.normals = skipPrefix(word, "N");
    if (word != "OFF") {
        const bool otherDimension = word == "4OFF" || word == "nOFF" || word == "4nOFF";
        return start.expected(otherDimension ? "vertices of three dimensions (OFF)"
                                             : "OFF, COFF, NOFF or STOFF");
    }
    const TextScanner afterWord = scanner;
    if (scanner.word() == "BINARY") {
        header.binary = true;
        if (!scanner.atLineEnd()) {
            return scanner.expected("the end of the line after BINARY");
        }
        scanner.skipLine();
    } else {
        scanner = afterWord;
    }
    return header;
}

} // namespace trixel
