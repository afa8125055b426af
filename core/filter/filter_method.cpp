// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/filter_method.h"

#include "core/filter/methods.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace trixel {
namespace {

std::string namesOf(std::span<const MethodEntry> methods)
{
    std::string names;
    for (const MethodEntry& method : methods) {
        names += names.empty() ? "" : ", ";
        names += method.name;
    }
    return names;
}

std::string shortest(double number)
{
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), number).ptr;
    return {text.data(), end};
}

} // namespace

std::span<const MethodEntry> filterMethods()
{
    static const std::vector<MethodEntry> kMethods = {
        pointMethod(),
        nearestLevelMethod(),
        rectilinearBilinearMethod(),
        latticeLinearMethod(),
        trilinearMethod(),
        probesOneLevelMethod(),
        probesTwoLevelsMethod(),
        equalProbesMethod(),
        stochasticMethod(),
        separableMethod(),
        referenceLoopMethod(),
        ewaMethod(),
        ewaBlendedMethod(),
        ewaBaseMethod(),
        exactMethod(),
    };
    return kMethods;
}

const MethodEntry* findMethod(std::string_view name)
{
    const auto methods = filterMethods();
    const auto found = std::ranges::find(methods, name, &MethodEntry::name);
    return found != methods.end() ? &*found : nullptr;
}

Result<MethodChoice> parseMethod(std::string_view text)
{
    const std::size_t colon = text.find(':');
    MethodChoice choice{std::string(text.substr(0, colon)), std::nullopt};
    const MethodEntry* entry = findMethod(choice.name);
    if (entry == nullptr) {
        return contentsError("There is no filter method '" + choice.name + "'; there are " +
                             namesOf(filterMethods()) + ".");
    }
    if (colon == std::string_view::npos) {
        return choice;
    }
    const std::string_view number = text.substr(colon + 1);
    if (!entry->parameter) {
        return contentsError("The filter method '" + choice.name + "' takes no parameter, found '" +
                             std::string(number) + "'.");
    }
    double value = 0;
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
    const MethodParameter& parameter = *entry->parameter;
    if (error != std::errc() || end != number.data() + number.size() ||
        !(value >= parameter.least && value <= parameter.most) ||
        (parameter.whole && value != std::floor(value))) {
        return contentsError(
            "The filter method '" + choice.name + "' takes " + std::string(parameter.name) +
            " from " + shortest(parameter.least) + " to " + shortest(parameter.most) +
            (parameter.whole ? ", a whole number" : "") + ", found '" + std::string(number) + "'.");
    }
    choice.parameter = value;
    return choice;
}

std::string toText(const MethodChoice& choice)
{
    return choice.parameter ? choice.name + ":" + shortest(*choice.parameter) : choice.name;
}

std::unique_ptr<const FilterMethod> makeMethod(const MethodChoice& choice)
{
    const MethodEntry* entry = findMethod(choice.name);
    check(entry != nullptr, "a method of the table");
    if (!entry->parameter) {
        return entry->make(0);
    }
    const double value = choice.parameter.value_or(entry->parameter->standard);
    check(value >= entry->parameter->least && value <= entry->parameter->most, "in bounds");
    return entry->make(value);
}

void filterParallel(const FilterMethod& method,
                    const FilterScene& scene,
                    const FilterQueries& queries,
                    const FilterResults& results,
                    Threads threads)
{
    constexpr std::size_t kGrain = 64;
    parallelFor(queries.size(), kGrain, threads, [&](std::size_t begin, std::size_t end) {
        FilterResults part = results;
        part.values = results.values.subspan(begin);
        part.levels =
            results.levels.empty() ? results.levels : results.levels.subspan(begin, end - begin);
        part.taps = results.taps.empty() ? results.taps : results.taps.subspan(begin, end - begin);
        method.filter(scene, queries.subspan(begin, end - begin), part);
    });
}

} // namespace trixel
