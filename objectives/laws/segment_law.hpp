// SPDX-License-Identifier: MIT
// The law of a segment of a program on its stroke: 0 to 1 over the segment, from the displacement before it
// to its own.
//
//   "modified_sine(0.2)"  of the catalogue (motions/laws/law_catalogue.hpp)
//   "polynomial"          the polynomial of least degree with the states of its neighbours at both ends: of
//                         laws and dwells velocity and acceleration, what `end` of a joint gives, the
//                         states of motion.start and motion.end, else rest
//   one-dwell laws        with their top at the end where the motion turns back at once
#pragma once

#include "scene/scene.hpp"

namespace camopt {

class Law;

/// Throws SceneError for a law that does not fit: one that turns back where the motion does not, a moving end
/// beside one that rests or moves otherwise, a polynomial of no rise or whose displacements are free.
[[nodiscard]] std::shared_ptr<const Law> segment_law(const MotionSpec& motion, std::size_t index);

/// y' and y'' where a segment begins or ends, in lifts by the cam angle; none: it is free.
struct JointState {
    std::optional<double> velocity = 0.0, acceleration = 0.0;
};
/// What the scene says of both ends of a segment: what it gives there, what laws and dwells beside it have,
/// else rest.
[[nodiscard]] std::array<JointState, 2> joint_states(const MotionSpec& motion, std::size_t index);

/// The polynomial of least degree with these states over a stroke; states by the same variable as the width.
/// rise: not 0. The velocities are known.
[[nodiscard]] std::shared_ptr<const Law> polynomial_between(const std::array<JointState, 2>& ends,
                                                            double rise, double width);

/// Displacements at the joints of the own segments as far as the scene gives them, in lifts: a dwell keeps
/// it, a closed program ends at 0.
[[nodiscard]] std::vector<std::optional<double>> given_levels(const MotionSpec& motion);

}  // namespace camopt
