// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/obj_statement.h"

#include <algorithm>
#include <array>

namespace trixel {
namespace {

// Grouping, appearance, points, lines and free-form geometry of the OBJ specification 3.0. Not
// "call" and "csh", which bring in other files.
constexpr std::array<std::string_view, 38> kSkipped{
    "g",         "o",        "s",      "usemtl", "mtllib", "l",     "p",     "vp",
    "mg",        "deg",      "cstype", "bmat",   "step",   "curv",  "curv2", "surf",
    "parm",      "trim",     "hole",   "scrv",   "sp",     "end",   "con",   "bevel",
    "c_interp",  "d_interp", "lod",    "usemap", "maplib", "ctech", "stech", "shadow_obj",
    "trace_obj", "bsp",      "bzp",    "cdc",    "cdp",    "res"};

bool isLetter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

// Whether a word looks like a statement that some program adds for itself: programs skip what they
// don't know. A single letter, a digit or an 'f' in front rather tell of a damaged vertex or face.
bool looksLikeExtension(std::string_view keyword)
{
    return keyword.size() >= 2 && keyword.front() != 'f' &&
           std::all_of(keyword.begin(), keyword.end(), isLetter) && keyword != "call" &&
           keyword != "csh";
}

} // namespace

ObjStatement objStatementOf(std::string_view keyword)
{
    if (keyword == "v") {
        return ObjStatement::Vertex;
    }
    if (keyword == "f" || keyword == "fo") { // "fo" is the older spelling
        return ObjStatement::Face;
    }
    if (keyword == "vt") {
        return ObjStatement::Texture;
    }
    if (keyword == "vn") {
        return ObjStatement::Normal;
    }
    if (keyword == "t") {
        return ObjStatement::Tag;
    }
    const bool isKnown = std::find(kSkipped.begin(), kSkipped.end(), keyword) != kSkipped.end();
    return isKnown || looksLikeExtension(keyword) ? ObjStatement::Skipped : ObjStatement::Unknown;
}

} // namespace trixel
