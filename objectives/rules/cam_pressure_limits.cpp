// SPDX-License-Identifier: MIT
#include "motions/laws/law.hpp"
#include "objectives/laws/segment_law.hpp"
#include "objectives/rules/cam_limits.hpp"
#include "scene/motion/set_points.hpp"

namespace camopt {

namespace {

constexpr double at_rest = 1e-9;  // of a law's mean velocity: less is round-off

void add_program(std::vector<double>& places, const Scene& scene) {
    const MotionSpec& motion = scene.motion;
    const double unit = motion.unit_angle();
    double angle = 0.0;
    for (std::size_t i = 0; i < motion.segments.size(); ++i) {
        const ProgramSegment& segment = motion.segments[i];
        const double begin = angle / unit;
        angle += segment.angle;
        const double end = angle / unit;
        bool rests_first = segment.kind == SegmentKind::dwell, rests_last = rests_first;
        if (segment.kind == SegmentKind::law) {
            const auto law = segment_law(motion, i);
            rests_first = std::abs(law->at(law->begin(), Side::right).derivative[1]) < at_rest;
            rests_last = std::abs(law->at(law->end(), Side::left).derivative[1]) < at_rest;
        }
        const bool opens = i == 0 && !motion.periodic() && end_velocities(motion, false)[0] == 0.0;
        const bool closes =
            i + 1 == motion.segments.size() && !motion.periodic() && end_velocities(motion, true)[0] == 0.0;
        const bool spline = segment.kind == SegmentKind::spline;
        if (rests_first || (opens && spline)) places.push_back(begin);
        if (rests_last || (closes && spline)) places.push_back(end);
    }
}

}  // namespace

std::vector<double> rest_places(const Scene& scene) {
    const MotionSpec& motion = scene.motion;
    std::vector<double> places;
    if (motion.type == MotionType::program) {
        add_program(places, scene);
    } else {
        if (end_velocities(motion, false)[0] == 0.0) places.push_back(0.0);
        if (end_velocities(motion, true)[0] == 0.0) places.push_back(motion.length());
        if (motion.type == MotionType::rr) places.push_back(1.0);
    }
    for (const PlacedPoint& point : placed_points(motion))
        if (point.wanted[1] && *point.wanted[1] == 0.0) places.insert(places.end(), {point.begin, point.end});
    std::ranges::sort(places);
    places.erase(std::unique(places.begin(), places.end()), places.end());
    return places;
}

// Pressure angle: tan φ = N/D as a limit on N and D, one side at a time.

namespace cam_limit_parts {

namespace {

using enum MechanismQuantity;

/// sign · N cos φm − D sin φm over L, with the s' of rest put in: 0, or the error of a made cam.
MechanismValue excess_at_rest(CamCall call, const PressureSide& side, double length, double slope) {
    call.state.output.velocity = slope;
    MechanismValue value =
        1.0 / length * call.cam.pressure_excess(side.limit, side.sign, call.state, side.station, call.active);
    value.gradient[1] = 0.0;
    value.hessian.row(1).setZero();
    value.hessian.col(1).setZero();
    return value;
}

void add_side(Limits& limits, const WrittenLimit& limit, PressureSide side, bool at_rest,
              std::vector<double> places = {}) {
    side.limit = limit.value;
    const double length = limits.length(), slope = limits.variables().motion_error[1];
    CamFormula formula;
    formula.name = limit.key;
    formula.sign = side.sign;
    formula.highest_order = at_rest ? 0 : 1;
    formula.scale = limit.value;
    formula.places = std::move(places);
    formula.value = [=](const CamCall& call) {
        if (at_rest) return excess_at_rest(call, side, length, slope);
        return 1.0 / length *
               call.cam.pressure_excess(side.limit, side.sign, call.state, side.station, call.active);
    };
    formula.over = [=](const CamCallOver& call) -> std::optional<RangeOver> {
        const MechanismEnclosures* const known = call.cam.enclosures();
        if (known == nullptr) return {};
        if (!at_rest) return known->pressure_over(side.limit, side.sign, call.state, side.station);
        MechanismStateOver still = call.state;
        still.velocity = RangeOver(slope);
        return known->pressure_over(side.limit, side.sign, still, side.station);
    };
    formula.along = [=](const CamCallAlong& call) -> std::optional<RangeAlong> {
        const MechanismEnclosures* const known = call.cam.enclosures();
        if (known == nullptr) return {};
        MechanismStateAlong state = call.state;
        if (at_rest) state.velocity = RangeAlong(slope);
        const auto excess = known->pressure_along(side.limit, side.sign, state, side.station);
        if (!excess) return {};
        return 1.0 / length * *excess;
    };
    const auto shape = [cam = limits.variables().cam, active = limits.active(), side](double least,
                                                                                      double most) {
        return cam.formulas->limit_structure().pressure_shape(side, {cam.dimensions, active}, least, most);
    };
    formula.linear = shape(-infinity, infinity) == Curvature::linear;
    formula.shape = shape;
    if (!at_rest) formula.slopes = limits.structure().pressure_slopes(side, limits.dimensions());
    // Both flanks of a groove have one normal: one rule covers both.
    const int last = limits.cam().stations() - 1;
    if (limits.structure().binds(pressure_numerator, last))
        return limits.add_at(std::move(formula), side.station);
    if (last > 0) formula.fields.which["station"] = side.station;
    limits.add(std::move(formula));
}

}  // namespace

void add_pressure(Limits& limits) {
    const PressureLimits pressure = pressure_limits(limits.scene().limits);
    if (!pressure.stricter()) return;
    const LimitStructure& structure = limits.structure();
    for (int station = 0; station < limits.cam().stations(); ++station) {
        if (!structure.binds(pressure_numerator, station)) continue;
        // The upper side of tan φ = N/D belongs to the rise, or to the return.
        const bool rises = structure.upper_side_rises(station);
        const auto& upper = rises ? pressure.rise : pressure.back;
        const auto& lower = rises ? pressure.back : pressure.rise;
        if (upper) add_side(limits, *upper, {0.0, 1, station}, false);
        if (lower) add_side(limits, *lower, {0.0, -1, station}, false);
        const bool same = upper && lower && upper->value == lower->value;
        if (!structure.leans_at_rest(station, limits.setting())) continue;
        for (const int sign : {1, -1}) {
            if (!same) add_side(limits, *pressure.stricter(), {0.0, sign, station}, true);
            if (pressure.general_at_rest_alone())
                add_side(limits, *pressure.general, {0.0, sign, station}, true, rest_places(limits.scene()));
        }
    }
}

}  // namespace cam_limit_parts

PressureLimits pressure_limits(const LimitSpec& limits) {
    const auto either = [&](const std::optional<WrittenLimit>& own) {
        return own ? own : limits.pressure_angle;
    };
    return {either(limits.rise_pressure_angle), either(limits.return_pressure_angle), limits.pressure_angle};
}

std::optional<WrittenLimit> PressureLimits::stricter() const {
    if (!rise || !back) return rise ? rise : back;
    return rise->value <= back->value ? rise : back;
}

}  // namespace camopt
