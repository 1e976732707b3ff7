// SPDX-License-Identifier: MIT
#include "profiles/disk/disk_cam.hpp"
#include "profiles/disk/disk_cam_expansion.hpp"
#include "profiles/disk/disk_cam_formulas.hpp"
#include "profiles/disk/disk_sides.hpp"
#include "profiles/disk/quantity_algebra.hpp"
#include "profiles/disk/quantity_text.hpp"

#include <algorithm>
#include <array>

namespace camopt {
namespace {

using enum DimensionIndex;
using expansion::acceleration_column, expansion::velocity_column;
using expansion::Expander, expansion::Local;

/// Slope of a linear quantity by the variable of that column.
struct Term {
    int column = 0;
    double slope = 0.0;
};

template <std::size_t count>
QuantityValue linear(double value, const std::array<Term, count>& terms) {
    QuantityValue result = constant_quantity(value);
    for (const Term& term : terms) result.gradient(term.column) = term.slope;
    return result;
}

/// Of the arm: σψ', ψ'', and two of its dimensions.
std::array<Local, 4> arm_locals(const DiskCam& cam, DimensionIndex first, DimensionIndex second) {
    return {{{velocity_column, sense_of(cam.rotation)},
             {acceleration_column},
             {column_of(first)},
             {column_of(second)}}};
}

/// `locals` make the roller with its position. The regularity follows from the curvature: expanded in the
/// roller's radius too it would cost half as much again.
template <template <class> class Roller, std::size_t count>
QuantityValue roller_quantity(const DiskCam& cam, const FollowerState& state, MechanismQuantity which,
                              const std::array<Local, count>& locals) {
    const bool regular = which == MechanismQuantity::regularity && has_roller(cam.follower);
    const MechanismQuantity expanded = regular ? MechanismQuantity::pitch_curvature : which;
    QuantityValue found =
        Expander(cam, state).expand(locals, [&]<class T>(const T& position, const auto&... rest) {
            return formulas::quantity_of_roller<T>(cam.follower, Roller<T>{position, rest...}, T(0.0),
                                                   expanded);
        });
    if (!regular) return found;
    return formulas::regularity_of(variable_quantity(surface_offset(cam, 0), column_of(roller_radius)),
                                   found);
}

QuantityValue translating_roller_quantity(const DiskCam& cam, const FollowerState& state,
                                          MechanismQuantity which) {
    const double sense = sense_of(cam.rotation);
    // Linear in the motion: exact, and cheaper than the expansion.
    if (which == MechanismQuantity::pressure_numerator)
        return linear(state.velocity - sense * cam[offset],
                      std::array<Term, 2>{{{velocity_column, 1.0}, {column_of(offset), -sense}}});
    if (which == MechanismQuantity::pressure_denominator) return Expander(cam, state).position();
    const std::array<Local, 3> locals = {
        {{velocity_column}, {acceleration_column}, {column_of(offset), sense}}};
    return roller_quantity<formulas::TranslatingRoller>(cam, state, which, locals);
}

QuantityValue translating_flat_quantity(const DiskCam& cam, const FollowerState& state,
                                        MechanismQuantity which) {
    const std::array<Local, 3> locals = {
        {{velocity_column, sense_of(cam.rotation)}, {acceleration_column}, {column_of(base_radius)}}};
    return Expander(cam, state)
        .expand(locals,
                [&]<class T>(const T& height, const T& velocity, const T& acceleration, const T& base) {
                    return formulas::quantity_of_face<T>(base, height, velocity, acceleration, which);
                });
}

QuantityValue oscillating_flat_quantity(const DiskCam& cam, const FollowerState& state,
                                        MechanismQuantity which) {
    const Expander expander(cam, state);
    const auto locals = arm_locals(cam, center_distance, face_offset);
    if (which != MechanismQuantity::regularity)
        return expander.expand(locals, [&]<class T>(const T& position, const auto&... rest) {
            return formulas::quantity_of_face_arm<T>(T(1.0), {position, rest...}, which);
        });
    std::array<Local, 5> all;
    all[0] = {column_of(base_radius)};
    std::ranges::copy(locals, all.begin() + 1);
    return expander.expand(all, [&]<class T>(const T& position, const T& base, const auto&... rest) {
        return formulas::quantity_of_face_arm<T>(base, {position, rest...}, which);
    });
}

}  // namespace

QuantityValue quantity(const DiskCam& cam, const FollowerState& state, MechanismQuantity which) {
    switch (cam.follower) {
        case FollowerType::translating_roller:
        case FollowerType::translating_knife:
            return translating_roller_quantity(cam, state, which);
        case FollowerType::translating_flat:
            return translating_flat_quantity(cam, state, which);
        case FollowerType::oscillating_roller:
            return roller_quantity<formulas::OscillatingRoller>(cam, state, which,
                                                                arm_locals(cam, center_distance, arm_length));
        case FollowerType::oscillating_flat:
            return oscillating_flat_quantity(cam, state, which);
    }
    throw ModelError("quantity: a follower of no known type");
}

}  // namespace camopt
