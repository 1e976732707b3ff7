// SPDX-License-Identifier: MIT
// G-code read back: the moves that a control would make, from the printed text and the post-processor alone.
//
// Understood: G0 G1, G2 G3 with I and J from the arc's begin in the plane G17, G40 G41 G42 with D, G20 G21
// G90 G93 G94, axis words, F, N, O, S, T, M, comments ( ) and ;, %; G18 G19 G49 G61 G64 G80 change nothing
// here, nor do G54 … G59 and the unit before the first move. Everything else is an InputError naming the
// line: a check that skips what it does not know checks nothing.
#pragma once

#include "shop/nc/post_processor.hpp"

namespace camopt {

/// On which side of the programmed path the cutter goes, in the direction of its travel, seen from +Z.
enum class CompensationSide { none = 0, left = 1, right = -1 };

struct MoveArc {
    Eigen::Vector2d center;  ///< x and y of the machine, m
    bool clockwise = false;  ///< seen from +Z
};

struct NcMove {
    int line = 0;                                            ///< of the text, from 1
    bool rapid = false;                                      ///< G0
    Eigen::VectorXd values;                                  ///< at its end, machine axes, m and rad
    double seconds = 0.0;                                    ///< G93 only, else 0
    std::optional<MoveArc> arc = {};                         ///< none: straight, all axes in proportion
    CompensationSide compensation = CompensationSide::none;  ///< the control keeps the cutter's radius off
};

/// What the text sets beside moves.
struct NcWords {
    bool tool_call = false;         ///< M6
    double spindle_rpm = 0.0;       ///< the last S
    bool clockwise = false;         ///< M3
    bool counterclockwise = false;  ///< M4
};

/// Throws like read_nc_travel.
[[nodiscard]] NcWords read_nc_words(std::string_view text, const Machine& machine, const PostProcessor& post);

/// All moves; an axis that has no value yet is NaN. Throws InputError (see above), also where units, G90 or a
/// feed are missing, and for a G1 before every axis has a value.
[[nodiscard]] std::vector<NcMove> read_nc_travel(std::string_view text, const Machine& machine,
                                                 const PostProcessor& post);

}  // namespace camopt
