// SPDX-License-Identifier: MIT
// What the follower of a disk cam and its contact carry at one cam angle.
//
//     F = m ω² s'' + c s + preload                 on the follower, N; > 0 presses it on the cam
//     T = F s'                                     of the camshaft, N m; > 0: the shaft drives
//     N = F / lever                                along the normal, N (lever: cos φ; swinging: a length)
//     p = √(N E* / (π b R))                        Hertz, Pa; 1/R = 1/ρ_cam + 1/r, E* and b of ForceSpec
//
// Swinging followers: M in N m in place of F, by ψ. Where the follower cannot touch the cam as designed N and
// p mean nothing: the caller knows (CamSummary::no_contact).
#pragma once

#include "core/follower_state.hpp"
#include "profiles/disk/disk_cam.hpp"
#include "scene/cam_mechanism.hpp"
#include "scene/cam_spec.hpp"

#include <optional>

namespace camopt {

struct FollowerLoad {
    double force = 0.0;   ///< F (N) or M (N m)
    double torque = 0.0;  ///< signed
    double normal_force = 0.0;
    std::optional<double> hertz_pressure;  ///< none without a contact width, and of a knife edge
};

/// Formulas of one cam and what it carries. Keeps references to both.
class FollowerLoads {
 public:
    /// speed: ω, rad/s.
    FollowerLoads(const DiskCam& cam, const ForceSpec& forces, double speed)
        : cam_(cam), forces_(forces), speed_(speed) {}

    [[nodiscard]] double force(const FollowerState& state) const {
        return forces_.force(speed_, state.s, state.acceleration);
    }
    [[nodiscard]] double torque(const FollowerState& state) const { return force(state) * state.velocity; }
    [[nodiscard]] double normal_force(const FollowerState& state) const;
    /// There is a line of contact, whose width is known.
    [[nodiscard]] bool has_pressure() const;
    /// 0 where nothing presses.
    [[nodiscard]] double hertz_pressure(const FollowerState& state, const MechanismPoint& point) const;
    [[nodiscard]] FollowerLoad at(const FollowerState& state, const MechanismPoint& point) const;

 private:
    const DiskCam& cam_;
    const ForceSpec& forces_;
    double speed_ = 0.0;
};

}  // namespace camopt
