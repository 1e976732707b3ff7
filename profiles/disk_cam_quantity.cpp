// SPDX-License-Identifier: MIT
// Quantities of a disk cam with their partials: the formulas expanded to second order in their own few
// variables by automatic differentiation, then carried over to (s, s', s'', dimensions) by the chain rule.
// The only nonlinear variable is the position, start(dimensions) + s, so few variables are differentiated
// twice.
#include "core/errors.hpp"
#include "profiles/disk_cam.hpp"
#include "profiles/disk_cam_formulas.hpp"

#include <Eigen/Core>
#include <unsupported/Eigen/AutoDiff>

#include <cmath>

namespace camopt {
namespace {

template <int n>
using FirstOrder = Eigen::AutoDiffScalar<Eigen::Matrix<double, n, 1>>;
template <int n>
using SecondOrder = Eigen::AutoDiffScalar<Eigen::Matrix<FirstOrder<n>, n, 1>>;
template <int n>
using Jacobian = Eigen::Matrix<double, n, quantity_variables>;

/// Value and partials in n local variables.
template <int n>
struct Expansion {
    double value = 0.0;
    Eigen::Matrix<double, n, 1> gradient;
    Eigen::Matrix<double, n, n> hessian;

    explicit Expansion(const SecondOrder<n>& result)
        : value(result.value().value()), gradient(result.value().derivatives()) {
        for (int i = 0; i < n; ++i) hessian.col(i) = result.derivatives()(i).derivatives();
    }
};

template <int n>
SecondOrder<n> variable(double value, int index) {
    SecondOrder<n> result;
    result.value() = FirstOrder<n>(value, n, index);
    for (int i = 0; i < n; ++i) result.derivatives()(i) = FirstOrder<n>(i == index ? 1.0 : 0.0);
    return result;
}

/// The expansion in local variables that depend linearly on the global ones.
template <int n>
QuantityValue substituted(const Expansion<n>& local, const Jacobian<n>& jacobian) {
    QuantityValue result;
    result.value = local.value;
    result.gradient.noalias() = jacobian.transpose() * local.gradient;
    const Jacobian<n> half = local.hessian * jacobian;
    result.hessian.noalias() = jacobian.transpose() * half;
    return result;
}

constexpr int position_of_state = 3;
constexpr int column_of(DimensionIndex index) {
    return position_of_state + static_cast<int>(index);
}

QuantityValue constant(double value) {
    QuantityValue result;
    result.value = value;
    result.gradient.setZero();
    result.hessian.setZero();
    return result;
}

/// A variable of the formulas: a global variable, perhaps mirrored.
struct Local {
    int column = 0;
    double sign = 1.0;
};

QuantityValue start_of(const DiskCam& cam) {
    using enum DimensionIndex;
    const double base = cam[base_radius];
    const bool with_roller = has_roller(cam.follower);
    const double prime = with_roller ? base + cam[roller_radius] : base;
    const auto expanded = [&](const SecondOrder<3>& start, DimensionIndex second, DimensionIndex third) {
        Jacobian<3> jacobian = Jacobian<3>::Zero();
        jacobian(0, column_of(base_radius)) = 1.0;
        if (with_roller) jacobian(0, column_of(roller_radius)) = 1.0;
        jacobian(1, column_of(second)) = 1.0;
        jacobian(2, column_of(third)) = 1.0;
        return substituted(Expansion<3>(start), jacobian);
    };
    const SecondOrder<3> first = variable<3>(prime, 0);
    switch (cam.follower) {
        case FollowerType::translating_flat: {
            QuantityValue result = constant(base);
            result.gradient(column_of(base_radius)) = 1.0;
            return result;
        }
        case FollowerType::oscillating_roller:
            return expanded(formulas::oscillating_roller_start(first, variable<3>(cam[center_distance], 1),
                                                               variable<3>(cam[arm_length], 2)),
                            center_distance, arm_length);
        case FollowerType::oscillating_flat:
            return expanded(formulas::oscillating_flat_start(first, variable<3>(cam[center_distance], 1),
                                                             variable<3>(cam[face_offset], 2)),
                            center_distance, face_offset);
        case FollowerType::translating_roller:
        case FollowerType::translating_knife:
            break;
    }
    return expanded(formulas::translating_roller_start(first, variable<3>(cam[offset], 1)), offset,
                    face_offset);
}

/// The formulas of one cam at one state, ready to be expanded.
class Expander {
 public:
    Expander(const DiskCam& cam, const FollowerState& state) : cam_(cam), position_(start_of(cam)) {
        values_ << state.s, state.velocity, state.acceleration,
            Eigen::Map<const Eigen::Matrix<double, dimension_count, 1>>(cam.dimensions.data());
        position_.value += state.s;
        position_.gradient(0) += 1.0;
    }

