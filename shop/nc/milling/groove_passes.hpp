// SPDX-License-Identifier: MIT
// The passes that mill the groove of a drum: roughing layer by layer, from its middle towards the flanks,
// then the flanks.
//
// A layer is the finishing path lifted along the tool: what a lifted cutter touches the lower one touches
// too, so it leaves what the lower one leaves. In: down the middle of the groove on a ramp that goes to and
// fro, no steeper than the ramp's angle; where a layer above is cut already, straight down through it. From
// the middle the cutter goes to the flank: in a closed groove over the lead's length along it, on a parabola
// that touches the flank, once around and on over the same length back to the middle; an open groove ends
// round, there it steps across. A cutter as large as the roller cuts both flanks from the middle, one of them
// climbing. m, rad.
#pragma once

#include "shop/nc/milling/milling_choice.hpp"

namespace camopt {

struct GrooveMilling {
    RollerPath roller;
    std::vector<double> knots;  ///< as in block_angles: the whole groove
    CutterLocation location;    ///< of the finishing passes; its flank is not read. The tip: the floor
    double depth = 0.0;         ///< m: the greatest, along the cutter
};

/// The passes of a job that has its blank, and all of the task but the surfaces. Throws InputError for
/// numbers that are not valid, a direction where both flanks are cut at once, an allowance that the cutter is
/// too large for, and for compensation, which is for plane cams.
void add_groove(NcWork& work, const GrooveMilling& milling, const MillingOptions& options);

}  // namespace camopt
