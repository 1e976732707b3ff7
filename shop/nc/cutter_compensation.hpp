// SPDX-License-Identifier: MIT
// Cutter compensation as a control does it: where the cutter's centre goes under G41 and G42.
//
//   centre = programmed path + side · radius · left normal          side +1: G41, −1: G42
// The first block under compensation, a line, ends beside its programmed end. Around outer corners the cutter
// rolls about the corner, at inner ones the two offsets meet. The block with G40, a line, goes from the
// compensated end to its programmed one. Controls that mitre outer corners instead keep further off by at
// most radius · (1 / cos(turn / 2) − 1): never nearer to the cam. Plane of X and Y, m.
#pragma once

#include "shop/nc/finished_cam.hpp"
#include "shop/nc/nc_job.hpp"

namespace camopt {

/// The moves of the cutter's centre; what is not compensated stays as it is. Throws InputError for what no
/// control takes: an arc as the first or the last block, an inner arc of the cutter's radius or less, blocks
/// between which the cutter does not fit, Z moving under compensation.
[[nodiscard]] std::vector<NcMove> compensated(std::span<const NcMove> moves, double radius);

// Climb or conventional, read from where the tool goes past the flank that it cuts.
//
// v: the tip's way in the cam; m: from the cutter's axis to the flank; w: along the axis of the spindle's
// turn, away from the spindle where it turns clockwise. A tooth at the flank moves along w × m:
//   climb  (w × m) · v < 0      conventional  > 0
// so with a clockwise spindle the cutter is left of its way in the material's sight when it climbs: G41.

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

// Where a machine is in the middle of a move: all axes in proportion, on arcs the angle in proportion.
//
// An arc whose ends are not equally far from its centre, printed digits being what they are, changes its
// radius evenly. m, rad.

/// Axis values at `share` (0 … 1) of the way from `from` to the move's end.
[[nodiscard]] Eigen::VectorXd values_along(const Eigen::VectorXd& from, const NcMove& move, double share);

/// How far X, Y and Z go, m: no point between two shares a and b is further from the other than |b − a| of
/// it.
[[nodiscard]] double linear_length(const Eigen::VectorXd& from, const NcMove& move);

}  // namespace camopt
