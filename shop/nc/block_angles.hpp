// SPDX-License-Identifier: MIT
// At which cam angles a program has its blocks.
//
// A control moves all axes in proportion between two blocks. The cutter leaves the true path by the chord
// deviation: the largest distance, at either end of its working length, between where the axes put it and
// where it belongs. It is of the second order in the step. m and rad.
#pragma once

#include "shop/nc/machine.hpp"

namespace camopt {

struct BlockOptions {
    std::optional<int> count = {};  ///< >= 1: so many blocks, evenly over all knots; none: by the tolerance
    double chord_tolerance = 1e-6;  ///< m, > 0
    double working_length = 0.0;    ///< m, >= 0: from the tip back along the cutter
    /// Three axes, no count: where the path between two knots is a circle about the cam's axis (a dwell) and
    /// this holds, its blocks are arcs of no more than a quarter of a turn. Empty: no arcs.
    std::function<bool(double)> arcs = {};

    void validate() const;  ///< throws InputError
};

struct BlockArc {
    std::size_t end = 0;     ///< of theta
    bool clockwise = false;  ///< seen along the tool
};

struct BlockAngles {
    std::vector<double> theta;        ///< ascending; one more than there are blocks
    std::vector<BlockArc> arcs = {};  ///< ascending
    /// m: the largest found at the quarters of each block. Above the tolerance only where a block was halved
    /// as often as it may be (the path jumps), or a count was asked for.
    double chord_deviation = 0.0;
};

/// knots: ascending, at least two: begin, angles where the motion changes its formula, end. Without a count
/// every knot starts a block. Throws InputError for wrong options and knots.
[[nodiscard]] BlockAngles block_angles(const ToolPath& path, const Machine& machine,
                                       std::span<const double> knots, const BlockOptions& options);

}  // namespace camopt
