// SPDX-License-Identifier: MIT
#include "output/json/surface_json.hpp"

#include "core/errors.hpp"
#include "output/json/json_text.hpp"

#include <fmt/format.h>

namespace camopt {

std::string surface_json(const SurfaceIdentity& identity, const TradeOffSurface& surface) {
    Json json;
    json["camopt"] = identity.version;
    json["scene"] = identity.scene_file;
    json["error_asked_for"] = number_json(identity.error);
    json["error"] = number_json(surface.error);
    json["end"] = name_of(surface.end);
    json["solves"] = surface.table.rows.size();
    json["reference"] = {{"velocity", number_json(surface.reference[0])},
                         {"acceleration", number_json(surface.reference[1])},
                         {"jerk", number_json(surface.reference[2])}};
    json["triangles"] = surface.triangles;
    json["scene_text"] = identity.scene_text;
    return json_text(json);
}

SurfaceIdentity read_surface_json(std::string_view text, std::string_view name) {
    try {
        SurfaceIdentity identity;
        const Json json = Json::parse(text);
        json.at("camopt").get_to(identity.version);
        json.at("scene").get_to(identity.scene_file);
        json.at("error_asked_for").get_to(identity.error);
        json.at("scene_text").get_to(identity.scene_text);
        return identity;
    } catch (const Json::exception&) {
        // Told below: what the JSON library says is of no use to who reads it.
    }
    throw InputError(
        fmt::format("{}: found no description of a surface; allowed: one that camopt sweep wrote", name));
}

std::string difference(const SurfaceIdentity& one, const SurfaceIdentity& other) {
    if (one.version != other.version) return fmt::format("camopt {}, not {}", one.version, other.version);
    if (one.scene_text != other.scene_text) return "another scene";
    return {};
}

}  // namespace camopt
