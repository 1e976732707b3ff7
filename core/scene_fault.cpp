// SPDX-License-Identifier: MIT
// The checks of a scene: numbers against their ranges (one table), then what must hold between members.
#include "core/errors.hpp"
#include "core/range.hpp"
#include "core/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace camopt {
namespace {

using Fault = std::optional<SceneFault>;

// Places along the motion closer than this are the same place; the rounding of a decimal breakpoint is far
// below.
constexpr double same_place = 1e-12;
constexpr double full_turn = 2.0 * std::numbers::pi;

struct NumberRule {
    const char* member;
    std::optional<double> (*value)(const Scene&);
    Range range;
};

std::optional<double> normalised(const std::optional<PeakLimit>& limit) {
    if (!limit) return std::nullopt;
    return limit->normalised;
}

const std::array number_rules = {
    NumberRule{"motion.lift", [](const Scene& s) { return std::optional(s.motion.lift); }, Range::above(0.0)},
    NumberRule{"motion.rise", [](const Scene& s) { return std::optional(s.motion.rise); },
               Range::above_up_to(0.0, full_turn)},
    NumberRule{"motion.return_angle", [](const Scene& s) { return s.motion.return_angle; },
               Range::above_up_to(0.0, full_turn)},
    NumberRule{"motion.speed", [](const Scene& s) { return s.motion.speed; }, Range::above(0.0)},
    NumberRule{"objective.velocity", [](const Scene& s) { return std::optional(s.objective.velocity); },
               Range::at_least(0.0)},
    NumberRule{"objective.acceleration",
               [](const Scene& s) { return std::optional(s.objective.acceleration); }, Range::at_least(0.0)},
    NumberRule{"objective.jerk", [](const Scene& s) { return std::optional(s.objective.jerk); },
               Range::at_least(0.0)},
    NumberRule{"objective.rms_acceleration",
               [](const Scene& s) { return std::optional(s.objective.rms_acceleration); },
               Range::at_least(0.0)},
    NumberRule{"objective.rms_jerk", [](const Scene& s) { return std::optional(s.objective.rms_jerk); },
               Range::at_least(0.0)},
    NumberRule{"objective.reference.velocity", [](const Scene& s) { return s.objective.reference.velocity; },
               Range::above(0.0)},
    NumberRule{"objective.reference.acceleration",
               [](const Scene& s) { return s.objective.reference.acceleration; }, Range::above(0.0)},
    NumberRule{"objective.reference.jerk", [](const Scene& s) { return s.objective.reference.jerk; },
               Range::above(0.0)},
    NumberRule{"objective.reference.rms_acceleration",
               [](const Scene& s) { return s.objective.reference.rms_acceleration; }, Range::above(0.0)},
    NumberRule{"objective.reference.rms_jerk", [](const Scene& s) { return s.objective.reference.rms_jerk; },
               Range::above(0.0)},
    NumberRule{"limits.velocity", [](const Scene& s) { return normalised(s.limits.velocity); },
               Range::above(0.0)},
    NumberRule{"limits.acceleration", [](const Scene& s) { return normalised(s.limits.acceleration); },
               Range::above(0.0)},
    NumberRule{"limits.jerk", [](const Scene& s) { return normalised(s.limits.jerk); }, Range::above(0.0)},
    NumberRule{"solver.tolerance", [](const Scene& s) { return std::optional(s.solver.tolerance); },
               Range::between(1e-12, 1e-2)},
    NumberRule{"solver.gap", [](const Scene& s) { return std::optional(s.solver.gap); },
               Range::between(1e-12, 1e-2)},
    NumberRule{"solver.max_seconds", [](const Scene& s) { return std::optional(s.solver.max_seconds); },
               Range::above(0.0)},
};

Fault number_fault(const Scene& scene) {
    for (const NumberRule& rule : number_rules) {
        const std::optional<double> value = rule.value(scene);
        if (value && !rule.range.contains(*value))
            return SceneFault{rule.member, fmt::format("{}", *value), rule.range.number_text()};
    }
    if (scene.solver.starts && *scene.solver.starts < 1)
        return SceneFault{"solver.starts", fmt::to_string(*scene.solver.starts),
                          Range::at_least(1).integer_text()};
    return std::nullopt;
}

Fault angle_fault(const MotionSpec& motion) {
    if (motion.type != MotionType::rr) {
        if (motion.return_angle)
            return SceneFault{"motion.return_angle",
                              fmt::format("a return in a motion of type \"{}\"", name_of(motion.type)),
                              "only in type \"RR\""};
        return std::nullopt;
    }
    const double total = motion.rise + motion.return_angle.value_or(motion.rise);
    if (!Range::above_up_to(0.0, full_turn).contains(total))
        return SceneFault{"motion.return_angle", fmt::format("{} rad for rise and return together", total),
                          fmt::format("at most a whole turn, {} rad", full_turn)};
    if (motion.symmetric && std::abs(motion.length() - 2.0) > same_place)
        return SceneFault{"motion.symmetric", "true with a return unlike the rise",
                          "false, or equal angles for rise and return"};
    return std::nullopt;
}

Fault via_fault(const MotionSpec& motion) {
    const Range inside = Range::between(0.0, motion.length());
    for (std::size_t i = 0; i < motion.via.size(); ++i) {
        const SetPoint& point = motion.via[i];
        const std::string member = fmt::format("motion.via[{}]", i);
        if (!inside.contains(point.at))
            return SceneFault{member + ".at", fmt::format("{}", point.at), inside.number_text()};
        for (std::size_t j = 0; j < i; ++j)
            if (std::abs(motion.via[j].at - point.at) <= same_place)
                return SceneFault{member + ".at", fmt::format("{}, the place of motion.via[{}]", point.at, j),
                                  "one point at a place"};
        if (!point.displacement && !point.velocity && !point.acceleration)
            return SceneFault{member, "no value", "at least one of displacement, velocity, acceleration"};
        for (const auto& [name, value] :
             {std::pair{"displacement", point.displacement}, std::pair{"velocity", point.velocity},
              std::pair{"acceleration", point.acceleration}})
            if (value && !std::isfinite(*value))
                return SceneFault{fmt::format("{}.{}", member, name), fmt::format("{}", *value),
                                  Range{}.number_text()};
    }
    return std::nullopt;
}

Fault breakpoint_fault(const Scene& scene) {
    const std::vector<double>& points = scene.spline.breakpoints;
    if (points.empty()) return std::nullopt;
    const double length = scene.motion.length();
    const auto member = [](std::size_t i) { return fmt::format("spline.breakpoints[{}]", i); };
    if (points.size() < 2 || points.size() > 65537)
        return SceneFault{"spline.breakpoints", fmt::format("{} breakpoint(s)", points.size()), "2 to 65537"};
    if (!(std::abs(points.front()) <= same_place))
        return SceneFault{member(0), fmt::format("{}", points.front()), "0, the start of the motion"};
    for (std::size_t i = 1; i < points.size(); ++i)
        if (!(points[i] - points[i - 1] > same_place))
            return SceneFault{member(i), fmt::format("{} after {}", points[i], points[i - 1]),
                              "ascending breakpoints"};
    if (!(std::abs(points.back() - length) <= same_place))
        return SceneFault{member(points.size() - 1), fmt::format("{}", points.back()),
                          fmt::format("{}, the end of the motion", length)};
    if (!scene.motion.symmetric) return std::nullopt;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double mirrored = length - points[points.size() - 1 - i];
        if (std::abs(points[i] - mirrored) > same_place)
            return SceneFault{member(i), fmt::format("{} in a symmetric motion", points[i]),
                              fmt::format("{}, the mirror image of another breakpoint", mirrored)};
    }
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

Fault objective_fault(const ObjectiveSpec& objective) {
    const Reference& reference = objective.reference;
    const std::array terms = {
        std::tuple{"velocity", objective.velocity, reference.velocity},
        std::tuple{"acceleration", objective.acceleration, reference.acceleration},
        std::tuple{"jerk", objective.jerk, reference.jerk},
        std::tuple{"rms_acceleration", objective.rms_acceleration, reference.rms_acceleration},
        std::tuple{"rms_jerk", objective.rms_jerk, reference.rms_jerk},
    };
    if (std::ranges::none_of(terms, [](const auto& term) { return std::get<1>(term) > 0.0; }))
        return SceneFault{"objective", "no weight > 0",
                          "at least one of velocity, acceleration, jerk, rms_acceleration, rms_jerk > 0"};
    for (const auto& [name, weight, number] : terms)
        if (reference.numeric && weight > 0.0 && !number)
            return SceneFault{fmt::format("objective.reference.{}", name), "no number",
                              fmt::format("a number > 0, because objective.{} = {}", name, weight)};
    return std::nullopt;
}

Fault limit_fault(const Scene& scene) {
    for (const auto& [name, limit] :
         {std::pair{"velocity", &scene.limits.velocity},
          std::pair{"acceleration", &scene.limits.acceleration}, std::pair{"jerk", &scene.limits.jerk}})
        if (*limit && !(*limit)->unit.empty() && !scene.motion.speed)
            return SceneFault{fmt::format("limits.{}", name),
                              fmt::format("a limit in {} without a speed", (*limit)->unit),
                              "a limit in time only where motion.speed is given"};
    return std::nullopt;
}

}  // namespace

std::optional<SceneFault> find_fault(const Scene& scene) {
    if (Fault fault = number_fault(scene)) return fault;
    if (Fault fault = angle_fault(scene.motion)) return fault;
    if (Fault fault = via_fault(scene.motion)) return fault;
    if (Fault fault = spline_fault(scene.spline)) return fault;
    if (Fault fault = breakpoint_fault(scene)) return fault;
    if (Fault fault = objective_fault(scene.objective)) return fault;
    return limit_fault(scene);
}

void validate(const Scene& scene) {
    if (const Fault fault = find_fault(scene))
        throw InputError(
            fmt::format("{}: found {}; allowed: {}", fault->member, fault->found, fault->allowed));
}

}  // namespace camopt
