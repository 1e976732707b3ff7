// SPDX-License-Identifier: MIT
// Validation of a scene: numbers against their ranges in the order of the scene's members, then relations
// between members.
#include "core/text/list_text.hpp"
#include "scene/faults/scene_faults.hpp"
#include "scene/key_place.hpp"
#include "scene/keys/own_rows.hpp"
#include "scene/limit_table.hpp"
#include "scene/part_names.hpp"

#include <fmt/ranges.h>

namespace camopt {

namespace {

using ranges::any, ranges::positive;

Fault out_of(const Range& range, double value, std::string_view table, std::string_view name) {
    if (range.contains(value)) return std::nullopt;
    return SceneFault{joined_key(table, name), fmt::format("{}", value), range.number_text()};
}

Fault limit_number_fault(const LimitSpec& limits) {
    for (const PeakLimitRow& row : peak_limit_rows())
        if (const auto& limit = row.in(limits))
            if (Fault fault = out_of(row.side == 0 ? positive : any, limit->normalised, "limits", row.name()))
                return fault;
    for (const LimitRow& row : limit_rows())
        if (const auto& limit = row.in(limits))
            if (Fault fault = out_of(row.range, limit->value, "limits", row.name)) return fault;
    return std::nullopt;
}

}  // namespace

Fault row_fault(const KeyRow& row, const KeyOwner& owner) {
    const std::optional<KeyValue> value = row.place->value(owner, {});
    if (!value) return std::nullopt;
    if (const auto* const number = std::get_if<double>(&*value))
        return out_of(row.range.scaled(row.spellings.front().factor), *number, row.table, row.name);
    const auto* const integer = std::get_if<long long>(&*value);
    const auto* const word = row.type == KeyType::text ? std::get_if<std::string>(&*value) : nullptr;
    if (integer == nullptr && word == nullptr) return std::nullopt;
    const std::string found = integer != nullptr ? fmt::to_string(*integer) : *word;
    if (!row.choices.empty() && std::ranges::find(row.choices, found) == row.choices.end())
        return SceneFault{joined_key(row.table, row.name), word != nullptr ? in_quotes(found) : found,
                          row.choices_text()};
    if (integer == nullptr || row.range.contains(static_cast<double>(*integer))) return std::nullopt;
    return SceneFault{joined_key(row.table, row.name), found, row.range.integer_text()};
}

Fault number_fault(const Scene& scene) {
    // Before its row, which has no lift of stops and that of the valve of a lobe: those are computed from it.
    if (Fault fault = out_of(positive, scene.motion.lift, "motion", "lift")) return fault;
    for (const KeyRow& row : own_rows())
        if (row.place && row.place->entries == 0 && !row.place->stored)
            if (Fault fault = row_fault(row, scene)) return fault;
    return limit_number_fault(scene.limits);
}

// Validation of a scene: numbers against their ranges (one table), then relations between members.

namespace {

Fault breakpoint_fault(const Scene& scene) {
    const std::vector<double>& points = scene.spline.breakpoints;
    if (points.empty()) return std::nullopt;
    const bool program = scene.motion.type == MotionType::program;
    const double length = program ? 1.0 : scene.motion.length();
    const auto member = [](std::size_t i) { return entry_key("spline.breakpoints", i); };
    if (points.size() < 2 || points.size() > 65537)
        return SceneFault{"spline.breakpoints", fmt::format("{} breakpoint(s)", points.size()), "2 to 65537"};
    if (!(std::abs(points.front()) <= same_place))
        return SceneFault{member(0), fmt::format("{}", points.front()),
                          program ? "0, the start of a segment" : "0, the start of the motion"};
    for (std::size_t i = 1; i < points.size(); ++i)
        if (!(points[i] - points[i - 1] > same_place))
            return SceneFault{member(i), fmt::format("{} after {}", points[i], points[i - 1]),
                              "ascending breakpoints"};
    if (!(std::abs(points.back() - length) <= same_place))
        return SceneFault{member(points.size() - 1), fmt::format("{}", points.back()),
                          fmt::format("{}, the end of {}", length, program ? "a segment" : "the motion")};
    if (!scene.motion.symmetric) return std::nullopt;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double mirrored = length - points[points.size() - 1 - i];
        if (std::abs(points[i] - mirrored) > same_place)
            return SceneFault{member(i), fmt::format("{} in a symmetric motion", points[i]),
                              fmt::format("{}, the mirror image of another breakpoint", mirrored)};
    }
    return std::nullopt;
}

/// The search is dense in the breakpoints.
constexpr int most_free_segments = 256;

Fault free_knot_fault(const Scene& scene) {
    const SplineSpec& spline = scene.spline;
    if (!spline.free_knots) return std::nullopt;
    const int segments =
        spline.breakpoints.empty() ? spline.segments : static_cast<int>(spline.breakpoints.size()) - 1;
    if (segments > most_free_segments)
        return SceneFault{"spline.knots", fmt::format("\"free\" with {} segments", segments),
                          fmt::format("\"fixed\", or at most {} segments", most_free_segments)};
    return std::nullopt;
}

Fault spline_fault(const SplineSpec& spline) {
    if (spline.degree != 3 && spline.degree != 5 && spline.degree != 7)
        return SceneFault{"spline.degree", fmt::to_string(spline.degree), "3, 5 or 7"};
    const int smoothest = spline.degree - 1;
    if (spline.smoothness() < spline.roughest() || spline.smoothness() > smoothest)
        return SceneFault{"spline.continuity", fmt::to_string(*spline.continuity),
                          smoothest == 2 ? "2 with degree 3"
                                         : fmt::format("an integer from {} to {} with degree {}",
                                                       spline.roughest(), smoothest, spline.degree)};
    if (spline.rest == 3 && smoothest < 3)
        return SceneFault{"spline.end_jerk", "\"zero\" with degree 3", "\"free\", or degree 5 or 7"};
    if (spline.rest < 2 || spline.rest > smoothest)
        return SceneFault{
            "spline.rest", fmt::format("{} with degree {}", spline.rest, spline.degree),
            smoothest == 2 ? "2, or degree 5 or 7" : fmt::format("an integer from 2 to {}", smoothest)};
    if (spline.design == DesignKind::ordinates && spline.smoothness() != smoothest)
        return SceneFault{"spline.design",
                          fmt::format("\"ordinates\" with continuity {}", spline.smoothness()),
                          fmt::format("\"ordinates\" only with continuity {}", smoothest)};
    return std::nullopt;
}

std::string missing_dimension(const CamSpec& cam, double weight) {
    const std::string follower = cam.choice("follower");
    return fmt::format("{} for a dimension that {} does not have", weight,
                       follower.empty() ? fmt::format("a cam of type \"{}\"", cam.type)
                                        : fmt::format("the follower \"{}\"", follower));
}

/// The weights of the cam's dimensions; `found`: one of them counts.
Fault dimension_weight_fault(const Scene& scene, bool& found) {
    for (int i = 0; i < dimension_count; ++i) {
        const auto index = static_cast<DimensionIndex>(i);
        const double weight = scene.objective.dimensions[static_cast<std::size_t>(i)];
        if (weight == 0.0) continue;
        const std::string member = fmt::format("objective.{}", name_of(index));
        if (!scene.cam)
            return SceneFault{member, fmt::format("{} without a cam", weight),
                              "0, or a [cam] table with this dimension"};
        const Dimension* const own = scene.cam->find(index);
        if (own == nullptr) return SceneFault{member, missing_dimension(*scene.cam, weight), "0"};
        if (own->is_variable()) found = true;
    }
    return std::nullopt;
}

Fault objective_fault(const Scene& scene) {
    const ObjectiveSpec& objective = scene.objective;
    const Reference& reference = objective.reference;
    bool weighs_dimension = false;
    if (Fault fault = dimension_weight_fault(scene, weighs_dimension)) return fault;
    if (!weighs_dimension && !scene.motion.prescribed() && !scene.is_given() && scene.own_terms.empty() &&
        std::ranges::none_of(cost_terms(),
                             [&](const CostTerm& term) { return term.weight_in(objective) > 0.0; }) &&
        std::ranges::none_of(response_terms(),
                             [&](const ResponseTerm& term) { return term.weight_in(objective) > 0.0; }))
        return SceneFault{"objective", "no weight > 0",
                          fmt::format("at least one of {}, area > 0, or of a dimension of the cam that is a "
                                      "range",
                                      fmt::join(cost_term_names(), ", "))};
    for (const CostTerm& term : cost_terms()) {
        const double weight = term.weight_in(objective);
        if (reference.numeric && weight > 0.0 && !(reference.*term.reference))
            return SceneFault{fmt::format("objective.reference.{}", term.name()), "no number",
                              fmt::format("a number > 0, because objective.{} = {}", term.name(), weight)};
    }
    return std::nullopt;
}

}  // namespace

