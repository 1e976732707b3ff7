// SPDX-License-Identifier: MIT
#include "core/errors.hpp"
#include "profiles/disk_cam.hpp"
#include "profiles/disk_cam_expansion.hpp"
#include "profiles/disk_cam_formulas.hpp"

#include <array>
#include <string>

namespace camopt {
namespace {

using enum DimensionIndex;
using expansion::acceleration_column, expansion::column_of, expansion::velocity_column;
using expansion::Expander, expansion::Local;

[[noreturn]] void refuse(FollowerType follower) {
    throw ModelError(std::string("quantity: a ") + name_of(follower) + " follower has no such quantity");
}

/// Slope of a linear quantity by the variable of that column.
struct Term {
    int column = 0;
    double slope = 0.0;
};

template <std::size_t count>
QuantityValue linear(double value, const std::array<Term, count>& terms) {
    QuantityValue result;
    result.value = value;
    result.gradient.setZero();
    result.hessian.setZero();
    for (const Term& term : terms) result.gradient(term.column) = term.slope;
    return result;
}

QuantityValue constant(double value) {
    return linear(value, std::array<Term, 0>{});
}

QuantityValue translating_roller_quantity(const DiskCam& cam, const FollowerState& state, Quantity which) {
    const double sense = formulas::sense_of(cam.rotation);
    const auto expand = [&](const auto& formula) {
        const std::array<Local, 4> locals = {{{velocity_column},
                                              {acceleration_column},
                                              {column_of(offset), sense},
                                              {column_of(roller_radius)}}};
        return Expander(cam, state).expand<formulas::TranslatingRoller>(locals, formula);
    };
    switch (which) {
        case Quantity::pressure_numerator:
            return linear(state.velocity - sense * cam[offset],
                          std::array<Term, 2>{{{velocity_column, 1.0}, {column_of(offset), -sense}}});
        case Quantity::pressure_denominator:
            return Expander(cam, state).position();
        case Quantity::pitch_curvature:
            return expand([](const auto& roller) { return roller.pitch().curvature(); });
        case Quantity::regularity:
            if (cam.follower == FollowerType::translating_knife) return constant(1.0);
            return expand([](const auto& roller) { return formulas::roller_regularity(roller); });
        case Quantity::normal_lever:
            return expand([](const auto& roller) { return roller.normal_lever(); });
        case Quantity::cam_radius:
        case Quantity::contact_offset:
            break;
    }
    refuse(cam.follower);
}

QuantityValue oscillating_roller_quantity(const DiskCam& cam, const FollowerState& state, Quantity which) {
    const auto expand = [&](const auto& formula) {
        const std::array<Local, 5> locals = {{{velocity_column, formulas::sense_of(cam.rotation)},
                                              {acceleration_column},
                                              {column_of(center_distance)},
                                              {column_of(arm_length)},
                                              {column_of(roller_radius)}}};
        return Expander(cam, state).expand<formulas::OscillatingRoller>(locals, formula);
    };
    switch (which) {
        case Quantity::pressure_numerator:
            return expand([](const auto& roller) { return roller.pressure_numerator(); });
        case Quantity::pressure_denominator:
            return expand([](const auto& roller) { return roller.pressure_denominator(); });
        case Quantity::pitch_curvature:
            return expand([](const auto& roller) { return roller.pitch().curvature(); });
        case Quantity::regularity:
            return expand([](const auto& roller) { return formulas::roller_regularity(roller); });
        case Quantity::normal_lever:
            return expand([](const auto& roller) { return roller.normal_lever(); });
        case Quantity::cam_radius:
        case Quantity::contact_offset:
            break;
    }
    refuse(cam.follower);
}

QuantityValue translating_flat_quantity(const DiskCam& cam, const FollowerState& state, Quantity which) {
    const double sense = formulas::sense_of(cam.rotation);
    switch (which) {
        case Quantity::pressure_numerator:
            return constant(0.0);
        case Quantity::pressure_denominator:
            return Expander(cam, state).position();
        case Quantity::cam_radius: {
            QuantityValue radius = Expander(cam, state).position();
            radius.value += state.acceleration;
            radius.gradient(acceleration_column) = 1.0;
            return radius;
        }
        case Quantity::regularity: {
            const std::array<Local, 3> locals = {
                {{velocity_column}, {acceleration_column}, {column_of(base_radius)}}};
            return Expander(cam, state).expand<formulas::TranslatingFlat>(locals, [](const auto& flat) {
                return flat.regularity();
            });
        }
        case Quantity::contact_offset:
            return linear(sense * state.velocity, std::array<Term, 1>{{{velocity_column, sense}}});
        case Quantity::normal_lever:
            return constant(1.0);
        case Quantity::pitch_curvature:
            break;
    }
    refuse(cam.follower);
}

QuantityValue oscillating_flat_quantity(const DiskCam& cam, const FollowerState& state, Quantity which) {
    const auto expand = [&](const auto& formula) {
        const std::array<Local, 5> locals = {{{velocity_column, formulas::sense_of(cam.rotation)},
                                              {acceleration_column},
                                              {column_of(center_distance)},
                                              {column_of(face_offset)},
                                              {column_of(base_radius)}}};
        return Expander(cam, state).expand<formulas::OscillatingFlat>(locals, formula);
    };
    switch (which) {
        case Quantity::pressure_numerator:
            return expand([](const auto& flat) { return flat.pressure_numerator(); });
        case Quantity::pressure_denominator:
            return expand([](const auto& flat) { return flat.pressure_denominator(); });
        case Quantity::cam_radius:
            return expand([](const auto& flat) { return flat.cam_radius(); });
        case Quantity::regularity:
            return expand([](const auto& flat) { return flat.regularity(); });
        case Quantity::contact_offset:
        case Quantity::normal_lever:
            return expand([](const auto& flat) { return flat.contact_offset(); });
        case Quantity::pitch_curvature:
            break;
    }
    refuse(cam.follower);
}

}  // namespace

QuantityValue quantity(const DiskCam& cam, const FollowerState& state, Quantity which) {
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
