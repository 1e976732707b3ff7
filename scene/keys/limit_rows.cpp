// SPDX-License-Identifier: MIT
// The rows of [limits] and [solver].
#include "scene/key_place.hpp"
#include "scene/keys/own_rows.hpp"
#include "scene/limit_table.hpp"
#include "scene/written_limits.hpp"

#include <fmt/format.h>

namespace camopt::key_rows {
namespace {

using enum KeyType;
using namespace spellings;

/// From SI to the unit of the spelling: 90 deg, not 90.00000000000001.
Range range_in(Range range, const Spelling& spelling) {
    for (double* bound : {&range.low, &range.high})
        if (std::isfinite(*bound)) *bound = as_written(*bound / spelling.factor);
    return range;
}

std::string limit_key(std::string_view name, const KeyAt& at, std::string_view side) {
    return written_limit_key(name, at.spelling != nullptr ? at.spelling->suffix : "", side);
}

/// A number goes to the first of the rows, the bounds of a table to the other two.
template <class Row, class Assign>
void assign_sides(const KeyValue& value, const std::vector<const Row*>& rows, const Assign& assign) {
    if (const auto* const number = std::get_if<double>(&value)) return assign(*rows[0], *number, "");
    const auto& bounds = std::get<KeyBounds>(value);
    if (bounds.least) assign(*rows[1], *bounds.least, "min");
    if (bounds.most) assign(*rows[2], *bounds.most, "max");
}

std::optional<KeyValue> value_of_sides(const std::optional<double>& both, const KeyBounds& sides) {
    if (both) return *both;
    return sides == KeyBounds() ? std::nullopt : std::optional<KeyValue>(sides);
}

/// Of this figure, in the order of peak_limit_rows(): of both sides, least, most.
std::vector<const PeakLimitRow*> sides_of(const PeakLimitRow& both) {
    std::vector<const PeakLimitRow*> rows;
    for (const PeakLimitRow& row : peak_limit_rows())
        if (std::string_view(row.key_name) == both.key_name) rows.push_back(&row);
    return rows;
}

/// A limit on a peak, or on its sides. As written: the limit remembers that number.
KeyPlace peak_limit_place(const PeakLimitRow& both) {
    KeyPlace place;
    place.stored = [](const Scene&, const KeyAt&, double written) { return written; };
    place.assign = [rows = sides_of(both)](Scene& scene, const KeyValue& value, const KeyAt& at) {
        const auto limit = [&](const PeakLimitRow& row, double number, std::string_view side) {
            PeakLimit& own = row.in(scene.limits)
                                 .emplace(number, limit_key(rows[0]->name(), at, side), number,
                                          std::string(at.spelling != nullptr ? at.spelling->unit : ""));
            own.one_normalised =
                own.unit.empty() ? 1.0 : one_normalised_peak(scene.motion, row.order(), *at.spelling);
            own.normalised = number / own.one_normalised;
        };
        assign_sides(value, rows, limit);
    };
    place.value = [rows = sides_of(both)](const Scene& scene, const KeyAt&) -> std::optional<KeyValue> {
        const auto given = [&](std::size_t side) -> std::optional<double> {
            const auto& limit = rows[side]->in(scene.limits);
            return limit ? std::optional(limit->given) : std::nullopt;
        };
        return value_of_sides(given(0), {given(1), given(2)});
    };
    place.unit = [rows = sides_of(both)](const Scene& scene, const KeyAt&) {
        for (const PeakLimitRow* const row : rows)
            if (const auto& limit = row->in(scene.limits)) return limit->unit;
        return std::string();
    };
    return place;
}

/// The rows of one key of a limit: itself, and where it may be a table its sides.
std::vector<const LimitRow*> sides_of(const LimitRow& number) {
    std::vector<const LimitRow*> rows = {&number};
    for (const LimitRow& row : limit_rows())
        if (row.table != nullptr && std::string_view(row.table) == number.name) rows.push_back(&row);
    return rows;
}

/// Any other limit, or its sides, under this name.
KeyPlace limit_place(const LimitRow& number, std::string_view name) {
    const std::vector<const LimitRow*> rows = sides_of(number);
    KeyPlace place;
    place.stored = [](const Scene&, const KeyAt& at, double written) {
        return written * at.spelling->factor;
    };
    place.assign = [=](Scene& scene, const KeyValue& value, const KeyAt& at) {
        const auto limit = [&](const LimitRow& row, double si, std::string_view side) {
            const Spelling& spelling = at.spelling != nullptr ? *at.spelling : spellings::plain[0];
            row.in(scene.limits)
                .emplace(si, limit_key(name, at, side), spelling.factor, std::string(spelling.unit));
        };
        assign_sides(value, rows, limit);
    };
    // A limit of a swinging follower has another name than the same limit of others.
    const auto own = [prefix = fmt::format("limits.{}", name)](const LimitRow& row,
                                                               const Scene& scene) -> const WrittenLimit* {
        const auto& limit = row.in(scene.limits);
        if (!limit || !limit->key.starts_with(prefix)) return nullptr;
        return limit->key.size() == prefix.size() ||
                       std::string_view("._").find(limit->key[prefix.size()]) != std::string_view::npos
                   ? &*limit
                   : nullptr;
    };
    place.value = [=](const Scene& scene, const KeyAt&) -> std::optional<KeyValue> {
        const auto si = [&](std::size_t side) -> std::optional<double> {
            const WrittenLimit* const limit = side < rows.size() ? own(*rows[side], scene) : nullptr;
            return limit != nullptr ? std::optional(limit->value) : std::nullopt;
        };
        return value_of_sides(si(0), {si(1), si(2)});
    };
    place.unit = [=](const Scene& scene, const KeyAt&) {
        for (const LimitRow* const row : rows)
            if (const WrittenLimit* const limit = own(*row, scene)) return limit->unit;
        return std::string();
    };
    return place;
}

/// One harmonic, or the first and the last; none: those near the spring's frequency.
KeyPlace harmonics_place() {
    return {
        .assign =
            [](Scene& scene, const KeyValue& value, const KeyAt&) {
                const auto* const one = std::get_if<double>(&value);
                const KeyBounds both = one != nullptr ? KeyBounds{*one, *one} : std::get<KeyBounds>(value);
                scene.limits.spring_harmonics = {static_cast<int>(*both.least), static_cast<int>(*both.most)};
            },
        .value = [](const Scene& scene, const KeyAt&) -> std::optional<KeyValue> {
            const auto [first, last] = scene.limits.spring_harmonics;
            if (first == 0) return std::nullopt;
            if (first == last) return static_cast<double>(first);
            return KeyBounds{first, last};
        }};
}

KeyPlace motor_curve_place() {
    KeyPlace place = stored_in(&Scene::limits, &LimitSpec::motor_curve);
    place.first_unit = units::revolution_per_minute;
    return place;
}

// A row is read as a row.
// clang-format off
Rows limits() {
    Rows rows;
    for (const PeakLimitRow& row : peak_limit_rows())
        if (row.side == 0)
            rows.push_back({"limits", row.name(), number_or_bounds, row.spellings, any, {}, "none", row.meaning,
                            peak_limit_place(row)});
    for (const LimitRow& row : limit_rows()) {
        if (row.side != nullptr) continue;
        const Availability needs = row.needs_dynamics ? Availability::needs_dynamics
                                   : row.needs_drive  ? Availability::needs_drive
                                   : row.needs_forces ? Availability::needs_forces
                                                      : Availability::needs_cam;
        const KeyType type = row.figure == LimitedFigure::motor_torque ? number_or_bounds : number;
        const std::string_view label = row.words == nullptr ? "" : row.words;
        rows.push_back(called(label, {"limits", row.name, type, row.spellings,
                        type == number ? range_in(row.range, row.spellings.front()) : any,
                        {}, row.default_text, row.meaning, limit_place(row, row.name), needs}));
        if (const LimitRow::Swinging& swinging = row.swinging; swinging.name != nullptr)
            rows.push_back(called(label, {"limits", swinging.name, number, swinging.spellings,
                            range_in(row.range, swinging.spellings.front()), {}, row.default_text,
                            swinging.meaning, limit_place(row, swinging.name), needs, row.name}));
    }
    rows.push_back({"limits", "motor_curve", points, plain, any, {}, "none",
                    "The torque-speed curve of the motor: pairs of a speed in rpm, from 0 on, and the largest "
                    "magnitude of the torque there in N m. Linear between them, concave and never rising; the last "
                    "speed is the largest.", motor_curve_place(), Availability::needs_drive});
    rows.push_back({"limits", "spring_harmonics", number_or_range, plain, Range::between(1, most_harmonic), {},
                    "the nearest 3", "The harmonics that `spring_harmonic` holds for: one, or a range `{ min, max }`. "
                    "Default: the nearest to `forces.spring_frequency`, and one to either side.",
                    harmonics_place(), Availability::needs_forces});
    return rows;
}

Rows solver() {
    return {
        called("solver", {"solver", "name", text, plain, any, {}, "\"auto\"",
         "`\"auto\"` or a solver of `camopt list solvers`.", stored_in(&Scene::solver, &SolverSpec::name)}),
        {"solver", "tolerance", number, plain, Range::between(1e-12, 1e-2), {}, "1e-9",
         "Feasibility and optimality of the solve, relative.", stored_in(&Scene::solver, &SolverSpec::tolerance)},
        called("proved gap", {"solver", "gap", number, plain, Range::between(1e-12, 1e-2), {}, "1e-7 where convex, 1e-4 otherwise",
         "Proved relative gap below which the verdict is optimal.", stored_in(&Scene::solver, &SolverSpec::gap)}),
        called("time limit, s", {"solver", "max_seconds", number, plain, positive, {}, "60",
         "Wall time of search, proof, tie-break and explanation together; then the best motion so far is returned.",
         stored_in(&Scene::solver, &SolverSpec::max_seconds)}),
        called("time for suggested changes, s", {"solver", "explain_seconds", number, plain, not_negative, {}, "5",
         "Part of this time: for the search for changes that make an infeasible scene feasible.",
         stored_in(&Scene::solver, &SolverSpec::explain_seconds)}),
        called("suggested changes", {"solver", "explain_changes", integer, plain, Range::between(1, 1000), {}, "3",
         "That search ends as soon as it has found so many useful changes.",
         stored_in(&Scene::solver, &SolverSpec::explain_changes)}),
        called("starting points", {"solver", "starts", integer, plain, Range::between(1, 100000), {}, "1 where convex, 8 otherwise",
         "Starting points; a convex scene needs one.", stored_in(&Scene::solver, &SolverSpec::starts)}),
        called("seed of the starting points", {"solver", "seed", integer, plain, Range::between(0, 4294967295), {}, "0",
         "Seed of the random starting points.", stored_in(&Scene::solver, &SolverSpec::seed)}),
        {"solver", "options", options, plain, any, {}, "none",
         "The solver's own options: any names, values are text, numbers, true or false.",
         stored_in(&Scene::solver, &SolverSpec::options)},
    };
}
// clang-format on

}  // namespace

Rows of_limits() {
    return joined(limits(), solver());
}

}  // namespace camopt::key_rows
