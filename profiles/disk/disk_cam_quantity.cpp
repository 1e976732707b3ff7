// SPDX-License-Identifier: MIT
#include "profiles/disk/disk_cam.hpp"
#include "profiles/disk/disk_cam_expansion.hpp"
#include "profiles/disk/disk_cam_formulas.hpp"
#include "profiles/disk/disk_sides.hpp"
#include "profiles/disk/quantity_algebra.hpp"

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

/// 1 - R times curvature, R the distance of the surface from the roller's centre.
QuantityValue roller_regularity(const QuantityValue& pitch_curvature, double radius) {
    const QuantityValue roller = variable_quantity(radius, column_of(roller_radius));
    return shifted(scaled(product(roller, pitch_curvature), -1.0), 1.0);
}

/// A radius as a share of the base radius.
QuantityValue flat_regularity(const QuantityValue& radius, double base) {
    return quotient(radius, variable_quantity(base, column_of(base_radius)));
}

constexpr auto curvature = [](const auto& roller) { return roller.pitch().curvature(); };

/// What a translating and an oscillating roller (or knife) have alike; `expand` gives a formula its partials.
QuantityValue roller_quantity(const DiskCam& cam, MechanismQuantity which, const auto& expand) {
    switch (which) {
        case MechanismQuantity::pressure_numerator:
            return expand([](const auto& roller) { return roller.pressure_numerator(); });
        case MechanismQuantity::pressure_denominator:
            return expand([](const auto& roller) { return roller.pressure_denominator(); });
        case MechanismQuantity::pitch_curvature:
            return expand(curvature);
        case MechanismQuantity::regularity:
            if (cam.follower == FollowerType::translating_knife) return constant_quantity(1.0);
            return roller_regularity(expand(curvature), surface_offset(cam, 0));
        case MechanismQuantity::normal_lever:
            return expand([](const auto& roller) { return roller.normal_lever(); });
        case MechanismQuantity::cam_radius:
        case MechanismQuantity::contact_offset:
            break;
    }
    refuse_quantity(name_of(cam.follower));
}

QuantityValue translating_roller_quantity(const DiskCam& cam, const FollowerState& state, MechanismQuantity which) {
    const double sense = sense_of(cam.rotation);
    const auto expand = [&](const auto& formula) {
        const std::array<Local, 3> locals = {
            {{velocity_column}, {acceleration_column}, {column_of(offset), sense}}};
        return Expander(cam, state).expand<formulas::TranslatingRoller>(locals, formula);
    };
    // Linear in the motion: exact, and cheaper than the expansion.
    if (which == MechanismQuantity::pressure_numerator)
        return linear(state.velocity - sense * cam[offset],
                      std::array<Term, 2>{{{velocity_column, 1.0}, {column_of(offset), -sense}}});
    if (which == MechanismQuantity::pressure_denominator) return Expander(cam, state).position();
    return roller_quantity(cam, which, expand);
}

QuantityValue oscillating_roller_quantity(const DiskCam& cam, const FollowerState& state, MechanismQuantity which) {
    const auto expand = [&](const auto& formula) {
        const std::array<Local, 4> locals = {{{velocity_column, sense_of(cam.rotation)},
                                              {acceleration_column},
                                              {column_of(center_distance)},
                                              {column_of(arm_length)}}};
        return Expander(cam, state).expand<formulas::OscillatingRoller>(locals, formula);
    };
    return roller_quantity(cam, which, expand);
}

QuantityValue translating_flat_radius(const DiskCam& cam, const FollowerState& state) {
    return linear(cam[base_radius] + state.s + state.acceleration,
                  std::array<Term, 3>{{{0, 1.0}, {acceleration_column, 1.0}, {column_of(base_radius), 1.0}}});
}

QuantityValue translating_flat_quantity(const DiskCam& cam, const FollowerState& state, MechanismQuantity which) {
    const double sense = sense_of(cam.rotation);
    switch (which) {
        case MechanismQuantity::pressure_numerator:
            return constant_quantity(0.0);
        case MechanismQuantity::pressure_denominator:
            return linear(cam[base_radius] + state.s,
                          std::array<Term, 2>{{{0, 1.0}, {column_of(base_radius), 1.0}}});
        case MechanismQuantity::cam_radius:
            return translating_flat_radius(cam, state);
        case MechanismQuantity::regularity:
            return flat_regularity(translating_flat_radius(cam, state), cam[base_radius]);
        case MechanismQuantity::contact_offset:
            return linear(sense * state.velocity, std::array<Term, 1>{{{velocity_column, sense}}});
        case MechanismQuantity::normal_lever:
            return constant_quantity(1.0);
        case MechanismQuantity::pitch_curvature:
            break;
    }
    refuse_quantity(name_of(cam.follower));
}

QuantityValue oscillating_flat_quantity(const DiskCam& cam, const FollowerState& state, MechanismQuantity which) {
    const auto expand = [&](const auto& formula) {
        const std::array<Local, 4> locals = {{{velocity_column, sense_of(cam.rotation)},
                                              {acceleration_column},
                                              {column_of(center_distance)},
                                              {column_of(face_offset)}}};
        return Expander(cam, state).expand<formulas::OscillatingFlat>(locals, formula);
    };
    switch (which) {
        case MechanismQuantity::pressure_numerator:
            return expand([](const auto& flat) { return flat.pressure_numerator(); });
        case MechanismQuantity::pressure_denominator:
            return expand([](const auto& flat) { return flat.pressure_denominator(); });
        case MechanismQuantity::cam_radius:
            return expand([](const auto& flat) { return flat.cam_radius(); });
        case MechanismQuantity::regularity:
            return flat_regularity(expand([](const auto& flat) { return flat.turned_radius(); }),
                                   cam[base_radius]);
        case MechanismQuantity::contact_offset:
        case MechanismQuantity::normal_lever:
            return expand([](const auto& flat) { return flat.contact_offset(); });
        case MechanismQuantity::pitch_curvature:
            break;
    }
    refuse_quantity(name_of(cam.follower));
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
            return oscillating_roller_quantity(cam, state, which);
        case FollowerType::oscillating_flat:
            break;
    }
    return oscillating_flat_quantity(cam, state, which);
}

}  // namespace camopt
