// SPDX-License-Identifier: MIT
// The smallest base radius at which a given motion satisfies every limit of the scene's cam, the other
// dimensions as they are.
//
// The limits are the rules the optimizer keeps (objectives/rules/cam_limits.hpp), judged by their continuous
// maxima along the motion. From the smallest cam that can be built upwards, radii are tried in steps (ten a
// decade of the distance from that smallest; where the mechanism allows no larger ones than some radius,
// 1/400 of what it allows); the first that satisfies all limits is bisected against its forerunner. A radius
// that helps only within one step, between two that do not, may be missed.
#pragma once

#include "core/motion.hpp"
#include "scene/cam_mechanism.hpp"
#include "scene/scene.hpp"

#include <optional>
#include <string>

namespace camopt {

struct NeededBase {
    std::optional<double> radius;  ///< m; none: no base radius helps
    std::string broken;            ///< then a limit that stays broken: its key, or why no cam can be built
};

/// cam: that of the scene. Of its own base radius only the steps depend. Throws InputError for a cam whose
/// base radius is no dimension (CamMechanism::base_radius_index), and for a limit the follower cannot have.
[[nodiscard]] NeededBase needed_base(const Scene& scene, const DrivenMechanism& cam, const Motion& motion);

}  // namespace camopt
