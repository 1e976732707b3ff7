// SPDX-License-Identifier: MIT
// mechanism.svg: a planar cam mechanism to scale. The cam and its pitch curve at cam angle 0, roller, levers,
// couplers and slider there, and thin the links at the two ends of the output's motion.
#pragma once

#include "studies/delivered/driven_mechanism.hpp"

#include <string>
#include <string_view>

namespace camopt {

/// What is drawn: a mechanism, its motion.
struct MechanismDrawing {
    const DrivenMechanism& mechanism;
    const Motion& motion;
    MotionScale scale;
};

/// Throws InputError for a mechanism that cannot be drawn.
[[nodiscard]] std::string mechanism_svg(const MechanismDrawing& drawing, std::string_view title);

}  // namespace camopt
