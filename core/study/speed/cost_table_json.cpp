// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/speed/cost_table.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace trixel {
namespace {

using nlohmann::json;

/// Null where the key is missing or the value is of another kind.
const std::string* textAt(const json& object, const char* key)
{
    const auto at = object.find(key);
    return at != object.end() ? at->get_ptr<const std::string*>() : nullptr;
}

/// NaN where there is none; JSON has no NaN of its own.
double numberAt(const json& object, const char* key)
{
    const auto at = object.find(key);
    return at != object.end() && at->is_number() ? at->get<double>() : std::nan("");
}

Result<CostEntry> entryOf(const json& row)
{
    if (!row.is_object()) {
        return contentsError("expected an object.");
    }
    const std::string* method = textAt(row, "method");
    const std::string* className = textAt(row, "class");
    if (method == nullptr || className == nullptr) {
        return contentsError("expected a method and a class.");
    }
    auto choice = parseMethod(*method);
    if (!choice) {
        return tl::unexpected(choice.error());
    }
    const auto classes = footprintClasses();
    const auto found = std::ranges::find(
        classes, *className, [](FootprintClass c) { return std::string(nameOf(c)); });
    CostEntry entry;
    entry.cost = numberAt(row, "cost");
    entry.rms = numberAt(row, "rms");
    entry.p99 = numberAt(row, "p99");
    const auto usable = [](double number) { return std::isfinite(number) && number >= 0; };
    if (found == classes.end() || !usable(entry.cost) || !usable(entry.rms) || !usable(entry.p99)) {
        return contentsError("expected a known class and finite numbers.");
    }
    entry.method = std::move(*choice);
    entry.footprintClass = *found;
    return entry;
}

} // namespace

std::string toJson(const CostTable& table)
{
    json entries = json::array();
    for (const CostEntry& entry : table.entries) {
        entries.push_back({{"method", toText(entry.method)},
                           {"class", nameOf(entry.footprintClass)},
                           {"cost", entry.cost},
                           {"rms", entry.rms},
                           {"p99", entry.p99}});
    }
    return json{{"version", 1},
                {"processor", table.machine.processor},
                {"simd", table.machine.simd},
                {"program", table.machine.version},
                {"contents", table.contents},
                {"entries", std::move(entries)}}
        .dump(1, ' ', false, json::error_handler_t::replace);
}

Result<CostTable> parseCostTable(std::string_view text)
{
    const json root = json::parse(text, nullptr, false);
    if (!root.is_object() || numberAt(root, "version") != 1) {
        return contentsError("expected a table of costs, version 1.");
    }
    const std::string* processor = textAt(root, "processor");
    const std::string* simd = textAt(root, "simd");
    const std::string* program = textAt(root, "program");
    const auto contents = root.find("contents");
    const auto rows = root.find("entries");
    if (processor == nullptr || simd == nullptr || program == nullptr || contents == root.end() ||
        !contents->is_number_unsigned() || rows == root.end() || !rows->is_array()) {
        return contentsError("expected processor, simd, program, contents and entries.");
    }
    CostTable table{{*processor, *simd, *program}, contents->get<std::uint64_t>(), {}};
    for (const json& row : *rows) {
        auto entry = entryOf(row);
        if (!entry) {
            return prefixed("entry " + std::to_string(table.entries.size()), entry.error());
        }
        table.entries.push_back(std::move(*entry));
    }
    return table;
}

} // namespace trixel
