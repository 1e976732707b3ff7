// SPDX-License-Identifier: MIT
// Private to studies/delivered: the figures that only a follower which touches its cam has: the pressure
// angle by strokes, whether it can touch at all, what it carries.
#pragma once

#include "studies/delivered/cam/cam_summary.hpp"
#include "studies/delivered/cam/cam_turn.hpp"

namespace camopt {

/// Of a disk cam; nothing to do for another. The summary has what every cam has.
void add_follower_figures(CamSummary& summary, const DrivenMechanism& mechanism, const CamTurn& turn,
                          const Scene& scene);

}  // namespace camopt
