// SPDX-License-Identifier: GPL-3.0-or-later
//
// Files that are part of the program: the assembler puts them into it as they are, the build says
// where they lie.
#pragma once

// NOLINTBEGIN: no other way to name what the assembler defines
/// Defines `symbolBegin` and `symbolEnd`, the bytes of a file. Outside of namespaces.
#define TRIXEL_EMBED(symbol, file)                                                                 \
    __asm__(".section .rodata\n"                                                                   \
            ".global " #symbol "Begin\n.global " #symbol "End\n" #symbol "Begin:\n.incbin \"" file \
            "\"\n" #symbol "End:\n"                                                                \
            ".previous\n");                                                                        \
    extern "C" const char symbol##Begin[];                                                         \
    extern "C" const char symbol##End[];
// NOLINTEND
