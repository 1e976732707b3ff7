// SPDX-License-Identifier: MIT
// Validation of a scene: numbers against their ranges in the order of the scene's members, then relations
// between members.
#include "scene/faults/scene_faults.hpp"
#include "scene/limit_table.hpp"

#include <fmt/ranges.h>

namespace camopt {

// Validates the numbers of a scene against their ranges, in the order of the scene's members.

namespace {

using ranges::any, ranges::not_negative, ranges::positive;

const Range poisson_ratio = {.low = 0.0, .high = 0.5, .high_included = false};

using Number = std::optional<double>;

struct NumberRule {
    const char* member = nullptr;
    Number (*value)(const Scene&) = nullptr;
    Range range;
};

Number of_forces(const Scene& scene, double ForceSpec::*member) {
    return scene.forces ? Number((*scene.forces).*member) : std::nullopt;
}

const std::array motion_numbers = {
    NumberRule{"motion.lift", [](const Scene& s) { return Number(s.motion.lift); }, positive},
    NumberRule{"motion.rise", [](const Scene& s) { return Number(s.motion.rise); },
               Range::above_up_to(0.0, units::turn)},
    NumberRule{"motion.return_angle", [](const Scene& s) { return s.motion.return_angle; },
               Range::above_up_to(0.0, units::turn)},
    NumberRule{"motion.speed", [](const Scene& s) { return s.motion.speed; }, positive},
};

const std::array force_numbers = {
    NumberRule{"forces.mass", [](const Scene& s) { return of_forces(s, &ForceSpec::mass); }, not_negative},
    NumberRule{"forces.spring_rate", [](const Scene& s) { return of_forces(s, &ForceSpec::spring_rate); },
               not_negative},
    NumberRule{"forces.damping", [](const Scene& s) { return of_forces(s, &ForceSpec::damping); },
               not_negative},
    NumberRule{"forces.preload", [](const Scene& s) { return of_forces(s, &ForceSpec::preload); }, Range{}},
    NumberRule{"forces.spring_frequency",
               [](const Scene& s) { return s.forces ? s.forces->spring_frequency : std::nullopt; }, positive},
    NumberRule{"forces.contact_width",
               [](const Scene& s) { return s.forces ? s.forces->contact_width : std::nullopt; }, positive},
    NumberRule{"forces.cam_modulus", [](const Scene& s) { return of_forces(s, &ForceSpec::cam_modulus); },
               positive},
    NumberRule{"forces.follower_modulus",
               [](const Scene& s) { return of_forces(s, &ForceSpec::follower_modulus); }, positive},
    NumberRule{"forces.cam_poisson", [](const Scene& s) { return of_forces(s, &ForceSpec::cam_poisson); },
               poisson_ratio},
    NumberRule{"forces.follower_poisson",
               [](const Scene& s) { return of_forces(s, &ForceSpec::follower_poisson); }, poisson_ratio},
};

const std::array solver_numbers = {
    NumberRule{"solver.tolerance", [](const Scene& s) { return Number(s.solver.tolerance); },
               Range::between(1e-12, 1e-2)},
    NumberRule{"solver.gap", [](const Scene& s) { return s.solver.gap; }, Range::between(1e-12, 1e-2)},
    NumberRule{"solver.max_seconds", [](const Scene& s) { return Number(s.solver.max_seconds); }, positive},
    NumberRule{"solver.explain_seconds", [](const Scene& s) { return Number(s.solver.explain_seconds); },
               not_negative},
    NumberRule{"solver.explain_changes", [](const Scene& s) { return Number(s.solver.explain_changes); },
               Range::between(1, 1000)},
};

Fault out_of(const Range& range, const Number& value, const std::string& member) {
    if (!value || range.contains(*value)) return std::nullopt;
    return SceneFault{member, fmt::format("{}", *value), range.number_text()};
}

Fault fault_in(std::span<const NumberRule> rules, const Scene& scene) {
    for (const NumberRule& rule : rules)
        if (Fault fault = out_of(rule.range, rule.value(scene), rule.member)) return fault;
    return std::nullopt;
}

Fault weight_fault(const ObjectiveSpec& objective) {
    for (const CostTerm& term : cost_terms())
        if (Fault fault =
                out_of(not_negative, objective.*term.weight, fmt::format("objective.{}", term.name())))
            return fault;
    for (const ResponseTerm& term : response_terms()) {
        const std::string key = fmt::format("objective.{}", term.name);
        if (Fault fault = out_of(not_negative, objective.*term.weight, key)) return fault;
        const std::string reference = fmt::format("objective.reference.{}", term.name);
        if (Fault fault = out_of(positive, objective.reference.*term.reference, reference)) return fault;
    }
    for (int i = 0; i < dimension_count; ++i)
        if (Fault fault = out_of(not_negative, objective.dimensions[static_cast<std::size_t>(i)],
                                 fmt::format("objective.{}", name_of(static_cast<DimensionIndex>(i)))))
            return fault;
    for (const CostTerm& term : cost_terms())
        if (Fault fault = out_of(positive, objective.reference.*term.reference,
                                 fmt::format("objective.reference.{}", term.name())))
            return fault;
    return std::nullopt;
}

Fault limit_number_fault(const LimitSpec& limits) {
    for (const PeakLimitRow& row : peak_limit_rows())
        if (const auto& limit = row.in(limits))
            if (Fault fault = out_of(row.side == 0 ? positive : any, limit->normalised,
                                     fmt::format("limits.{}", row.name())))
                return fault;
    for (const LimitRow& row : limit_rows())
        if (const auto& limit = row.in(limits))
            if (Fault fault = out_of(row.range, limit->value, fmt::format("limits.{}", row.name)))
                return fault;
    return std::nullopt;
}

}  // namespace

Fault number_fault(const Scene& scene) {
    if (Fault fault = fault_in(motion_numbers, scene)) return fault;
    if (Fault fault = weight_fault(scene.objective)) return fault;
    if (Fault fault = fault_in(force_numbers, scene)) return fault;
    if (Fault fault = limit_number_fault(scene.limits)) return fault;
    if (Fault fault = fault_in(solver_numbers, scene)) return fault;
    if (scene.solver.starts && *scene.solver.starts < 1)
        return SceneFault{"solver.starts", fmt::to_string(*scene.solver.starts),
                          Range::at_least(1).integer_text()};
    return std::nullopt;
}

// Validation of a scene: numbers against their ranges (one table), then relations between members.

namespace {

Fault breakpoint_fault(const Scene& scene) {
    const std::vector<double>& points = scene.spline.breakpoints;
    if (points.empty()) return std::nullopt;
    const bool program = scene.motion.type == MotionType::program;
    const double length = program ? 1.0 : scene.motion.length();
    const auto member = [](std::size_t i) { return fmt::format("spline.breakpoints[{}]", i); };
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
    if (scene.motion.type == MotionType::program)
        return SceneFault{"spline.knots", "\"free\" in a program",
                          "\"fixed\", or motion type \"DRD\" or \"RR\""};
    if (std::ranges::any_of(scene.motion.via, &SetPoint::is_region))
        return SceneFault{"spline.knots", "\"free\" with a region of constant velocity, whose ends are knots",
                          "\"fixed\", or exact points alone"};
    const bool bounded = !scene.motion.corridors.empty() ||
                         std::ranges::any_of(peak_limit_rows(), [&](const PeakLimitRow& row) {
                             return row.side != 0 && row.in(scene.limits).has_value();
                         });
    const bool weighed = std::ranges::any_of(response_terms(), [&](const ResponseTerm& term) {
        return !term.needs_dynamics() && !term.needs_drive() && term.weight_in(scene.objective) > 0.0;
    });
    if (bounded || scene.motion.start || scene.motion.end || weighed)
        return SceneFault{
            "spline.knots",
            "\"free\" with motion.start, motion.end, a corridor, a limit of one side or a weight "
            "of the area or of a deviation",
            "\"fixed\""};
    const int segments =
        spline.breakpoints.empty() ? spline.segments : static_cast<int>(spline.breakpoints.size()) - 1;
    if (segments > most_free_segments)
        return SceneFault{"spline.knots", fmt::format("\"free\" with {} segments", segments),
                          fmt::format("\"fixed\", or at most {} segments", most_free_segments)};
    return std::nullopt;
}

Fault spline_fault(const SplineSpec& spline) {
    if (spline.degree != 3 && spline.degree != 5)
        return SceneFault{"spline.degree", fmt::to_string(spline.degree), "3 or 5"};
    const Range segments = Range::between(1, 65536);
    if (spline.breakpoints.empty() && !segments.contains(spline.segments))
        return SceneFault{"spline.segments", fmt::to_string(spline.segments), segments.integer_text()};
    const int smoothest = spline.degree - 1;
    if (spline.smoothness() < 2 || spline.smoothness() > smoothest)
        return SceneFault{
            "spline.continuity", fmt::to_string(*spline.continuity),
            smoothest == 2 ? "2 with degree 3"
                           : fmt::format("an integer from 2 to {} with degree {}", smoothest, spline.degree)};
    if (spline.end_jerk == EndJerk::zero && spline.degree != 5)
        return SceneFault{"spline.end_jerk", "\"zero\" with degree 3", "\"free\", or degree 5"};
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
    if (!weighs_dimension && !scene.motion.prescribed() && scene.own_terms.empty() &&
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
    return limit_fault(scene);
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
