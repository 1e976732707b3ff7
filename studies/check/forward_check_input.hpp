// SPDX-License-Identifier: MIT
// What a forward check is given about a cam that camopt has designed: the points it exports, and nothing of
// how it made them.
#pragma once

#include "profiles/sampling.hpp"
#include "studies/check/forward_check.hpp"

#include <Eigen/Core>

#include <vector>

namespace camopt {

/// About `points` points evenly by cam angle, the motion's breakpoints among them. Closed where the motion
/// takes a whole turn and the cam ends where it began. Keeps a reference to the motion.
[[nodiscard]] ForwardCheckInput forward_check_input(const DiskCam& cam, const Motion& motion,
                                                    const MotionScale& scale, int points = 2000);

/// The same of points at hand, `breaks` the indices of those that lie on breakpoints: the cam a disk with the
/// follower `cam`.
[[nodiscard]] ForwardCheckInput forward_check_input(const DiskCam& cam, const Motion& motion,
                                                    const MotionScale& scale,
                                                    std::vector<Eigen::Vector2d> points,
                                                    std::vector<int> breaks);

}  // namespace camopt
