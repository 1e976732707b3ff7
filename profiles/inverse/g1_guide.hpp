// SPDX-License-Identifier: MIT
// The guide of the paper: a line from the pivot, two arcs, a line towards which the pivot lies; tangents
// agree.
//
//   S = R1 + R2,  alpha = beta + acos((R2 - x0 sin beta + R1 cos beta) / S),
//   C1 = (x0, R1),  C2 = (x0 + S sin alpha, R1 - S cos alpha)
// The first line runs along the body's +x axis up to x0; arc 1 bends to the left through alpha; arc 2 bends
// back to the direction beta of the last line, which points away from the pivot. Lengths m, angles rad.
// Errors: InputError where such a guide does not exist.
#pragma once

#include "profiles/inverse/guide.hpp"

namespace camopt {

struct G1GuideDimensions {
    double line_end = 0.0;                           ///< x0 > 0
    double first_radius = 0.0, second_radius = 0.0;  ///< R1, R2 > 0
    double end_angle = 0.0;                          ///< beta, 0 < beta < pi / 2
    double begin = 0.0, end = 0.0;                   ///< L from which and up to which the guide exists
};

/// alpha and the second centre, as above. NaN where there is none.
struct G1GuideShape {
    double middle_angle = 0.0;  ///< alpha
    Eigen::Vector2d second_center;
};
[[nodiscard]] G1GuideShape g1_guide_shape(const G1GuideDimensions& dimensions);

/// Four pieces; its joints are begin, x0, L3, L4, end.
[[nodiscard]] Guide make_g1_guide(const G1GuideDimensions& dimensions);

}  // namespace camopt
