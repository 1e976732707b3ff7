// SPDX-License-Identifier: MIT
// One point of a disk cam from the follower's position alone: positions as complex numbers, their derivatives
// by the product rule, the flat faces as envelopes of lines by their support function. Closed forms of the
// library are not used. Frames and signs: docs/cams.md.
//
// Roller and knife edge. The centre C(s) stands still; in the frame of the cam it runs P = exp(−iσθ) C, so
//   P' = exp(−iσθ) (C' − iσC),   P'' = exp(−iσθ) (C'' − 2iσC' − C),   outward normal n = iσP'/|P'|,
//   curvature κ = −σ Im(conj(P') P'')/|P'|³, cam radius 1/κ − r.
// Flat face. Distance p of the face from the cam's centre, angle α of its normal in the cam: radius p +
// d²p/dα². The pressure angle is the one between n and the velocity that the follower has at the contact.
#pragma once

#include "tests/soak/scenes/scene_numbers.hpp"

#include <array>
#include <map>
#include <string>

namespace camopt::soak {

/// A cam with all its dimensions, m.
struct Cam {
    std::string follower;
    double sense = 1.0;
    double base = 0.0, roller = 0.0, offset = 0.0, center = 0.0, arm = 0.0, face = 0.0;
    double speed = 0.0;
    std::map<std::string, double> forces;
    /// Height or angle of the follower at displacement 0; NaN: it does not reach.
    [[nodiscard]] double rest() const;
};

/// The dimensions by name, m.
[[nodiscard]] Cam cam_of(const SceneNumbers& scene, const std::map<std::string, double>& dimensions);

struct CamPoint {
    double velocity = 0.0;        ///< s' by the cam angle
    double pressure_angle = 0.0;  ///< rad, >= 0
    double curvature = 0.0;       ///< of the pitch curve; flat: of the cam
    double cam_radius = 0.0, regularity = 1.0, contact_offset = 0.0;
    double turning = 1.0;  ///< of a face on an arm against the cam, by the cam's own; <= 0: it turns back
    double force = 0.0, torque = 0.0, normal_force = 0.0;
    double hertz = 0.0;  ///< Pa; infinite where the cam is undercut
};

/// The state: s, s', s'' by the cam angle in m or rad.
[[nodiscard]] CamPoint cam_point(const Cam& cam, const std::array<double, 3>& state);

}  // namespace camopt::soak
