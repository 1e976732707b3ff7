// SPDX-License-Identifier: MIT
// The program that makes a machine follow cutter poses.
//
//   header · units, G90 · for each pass: way in, blocks, way out · footer
// Way in: rapid up to the clearance plane, rapid in that plane over the first pose, rapid down to the safe
// distance over the blank, plunge. Way out: feed up to the safe distance over the blank, rapid up to the
// clearance plane. The plane lies over the blank however the table stands; both heights follow from the blank
// alone, so a program cannot have them inside. Ways in and out are along the tool.
// Each block is G1 with all axes; under inverse time F = 1 / minutes, the time being the longest of
// path / feed (path of the tip in the cam) and turn / rotary speed of each rotary axis. Rotary axes run on
// beyond a turn instead of jumping back. m, rad, s inside.
#pragma once

#include "output/nc/blank.hpp"
#include "output/nc/machine.hpp"
#include "output/nc/post/post_processor.hpp"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace camopt {

struct NcPass {
    std::string name;
    std::vector<ToolPose> poses;  ///< at least one
};

struct NcJob {
    std::string title, tool;           ///< of the program; what the cutter is, in words
    std::vector<std::string> remarks;  ///< comment lines
    std::vector<NcPass> passes;        ///< at least one
    double feed = 5e-3;                ///< m/s, > 0: of the tip in the cam
    double plunge_feed = 1e-3;         ///< m/s, > 0
    double rotary_speed = 0.0;         ///< rad/s, >= 0: the fastest a rotary axis may turn; 0: no limit
    Blank blank;                       ///< must be given
    double clearance = 0.02;           ///< m, >= safe_distance: of the clearance plane, above the blank
    double safe_distance = 2e-3;       ///< m, > 0: rapids keep so far from the blank
    double spindle_rpm = 0.0;          ///< rev/min, >= 0; 0: no word for the spindle

    void validate() const;  ///< throws InputError
};

struct NcProgram {
    std::string text;
    int blocks = 0;        ///< G1 blocks between poses
    double seconds = 0.0;  ///< of those blocks
    /// Of the machine, one for each pose of each pass, before they are rounded.
    std::vector<Eigen::VectorXd> values;
};

/// Throws InputError for a job or a post that is not valid, and for poses the machine cannot take.
[[nodiscard]] NcProgram nc_program(const Machine& machine, const PostProcessor& post, const NcJob& job);

}  // namespace camopt
