// SPDX-License-Identifier: MIT
#include "report/json/sweep_json.hpp"

#include "report/json/json_fields.hpp"

#include <fmt/format.h>

namespace camopt {

template <>
inline constexpr DimensionIndex last_of<DimensionIndex> = DimensionIndex::face_offset;

static void fields(const JsonFields& json, SweepShard& shard) {
    json("index", shard.index);
    json("count", shard.count);
    json.check("index", shard.index >= 1 && shard.index <= shard.count, fmt::format("1 to {}", shard.count));
}

static void fields(const JsonFields& json, StoredSweep& sweep) {
    SweepIdentity& identity = sweep.identity;
    SweepColumns& columns = identity.columns;
    const auto count = [&](const char* key, int& number) {
        json(key, number);
        json.check(key, number >= 1 && number <= most_sweep_rows, fmt::format("1 to {}", most_sweep_rows));
    };
    json("camopt", identity.version);
    json("scene", identity.scene_file);
    json("settings", identity.settings);
    json("axes", identity.axes);
    json("plan", identity.plan);
    count("rows", identity.chunking.rows);
    count("chunk", identity.chunking.size);
    json("shard", sweep.shard);
    json("keys", columns.keys);
    json("dimensions", columns.dimensions);
    json("train", columns.train);
    json("drive", columns.drive);
    json("sought", columns.sought);
    json("machine", columns.machine);
    json("criteria", columns.criteria);
    json("length_unit", columns.length_unit);
    json("scene_text", identity.scene_text);
}

/// surface: written only.
static void fields(const JsonFields& json, SurfaceIdentity& identity, const TradeOffSurface& surface) {
    json("camopt", identity.version);
    json("scene", identity.scene_file);
    json("error_asked_for", identity.error);
    json.shown("error", number_json(surface.error));
    json.shown("end", name_of(surface.end));
    json.shown("solves", surface.table.rows.size());
    json.shown("reference", Json{{"velocity", number_json(surface.reference[0])},
                                 {"acceleration", number_json(surface.reference[1])},
                                 {"jerk", number_json(surface.reference[2])}});
    json.shown("triangles", surface.triangles);
    json("scene_text", identity.scene_text);
}

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
    return json_text(written(sweep));
}

StoredSweep read_sweep_json(std::string_view text, std::string_view name) {
    return JsonFields(text, name, "a description of a sweep").as<StoredSweep>();
}

std::string surface_json(const SurfaceIdentity& identity, const TradeOffSurface& surface) {
    Json json;
    fields(JsonFields(json), to_write(identity), surface);
    return json_text(json);
}

SurfaceIdentity read_surface_json(std::string_view text, std::string_view name) {
    SurfaceIdentity identity;
    fields(JsonFields(text, name, "a description of a surface"), identity, {});
    return identity;
}

std::string difference(const SurfaceIdentity& one, const SurfaceIdentity& other) {
    if (one.version != other.version) return fmt::format("camopt {}, not {}", one.version, other.version);
    if (one.scene_text != other.scene_text) return "another scene";
    return {};
}

}  // namespace camopt
