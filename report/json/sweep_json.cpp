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

static void grid_fields(const JsonFields& json, StoredSweep& sweep) {
    SweepIdentity& identity = sweep.identity;
    SweepColumns& columns = identity.columns;
    const auto count = [&](const char* key, int& number) {
        json(key, number);
        json.check(key, number >= 1 && number <= most_sweep_rows, fmt::format("1 to {}", most_sweep_rows));
    };
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
    json.unless("spring", columns.spring, false);
    json("sought", columns.sought);
    json("machine", columns.machine);
    json("criteria", columns.criteria);
    json("length_unit", columns.length_unit);
}

/// found: written only.
static void fields(const JsonFields& json, StoredSweep& sweep, const Json& found = Json::object()) {
    SweepIdentity& identity = sweep.identity;
    json("camopt", identity.version);
    json("scene", identity.scene_file);
    if (identity.is_grid()) {
        grid_fields(json, sweep);
    } else {
        json.unless("settings", identity.settings, std::vector<std::string>());
        json.unless("axes", identity.axes, std::vector<std::string>());
        if (double* const error = json.if_there("error_asked_for", identity.error))
            json("error_asked_for", *error);
    }
    for (const auto& [key, value] : found.items()) json.shown(key, value);
    json("scene_text", identity.scene_text);
}

static std::string text_of(const StoredSweep& sweep, const Json& found) {
    Json json;
    fields(JsonFields(json), to_write(sweep), found);
    return json_text(json);
}

std::string difference(const SweepIdentity& one, const SweepIdentity& other) {
    if (one.version != other.version) return fmt::format("camopt {}, not {}", one.version, other.version);
    if (one.scene_text != other.scene_text) return "another scene";
    if (one.settings != other.settings) return "other settings (--set, --solver)";
    if (!one.is_grid())
        return one.error || one.axes == other.axes ? "" : "other goals (--pareto, --keep-weights)";
    if (one.columns.keys != other.columns.keys) return "other keys that vary";
    if (one.chunking.rows != other.chunking.rows)
        return fmt::format("{} rows, not {}", one.chunking.rows, other.chunking.rows);
    if (one.plan != other.plan) return "other values of the keys that vary";
    if (one.chunking.size != other.chunking.size)
        return fmt::format("chunks of {} rows, not {}", one.chunking.size, other.chunking.size);
    return {};
}

std::string sweep_json(const StoredSweep& sweep) {
    return text_of(sweep, Json::object());
}

std::string sweep_json(const StoredSweep& sweep, const TradeOffSurface& surface) {
    Json found;
    found["error"] = number_json(surface.error);
    found["end"] = name_of(surface.end);
    found["solves"] = surface.table.rows.size();
    found["reference"] = {{"velocity", number_json(surface.reference[0])},
                          {"acceleration", number_json(surface.reference[1])},
                          {"jerk", number_json(surface.reference[2])}};
    found["triangles"] = surface.triangles;
    return text_of(sweep, found);
}

std::string sweep_json(const StoredSweep& sweep, const ParetoFront& front) {
    Json found;
    found["goals"] = {name_of(front.request.goals[0]), name_of(front.request.goals[1])};
    found["complete"] = front.complete;
    found["even"] = front.even;
    found["solves"] = front.points.size();
    found["spacing"] = {{"least", number_json(front.spacing.least)},
                        {"mean", number_json(front.spacing.mean)},
                        {"most", number_json(front.spacing.most)},
                        {"length", number_json(front.spacing.length)},
                        {"jumps", front.spacing.jumps}};
    return text_of(sweep, found);
}

StoredSweep read_sweep_json(std::string_view text, std::string_view name, const std::string& study) {
    StoredSweep sweep;
    sweep.identity.study = study;
    fields(JsonFields(text, name, "a description of a sweep"), sweep);
    return sweep;
}

}  // namespace camopt
