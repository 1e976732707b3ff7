// SPDX-License-Identifier: MIT
// Pressure angle: tan φ = N/D as a limit on N and D, one side at a time.
#include "core/nlp.hpp"
#include "objectives/rules/cam_limit_parts.hpp"
#include "objectives/rules/cam_limits.hpp"
#include "objectives/rules/rest_places.hpp"
#include "profiles/disk/quantity_algebra.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace camopt {

namespace cam_limit_parts {

double length_of(const DiskCam& cam) {
    if (is_oscillating(cam.follower)) return cam[DimensionIndex::center_distance];
    return cam[DimensionIndex::base_radius] + cam[DimensionIndex::roller_radius];
}

namespace {

constexpr double right_angle = 0.5 * std::numbers::pi;

/// sign · N cos φm − D sin φm over L.
struct PressureSide {
    int sign = 1;
    WrittenLimit limit;
    bool at_rest = false;  ///< with s' = 0 put in
    int disk = 0;          ///< 1: the second one of a conjugate cam
};

/// Translating, nothing variable but base and roller, no offset: N = s', D = base + roller + s.
bool pressure_is_linear(const DiskVariables& cam) {
    if (is_oscillating(cam.cam.follower)) return false;
    return cam.variables.empty() ||
           (!cam.is_variable(DimensionIndex::offset) && cam.cam[DimensionIndex::offset] == 0.0);
}

/// On the second disk N = −s' + σ e2, D = D0 − start − s: the mirror turns the other way and moves by −s.
QuantityValue linear_pressure(const DiskCam& cam, const FollowerState& state, const PressureSide& side,
                              double length) {
    using enum DimensionIndex;
    const bool second = side.disk == 1;
    const double turned = second ? -1.0 : 1.0;
    const double slope = turned * side.sign * std::cos(side.limit.value) / length;
    const double height = turned * std::sin(side.limit.value) / length;
    const double velocity = side.at_rest ? 0.0 : state.velocity;
    const double start = cam[offset] == 0.0 ? cam[base_radius] + cam[roller_radius] : rest_position(cam);
    const double across = second ? cam.form.second_offset.value_or(cam[offset]) : cam[offset];
    const double beyond = second ? cam.form.roller_distance : 0.0;  // of the rollers, less what the first has
    QuantityValue value = constant_quantity(slope * (velocity - sense_of(cam.rotation) * across) -
                                            height * (start + state.s - beyond));
    value.gradient[0] = -height;
    if (!side.at_rest) value.gradient[1] = slope;
    value.gradient[column_of(base_radius)] = -height;
    if (has_roller(cam.follower)) value.gradient[column_of(roller_radius)] = -height;
    return value;
}

QuantityValue general_pressure(const DiskCam& cam, FollowerState state, const PressureSide& side,
                               double length) {
    if (side.at_rest) state.velocity = 0.0;
    QuantityValue numerator = quantity(cam, state, Quantity::pressure_numerator, side.disk);
    QuantityValue denominator = quantity(cam, state, Quantity::pressure_denominator, side.disk);
    if (side.at_rest) {
        for (QuantityValue* value : {&numerator, &denominator}) {
            value->gradient[1] = 0.0;
            value->hessian.row(1).setZero();
            value->hessian.col(1).setZero();
        }
    }
    return sum(side.sign * std::cos(side.limit.value) / length, numerator,
               -std::sin(side.limit.value) / length, denominator);
}

/// The same enclosed, along a stretch or over a box.
template <class State>
auto enclosed_pressure(const DiskCam& cam, State state, const PressureSide& side, double length) {
    if (side.at_rest) state.velocity = {};
    return sum(side.sign * std::cos(side.limit.value) / length,
               quantity(cam, state, Quantity::pressure_numerator, side.disk),
               -std::sin(side.limit.value) / length,
               quantity(cam, state, Quantity::pressure_denominator, side.disk));
}

/// Where sign · N cos φm − D sin φm is convex in the motion (and, translating, in the dimensions):
/// docs/theory/pressure_angle.md. For an oscillating roller it is l(1 + σψ') cos φm − a cos(ψ ∓ φm): convex
/// where the cosine is concave for the upper side, where it is convex for the lower one.
/// The second disk is the same in ψ2 = γ − ψ; translating it has +s0 where the first has −s0, which is
/// concave in the dimensions unless it is linear in them.
bool pressure_is_convex(const DiskVariables& cam, const PressureSide& side, double least, double most) {
    const bool second = side.disk == 1;
    if (!is_oscillating(cam.cam.follower)) return !second || pressure_is_linear(cam);
    if (!cam.variables.empty() || !std::isfinite(least) || !std::isfinite(most)) return false;
    const double start = second ? second_rest_position(cam.cam) : rest_position(cam.cam);
    const double low = start + cam.scale.lift * (second ? -most : least);
    const double high = start + cam.scale.lift * (second ? -least : most);
    if (has_turning_face(cam.cam.follower)) return low >= -right_angle && high <= right_angle;
    const double limit = side.limit.value;
    if (side.sign > 0) return low >= limit - right_angle && high <= limit + right_angle;
    return low >= right_angle - limit && high <= 3.0 * right_angle - limit;
}

/// sign · N cos φm <= D sin φm bounds the arm's velocity whatever its angle: σψ' <= a/(l cos φm) − 1 for the
/// upper side of a roller, >= −a/(l cos φm) − 1 for the lower one; f(1 + σψ') <= a tan φm for a face.
SlopeRange pressure_slopes(const DiskCam& whole, const PressureSide& side) {
    using enum DimensionIndex;
    if (!is_oscillating(whole.follower) || side.at_rest) return {};
    const bool second = side.disk == 1;
    const DiskCam cam = second ? second_disk(whole) : whole;
    const bool roller = has_roller(cam.follower);
    const double lever = roller ? cam[arm_length] : std::abs(cam[face_offset]);
    if (lever == 0.0) return {};
    const double reach = cam[center_distance] / lever *
                         (roller ? 1.0 / std::cos(side.limit.value) : std::tan(side.limit.value));
    // With the face on the other side of the arm the sides change places.
    const bool upper = (side.sign > 0) == (roller || cam[face_offset] > 0.0);
    const SlopeRange turned = upper ? SlopeRange{-infinity, reach - 1.0} : SlopeRange{-reach - 1.0, infinity};
    const bool as_seen = (sense_of(cam.rotation) > 0.0) != second;  // the second disk's ψ' is −ψ'
    return as_seen ? turned : SlopeRange{-turned.most, -turned.least};
}

void add_pressure_side(Rules& rules, const Shared& cam, const PressureSide& side,
                       std::vector<double> places = {}) {
    const double length = length_of(cam->cam);
    const bool linear = pressure_is_linear(*cam);
    CamFormula formula;
    formula.name = side.limit.key;
    formula.sign = side.sign;
    formula.linear = linear;
    formula.highest_order = side.at_rest ? 0 : 1;
    formula.scale = side.limit.value;
    formula.value = [side, length, linear](const DiskCam& own, const FollowerState& state) {
        return linear ? linear_pressure(own, state, side, length)
                      : general_pressure(own, state, side, length);
    };
    formula.range = [side, length](const DiskCam& own, const StateAlong& state) {
        return enclosed_pressure(own, state, side, length);
    };
    formula.over = [side, length](const DiskCam& own, const StateOver& state) {
        return enclosed_pressure(own, state, side, length);
    };
    formula.convex = [cam, side](double least, double most) {
        return pressure_is_convex(*cam, side, least, most);
    };
    formula.slope = pressure_slopes(cam->cam, side);
    formula.places = std::move(places);
    if (cam->cam.form.is_conjugate()) return add_on_side(rules, cam, std::move(formula), side.disk);
    rules.push_back(std::make_shared<CamRule>(cam, std::move(formula)));
}

/// The follower's contact may lie beside the line that it is pushed along.
bool leans(const DiskVariables& cam, int disk) {
    if (is_oscillating(cam.cam.follower)) return true;
    if (disk == 1 && cam.cam.form.second_offset) return *cam.cam.form.second_offset != 0.0;
    return cam.cam[DimensionIndex::offset] != 0.0 || cam.is_variable(DimensionIndex::offset);
}

void add_pressure_of_disk(Rules& rules, const Scene& scene, const Shared& cam, int disk) {
    const PressureLimits limits = pressure_limits(scene.limits);
    // The upper side of tan φ = N/D belongs to the rise; an arm's rise turns the cam's way clockwise. The
    // mirror of the second disk turns the other way, and it falls where the follower rises.
    const bool swings = is_oscillating(cam->cam.follower);
    const bool turned = swings ? sense_of(cam->cam.rotation) < 0.0 : disk == 1;
    const auto& upper = turned ? limits.back : limits.rise;
    const auto& lower = turned ? limits.rise : limits.back;
    if (upper) add_pressure_side(rules, cam, {1, *upper, false, disk});
    if (lower) add_pressure_side(rules, cam, {-1, *lower, false, disk});
    const bool alike = upper && lower && upper->value == lower->value;
    if (!leans(*cam, disk)) return;
    for (const int sign : {1, -1}) {
        if (!alike) add_pressure_side(rules, cam, {sign, *limits.stricter(), true, disk});
        if (limits.general_at_rest_alone())
            add_pressure_side(rules, cam, {sign, *limits.general, true, disk}, rest_places(scene));
    }
}

}  // namespace

void add_pressure(Rules& rules, const Scene& scene, const Shared& cam) {
    if (!pressure_limits(scene.limits).stricter() || has_pushed_face(cam->cam.follower)) return;
    // Both flanks of a groove have one normal.
    const int disks = cam->cam.form.is_conjugate() ? 2 : 1;
    for (int disk = 0; disk < disks; ++disk) add_pressure_of_disk(rules, scene, cam, disk);
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

std::optional<WrittenLimit> PressureLimits::at_rest() const {
    return general_at_rest_alone() ? general : stricter();
}

bool PressureLimits::general_at_rest_alone() const {
    return general && general->value < stricter()->value;
}

}  // namespace camopt
