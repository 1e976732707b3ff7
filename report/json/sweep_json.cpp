// SPDX-License-Identifier: MIT
#include "report/json/sweep_json.hpp"

#include "report/json/json_text.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

Json names_json(const std::vector<DimensionIndex>& dimensions) {
    Json names = Json::array();
    for (const DimensionIndex index : dimensions) names.push_back(name_of(index));
    return names;
}

std::vector<DimensionIndex> dimensions_of(const Json& names) {
    std::vector<DimensionIndex> dimensions;
    for (const Json& name : names)
        for (int i = 0; i < dimension_count; ++i)
            if (name == name_of(static_cast<DimensionIndex>(i)))
                dimensions.push_back(static_cast<DimensionIndex>(i));
    return dimensions;
}

bool makes_sense(const StoredSweep& sweep) {
    const Chunking& chunking = sweep.identity.chunking;
    const SweepShard& shard = sweep.shard;
    return chunking.rows >= 1 && chunking.rows <= most_sweep_rows && chunking.size >= 1 &&
           chunking.size <= most_sweep_rows && shard.index >= 1 && shard.index <= shard.count;
}

StoredSweep sweep_of(const Json& json) {
    StoredSweep sweep;
    SweepIdentity& identity = sweep.identity;
    json.at("camopt").get_to(identity.version);
    json.at("scene").get_to(identity.scene_file);
    json.at("settings").get_to(identity.settings);
    json.at("axes").get_to(identity.axes);
    json.at("plan").get_to(identity.plan);
    json.at("rows").get_to(identity.chunking.rows);
    json.at("chunk").get_to(identity.chunking.size);
    json.at("keys").get_to(identity.columns.keys);
    identity.columns.dimensions = dimensions_of(json.at("dimensions"));
    identity.columns.train = json.value("train", false);
    identity.columns.drive = json.value("drive", false);
    identity.columns.machine = json.value("machine", false);
    json.at("criteria").get_to(identity.columns.criteria);
    if (json.at("length_unit") == name_of(LengthUnit::inch)) identity.columns.length_unit = LengthUnit::inch;
    json.at("scene_text").get_to(identity.scene_text);
    json.at("shard").at("index").get_to(sweep.shard.index);
    json.at("shard").at("count").get_to(sweep.shard.count);
    return sweep;
}

}  // namespace

std::string difference(const SweepIdentity& one, const SweepIdentity& other) {
    if (one.version != other.version) return fmt::format("camopt {}, not {}", one.version, other.version);
    if (one.scene_text != other.scene_text) return "another scene";
    if (one.settings != other.settings) return "other settings (--set, --solver)";
    if (one.columns.keys != other.columns.keys) return "other keys that vary";
    if (one.chunking.rows != other.chunking.rows)
        return fmt::format("{} rows, not {}", one.chunking.rows, other.chunking.rows);
    if (one.plan != other.plan) return "other values of the keys that vary";
    if (one.chunking.size != other.chunking.size)
        return fmt::format("chunks of {} rows, not {}", one.chunking.size, other.chunking.size);
    return {};
}

std::string sweep_json(const StoredSweep& sweep) {
    const SweepIdentity& identity = sweep.identity;
    const Json json = {{"camopt", identity.version},
                       {"scene", identity.scene_file},
                       {"settings", identity.settings},
                       {"axes", identity.axes},
                       {"plan", identity.plan},
                       {"rows", identity.chunking.rows},
                       {"chunk", identity.chunking.size},
                       {"shard", {{"index", sweep.shard.index}, {"count", sweep.shard.count}}},
                       {"keys", identity.columns.keys},
                       {"dimensions", names_json(identity.columns.dimensions)},
                       {"train", identity.columns.train},
                       {"drive", identity.columns.drive},
                       {"machine", identity.columns.machine},
                       {"criteria", identity.columns.criteria},
                       {"length_unit", name_of(identity.columns.length_unit)},
                       {"scene_text", identity.scene_text}};
    return json_text(json);
}

StoredSweep read_sweep_json(std::string_view text, std::string_view name) {
    try {
        StoredSweep sweep = sweep_of(Json::parse(text));
        if (makes_sense(sweep)) return sweep;
    } catch (const Json::exception&) {
        // Told below: what the JSON library says is of no use to who reads it.
    }
    throw InputError(
        fmt::format("{}: found no description of a sweep; allowed: one that camopt sweep wrote", name));
}

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
