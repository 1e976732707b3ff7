// SPDX-License-Identifier: MIT
#include "objectives/cam_limits.hpp"

#include "core/errors.hpp"
#include "core/units.hpp"
#include "objectives/quantity_algebra.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace camopt {

namespace {

using Rules = std::vector<std::shared_ptr<const CamRule>>;
using Shared = std::shared_ptr<const CamVariables>;
constexpr double right_angle = 0.5 * std::numbers::pi;
// A relative violation of a radius near zero says nothing: scales stay above this part of the cam.
constexpr double least_scale = 1e-3;
// A flat oscillating face turns back on itself where 1 + ψ' vanishes; it stays this far away.
constexpr double least_face_turn = 1e-3;

int column(DimensionIndex dimension) {
    return 3 + static_cast<int>(dimension);
}

double direction(const DiskCam& cam) {
    return cam.rotation == Rotation::counterclockwise ? 1.0 : -1.0;
}

bool is_flat(const DiskCam& cam) {
    return has_flat_face(cam.follower);
}

/// A length by which geometry is made dimensionless: the prime radius, or for an arm its pivot's distance.
double length_of(const DiskCam& cam) {
    if (is_oscillating(cam.follower)) return cam[DimensionIndex::center_distance];
    return cam[DimensionIndex::base_radius] + cam[DimensionIndex::roller_radius];
}

/// Displacement of the roller centre (translating) or the arm's angle at rest: what s is added to.
double start_of(const DiskCam& cam) {
    using enum DimensionIndex;
    const double prime = cam[base_radius] + cam[roller_radius];
    if (cam.follower == FollowerType::oscillating_roller) {
        const double a = cam[center_distance], l = cam[arm_length];
        return std::acos((a * a + l * l - prime * prime) / (2.0 * a * l));
    }
    if (cam.follower == FollowerType::oscillating_flat) {
        return std::asin((cam[base_radius] + cam[face_offset]) / cam[center_distance]);
    }
    return std::sqrt(prime * prime - cam[offset] * cam[offset]);
}

/// sign · N cos φm − D sin φm over L.
struct PressureSide {
    int sign = 1;
    WrittenLimit limit;
    bool at_rest = false;  ///< with s' = 0 put in
};

/// Translating, nothing variable but base and roller, no offset: N = s', D = base + roller + s.
bool pressure_is_linear(const CamVariables& cam) {
    if (is_oscillating(cam.cam.follower)) return false;
    return cam.variables.empty() ||
           (!cam.is_variable(DimensionIndex::offset) && cam.cam[DimensionIndex::offset] == 0.0);
}

QuantityValue linear_pressure(const DiskCam& cam, const FollowerState& state, const PressureSide& side,
                              double length) {
    using enum DimensionIndex;
    const double slope = side.sign * std::cos(side.limit.value) / length;
    const double height = std::sin(side.limit.value) / length;
    const double velocity = side.at_rest ? 0.0 : state.velocity;
    const double start = cam[offset] == 0.0 ? cam[base_radius] + cam[roller_radius] : start_of(cam);
    QuantityValue value =
        constant_quantity(slope * (velocity - direction(cam) * cam[offset]) - height * (start + state.s));
    value.gradient[0] = -height;
    if (!side.at_rest) value.gradient[1] = slope;
    value.gradient[column(base_radius)] = -height;
    if (has_roller(cam.follower)) value.gradient[column(roller_radius)] = -height;
    return value;
}

QuantityValue general_pressure(const DiskCam& cam, FollowerState state, const PressureSide& side,
                               double length) {
    if (side.at_rest) state.velocity = 0.0;
    QuantityValue numerator = quantity(cam, state, Quantity::pressure_numerator);
    QuantityValue denominator = quantity(cam, state, Quantity::pressure_denominator);
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

/// Where sign · N cos φm − D sin φm is convex in the motion (and, translating, in the dimensions):
/// MECHANISMS §5. For an oscillating roller it is l(1 + σψ') cos φm − a cos(ψ ∓ φm): convex where the cosine
/// is concave for the upper side, where it is convex for the lower one.
bool pressure_is_convex(const CamVariables& cam, const PressureSide& side, double least, double most) {
    if (!is_oscillating(cam.cam.follower)) return true;
    if (!cam.variables.empty() || !std::isfinite(least) || !std::isfinite(most)) return false;
    const double start = start_of(cam.cam);
    const double low = start + cam.scale.lift * least;
    const double high = start + cam.scale.lift * most;
    if (cam.cam.follower == FollowerType::oscillating_flat) return low >= -right_angle && high <= right_angle;
    const double limit = side.limit.value;
    if (side.sign > 0) return low >= limit - right_angle && high <= limit + right_angle;
    return low >= right_angle - limit && high <= 3.0 * right_angle - limit;
}

/// sign · N cos φm <= D sin φm bounds the arm's velocity whatever its angle: σψ' <= a/(l cos φm) − 1 for the
/// upper side of a roller, >= −a/(l cos φm) − 1 for the lower one; f(1 + σψ') <= a tan φm for a face.
SlopeRange pressure_slopes(const DiskCam& cam, const PressureSide& side) {
    using enum DimensionIndex;
    if (!is_oscillating(cam.follower) || side.at_rest) return {};
    const bool roller = cam.follower == FollowerType::oscillating_roller;
    const double lever = roller ? cam[arm_length] : std::abs(cam[face_offset]);
    if (lever == 0.0) return {};
    const double reach = cam[center_distance] / lever *
                         (roller ? 1.0 / std::cos(side.limit.value) : std::tan(side.limit.value));
    // With the face on the other side of the arm the sides change places.
    const bool upper = (side.sign > 0) == (roller || cam[face_offset] > 0.0);
    const SlopeRange turned = upper ? SlopeRange{-infinity, reach - 1.0} : SlopeRange{-reach - 1.0, infinity};
    return direction(cam) > 0.0 ? turned : SlopeRange{-turned.most, -turned.least};
}

void add_pressure_side(Rules& rules, const Shared& cam, const PressureSide& side) {
    const double length = length_of(cam->cam);
    const bool linear = pressure_is_linear(*cam);
    CamFormula formula;
    formula.name = side.limit.key;
    formula.linear = linear;
    formula.highest_order = side.at_rest ? 0 : 1;
    formula.scale = side.limit.value;
    formula.value = [side, length, linear](const DiskCam& own, const FollowerState& state) {
        return linear ? linear_pressure(own, state, side, length)
                      : general_pressure(own, state, side, length);
    };
    formula.convex = [cam, side](double least, double most) {
        return pressure_is_convex(*cam, side, least, most);
    };
    formula.slope = pressure_slopes(cam->cam, side);
    rules.push_back(std::make_shared<CamRule>(cam, std::move(formula)));
}

void add_pressure(Rules& rules, const Scene& scene, const Shared& cam) {
    const PressureLimits limits = pressure_limits(scene.limits);
    if (!limits.stricter() || cam->cam.follower == FollowerType::translating_flat) return;
    // The upper side of tan φ = N/D belongs to the rise; an arm's rise turns the cam's way clockwise.
    const bool turned = is_oscillating(cam->cam.follower) && direction(cam->cam) < 0.0;
    const auto& upper = turned ? limits.back : limits.rise;
    const auto& lower = turned ? limits.rise : limits.back;
    if (upper) add_pressure_side(rules, cam, {1, *upper, false});
    if (lower) add_pressure_side(rules, cam, {-1, *lower, false});
    const bool alike = upper && lower && upper->value == lower->value;
    const bool leans = is_oscillating(cam->cam.follower) || cam->cam[DimensionIndex::offset] != 0.0 ||
                       cam->is_variable(DimensionIndex::offset);
    if (alike || !leans) return;
    for (const int sign : {1, -1}) add_pressure_side(rules, cam, {sign, *limits.stricter(), true});
}

void add_roller_radii(Rules& rules, const Scene& scene, const Shared& cam) {
    const bool roller = has_roller(cam->cam.follower);
    const auto radius_of = [roller](const DiskCam& own) {
        const double radius = roller ? own[DimensionIndex::roller_radius] : 0.0;
        return roller ? variable_quantity(radius, column(DimensionIndex::roller_radius))
                      : constant_quantity(0.0);
    };
    const double nominal = roller ? cam->cam[DimensionIndex::roller_radius] : 0.0;
    if (const auto& limit = scene.limits.cam_radius_min; limit && (roller || limit->value > 0.0)) {
        const double least = limit->value;
        const double scale = least > 0.0 ? std::max(least_scale, least / (nominal + least)) : 1.0;
        rules.push_back(std::make_shared<CamRule>(
            cam, CamFormula{limit->key,
                            [radius_of, least](const DiskCam& own, const FollowerState& state) {
                                return shifted(product(shifted(radius_of(own), least),
                                                       quantity(own, state, Quantity::pitch_curvature)),
                                               -1.0);
                            },
                            2,
                            false,
                            scale,
                            {}}));
    }
    const auto& concave = scene.limits.concave_radius_min;
    const bool may_bite =
        concave && (cam->is_variable(DimensionIndex::roller_radius) || concave->value > nominal);
    if (may_bite) {
        const double least = concave->value;
        const double scale = std::clamp(least / std::max(least - nominal, least_scale * least), 1.0, 1e3);
        rules.push_back(std::make_shared<CamRule>(
            cam, CamFormula{concave->key,
                            [radius_of, least](const DiskCam& own, const FollowerState& state) {
                                return shifted(product(shifted(radius_of(own), -least),
                                                       quantity(own, state, Quantity::pitch_curvature)),
                                               -1.0);
                            },
                            2,
                            false,
                            scale,
                            {}}));
    }
}

void add_flat_radius(Rules& rules, const Scene& scene, const Shared& cam) {
    const auto& limit = scene.limits.cam_radius_min;
    if (!limit) return;
    const double base = cam->cam[DimensionIndex::base_radius];
    const double least = limit->value;
    const bool translating = cam->cam.follower == FollowerType::translating_flat;
    const double scale = least > 0.0 ? std::max(least_scale, least / base) : 1.0;
    rules.push_back(std::make_shared<CamRule>(
        cam, CamFormula{limit->key,
                        [base, least](const DiskCam& own, const FollowerState& state) {
                            return scaled(shifted(quantity(own, state, Quantity::cam_radius), -least),
                                          -1.0 / base);
                        },
                        2,
                        translating,
                        scale,
                        {}}));
    if (translating) return;
    rules.push_back(std::make_shared<CamRule>(
        cam, CamFormula{limit->key + " (face turns back)",
                        [](const DiskCam& own, const FollowerState& state) {
                            const double sign = direction(own);
                            return shifted(scaled(variable_quantity(state.velocity, 1), -sign),
                                           least_face_turn - 1.0);
                        },
                        1,
                        true,
                        1.0,
                        {}}));
}

void add_margin(Rules& rules, const Scene& scene, const Shared& cam) {
    const auto& limit = scene.limits.undercut_margin;
    if (!limit || cam->cam.follower == FollowerType::translating_knife) return;
    // Flat and translating: (base + s + s'')/base >= margin times base is linear in the base radius too.
    if (cam->cam.follower == FollowerType::translating_flat) {
        const double base = cam->cam[DimensionIndex::base_radius];
        rules.push_back(std::make_shared<CamRule>(
            cam, CamFormula{limit->key,
                            [base, margin = limit->value](const DiskCam& own, const FollowerState& state) {
                                const QuantityValue own_base = variable_quantity(
                                    own[DimensionIndex::base_radius], column(DimensionIndex::base_radius));
                                return sum(margin / base, own_base, -1.0 / base,
                                           quantity(own, state, Quantity::cam_radius));
                            },
                            2,
                            true,
                            1.0,
                            {}}));
        return;
    }
    rules.push_back(std::make_shared<CamRule>(
        cam, CamFormula{limit->key,
                        [margin = limit->value](const DiskCam& own, const FollowerState& state) {
                            return shifted(scaled(quantity(own, state, Quantity::regularity), -1.0), margin);
                        },
                        2,
                        false,
                        1.0,
                        {}}));
}

void add_face_width(Rules& rules, const Scene& scene, const Shared& cam) {
    if (!scene.cam->face_half_width) return;
    const double width = *scene.cam->face_half_width;
    for (const int sign : {1, -1}) {
        rules.push_back(std::make_shared<CamRule>(
            cam, CamFormula{"cam.face_half_width",
                            [sign, width](const DiskCam&, const FollowerState& state) {
                                return shifted(scaled(variable_quantity(state.velocity, 1), sign / width),
                                               -1.0);
                            },
                            1,
                            true,
                            1.0,
                            {}}));
    }
}

/// F = m ω² s'' + k s + F_0 (or the moment of an arm).
QuantityValue force_of(const ForceSpec& force, double speed, const FollowerState& state) {
    const double inertia = force.mass * speed * speed;
    QuantityValue value =
        constant_quantity(inertia * state.acceleration + force.spring_rate * state.s + force.preload);
    value.gradient[0] = force.spring_rate;
    value.gradient[2] = inertia;
    return value;
}

void add_forces(Rules& rules, const Scene& scene, const Shared& cam) {
    if (!scene.forces || !scene.motion.speed) return;
    const ForceSpec force = *scene.forces;
    const double speed = *scene.motion.speed;
    const LimitSpec& limits = scene.limits;
    if (const auto& least = limits.contact_force_min) {
        const double swing =
            force.mass * speed * speed * cam->scale.lift / (cam->scale.unit_angle * cam->scale.unit_angle);
        const double unit = std::max({std::abs(least->value), force.preload, swing, least_scale});
        rules.push_back(std::make_shared<CamRule>(
            cam, CamFormula{
                     least->key,
                     [force, speed, unit, least = least->value](const DiskCam&, const FollowerState& state) {
                         return scaled(shifted(force_of(force, speed, state), -least), -1.0 / unit);
                     },
                     2,
                     true,
                     1.0,
                     {}}));
    }
    if (const auto& most = limits.torque_max) {
        for (const int sign : {1, -1}) {
            rules.push_back(std::make_shared<CamRule>(
                cam, CamFormula{most->key,
                                [force, speed, sign, most = most->value](const DiskCam&,
                                                                         const FollowerState& state) {
                                    return shifted(scaled(product(force_of(force, speed, state),
                                                                  variable_quantity(state.velocity, 1)),
                                                          sign / most),
                                                   -1.0);
                                },
                                2,
                                false,
                                1.0,
                                {}}));
        }
    }
    if (const auto& most = limits.hertz_pressure_max) {
        if (cam->cam.follower == FollowerType::translating_knife) {
            throw InputError(most->key +
                             ": found a limit on the Hertz pressure of a knife edge; allowed: a roller "
                             "or a flat face");
        }
        if (!force.contact_width) {
            throw InputError(most->key +
                             ": found no contact width; allowed: together with forces.contact_width_mm");
        }
        const double compliance =
            (1.0 - force.cam_poisson * force.cam_poisson) / force.cam_modulus +
            (1.0 - force.follower_poisson * force.follower_poisson) / force.follower_modulus;
        const double factor =
            1.0 / (compliance * std::numbers::pi * *force.contact_width * most->value * most->value);
        rules.push_back(std::make_shared<CamRule>(
            cam, CamFormula{
                     most->key,
                     [force, speed, factor](const DiskCam& own, const FollowerState& state) {
                         // 1/ρ_cam + 1/r = 1/(r · regularity) for a roller.
                         const bool roller = has_roller(own.follower);
                         QuantityValue radius =
                             quantity(own, state, roller ? Quantity::regularity : Quantity::cam_radius);
                         if (roller) {
                             radius =
                                 product(radius, variable_quantity(own[DimensionIndex::roller_radius],
                                                                   column(DimensionIndex::roller_radius)));
                         }
                         const QuantityValue lever = quantity(own, state, Quantity::normal_lever);
                         return shifted(
                             scaled(quotient(force_of(force, speed, state), product(radius, lever)), factor),
                             -1.0);
                     },
                     2,
                     false,
                     2.0,
                     {}}));  // a pressure grows with the root of the force
    }
}

}  // namespace

PressureLimits pressure_limits(const LimitSpec& limits) {
    const auto either = [&](const std::optional<WrittenLimit>& own) {
        return own ? own : limits.pressure_angle;
    };
    return {either(limits.rise_pressure_angle), either(limits.return_pressure_angle)};
}

std::optional<WrittenLimit> PressureLimits::stricter() const {
    if (!rise || !back) return rise ? rise : back;
    return rise->value <= back->value ? rise : back;
}

Rules cam_limits(const Scene& scene, const Shared& cam) {
    Rules rules;
    add_pressure(rules, scene, cam);
    if (is_flat(cam->cam)) {
        add_flat_radius(rules, scene, cam);
    } else {
        add_roller_radii(rules, scene, cam);
    }
    add_margin(rules, scene, cam);
    add_face_width(rules, scene, cam);
    add_forces(rules, scene, cam);
    return rules;
}

}  // namespace camopt
