// SPDX-License-Identifier: MIT
// Quantities with exact partials by (s, s', s'', active dimensions): automatic differentiation, by two
// dimensions at a time, so that the number of variables of one pass is small and known at compile time.
#include "core/second_order.hpp"
#include "profiles/remote/remote_cam.hpp"
#include "profiles/remote/remote_numbers.hpp"

#include <Eigen/Core>

#include <algorithm>

namespace camopt {
namespace {

constexpr int output_variables = 3;

template <class T>
T formula(const RemoteEvaluation<T>& own, const std::array<T, 3>& output, MechanismQuantity which) {
    const remote::RollerState<T> roller = own.roller(output);
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
            break;
    }
    refuse_quantity(remote_type);
}

struct Request {
    const RemoteCam& cam;
    const MechanismState& state;
    MechanismQuantity which;
};

/// By the output and n − 3 dimensions.
template <int n>
SecondOrder<n> expanded(const Request& request, const std::array<int, n - output_variables>& by) {
    std::array<SecondOrder<n>, remote_dimension_count> dimensions;
    for (std::size_t i = 0; i < dimensions.size(); ++i)
        dimensions[i] = constant<n>(request.state.dimensions[i]);
    for (std::size_t k = 0; k < by.size(); ++k) {
        const auto which = static_cast<std::size_t>(by[k]);
        dimensions[which] =
            variable<n>(request.state.dimensions[which], output_variables + static_cast<int>(k));
    }
    const std::array<double, 3> output = remote::numbers(request.state.output);
    const std::array<SecondOrder<n>, 3> state = {variable<n>(output[0], 0), variable<n>(output[1], 1),
                                                 variable<n>(output[2], 2)};
    return formula(RemoteEvaluation<SecondOrder<n>>(request.cam, dimensions), state, request.which);
}

/// Writes the partials of one pass into the rows and columns of its variables.
template <int n>
void put(const SecondOrder<n>& pass, const std::array<int, n>& columns, MechanismValue& result) {
    result.value = pass.value().value();
    for (int i = 0; i < n; ++i) {
        result.gradient(columns[i]) = pass.value().derivatives()(i);
        for (int j = 0; j < n; ++j)
            result.hessian(columns[i], columns[j]) = pass.derivatives()(i).derivatives()(j);
    }
}

}  // namespace

MechanismValue RemoteCam::quantity(MechanismQuantity which, const MechanismState& state, int,
                                   std::span<const int> active) const {
    const Request request{*this, state, which};
    const int count = static_cast<int>(active.size()), size = output_variables + count;
    MechanismValue result{0.0, Eigen::VectorXd::Zero(size), Eigen::MatrixXd::Zero(size, size)};
    if (count == 0) put<3>(expanded<3>(request, {}), {0, 1, 2}, result);
    if (count == 1) put<4>(expanded<4>(request, {active[0]}), {0, 1, 2, 3}, result);
    for (int i = 0; i < count; ++i)
        for (int j = i + 1; j < count; ++j)
            put<5>(expanded<5>(request, {active[i], active[j]}),
                   {0, 1, 2, output_variables + i, output_variables + j}, result);
    return result;
}

std::optional<RangeAlong> RemoteCam::quantity_along(MechanismQuantity which, const MechanismStateAlong& state,
                                                    int) const {
    std::array<RangeAlong, remote_dimension_count> dimensions;
    std::copy_n(state.dimensions.begin(), remote_dimension_count, dimensions.begin());
    return formula(RemoteEvaluation<RangeAlong>(*this, dimensions),
                   {state.s, state.velocity, state.acceleration}, which);
}

}  // namespace camopt