std::optional<SceneFault> find_fault(const Scene& scene) {
    if (Fault fault = number_fault(scene)) return fault;
    if (Fault fault = motion_fault(scene.motion)) return fault;
    if (!scene.is_given())
        if (Fault fault = idle_fault(scene.motion)) return fault;
    if (Fault fault = spline_fault(scene.spline)) return fault;
    if (Fault fault = breakpoint_fault(scene)) return fault;
    if (Fault fault = free_knot_fault(scene)) return fault;
    if (Fault fault = measured_fault(scene)) return fault;
    if (Fault fault = cam_fault(scene)) return fault;
    if (Fault fault = objective_fault(scene)) return fault;
    if (Fault fault = force_fault(scene)) return fault;
    if (Fault fault = own_rules_fault(scene)) return fault;
    if (Fault fault = drawing_fault(scene)) return fault;
    if (Fault fault = dynamics_fault(scene)) return fault;
    if (Fault fault = drive_fault(scene)) return fault;
    if (Fault fault = limit_fault(scene)) return fault;
    return tolerance_fault(scene);
}

void validate(const Scene& scene) {
    if (const Fault fault = find_fault(scene)) throw SceneError(*fault);
}

SceneError::SceneError(SceneFault fault)
    : InputError(fmt::format("{}: {}", fault.member, words_of(fault))), fault_(std::move(fault)) {}

std::string words_of(const SceneFault& fault) {
    return fmt::format("found {}; allowed: {}", fault.found, fault.allowed);
}

}  // namespace camopt
