// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reading JSON strictly: what is missing, misspelt or of another kind is said in one sentence that
// names the place.
#pragma once

#include "core/base/result.h"

#include <cmath>
#include <initializer_list>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace trixel {

using Json = nlohmann::json;

/// The whole text as JSON; errors name the byte that the grammar does not expect.
Result<Json> parseJson(std::string_view text);

/// A value as an error shows it: short, whatever was in the file.
std::string shown(const Json& value);

/// The first failure of several.
Status firstError(std::initializer_list<Status> all);

/// One object of a file, and what errors call it. The JSON must outlive it.
class JsonFields
{
public:
    static Result<JsonFields> of(const Json& json, std::string place);

    const std::string& place() const { return m_place; }

    /// Null when it is absent.
    const Json* find(const char* name) const;

    tl::unexpected<Error>
    error(const char* name, const std::string& expected, const Json& found) const;

    /// A field that must be there.
    Result<const Json*> need(const char* name) const;

    /// Fails on a field that none of the names stands for: a misspelt setting is not passed over.
    Status onlyHas(std::initializer_list<std::string_view> names) const;

    /// Leaves `value` alone if the field is absent.
    template <class T>
    Status number(const char* name, T& value) const
    {
        const Json* field = find(name);
        if (field == nullptr) {
            return {};
        }
        const double limit = static_cast<double>(std::numeric_limits<T>::max());
        if (!field->is_number() || !(std::abs(field->template get<double>()) <= limit)) {
            return error(name, "a finite number", *field);
        }
        value = static_cast<T>(field->template get<double>());
        return {};
    }

    Status flag(const char* name, bool& value) const;

    /// Fails if the field is there and is anything else.
    Status mustBe(const char* name, const Json& only) const;

    Result<const Json*> array(const char* name) const;

private:
    JsonFields(const Json& json, std::string place)
        : m_json(&json)
        , m_place(std::move(place))
    {
    }

    const Json* m_json;
    std::string m_place;
};

} // namespace trixel
