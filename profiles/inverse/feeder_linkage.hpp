// SPDX-License-Identifier: MIT
// The linkage from the swinging body of an inverse cam over its pin and a slotted rocker to the feeder.
// Formulas: profiles/inverse/inverse_feeder.hpp.
#pragma once

#include "core/base/standard.hpp"

#include <Eigen/Core>

namespace camopt {

struct FeederLinkage {
    double pin_distance = 0.0;               ///< L1 > 0: pin from the body's pivot
    double pin_angle = 0.0;                  ///< al0: of the pin where the body is at theta = 0
    Eigen::Vector2d rocker_pivot{0.0, 0.0};  ///< C
    double feeder_offset = 0.0;              ///< Lx, not 0: feeder's line from the rocker's pivot, along x

    void validate() const;  ///< throws InputError
};

/// The pin where the body is at this angle, m.
[[nodiscard]] Eigen::Vector2d pin_at(const FeederLinkage& linkage, double body_angle);

}  // namespace camopt
