// SPDX-License-Identifier: MIT
// Quantities with exact partials by (s, s', s'', active dimensions): automatic differentiation, by two
// dimensions at a time, so that the number of variables of one pass is small and known at compile time.
#include "profiles/remote/remote_cam.hpp"
#include "profiles/remote/remote_formulas.hpp"

namespace camopt {
namespace {

constexpr int output_variables = 3;

/// The requested quantity, as a formula of a RemoteEvaluation and the roller's state.
struct QuantityFormula {
    MechanismQuantity which;

    template <class T>
    T operator()(const RemoteEvaluation<T>& own, const remote::RollerState<T>& roller) const {
        switch (which) {
            case MechanismQuantity::pressure_numerator:
                return own.numerator(roller);
            case MechanismQuantity::pressure_denominator:
                return own.denominator(roller);
            case MechanismQuantity::pitch_curvature:
                return roller.curvature();
            case MechanismQuantity::regularity:
                return own.regularity(roller);
            case MechanismQuantity::cam_radius:
            case MechanismQuantity::contact_offset:
            case MechanismQuantity::normal_lever:
            case MechanismQuantity::contact_radius:
                break;
        }
        refuse_quantity(remote_type);
    }
};

/// CamMechanism::pressure_excess, of one evaluation of the linkage.
struct PressureFormula {
    double cosine, sine;  ///< sign · cos φ, sin φ

