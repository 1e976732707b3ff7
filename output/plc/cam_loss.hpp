// SPDX-License-Identifier: MIT
// How far an electronic cam is from the motion it stands for: over one revolution, not at samples.
//
// On a stretch where the motion is a polynomial the difference is one, and its greatest magnitude is found
// from the sign changes of its derivative: exact but for rounding. On a stretch of a law it is searched for
// between 64 places, each top by golden sections. Units as in MasterCurve.
#pragma once

#include "output/plc/cam_pieces.hpp"

#include <array>
#include <vector>

namespace camopt {

struct CamDifference {
    double value = 0.0;  ///< magnitude
    double at = 0.0;     ///< deg
};

struct MasterStretch {
    double from = 0.0, to = 0.0;  ///< deg
};

/// Largest |motion − piece| of the derivative of that order (0 … 3) on a stretch. Without a breakpoint of the
/// motion inside, but where stretches between them are looked at one after another.
[[nodiscard]] CamDifference largest_difference(const MasterCurve& curve, const CamPiece& piece,
                                               const MasterStretch& stretch, int order);

/// Of the first `orders` of s, s', s'', s''' over the turn. Throws InputError where the pieces leave a gap,
/// overlap, or do not go from 0 to the end.
[[nodiscard]] std::array<CamDifference, 4> cam_loss(const MasterCurve& curve,
                                                    const std::vector<CamPiece>& pieces, int orders = 4);

/// Largest |s|, |s'|, |s''|, |s'''| of the motion itself.
[[nodiscard]] std::array<CamDifference, 4> cam_peaks(const MasterCurve& curve);

}  // namespace camopt
