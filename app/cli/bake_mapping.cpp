// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/bake_mapping.h"

#include "core/base/read_file.h"
#include "core/mapping/projection.h"
#include "core/mapping/sphere_mapping.h"
#include "core/mapping/uv_mapping.h"
#include "core/study/views/camera_clip.h"

#include <CLI/CLI.hpp>
#include <array>
#include <charconv>
#include <cmath>
#include <glm/vec3.hpp>
#include <vector>

namespace trixel::app {
namespace {

/// Finite numbers between commas or blanks, `count` of them.
Result<std::vector<double>>
numbers(std::string_view option, std::string_view text, std::size_t count)
{
    std::vector<double> values;
    const char* at = text.data();
    const char* const end = at + text.size();
    while (at != end) {
        if (*at == ',' || *at == ' ' || *at == ';') {
            ++at;
            continue;
        }
        double value = 0;
        const auto [rest, error] = std::from_chars(at, end, value);
        if (error != std::errc{} || !(std::abs(value) <= kLargestCoordinate)) {
            break;
        }
        values.push_back(value);
        at = rest;
    }
    if (at != end || values.size() != count) {
        return contentsError(std::string(option) + ": expected " + std::to_string(count) +
                             " finite numbers, found '" + std::string(text) + "'");
    }
    return values;
}

Result<glm::dvec3>
vectorOf(std::string_view option, const std::optional<std::string>& text, glm::dvec3 otherwise)
{
    if (!text) {
        return otherwise;
    }
    return numbers(option, *text, 3).map([](const std::vector<double>& v) {
        return glm::dvec3(v[0], v[1], v[2]);
    });
}

using MadeMapping = Result<std::unique_ptr<const Mapping>>;

MadeMapping projectionMapping(const Result<Projection>& projection, const Surface& surface)
{
    if (!projection) {
        return tl::unexpected(projection.error());
    }
    return std::make_unique<const ProjectionMapping>(surface.mesh(), *projection, &surface.bvh());
}

MadeMapping uvMapping(const Surface& surface)
{
    if (!surface.mesh().hasUvs()) {
        return contentsError("the mesh has no uvs");
    }
    return std::make_unique<const UvMapping>(surface.mesh());
}

/// By default the mesh's own front: its box seen along z.
MadeMapping planarMapping(const BakeMappingArguments& arguments, const Surface& surface)
{
    const glm::dvec3 low(surface.low());
    const glm::dvec3 size = glm::dvec3(surface.high()) - low;
    const auto origin = vectorOf("--origin", arguments.origin, low);
    const auto right = vectorOf("--right", arguments.right, {size.x, 0, 0});
    const auto up = vectorOf("--up", arguments.up, {0, size.y, 0});
    for (const auto* vector : {&origin, &right, &up}) {
        if (!*vector) {
            return tl::unexpected(vector->error());
        }
    }
    auto projection = planarProjection(*origin, *right, *up);
    if (projection) {
        projection->frontOnly = arguments.frontOnly;
        projection->visibleOnly = arguments.visibleOnly;
    }
    return projectionMapping(projection, surface);
}

MadeMapping quadMapping(const BakeMappingArguments& arguments, const Surface& surface)
{
    const auto values = numbers("--corners", arguments.corners.value_or(""), 12);
    if (!values) {
        return tl::unexpected(values.error());
    }
    std::array<glm::dvec3, 4> corners{};
    for (std::size_t k = 0; k < 4; ++k) {
        corners[k] = {(*values)[3 * k], (*values)[3 * k + 1], (*values)[3 * k + 2]};
    }
    auto projection = quadProjection(corners);
    if (projection) {
        projection->frontOnly = arguments.frontOnly;
        projection->visibleOnly = arguments.visibleOnly;
    }
    return projectionMapping(projection, surface);
}

MadeMapping sphereMapping(const BakeMappingArguments& arguments, const Surface& surface)
{
    const glm::dvec3 middle = 0.5 * (glm::dvec3(surface.low()) + glm::dvec3(surface.high()));
    const auto centre = vectorOf("--centre", arguments.centre, middle);
    const auto axis = vectorOf("--axis", arguments.axis, {0, 1, 0});
    const auto turn = numbers("--turn", arguments.turn, 1);
    if (!centre || !axis || !turn) {
        return tl::unexpected(!centre ? centre.error() : !axis ? axis.error() : turn.error());
    }
    const auto turned = sphereTurn(*axis, turn->front());
    if (!turned) {
        return contentsError("--axis: expected a direction, found none");
    }
    return std::make_unique<const SphereMapping>(surface.mesh(), *centre, *turned);
}

Result<ViewCamera> cameraOf(const BakeMappingArguments& arguments)
{
    const auto text = readFile(*arguments.cameras);
    if (!text) {
        return tl::unexpected(text.error());
    }
    const auto views = parseCameras(*text);
    if (!views) {
        return prefixed(*arguments.cameras, views.error());
    }
    for (const ViewCamera& camera : views->cameras) {
        if (!arguments.camera || camera.name == *arguments.camera) {
            return camera;
        }
    }
    return contentsError(
        *arguments.cameras + ": there is no camera" +
        (arguments.camera ? " '" + *arguments.camera + "'" : std::string(" of one place")));
}

MadeMapping cameraMapping(const BakeMappingArguments& arguments, const Surface& surface)
{
    const auto camera = cameraOf(arguments);
    if (!camera) {
        return tl::unexpected(camera.error());
    }
    auto projection = cameraProjection(toClip(*camera));
    if (projection && arguments.everything) {
        projection->frontOnly = projection->visibleOnly = false;
    }
    return projectionMapping(projection, surface);
}

struct MappingName
{
    std::string_view name;
    MappingKind kind;
};
constexpr MappingName kMappings[] = {{"uv", MappingKind::Uv},
                                     {"sphere", MappingKind::Sphere},
                                     {"planar", MappingKind::Planar},
                                     {"quad", MappingKind::Quad},
                                     {"camera", MappingKind::Camera}};

} // namespace

void addMappingOptions(CLI::App& verb, BakeMappingArguments& arguments)
{
    verb.add_option("--map",
                    arguments.name,
                    "How the image lies on the mesh: uv, sphere, planar, quad or camera")
        ->capture_default_str()
        ->type_name("WAY");
    const auto vector = [&](const char* name, auto& target, const char* about) {
        verb.add_option(name, target, about)->type_name("X,Y,Z");
    };
    vector("--origin",
           arguments.origin,
           "planar: the image's lower left corner; by default that of the mesh's box");
    vector("--right", arguments.right, "planar: along the image's width, as long as it is");
    vector("--up", arguments.up, "planar: along the image's height, as long as it is");
    vector("--centre", arguments.centre, "sphere: by default the middle of the mesh's box");
    vector("--axis", arguments.axis, "sphere: from the lower pole to the upper");
    verb.add_option("--turn", arguments.turn, "sphere: how far the image is turned about its axis")
        ->type_name("DEGREES");
    verb.add_option("--corners",
                    arguments.corners,
                    "quad: lower left, lower right, upper right and upper left corner of the image")
        ->type_name("X,Y,Z,X,Y,Z,...");
    verb.add_option("--cameras", arguments.cameras, "camera: a cameras file (JSON)")
        ->type_name("FILE");
    verb.add_option("--camera", arguments.camera, "camera: its name; by default the first")
        ->type_name("NAME");
    verb.add_flag("--front-only",
                  arguments.frontOnly,
                  "planar, quad: leave out faces that turn their back (camera always does)");
    verb.add_flag("--visible-only",
                  arguments.visibleOnly,
                  "planar, quad: leave out what something hides (camera always does)");
    verb.add_flag("--everything",
                  arguments.everything,
                  "camera: reach faces that turn their back or are hidden, too");
}

Result<MappingKind> mappingKind(const BakeMappingArguments& arguments)
{
    std::string names;
    std::optional<MappingKind> kind;
    for (const MappingName& one : kMappings) {
        names += names.empty() ? "" : ", ";
        names += one.name;
        if (one.name == arguments.name) {
            kind = one.kind;
        }
    }
    if (!kind) {
        return contentsError("--map: expected one of " + names + ", found '" + arguments.name +
                             "'");
    }
    if (*kind == MappingKind::Quad && !arguments.corners) {
        return contentsError("--map quad needs --corners, twelve numbers");
    }
    if (*kind == MappingKind::Camera && !arguments.cameras) {
        return contentsError("--map camera needs --cameras, a cameras file");
    }
    return *kind;
}

Result<std::unique_ptr<const Mapping>>
makeMapping(MappingKind kind, const BakeMappingArguments& arguments, const Surface& surface)
{
    switch (kind) {
    case MappingKind::Uv:
        return uvMapping(surface);
    case MappingKind::Sphere:
        return sphereMapping(arguments, surface);
    case MappingKind::Planar:
        return planarMapping(arguments, surface);
    case MappingKind::Quad:
        return quadMapping(arguments, surface);
    case MappingKind::Camera:
        break;
    }
    return cameraMapping(arguments, surface);
}

} // namespace trixel::app