    template <class T>
    T operator()(const RemoteEvaluation<T>& own, const remote::RollerState<T>& roller) const {
        return T(own.numerator(roller) * cosine) - T(own.denominator(roller) * sine);
    }
};

/// All dimensions as constants of n variables, but those in `by`, the variables from `first` on.
template <int n, std::size_t count>
std::array<SecondOrder<n>, remote_dimension_count> dimensions_of(const MechanismState& state,
                                                                 const std::array<int, count>& by,
                                                                 int first) {
    std::array<SecondOrder<n>, remote_dimension_count> dimensions;
    for (std::size_t i = 0; i < dimensions.size(); ++i) dimensions[i] = constant<n>(state.dimensions[i]);
    for (std::size_t k = 0; k < by.size(); ++k) {
        const auto which = static_cast<std::size_t>(by[k]);
        dimensions[which] = variable<n>(state.dimensions[which], first + static_cast<int>(k));
    }
    return dimensions;
}

/// By (s, dimensions) -> by (s, s', s'', dimensions).
template <int n>
SecondOrder<n> widened(const SecondOrder<n - 2>& narrow) {
    const auto place = [](std::size_t i) { return i == 0 ? 0 : i + 2; };
    SecondOrder<n> wide(narrow.value);
    for (std::size_t i = 0; i < narrow.variables; ++i) {
        wide.first[place(i)] = narrow.first[i];
        for (std::size_t j = 0; j <= i; ++j)
            wide.second[wide.pair(place(i), place(j))] = narrow.second[narrow.pair(i, j)];
    }
    return wide;
}

/// By the output and n − 3 dimensions. The linkage does not depend on s' and s'': it is evaluated without
/// them.
template <int n, class Formula>
SecondOrder<n> expanded(const RemoteLayout& layout, const MechanismState& state, const Formula& formula,
                        const std::array<int, n - output_variables>& by) {
    const std::array<double, 3> output = remote::numbers(state.output);
    const RemoteEvaluation<SecondOrder<n - 2>> narrow(layout, dimensions_of<n - 2>(state, by, 1));
    const remote::Turning<SecondOrder<n - 2>> arm = narrow.linkage.roller_arm(variable<n - 2>(output[0], 0));
    const RemoteEvaluation<SecondOrder<n>> own(layout, dimensions_of<n>(state, by, output_variables));
    return formula(
        own, own.roller({{widened<n>(arm.direction.x), widened<n>(arm.direction.y)},
                         widened<n>(arm.first),
                         widened<n>(arm.second)},
                        {variable<n>(output[0], 0), variable<n>(output[1], 1), variable<n>(output[2], 2)}));
}

/// Writes the partials of one pass into the rows and columns of its variables.
template <int n>
void put(const SecondOrder<n>& pass, const std::array<int, n>& columns, MechanismValue& result) {
    result.value = pass.value;
    for (std::size_t i = 0; i < pass.variables; ++i) {
        result.gradient(columns[i]) = pass.first[i];
        for (std::size_t j = 0; j < pass.variables; ++j)
            result.hessian(columns[i], columns[j]) = pass.second[pass.pair(i, j)];
    }
}

template <class Formula>
MechanismValue value_of(const RemoteLayout& layout, const MechanismState& state, std::span<const int> active,
                        const Formula& formula) {
    const int count = static_cast<int>(active.size()), size = output_variables + count;
    MechanismValue result{0.0, Eigen::VectorXd::Zero(size), Eigen::MatrixXd::Zero(size, size)};
    if (count == 0) put<3>(expanded<3>(layout, state, formula, {}), {0, 1, 2}, result);
    if (count == 1) put<4>(expanded<4>(layout, state, formula, {active[0]}), {0, 1, 2, 3}, result);
    for (int i = 0; i < count; ++i)
        for (int j = i + 1; j < count; ++j)
            put<5>(expanded<5>(layout, state, formula, {active[i], active[j]}),
                   {0, 1, 2, output_variables + i, output_variables + j}, result);
    return result;
}

template <class Formula>
RangeAlong range_of(const RemoteLayout& layout, const MechanismStateAlong& state, const Formula& formula) {
    std::array<RangeAlong, remote_dimension_count> dimensions;
    std::copy_n(state.dimensions.begin(), remote_dimension_count, dimensions.begin());
    const RemoteEvaluation<RangeAlong> own(layout, dimensions);
    return formula(own, own.roller({state.s, state.velocity, state.acceleration}));
}

// The limits of a remote follower over a box of the output's motion and of dimensions, by the formulas of
// remote_formulas.hpp. Each is divided by its coefficient of the highest derivative and is thus linear in it:
// the curved part is a function of s, or of s and s'.

RemoteEvaluation<RangeOver> evaluation_over(const RemoteLayout& layout, const MechanismStateOver& state) {
    std::array<RangeOver, remote_dimension_count> all;
    std::copy_n(state.dimensions.begin(), remote_dimension_count, all.begin());
    return {layout, all};
}

/// (factor κ − share) |V|³ over the size of the coefficient of s'' in κ |V|³, which is −C_across l ψ_s.
RangeOver curvature_excess_over(const RemoteEvaluation<RangeOver>& own, const MechanismStateOver& state,
                                const RangeOver& factor, double share) {
    const remote::RollerState<RangeOver> still = own.roller({state.s, state.velocity, RangeOver(0.0)});
    const RangeOver coefficient = still.across * (still.arm * still.ratio);
    const RangeOver sign = sign_of(coefficient), size = sign * coefficient;
    const RangeOver along = still.normal_along();
    const RangeOver cubed = cube_of_root(squared(along) + squared(still.across));
    return (factor * still.turning() - share * cubed) / size - factor * (sign * state.acceleration);
}

}  // namespace

MechanismValue RemoteCam::quantity(MechanismQuantity which, const MechanismState& state, int,
                                   std::span<const int> active) const {
    return value_of(layout_, state, active, QuantityFormula{which});
}

MechanismValue RemoteCam::pressure_excess(double limit, int sign, const MechanismState& state, int,
                                          std::span<const int> active) const {
    return value_of(layout_, state, active, PressureFormula{sign * std::cos(limit), std::sin(limit)});
}

std::optional<RangeAlong> RemoteCam::quantity_along(MechanismQuantity which, const MechanismStateAlong& state,
                                                    int) const {
    return range_of(layout_, state, QuantityFormula{which});
}

std::optional<RangeAlong> RemoteCam::pressure_along(double limit, int sign, const MechanismStateAlong& state,
                                                    int) const {
    return range_of(layout_, state, PressureFormula{sign * std::cos(limit), std::sin(limit)});
}

std::optional<RangeOver> RemoteCam::pressure_over(double limit, int sign, const MechanismStateOver& state,
                                                  int) const {
    const auto own = evaluation_over(layout_, state);
    const RangeOver cosine = cos(Interval(limit)), sine = sin(Interval(limit));
    const bool at_contact = layout_.pressure_point == PressurePoint::contact_point;
    // N = ±(C_along − σ l ψ_s s' [− r |V|/l]): independent of s' if there is no root.
    const auto roller = own.roller({state.s, at_contact ? state.velocity : RangeOver(0.0), RangeOver(0.0)});
    const RangeOver excess = sign * (cosine * own.numerator(roller)) - sine * own.denominator(roller);
    if (at_contact) return excess;
    const RangeOver lever = roller.arm * roller.ratio, turned = sign_of(lever);
    return excess / (cosine * (turned * lever)) -
           (sign * layout_.side * own.sense) * (turned * state.velocity);
}

std::optional<RangeOver> RemoteCam::regularity_over(double margin, const MechanismStateOver& state,
                                                    int) const {
    const auto own = evaluation_over(layout_, state);
    return curvature_excess_over(own, state, own.linkage[RemoteDimension::roller_radius], 1.0 - margin);
}

std::optional<RangeOver> RemoteCam::radius_over(const RangeOver& radius, const MechanismStateOver& state,
                                                int) const {
    return curvature_excess_over(evaluation_over(layout_, state), state, radius, 1.0);
}

}  // namespace camopt
