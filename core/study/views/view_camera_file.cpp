// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/json_fields.h"
#include "core/study/views/view_camera.h"

#include <algorithm>
#include <cmath>

namespace trixel {
namespace {

/// Leaves `vector` alone if the field is absent.
Status vectorOf(const JsonFields& fields, const char* name, glm::dvec3& vector)
{
    const Json* field = fields.find(name);
    if (field == nullptr) {
        return {};
    }
    const bool usable =
        field->is_array() && field->size() == 3 && std::ranges::all_of(*field, [](const Json& v) {
            return v.is_number() && std::abs(v.get<double>()) <= kLargestCoordinate;
        });
    if (!usable) {
        return fields.error(name, "an array of 3 finite numbers", *field);
    }
    vector = {(*field)[0].get<double>(), (*field)[1].get<double>(), (*field)[2].get<double>()};
    return {};
}

Status sizeOf(const JsonFields& fields, int& width, int& height)
{
    const Json* field = fields.find("size");
    if (field == nullptr) {
        return {};
    }
    const bool usable =
        field->is_array() && field->size() == 2 && std::ranges::all_of(*field, [](const Json& v) {
            return v.is_number_unsigned() && v.get<std::uint64_t>() >= 1 &&
                   v.get<std::uint64_t>() <= kMostPixels;
        });
    if (!usable) {
        return fields.error(
            "size", "two whole numbers from 1 to " + std::to_string(kMostPixels), *field);
    }
    width = (*field)[0].get<int>();
    height = (*field)[1].get<int>();
    return {};
}

Status nameOf(const JsonFields& fields, std::string& name)
{
    const Json* field = fields.find("name");
    if (field == nullptr) {
        return {};
    }
    if (!field->is_string()) {
        return fields.error("name", "a text", *field);
    }
    name = field->get<std::string>();
    return {};
}

Status parseDistant(const JsonFields& fields, const std::string& name, SceneViews& views)
{
    DistantViews distant;
    distant.name = name;
    const Status status = firstError({fields.onlyHas({"name", "anyBeyond", "fovY", "size"}),
                                      nameOf(fields, distant.name),
                                      fields.number("anyBeyond", distant.distance),
                                      fields.number("fovY", distant.fovY),
                                      sizeOf(fields, distant.width, distant.height)});
    if (!status) {
        return status;
    }
    views.distant.push_back(distant);
    return validate(distant);
}

Status parseCamera(const JsonFields& fields, const std::string& name, SceneViews& views)
{
    for (const char* required : {"position", "target"}) {
        if (const auto field = fields.need(required); !field) {
            return tl::unexpected(field.error());
        }
    }
    ViewCamera camera;
    camera.name = name;
    const Status status =
        firstError({fields.onlyHas({"name", "position", "target", "up", "fovY", "size"}),
                    nameOf(fields, camera.name),
                    vectorOf(fields, "position", camera.position),
                    vectorOf(fields, "target", camera.target),
                    vectorOf(fields, "up", camera.up),
                    fields.number("fovY", camera.fovY),
                    sizeOf(fields, camera.width, camera.height)});
    if (!status) {
        return status;
    }
    views.cameras.push_back(camera);
    return validate(camera);
}

Json toJson(const glm::dvec3& v)
{
    return Json::array({v.x, v.y, v.z});
}

} // namespace

Result<SceneViews> parseCameras(std::string_view text)
{
    const auto json = parseJson(text);
    if (!json) {
        return tl::unexpected(json.error());
    }
    const auto fields = JsonFields::of(*json, "cameras file");
    if (!fields) {
        return tl::unexpected(fields.error());
    }
    const auto version = fields->need("version");
    const auto list = fields->array("cameras");
    const Status status = firstError({version ? Status() : Status(tl::unexpected(version.error())),
                                      fields->mustBe("version", 1),
                                      fields->onlyHas({"version", "cameras"}),
                                      list ? Status() : Status(tl::unexpected(list.error()))});
    if (!status) {
        return tl::unexpected(status.error());
    }
    if ((*list)->empty()) {
        return fields->error("cameras", "at least one camera", **list);
    }
    SceneViews views;
    std::size_t number = 0;
    for (const Json& entry : **list) {
        const std::string name = "camera " + std::to_string(++number);
        const auto camera = JsonFields::of(entry, name);
        if (!camera) {
            return tl::unexpected(camera.error());
        }
        const bool distant = camera->find("anyBeyond") != nullptr;
        const Status read =
            distant ? parseDistant(*camera, name, views) : parseCamera(*camera, name, views);
        if (!read) {
            return tl::unexpected(read.error());
        }
    }
    return views;
}

std::string writeCameras(const SceneViews& views)
{
    Json list = Json::array();
    for (const ViewCamera& camera : views.cameras) {
        list.push_back({{"name", camera.name},
                        {"position", toJson(camera.position)},
                        {"target", toJson(camera.target)},
                        {"up", toJson(camera.up)},
                        {"fovY", camera.fovY},
                        {"size", {camera.width, camera.height}}});
    }
    for (const DistantViews& distant : views.distant) {
        list.push_back({{"name", distant.name},
                        {"anyBeyond", distant.distance},
                        {"fovY", distant.fovY},
                        {"size", {distant.width, distant.height}}});
    }
    const Json file{{"version", 1}, {"cameras", std::move(list)}};
    return file.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace trixel
