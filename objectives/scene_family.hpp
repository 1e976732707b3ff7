// SPDX-License-Identifier: MIT
// The motions that a scene allows: its family, from which the optimizer chooses.
#pragma once

#include "objectives/program_family.hpp"

namespace camopt {

/// The one spline of a DRD or RR scene: its breakpoints, end states, exact points and symmetry.
[[nodiscard]] DesignRequest spline_request(const Scene& scene, DesignKind kind);

/// The motions of the scene, with the given form of design vector (not automatic).
///   DRD: y = y' = y'' = 0 at x = 0, y = 1, y' = y'' = 0 at x = 1.
///   RR:  the same at x = 0, y = y' = y'' = 0 at the end, y(1) = 1, y'(1) = 0.
///   program: program_family.
[[nodiscard]] MotionFamily scene_family(const Scene& scene, DesignKind kind,
                                        const std::vector<StrokeDirection>& of_free = {});

/// What makes the cam's motion of the output's, where dynamics prescribes it (scene/dynamics_spec.hpp), at
/// the scene's speed; in lifts over x.
[[nodiscard]] DerivativeCombination cam_of_output(const Scene& scene);

/// The same for the torque of a motor between which and the output the train stands: with A the torque that
/// the motor and what moves with it take for s'' = 1, the output takes the part ρ of it, and A z'' with
/// z = s + ρ y is the torque of both.
[[nodiscard]] DerivativeCombination torque_of_output(const Scene& scene);

/// The scene's own breakpoints, in the units of spline.breakpoints: where a search for free ones starts.
[[nodiscard]] std::vector<double> start_breakpoints(const Scene& scene);

/// Those of them that no search moves: ends of regions of DRD and RR.
[[nodiscard]] std::vector<double> held_breakpoints(const Scene& scene);

/// The scene on these breakpoints, which are not free.
[[nodiscard]] Scene with_breakpoints(Scene scene, std::vector<double> breakpoints);

}  // namespace camopt
