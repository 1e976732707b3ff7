// SPDX-License-Identifier: MIT
// Validates the numbers of a scene against their ranges, in the order of the scene's members.
#include "core/numbers/range.hpp"
#include "core/units.hpp"
#include "scene/cost_table.hpp"
#include "scene/faults/scene_faults.hpp"
#include "scene/limit_table.hpp"

#include <fmt/format.h>

#include <array>
#include <span>
#include <string>

namespace camopt {
namespace {

using ranges::not_negative, ranges::positive;

const Range poisson_ratio = {.low = 0.0, .high = 0.5, .high_included = false};

using Number = std::optional<double>;

struct NumberRule {
    const char* member;
    Number (*value)(const Scene&);
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
    NumberRule{"forces.preload", [](const Scene& s) { return of_forces(s, &ForceSpec::preload); }, Range{}},
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
            if (Fault fault = out_of(positive, limit->normalised, fmt::format("limits.{}", row.name())))
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

}  // namespace camopt
