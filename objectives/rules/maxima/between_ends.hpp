// SPDX-License-Identifier: MIT
// Limits between the ends of the tolerances, along one motion.
//
//   max g(x; p),   x along the motion,  p in [−1, 1]^n: the parts of the errors of s, s', s'' and of the
//   numbers
//
// Branch and bound over boxes of (x, p). A rule that grows or falls with an error all over a box has its
// largest value on that side of it, one that is convex in it at an end; other boxes are bounded by the mean
// value form F(m) + Σ max |∂F/∂z_i| w_i, m the middle, w half the widths, F the rule times a positive factor
// (PointRule::range_over). Where every error is at an end of its tolerance the rules of made_cams.hpp hold.
// Rules that are linear in the motion and the numbers need none of it.
#pragma once

#include "objectives/rules/made_cams.hpp"

namespace camopt {

/// One rule between the ends.
struct BetweenEnds {
    std::shared_ptr<const CamRule> rule;
    /// No cam between the ends passes the limit by more than `worst` (or 0); false: rule or motion have no
    /// enclosure, or the effort was used up.
    bool enclosed = true;
    double worst =
        -infinity;    ///< relative to the rule's scale; −infinity: it is nowhere larger than at the ends
    double at = 0.0;  ///< x
    MadeParts parts = {};  ///< the cam that has it
};

/// Of every limit of a scene with tolerances that is not linear. `drawn`: its cam, without variables.
[[nodiscard]] std::vector<BetweenEnds> between_ends(const Scene& scene, const CamVariables& drawn,
                                                    const Motion& motion);

}  // namespace camopt
