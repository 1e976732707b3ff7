// SPDX-License-Identifier: MIT
// The rows of [spline], [objective], [limits] and [solver].
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

/// Given breakpoints replace them; without the key an RR motion has as many over each stroke.
KeyPlace uniform_segments() {
    KeyPlace place = stored_in(&Scene::spline, &SplineSpec::segments);
    place.assign = [assign = place.assign](Scene& scene, const KeyValue& value, const KeyAt& at) {
        assign(scene, value, at);
        scene.spline.by_stroke = false;
    };
    return unless(std::move(place), [](const Scene& scene, const KeyAt&) {
        const SplineSpec& spline = scene.spline;
        return (spline.by_stroke && spline.segments == SplineSpec().segments) || !spline.breakpoints.empty();
    });
}

KeyPlace breakpoints_place() {
    KeyPlace place = stored_in(&Scene::spline, &SplineSpec::breakpoints);
    place.assign = [assign = place.assign](Scene& scene, const KeyValue& value, const KeyAt& at) {
        assign(scene, value, at);
        scene.spline.by_stroke = false;
    };
    return place;
}

KeyPlace knots_place() {
    return {.assign = [](Scene& scene, const KeyValue& value,
                         const KeyAt&) { scene.spline.free_knots = value == KeyValue("free"); },
            .value = [](const Scene& scene, const KeyAt&) -> std::optional<KeyValue> {
                return scene.spline.free_knots ? "free" : "fixed";
            }};
}

std::string limit_key(std::string_view name, const KeyAt& at, std::string_view side) {
    return fmt::format("limits.{}{}{}{}", name, at.spelling != nullptr ? at.spelling->suffix : "",
                       side.empty() ? "" : ".", side);
}

