// SPDX-License-Identifier: MIT
#include "apps/studio/studio_controls.hpp"

#include "core/text/parsing.hpp"
#include "input/document/document.hpp"
#include "input/keys/scene_keys.hpp"
#include "motions/laws/law_catalogue.hpp"
#include "scene/limit_table.hpp"
#include "scene/part_names.hpp"
#include "solvers/registry.hpp"

#include <fmt/format.h>

#include <set>

namespace camopt::apps {

namespace {

std::vector<std::string> law_words() {
    std::vector<std::string> words;
    for (const LawInfo& info : law_catalogue()) words.emplace_back(info.key);
    return words;
}

using ControlJson = nlohmann::ordered_json;
using input::KeyMatch;
using input::KeyRow;
using input::KeyType;
using input::Member;
using input::Node;
using input::NodeKind;
using input::Spelling;

/// A table of the scene: what the key table calls it, and where it is.
struct SceneTable {
    std::string path;     ///< "motion.segments"
    std::string written;  ///< "motion.segments[1]"
    const Node* node = nullptr;
};

/// Those that are there, each before what is in it.
void collect_tables(const SceneTable& table, std::vector<SceneTable>& found) {
    found.push_back(table);
    for (const Member& member : table.node->members) {
        const KeyRow* const row = input::match_key(table.path, member.name).row;
        if (row == nullptr || row->type == KeyType::options || row->type == KeyType::number_or_range)
            continue;
        const std::string path = joined_key(table.path, row->name),
                          written = joined_key(table.written, member.name);
        if (member.value.kind == NodeKind::table) collect_tables({path, written, &member.value}, found);
        for (std::size_t i = 0; i < member.value.items.size(); ++i)
            if (member.value.items[i].kind == NodeKind::table)
                collect_tables({path, entry_key(written, i), &member.value.items[i]}, found);
    }
}

/// What decides which keys a scene could have.
struct SceneState {
    std::string cam_type;  ///< empty: no cam
    std::string motion_type;
    bool has_forces = false;
    bool has_dynamics = false;
    bool has_drive = false;
    bool in_lifts = false, in_units = false;  ///< how displacements are written
    std::set<std::string_view> units;         ///< that the scene is written in
};

SceneState state_of(const std::vector<SceneTable>& tables) {
    SceneState state;
    for (const SceneTable& table : tables) {
        if (table.path == "cam")
            if (const Member* const type = table.node->find("type")) state.cam_type = type->value.text;
        if (table.path == "motion")
            if (const Member* const type = table.node->find("type")) state.motion_type = type->value.text;
        state.has_forces = state.has_forces || table.path == "forces";
        state.has_dynamics = state.has_dynamics || table.path == "dynamics";
        state.has_drive = state.has_drive || table.path == "drive";
        for (const Member& member : table.node->members)
            if (const KeyMatch match = input::match_key(table.path, member.name); match.row != nullptr) {
                const std::string_view unit = match.spelling->unit;
                if (!unit.empty()) state.units.insert(unit);
                const bool ends = table.path == "motion.segments" && match.row->name == "to";
                if (!ends && match.row->name != "displacement") continue;
                state.in_units |= ends && !unit.empty();
                state.in_lifts |= unit.empty() && member.value.as_number() != 0.0;
            }
    }
    return state;
}

bool is_control(const KeyRow& row, const Node* value) {
    switch (row.type) {
        case KeyType::table:
        case KeyType::tables:
        case KeyType::options:
        case KeyType::numbers:
            return false;
        case KeyType::text_or_table:
            return value == nullptr || value->kind == NodeKind::text;
        default:
            return true;
    }
}

std::string type_of(const KeyRow& row, bool has_choices, const Node* value) {
    if (row.type == KeyType::boolean) return "boolean";
    if (has_choices) return "choice";
    if (row.type == KeyType::integer) return "integer";
    if (row.type == KeyType::number_or_range && value != nullptr && value->kind == NodeKind::table)
        return "range";
    return row.type == KeyType::text || row.type == KeyType::text_or_table ? "text" : "number";
}

ControlJson value_json(const Node& value) {
    switch (value.kind) {
        case NodeKind::boolean:
            return value.boolean;
        case NodeKind::integer:
            return value.integer;
        case NodeKind::number:
            return value.number;
        case NodeKind::text:
            return value.text;
        case NodeKind::table: {
            ControlJson ends = ControlJson::object();
            for (const Member& end : value.members) ends[end.name] = value_json(end.value);
            return ends;
        }
        default:
            return nullptr;
    }
}

ControlJson choices_json(const KeyRow& row) {
    ControlJson choices = ControlJson::array();
    for (const std::string& choice : values_of_key(row))
        choices.push_back(row.type == KeyType::integer ? ControlJson(integer_in(choice).value())
                                                       : ControlJson(choice));
    return choices;
}

ControlJson units_json(const KeyRow& row, const Spelling& spelling) {
    ControlJson units = ControlJson::array();
    for (const UnitChoice& one : units_of_field(row, spelling))
        units.push_back({{"unit", one.unit}, {"factor", one.factor}});
    return units;
}

ControlJson slider_json(const KeyRow& row, const Spelling& spelling, const Node& value) {
    const Range allowed = row.range.scaled(row.spellings.front().factor / spelling.factor);
    const SliderRange slider = slider_range(allowed, value.as_number(), row.type == KeyType::integer);
    return {{"from", slider.from}, {"to", slider.to}, {"step", slider.step}};
}

/// The key of [objective] that seeks the number of a limit; empty: it is none.
std::string seeking_key(const SceneTable& table, const KeyRow& row) {
    const bool number = row.type == KeyType::number || row.type == KeyType::number_or_bounds;
    if (table.path != "limits" || !number) return {};
    return is_least_limit(row.name) ? "objective.largest" : "objective.least";
}

ControlJson control_json(const SceneTable& table, const KeyRow& row, const Spelling& spelling,
                         const Node* value) {
    const ControlJson choices = choices_json(row);
    const std::string type = type_of(row, !choices.empty(), value);
    const bool slides = value != nullptr && (type == "number" || type == "integer");
    const ControlWords words = control_words(table.written, row, spelling.unit);
    return {{"table", table.written},
            {"key", row.key(spelling)},
            {"item", row.name},
            {"group", words.group},
            {"name", words.name},
            {"shown_unit", words.unit},
            {"label", words.label},
            {"given", value != nullptr},
            {"type", type},
            {"value", value == nullptr ? ControlJson(nullptr) : value_json(*value)},
            {"unit", spelling.unit},
            {"units", units_json(row, spelling)},
            {"choices", choices},
            {"default", row.default_text},
            {"allowed", row.allowed(spelling)},
            {"meaning", row.meaning},
            {"may_range", row.type == KeyType::number_or_range},
            {"seek", seeking_key(table, row)},
            {"slider", slides ? slider_json(row, spelling, *value) : ControlJson(nullptr)}};
}

/// In the units the scene is written in, where the quantity has one of them.
const Spelling& fitting_spelling(const KeyRow& row, const SceneState& state) {
    for (const Spelling& spelling : row.spellings)
        if (state.units.contains(spelling.unit)) return spelling;
    return row.spellings.front();
}

bool could_be(const KeyRow& row, const SceneState& state) {
    if (row.availability == input::Availability::needs_dynamics) return state.has_dynamics;
    if (row.availability == input::Availability::needs_drive) return state.has_drive;
    if (row.availability != input::Availability::now && state.cam_type.empty()) return false;
    if (row.availability == input::Availability::needs_forces && !state.has_forces) return false;
    if (row.table == "motion" && !input::motion_types_of(row.name, state.motion_type).empty()) return false;
    return row.is_for(state.cam_type);
}

struct Written {
    const Member* member = nullptr;
    const Spelling* spelling = nullptr;
};

Written written_in(const SceneTable& table, std::string_view name) {
    for (const Member& member : table.node->members) {
        const KeyMatch match = input::match_key(table.path, member.name);
        if (match.row != nullptr && match.row->name == name) return {&member, match.spelling};
    }
    return {};
}

bool is_replaced(const SceneTable& table, const KeyRow& row) {
    if (!row.instead_of.empty() && written_in(table, row.instead_of).member != nullptr) return true;
    return std::ranges::any_of(input::scene_keys(), [&](const KeyRow& other) {
        return other.table == row.table && other.instead_of == row.name &&
               written_in(table, other.name).member != nullptr;
    });
}

void add_controls(ControlJson& list, const SceneTable& table, const SceneState& state) {
    for (const KeyRow& row : input::scene_keys()) {
        if (row.table != table.path) continue;
        // The lift of a program whose displacements are all in units moves nothing.
        if (row.name == "lift" && state.in_units && !state.in_lifts && table.path == "motion") continue;
        const auto [member, spelling] = written_in(table, row.name);
        if (!is_control(row, member == nullptr ? nullptr : &member->value)) continue;
        if (member != nullptr)
            list.push_back(control_json(table, row, *spelling, &member->value));
        else if (could_be(row, state) && !is_replaced(table, row))
            list.push_back(control_json(table, row, fitting_spelling(row, state), nullptr));
    }
}

/// The tables of the top level that a scene could have without naming a new cam.
void add_empty_tables(std::vector<SceneTable>& tables, const Node& nothing) {
    for (const KeyRow& row : input::scene_keys()) {
        if (!row.table.empty() || row.type != KeyType::table ||
            row.availability != input::Availability::now || row.name == "cam")
            continue;
        if (std::ranges::find(tables, row.name, &SceneTable::path) == tables.end())
            tables.push_back({std::string(row.name), std::string(row.name), &nothing});
    }
}

constexpr std::array round_figures = {1.0, 2.0, 5.0, 10.0};
constexpr double steps_of_slider = 200.0;

/// The power of ten at or below.
double decade_of(double value) {
    return std::pow(10.0, std::floor(std::log10(value) + 1e-12));
}

/// 1, 2 or 5 times a power of ten, at or above.
double round_up(double value) {
    const double decade = decade_of(value);
    for (const double figure : round_figures)
        if (figure * decade >= value * (1.0 - 1e-12)) return figure * decade;
    return 10.0 * decade;
}

/// At or below.
double round_down(double value) {
    const double decade = decade_of(value);
    const auto above = std::ranges::upper_bound(std::span(round_figures), value / decade * (1.0 + 1e-12));
    return *std::prev(above) * decade;
}

double far_end(double value) {
    return value == 0.0 ? 1.0 : round_up(2.0 * std::abs(value));
}

}  // namespace

std::vector<std::string> solver_words() {
    std::vector<std::string> words = {"auto"};
    for (const SolverEntry& entry : solver_entries())
        if (entry.available) words.emplace_back(entry.name);
    return words;
}

std::vector<std::string> values_of_key(const KeyRow& row) {
    if (row.type == KeyType::boolean) return {"true", "false"};
    if (row.name == "law" || row.name == "reference") return law_words();
    if (row.table == "solver" && row.name == "name") return solver_words();
    return {row.choices.begin(), row.choices.end()};
}

ControlJson studio_controls(const std::string& text) {
    const Node root = input::parse_document(text, "scene"), nothing;
    std::vector<SceneTable> tables;
    collect_tables({"", "", &root}, tables);
    const SceneState state = state_of(tables);
    add_empty_tables(tables, nothing);
    ControlJson list = ControlJson::array();
    for (const KeyRow& row : input::scene_keys()) {
        if (!row.table.empty()) continue;
        for (const SceneTable& table : tables)
            if (table.path == row.name || table.path.starts_with(std::string(row.name) + "."))
                add_controls(list, table, state);
    }
    return list;
}

SliderRange slider_range(const Range& allowed, double value, bool integer) {
    SliderRange slider;
    const bool both = std::isfinite(allowed.low) && std::isfinite(allowed.high);
    const double end = far_end(value);
    // A range of four decades has two ends too, but no slider to find a value with.
    const bool whole = both && allowed.high - allowed.low <= 100.0 * end;
    slider.from = std::isfinite(allowed.low) ? allowed.low : value < 0.0 ? -end : 0.0;
    slider.to = whole ? allowed.high : std::min(std::max(end, slider.from + end), allowed.high);
    slider.step = integer ? 1.0 : round_down((slider.to - slider.from) / steps_of_slider);
    if (!allowed.low_included && slider.from == allowed.low) slider.from += slider.step;
    if (!allowed.high_included && slider.to == allowed.high) slider.to -= slider.step;
    return slider;
}

}  // namespace camopt::apps
