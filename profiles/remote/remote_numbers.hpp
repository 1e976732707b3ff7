// SPDX-License-Identifier: MIT
// Private to profiles/remote: a RemoteCam's formulas with its numbers.
#pragma once

#include "profiles/remote/remote_cam.hpp"
#include "profiles/remote/remote_formulas.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace camopt {

template <class T>
struct RemoteEvaluation {
    remote::Linkage<T> linkage;
    double sense = 1.0, side = 1.0;
    PressurePoint pressure_point = PressurePoint::roller_center;

    RemoteEvaluation(const RemoteCam& cam, const std::array<T, remote_dimension_count>& dimensions)
        : linkage{cam.linkage_, cam.lever_branch_, cam.rocker_branch_, dimensions},
          sense(sense_of(cam.rotation_)),
          side(cam.side_),
          pressure_point(cam.pressure_point_) {}

    [[nodiscard]] remote::RollerState<T> roller(const std::array<T, 3>& output) const {
        return roller(linkage.roller_arm(output[0]), output);
    }
    [[nodiscard]] remote::RollerState<T> roller(const remote::Turning<T>& arm,
                                                const std::array<T, 3>& output) const {
        return remote::roller_state(linkage, arm, output, sense);
    }
    [[nodiscard]] T numerator(const remote::RollerState<T>& roller) const {
        const T along = roller.normal_along();
        if (pressure_point == PressurePoint::roller_center) return T(along * side);
        const T radius = T(linkage[RemoteDimension::roller_radius] / roller.arm);
        return T(along - T(radius * roller.speed())) * side;
    }
    [[nodiscard]] T denominator(const remote::RollerState<T>& roller) const {
        return T(roller.normal_across() * side);
    }
    [[nodiscard]] T regularity(const remote::RollerState<T>& roller) const {
        return T(-T(linkage[RemoteDimension::roller_radius] * roller.curvature())) + 1.0;
    }
};

namespace remote {

inline std::array<double, remote_dimension_count> numbers(std::span<const double> dimensions) {
    std::array<double, remote_dimension_count> all{};
    std::copy_n(dimensions.begin(), remote_dimension_count, all.begin());
    return all;
}

inline std::array<double, 3> numbers(const FollowerState& state) {
    return {state.s, state.velocity, state.acceleration};
}

inline RemoteEvaluation<double> evaluation(const RemoteCam& cam, std::span<const double> dimensions) {
    return {cam, numbers(dimensions)};
}

}  // namespace remote
}  // namespace camopt