/// Of this figure, in the order of peak_limit_rows(): of both sides, least, most.
std::vector<const PeakLimitRow*> sides_of(const PeakLimitRow& both) {
    std::vector<const PeakLimitRow*> rows;
    for (const PeakLimitRow& row : peak_limit_rows())
        if (row.figure == both.figure) rows.push_back(&row);
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
        if (const auto* const number = std::get_if<double>(&value)) return limit(*rows[0], *number, "");
        const KeyBounds& bounds = std::get<KeyBounds>(value);
        if (bounds.least) limit(*rows[1], *bounds.least, "min");
        if (bounds.most) limit(*rows[2], *bounds.most, "max");
    };
    place.value = [rows = sides_of(both)](const Scene& scene, const KeyAt&) -> std::optional<KeyValue> {
        const auto given = [&](std::size_t side) -> std::optional<double> {
            const auto& limit = rows[side]->in(scene.limits);
            return limit ? std::optional(limit->given) : std::nullopt;
        };
        if (const auto number = given(0)) return *number;
        const KeyBounds bounds{given(1), given(2)};
        return bounds == KeyBounds() ? std::nullopt : std::optional<KeyValue>(bounds);
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
        if (const auto* const si = std::get_if<double>(&value)) return limit(*rows[0], *si, "");
        const KeyBounds& bounds = std::get<KeyBounds>(value);
        if (bounds.least) limit(*rows[1], *bounds.least, rows[1]->side);
        if (bounds.most) limit(*rows[2], *bounds.most, rows[2]->side);
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
        if (const auto one = si(0)) return *one;
        const KeyBounds bounds{si(1), si(2)};
        return bounds == KeyBounds() ? std::nullopt : std::optional<KeyValue>(bounds);
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
Rows spline() {
    return {
        {"spline", "degree", integer, plain, any, {"3", "5"}, "3", "Degree of the spline.",
         stored_in(&Scene::spline, &SplineSpec::degree)},
        {"spline", "segments", integer, plain, Range::between(1, 65536), {}, "12",
         "Uniform segments over the rise (DRD), over rise and return (RR), or over each spline segment of a "
         "program. Without the key RR has six over the rise and six over the return.", uniform_segments()},
        {"spline", "breakpoints", numbers, plain, not_negative, {}, "uniform",
         "The breakpoints themselves, ascending from 0 to the end of the motion, in units of the rise; in a "
         "program from 0 to 1, in units of each spline segment.", breakpoints_place(), Availability::now, "segments"},
        {"spline", "knots", text, plain, any, {"fixed", "free"}, "\"fixed\"",
         "`\"free\"` makes the interior breakpoints design variables: those of `segments` or `breakpoints` are "
         "where the search starts. DRD and RR, at most 256 segments.",
         knots_place()},
        {"spline", "continuity", integer, plain, Range::between(2, 4), {}, "degree - 1",
         "Highest continuous derivative, from 2 to degree - 1.", stored_in(&Scene::spline, &SplineSpec::continuity)},
        {"spline", "end_jerk", text, plain, any, {"free", "zero"}, "\"free\"",
         "`\"zero\"`: y''' = 0 at both ends, so that the jerk does not jump at the dwells; degree 5 only.",
         stored_in(&Scene::spline, &SplineSpec::end_jerk)},
        {"spline", "design", text, plain, any, {"auto", "ordinates", "coefficients", "states"}, "\"auto\"",
         "The variables of the search: displacements at the breakpoints (full continuity only), B-spline "
         "coefficients, or displacement and derivatives at the breakpoints.",
         stored_in(&Scene::spline, &SplineSpec::design)},
    };
}

/// In the order of the manual: convex terms before others.
std::vector<const CostTerm*> listed_terms() {
    std::vector<const CostTerm*> terms;
    for (const CostTerm& term : cost_terms()) terms.push_back(&term);
    std::stable_partition(terms.begin(), terms.end(),
                          [](const CostTerm* term) { return term->kind != CostTerm::Kind::torque; });
    return terms;
}

Availability needs_of(const ResponseTerm& term) {
    return term.needs_dynamics() ? Availability::needs_dynamics
           : term.needs_drive()  ? Availability::needs_drive
                                 : Availability::now;
}

Rows objective() {
    Rows rows;
    for (const CostTerm* term : listed_terms())
        rows.push_back({"objective", term->name(), number, plain, not_negative, {}, "0", term->weight_meaning,
                        stored_in(&Scene::objective, term->weight)});
    for (const ResponseTerm& term : response_terms())
        rows.push_back({"objective", term.name, number, plain, not_negative, {}, "0", term.weight_meaning,
                        stored_in(&Scene::objective, term.weight), needs_of(term)});
    return rows;
}

/// The first is the default.
std::vector<std::string_view> tie_break_words() {
    std::vector<std::string_view> words;
    words.reserve(std::size(tie_breaks));
    for (const TieBreak value : tie_breaks) words.emplace_back(name_of(value));
    return words;
}

Rows dimension_weights() {
    const auto dimension_weight = [](DimensionIndex dimension) {
        return stored_in(&Scene::objective, &ObjectiveSpec::dimensions, static_cast<std::size_t>(dimension));
    };
    return {
        {"objective", "base_radius", number, plain, not_negative, {}, "0",
         "Weight of the base radius divided by the lift (oscillating: by lift in rad · centre distance).",
         dimension_weight(DimensionIndex::base_radius),
         Availability::needs_cam},
        {"objective", "roller_radius", number, plain, not_negative, {}, "0",
         "Weight of the roller radius, divided likewise.",
         dimension_weight(DimensionIndex::roller_radius), Availability::needs_cam},
        {"objective", "offset", number, plain, not_negative, {}, "0",
         "Weight of the offset's magnitude, divided likewise.",
         dimension_weight(DimensionIndex::offset), Availability::needs_cam},
        {"objective", "center_distance", number, plain, not_negative, {}, "0",
         "Weight of the centre distance, divided likewise.",
         dimension_weight(DimensionIndex::center_distance), Availability::needs_cam},
        {"objective", "arm_length", number, plain, not_negative, {}, "0",
         "Weight of the arm length, divided likewise.",
         dimension_weight(DimensionIndex::arm_length), Availability::needs_cam},
        {"objective", "face_offset", number, plain, not_negative, {}, "0",
         "Weight of the face offset, divided likewise.",
         dimension_weight(DimensionIndex::face_offset), Availability::needs_cam},
    };
}

/// The name of a law, or a table of numbers.
KeyPlace reference_place() {
    return {.assign =
                [](Scene& scene, const KeyValue& value, const KeyAt&) {
                    Reference& reference = scene.objective.reference;
                    reference.numeric = !std::holds_alternative<std::string>(value);
                    if (!reference.numeric) reference.law = std::get<std::string>(value);
                },
            .value = [](const Scene& scene, const KeyAt&) -> std::optional<KeyValue> {
                const Reference& reference = scene.objective.reference;
                return reference.numeric ? KeyValue() : KeyValue(reference.law);
            }};
}

KeyPlace reference_number(std::optional<double> Reference::*number) {
    return stored_in(&Scene::objective, &ObjectiveSpec::reference, number);
}

Rows reference() {
    static const std::string first_tie_break = fmt::format("\"{}\"", name_of(tie_breaks.front()));
    Rows rows = {
        {"objective", "reference", text_or_table, plain, any, {}, "\"modified_sine\"",
         "What every term is divided by: the peaks of a law of the catalogue, or a table of numbers.", reference_place()},
        {"objective", "tie_break", text, plain, any, tie_break_words(), first_tie_break,
         "Among curves equally good within the tolerance take the one of least ∫ y'''²; `\"none\"` keeps "
         "the solver's point.", stored_in(&Scene::objective, &ObjectiveSpec::tie_break)},
    };
    for (const CostTerm* term : listed_terms())
        rows.push_back({"objective.reference", term->name(), number, plain, positive, {}, "none",
                        term->reference_meaning, reference_number(term->reference)});
    for (const ResponseTerm& term : response_terms())
        rows.push_back({"objective.reference", term.name, number, plain, positive, {}, "none",
                        term.reference_meaning, reference_number(term.reference), needs_of(term)});
    return rows;
}

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
        rows.push_back({"limits", row.name, type, row.spellings, type == number ? range_in(row.range, row.spellings.front()) : any,
                        {}, row.default_text, row.meaning, limit_place(row, row.name), needs});
        if (const LimitRow::Swinging& swinging = row.swinging; swinging.name != nullptr)
            rows.push_back({"limits", swinging.name, number, swinging.spellings,
                            range_in(row.range, swinging.spellings.front()), {}, row.default_text,
                            swinging.meaning, limit_place(row, swinging.name), needs, row.name});
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
        {"solver", "name", text, plain, any, {}, "\"auto\"",
         "`\"auto\"` or a solver of `camopt list solvers`.", stored_in(&Scene::solver, &SolverSpec::name)},
        {"solver", "tolerance", number, plain, Range::between(1e-12, 1e-2), {}, "1e-9",
         "Feasibility and optimality of the solve, relative.", stored_in(&Scene::solver, &SolverSpec::tolerance)},
        {"solver", "gap", number, plain, Range::between(1e-12, 1e-2), {}, "1e-7 where convex, 1e-4 otherwise",
         "Proved relative gap below which the verdict is optimal.", stored_in(&Scene::solver, &SolverSpec::gap)},
        {"solver", "max_seconds", number, plain, positive, {}, "60",
         "Wall time of search, proof, tie-break and explanation together; then the best motion so far is returned.",
         stored_in(&Scene::solver, &SolverSpec::max_seconds)},
        {"solver", "explain_seconds", number, plain, not_negative, {}, "5",
         "Part of this time: for the search for changes that make an infeasible scene feasible.",
         stored_in(&Scene::solver, &SolverSpec::explain_seconds)},
        {"solver", "explain_changes", integer, plain, Range::between(1, 1000), {}, "3",
         "That search ends as soon as it has found so many useful changes.",
         stored_in(&Scene::solver, &SolverSpec::explain_changes)},
        {"solver", "starts", integer, plain, Range::between(1, 100000), {}, "1 where convex, 8 otherwise",
         "Starting points; a convex scene needs one.", stored_in(&Scene::solver, &SolverSpec::starts)},
        {"solver", "seed", integer, plain, Range::between(0, 4294967295), {}, "0",
         "Seed of the random starting points.", stored_in(&Scene::solver, &SolverSpec::seed)},
        {"solver", "options", options, plain, any, {}, "none",
         "The solver's own options: any names, values are text, numbers, true or false.",
         stored_in(&Scene::solver, &SolverSpec::options)},
    };
}
// clang-format on

}  // namespace

Rows of_search() {
    return joined({spline(), objective(), dimension_weights(), reference()});
}

Rows of_limits() {
    return joined({limits(), solver()});
}

}  // namespace camopt::key_rows
