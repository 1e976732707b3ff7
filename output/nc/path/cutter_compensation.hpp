// SPDX-License-Identifier: MIT
// Cutter compensation as a control does it: where the cutter's centre goes under G41 and G42.
//
//   centre = programmed path + side · radius · left normal          side +1: G41, −1: G42
// The first block under compensation, a line, ends beside its programmed end. Around outer corners the cutter
// rolls about the corner, at inner ones the two offsets meet. The block with G40, a line, goes from the
// compensated end to its programmed one. Controls that mitre outer corners instead keep farther off by at
// most radius · (1 / cos(turn / 2) − 1): never nearer to the cam. Plane of X and Y, m.
#pragma once

#include "output/nc/nc_reader.hpp"

#include <span>
#include <vector>

namespace camopt {

/// The moves of the cutter's centre; what is not compensated stays as it is. Throws InputError for what no
/// control takes: an arc as the first or the last block, an inner arc of the cutter's radius or less, blocks
/// between which the cutter does not fit, Z moving under compensation.
[[nodiscard]] std::vector<NcMove> compensated(std::span<const NcMove> moves, double radius);

}  // namespace camopt
