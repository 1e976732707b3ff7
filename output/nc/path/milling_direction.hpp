// SPDX-License-Identifier: MIT
// Climb or conventional, read from where the tool goes past the flank that it cuts.
//
// v: the tip's way in the cam; m: from the cutter's axis to the flank; w: along the axis of the spindle's
// turn, away from the spindle where it turns clockwise. A tooth at the flank moves along w × m:
//   climb  (w × m) · v < 0      conventional  > 0
// so with a clockwise spindle the cutter is left of its way in the material's sight when it climbs: G41.
#pragma once

#include "output/nc/finished_cam.hpp"
#include "output/nc/machine.hpp"
#include "output/nc/nc_program.hpp"
#include "output/nc/nc_reader.hpp"

#include <optional>
#include <span>
#include <string>

namespace camopt {

/// Blocks of one pass that run along a flank, by lines of the text.
struct FlankBlocks {
    int first_line = 0, last_line = 0;
    bool climbs = true;  ///< what is wanted
};

struct DirectionCheck {
    int climb = 0, conventional = 0;  ///< blocks
    std::string fault;                ///< the first block that goes the other way; empty: none
};

struct CutterInBlank {
    Blank blank;
    double radius = 0.0;  ///< of the cutter, m
};

/// moves: compensated. Blocks too short to have a direction, and those beside the blank, are left out.
[[nodiscard]] DirectionCheck check_direction(std::span<const NcMove> moves, const Machine& machine,
                                             FinishedCam& cam, SpindleSense spindle,
                                             const CutterInBlank& cutter,
                                             std::span<const FlankBlocks> blocks);

}  // namespace camopt
