// SPDX-License-Identifier: MIT
// The limits of a remote follower over a box of the output's motion and of dimensions, by the formulas of
// remote_formulas.hpp. Each is divided by its coefficient of the highest derivative and is thus linear in it:
// the curved part is a function of s, or of s and s'.
#include "profiles/remote/remote_cam.hpp"
#include "profiles/remote/remote_numbers.hpp"

#include <cmath>

namespace camopt {
namespace {

RemoteEvaluation<RangeOver> evaluation_over(const RemoteCam& cam, const MechanismStateOver& state) {
    std::array<RangeOver, remote_dimension_count> all;
    std::copy_n(state.dimensions.begin(), remote_dimension_count, all.begin());
    return {cam, all};
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

std::optional<RangeOver> RemoteCam::pressure_over(double limit, int sign, const MechanismStateOver& state,
                                                  int) const {
    const auto own = evaluation_over(*this, state);
    const RangeOver cosine = cos(Interval(limit)), sine = sin(Interval(limit));
    const bool at_contact = pressure_point_ == PressurePoint::contact_point;
    // N = ±(C_along − σ l ψ_s s' [− r |V|/l]): independent of s' if there is no root.
    const auto roller = own.roller({state.s, at_contact ? state.velocity : RangeOver(0.0), RangeOver(0.0)});
    const RangeOver excess = sign * (cosine * own.numerator(roller)) - sine * own.denominator(roller);
    if (at_contact) return excess;
    const RangeOver lever = roller.arm * roller.ratio, turned = sign_of(lever);
    return excess / (cosine * (turned * lever)) - (sign * side_ * own.sense) * (turned * state.velocity);
}

std::optional<RangeOver> RemoteCam::regularity_over(double margin, const MechanismStateOver& state,
                                                    int) const {
    const auto own = evaluation_over(*this, state);
    return curvature_excess_over(own, state, own.linkage[RemoteDimension::roller_radius], 1.0 - margin);
}

std::optional<RangeOver> RemoteCam::radius_over(double shift, const MechanismStateOver& state, int) const {
    const auto own = evaluation_over(*this, state);
    return curvature_excess_over(own, state, own.linkage[RemoteDimension::roller_radius] + RangeOver(shift),
                                 1.0);
}

}  // namespace camopt
