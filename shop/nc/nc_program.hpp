// SPDX-License-Identifier: MIT
// The program that makes a machine follow cutter poses.
//
//   header · units, G90 · for each pass: way in, blocks, way out · footer
// Way in: rapid up to the clearance plane, rapid in that plane over the first pose, rapid down to the safe
// distance over the blank, plunge. Way out: feed up to the safe distance over the blank, rapid up to the
// clearance plane. The plane lies over the blank however the table stands; both heights follow from the blank
// alone, so a program cannot have them inside. Ways in and out are along the tool; beside the blank the
// cutter goes down by the ordinary feed.
// Each block is G1 with all axes; under inverse time F = 1 / minutes, the time being the longest of
// path / feed (path of the tip in the cam) and turn / rotary speed of each rotary axis. Rotary axes run on
// beyond a turn instead of jumping back. m, rad, s inside.
#pragma once

#include "shop/nc/nc_job.hpp"

namespace camopt {

struct NcProgram {
    std::string text;
    int blocks = 0;        ///< G1 blocks between poses
    double seconds = 0.0;  ///< of those blocks
    /// Of the machine, one for each pose of each pass, before they are rounded.
    std::vector<Eigen::VectorXd> values;
};

/// Arcs and cutter compensation are of the plane of X and Y: three axes, the first two with these letters.
[[nodiscard]] bool takes_arcs(const Machine& machine, const PostProcessor& post);

/// Throws InputError for a job or a post that is not valid, and for poses the machine cannot take.
[[nodiscard]] NcProgram nc_program(const Machine& machine, const PostProcessor& post, const NcJob& job);

}  // namespace camopt
