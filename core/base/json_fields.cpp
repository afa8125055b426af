// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/json_fields.h"

#include <algorithm>

namespace trixel {

Result<Json> parseJson(std::string_view text)
{
    try {
        return Json::parse(text);
    } catch (const Json::parse_error& error) {
        return contentsError("not JSON: byte " + std::to_string(error.byte) +
                             " is not what the grammar expects");
    } catch (const Json::exception&) {
        return contentsError("not usable as JSON: a number is out of range");
    }
}

std::string shown(const Json& value)
{
    constexpr std::size_t kLongest = 40;
    if (value.is_structured()) {
        return value.is_array() ? "an array" : "an object";
    }
    const std::string text = value.dump(-1, ' ', true, Json::error_handler_t::replace);
    return text.size() > kLongest ? text.substr(0, kLongest) + "…" : text;
}

Status firstError(std::initializer_list<Status> all)
{
    const auto* failed = std::ranges::find_if(all, [](const Status& s) { return !s; });
    return failed == all.end() ? Status() : *failed;
}

Result<JsonFields> JsonFields::of(const Json& json, std::string place)
{
    if (!json.is_object()) {
        return contentsError(place + ": expected an object, found " + shown(json));
    }
    return JsonFields(json, std::move(place));
}

const Json* JsonFields::find(const char* name) const
{
    const auto field = m_json->find(name);
    return field == m_json->end() ? nullptr : &*field;
}

tl::unexpected<Error>
JsonFields::error(const char* name, const std::string& expected, const Json& found) const
{
    return contentsError(m_place + ": " + name + ": expected " + expected + ", found " +
                         shown(found));
}

Result<const Json*> JsonFields::need(const char* name) const
{
    const Json* field = find(name);
    if (field == nullptr) {
        return contentsError(m_place + ": " + name + " is missing");
    }
    return field;
}

Status JsonFields::onlyHas(std::initializer_list<std::string_view> names) const
{
    for (const auto& [name, value] : m_json->items()) {
        if (std::ranges::find(names, name) == names.end()) {
            return contentsError(m_place + ": there is no field " + shown(Json(name)));
        }
    }
    return {};
}

Status JsonFields::flag(const char* name, bool& value) const
{
    const Json* field = find(name);
    if (field != nullptr && !field->is_boolean()) {
        return error(name, "true or false", *field);
    }
    value = field == nullptr ? value : field->get<bool>();
    return {};
}

Status JsonFields::mustBe(const char* name, const Json& only) const
{
    const Json* field = find(name);
    if (field != nullptr && *field != only) {
        return error(name, only.dump(), *field);
    }
    return {};
}

Result<const Json*> JsonFields::array(const char* name) const
{
    auto field = need(name);
    if (field && !(*field)->is_array()) {
        return error(name, "an array", **field);
    }
    return field;
}

} // namespace trixel
