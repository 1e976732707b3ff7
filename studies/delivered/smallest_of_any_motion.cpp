// SPDX-License-Identifier: MIT
#include "studies/delivered/smallest_of_any_motion.hpp"

#include "motions/bounds/any_curve_limit.hpp"
#include "motions/bounds/smallest_cam.hpp"
#include "objectives/rules/cam_limits.hpp"
#include "objectives/scene_model.hpp"
#include "scene/cost_table.hpp"

namespace camopt {

namespace {

// A limit this close to what some motion could keep, relative, is not called impossible.
constexpr double clearly_below = 1e-9;

/// Between two given displacements.
struct GivenStroke {
    double begin = 0.0, end = 0.0;  ///< x
    double low = 0.0, high = 0.0;   ///< displacements, in lifts
    bool rises = true;
    bool rests_low = true;  ///< it passes through s' = 0 at its lower end
};

std::vector<GivenStroke> strokes_of_program(const MotionSpec& motion) {
    std::vector<GivenStroke> strokes;
    std::optional<double> at = 0.0;
    double begin = 0.0;
    for (const ProgramSegment& segment : motion.segments) {
        const double end = begin + segment.angle / motion.unit_angle();
        const std::optional<double> to = segment.kind == SegmentKind::dwell ? at : segment.to;
        if (at && to && *at != *to)
            strokes.push_back({begin, end, std::min(*at, *to), std::max(*at, *to), *to > *at, false});
        at = to;
        begin = end;
    }
    return strokes;
}

std::vector<GivenStroke> given_strokes_of(const MotionSpec& motion) {
    if (motion.type == MotionType::program) return strokes_of_program(motion);
    std::vector<GivenStroke> strokes = {{0.0, 1.0, 0.0, 1.0, true, true}};
    if (motion.type == MotionType::rr) strokes.push_back({1.0, motion.length(), 0.0, 1.0, false, true});
    return strokes;
}

/// The least s0 of one stroke, m. With the offset of the scene as it counts for that sense of rotation.
double least_coordinate(const Scene& scene, const GivenStroke& given, double offset, double pressure_angle) {
    const double lift = scene.motion.lift;
    const CamStroke stroke{(given.high - given.low) * lift, offset,
                           given.rises ? Stroke::rise : Stroke::return_stroke};
    const double angle = (given.end - given.begin) * scene.motion.unit_angle();
    if (given.rests_low) return smallest_cam(stroke, angle, pressure_angle).prime_coordinate;
    double least = least_stroke_coordinate(stroke, angle, pressure_angle) - given.low * lift;
    // A closed motion rests where it is lowest, at 0 or below.
    if (scene.motion.closed) least = std::max(least, std::abs(offset) / std::tan(pressure_angle));
    return std::max(least, 0.0);
}

/// None where the pressure angle has another formula (DirectCam).
std::optional<double> pushed_offset(const DrivenMechanism& cam) {
    const DirectCam* const direct = cam.formulas->direct();
    return direct == nullptr ? std::nullopt : direct->pushed_offset(cam.dimensions);
}

/// What each stroke asks for; those without a limit are left out.
std::vector<SmallestCamReport> smallest_of_strokes(const Scene& scene, const DrivenMechanism& cam) {
    std::vector<SmallestCamReport> all;
    const std::optional<double> offset = pushed_offset(cam);
    if (!offset) return all;
    const PressureLimits limits = pressure_limits(scene.limits);
    const double prime_radius = cam.formulas->length(cam.dimensions);
    for (const GivenStroke& stroke : given_strokes_of(scene.motion)) {
        const std::optional<WrittenLimit>& limit = stroke.rises ? limits.rise : limits.back;
        if (!limit) continue;
        const double coordinate = least_coordinate(scene, stroke, *offset, limit->value);
        all.push_back({std::hypot(coordinate, *offset), prime_radius, limit->value, stroke.rises,
                       stroke.begin, stroke.end, limit->key});
    }
    return all;
}

/// The largest cam within the ranges; none where the offset is free: its best value is another question.
std::optional<DrivenMechanism> largest_cam(const Scene& scene) {
    const std::optional<CamSpec>& spec = scene.cam;
    if (!spec) return {};
    const auto formulas = spec->formulas();
    std::vector<double> low, high;
    for (const CamDimension& dimension : spec->dimensions) {
        low.push_back(dimension.value.low);
        high.push_back(dimension.value.high);
    }
    const bool offset_is_free = pushed_offset({formulas, low}) != pushed_offset({formulas, high});
    if (offset_is_free) return {};
    return DrivenMechanism{formulas, std::move(high)};
}

/// An input that asks for the least of nothing but what is set afterwards.
AnyCurveLimitInput input_of(const MotionSpec& motion) {
    AnyCurveLimitInput input;
    input.type = motion.type;
    input.length = motion.length();
    return input;
}

/// DRD and RR, the motions whose bound is known.
bool goes_from_rest_to_rest(const MotionSpec& motion) {
    constexpr std::array<double, 2> rest{};
    return motion.type != MotionType::program && end_velocities(motion, false) == rest &&
           end_velocities(motion, true) == rest;
}

void add_caps(std::vector<std::string>& keys, const Scene& scene) {
    struct Cap {
        const std::optional<PeakLimit>& limit;
        double AnyCurveLimitInput::*weight;
    };
    const LimitSpec& limits = scene.limits;
    for (const Cap& cap : {Cap{limits.velocity, &AnyCurveLimitInput::velocity_weight},
                           Cap{limits.acceleration, &AnyCurveLimitInput::acceleration_weight},
                           Cap{limits.jerk, &AnyCurveLimitInput::jerk_weight}}) {
        if (!cap.limit) continue;
        AnyCurveLimitInput input = input_of(scene.motion);
        input.*cap.weight = 1.0;
        const double least = any_curve_limit(input).objective;
        if (cap.limit->normalised < least * (1.0 - clearly_below)) keys.push_back(cap.limit->key);
    }
}

std::optional<AnyCurveLimit> any_curve_limit_of(const Scene& scene, const Peaks& reference) {
    const ObjectiveSpec& objective = scene.objective;
    // The limit knows the peaks of one rise (and return) only; a term beside them would make it a bound that
    // nothing approaches.
    if (!goes_from_rest_to_rest(scene.motion)) return {};
    for (const ResponseTerm& term : response_terms())
        if (term.weight_in(objective) > 0.0) return {};
    for (const CostTerm& term : cost_terms())
        if (term.kind != CostTerm::Kind::peak && term.weight_in(objective) > 0.0) return {};
    if (!scene.own_terms.empty()) return {};
    if (std::ranges::any_of(objective.dimensions, [](double weight) { return weight > 0.0; })) return {};
    const auto over = [](double weight, double peak) { return weight > 0.0 ? weight / peak : 0.0; };
    const auto cap = [](const std::optional<PeakLimit>& limit) {
        return limit ? std::optional(limit->normalised) : std::nullopt;
    };
    AnyCurveLimit limit = any_curve_limit(
        {scene.motion.type, scene.motion.length(), over(objective.velocity, reference.velocity.value),
         over(objective.acceleration, reference.acceleration.value),
         over(objective.jerk, reference.jerk.value), cap(scene.limits.velocity),
         cap(scene.limits.acceleration), cap(scene.limits.jerk)});
    if (limit.status == AnyCurveStatus::infeasible || limit.status == AnyCurveStatus::not_converged)
        return {};
    return limit;
}

}  // namespace

std::optional<SmallestCamReport> smallest_of_any_motion(const Scene& scene, const DrivenMechanism& cam) {
    if (scene.prescribes_output()) return {};  // its strokes are the output's
    const std::vector<SmallestCamReport> all = smallest_of_strokes(scene, cam);
    const auto largest = std::ranges::max_element(all, {}, &SmallestCamReport::prime_radius);
    if (largest == all.end()) return {};
    return *largest;
}

std::vector<std::string> kept_by_no_motion(const Scene& scene) {
    std::vector<std::string> keys;
    if (goes_from_rest_to_rest(scene.motion)) add_caps(keys, scene);
    const std::optional<DrivenMechanism> cam = largest_cam(scene);
    if (!cam) return keys;
    for (const SmallestCamReport& one : smallest_of_strokes(scene, *cam)) {
        const bool possible = one.given >= one.prime_radius * (1.0 - clearly_below);
        if (!possible && std::ranges::find(keys, one.key) == keys.end()) keys.push_back(one.key);
    }
    return keys;
}

std::optional<LimitCurve> limit_curve(const Scene& scene, const Peaks& reference) {
    const std::optional<AnyCurveLimit> limit = any_curve_limit_of(scene, reference);
    if (!limit) return {};
    return LimitCurve{limit->objective, limit->velocity, limit->acceleration, limit->jerk};
}

std::vector<double> limit_switches(const Scene& scene, const Peaks& reference) {
    std::optional<AnyCurveLimit> limit = any_curve_limit_of(scene, reference);
    return limit ? std::move(limit->breakpoints) : std::vector<double>{};
}

bool no_motion_keeps_all_caps(const Scene& scene) {
    if (!goes_from_rest_to_rest(scene.motion)) return false;
    const auto cap = [](const std::optional<PeakLimit>& limit) {
        return limit ? std::optional(limit->normalised * (1.0 + clearly_below)) : std::nullopt;
    };
    AnyCurveLimitInput input = input_of(scene.motion);
    input.velocity_weight = 1.0;
    input.velocity_cap = cap(scene.limits.velocity);
    input.acceleration_cap = cap(scene.limits.acceleration);
    input.jerk_cap = cap(scene.limits.jerk);
    return any_curve_limit(input).status == AnyCurveStatus::infeasible;
}

}  // namespace camopt