    [[nodiscard]] const QuantityValue& position() const { return position_; }

    /// `formula` takes n variables: the position, then those of `locals`.
    template <std::size_t count, class Formula>
    [[nodiscard]] QuantityValue expand(const std::array<Local, count>& locals, const Formula& formula) const {
        constexpr int n = static_cast<int>(count) + 1;
        std::array<SecondOrder<n>, count + 1> variables;
        Jacobian<n> jacobian = Jacobian<n>::Zero();
        variables[0] = variable<n>(position_.value, 0);
        jacobian.row(0) = position_.gradient.transpose();
        for (std::size_t i = 0; i < count; ++i) {
            const auto row = static_cast<int>(i) + 1;
            variables[i + 1] = variable<n>(locals[i].sign * values_(locals[i].column), row);
            jacobian(row, locals[i].column) = locals[i].sign;
        }
        const Expansion<n> local(formula(variables));
        QuantityValue result = substituted(local, jacobian);
        result.hessian += local.gradient(0) * position_.hessian;
        return result;
    }

    [[nodiscard]] double sense() const { return formulas::sense_of(cam_.rotation); }

 private:
    const DiskCam& cam_;
    QuantityValue position_;
    Eigen::Matrix<double, quantity_variables, 1> values_;
};

[[noreturn]] void refuse(FollowerType follower) {
    throw ModelError(std::string("quantity: a ") + name_of(follower) + " follower has no such quantity");
}

QuantityValue translating_roller_quantity(const DiskCam& cam, const FollowerState& state, Quantity which) {
    using enum DimensionIndex;
    const Expander expander(cam, state);
    const std::array<Local, 4> locals = {
        {{1}, {2}, {column_of(offset), expander.sense()}, {column_of(roller_radius)}}};
    const auto expand = [&](const auto& formula) {
        return expander.expand(locals, [&](const auto& v) {
            return formula(
                formulas::TranslatingRoller<std::decay_t<decltype(v[0])>>{v[0], v[1], v[2], v[3], v[4]});
        });
    };
    switch (which) {
        case Quantity::pressure_numerator: {
            QuantityValue result = constant(state.velocity - expander.sense() * cam[offset]);
            result.gradient(1) = 1.0;
            result.gradient(column_of(offset)) = -expander.sense();
            return result;
        }
        case Quantity::pressure_denominator:
            return expander.position();
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
    using enum DimensionIndex;
    const Expander expander(cam, state);
    const std::array<Local, 5> locals = {{{1, expander.sense()},
                                          {2},
                                          {column_of(center_distance)},
                                          {column_of(arm_length)},
                                          {column_of(roller_radius)}}};
    const auto expand = [&](const auto& formula) {
        return expander.expand(locals, [&](const auto& v) {
            return formula(formulas::OscillatingRoller<std::decay_t<decltype(v[0])>>{v[0], v[1], v[2], v[3],
                                                                                     v[4], v[5]});
        });
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
    using enum DimensionIndex;
    const Expander expander(cam, state);
    QuantityValue result = constant(0.0);
    switch (which) {
        case Quantity::pressure_numerator:
            return result;
        case Quantity::pressure_denominator:
            return expander.position();
        case Quantity::cam_radius:
            result = expander.position();
            result.value += state.acceleration;
            result.gradient(2) = 1.0;
            return result;
        case Quantity::regularity:
            return expander.expand(
                std::array<Local, 3>{{{1}, {2}, {column_of(base_radius)}}}, [](const auto& v) {
                    return formulas::TranslatingFlat<std::decay_t<decltype(v[0])>>{v[0], v[1], v[2], v[3]}
                        .regularity();
                });
        case Quantity::contact_offset:
            result.value = expander.sense() * state.velocity;
            result.gradient(1) = expander.sense();
            return result;
        case Quantity::normal_lever:
            return constant(1.0);
        case Quantity::pitch_curvature:
            break;
    }
    refuse(cam.follower);
}

QuantityValue oscillating_flat_quantity(const DiskCam& cam, const FollowerState& state, Quantity which) {
    using enum DimensionIndex;
    const Expander expander(cam, state);
    const std::array<Local, 5> locals = {{{1, expander.sense()},
                                          {2},
                                          {column_of(center_distance)},
                                          {column_of(face_offset)},
                                          {column_of(base_radius)}}};
    const auto expand = [&](const auto& formula) {
        return expander.expand(locals, [&](const auto& v) {
            return formula(
                formulas::OscillatingFlat<std::decay_t<decltype(v[0])>>{v[0], v[1], v[2], v[3], v[4], v[5]});
        });
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
