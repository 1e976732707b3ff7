// SPDX-License-Identifier: MIT
// The forward check of a cam whose roller sits on a lever: profile points only -> lever -> output. The lever
// is put down on the points as the arm of a disk cam (forward_check.hpp), which it is after a turn and
// perhaps a mirror; its angle goes forwards through the linkage by positions alone.
#pragma once

#include "studies/check/forward_check.hpp"
#include "studies/delivered/mechanism_summary.hpp"

namespace camopt {

/// points: about so many of the cam. The deviation is that of the output, m or rad; relative: by the lift.
/// Throws InputError for a mechanism without such a lever.
[[nodiscard]] ForwardCheckInput mechanism_check_input(const DrivenMechanism& mechanism, const Motion& motion,
                                                      const MotionScale& scale, int points);

}  // namespace camopt
