// SPDX-License-Identifier: MIT
// Plane cams for the machine: the checked program of an end mill around them, or along their groove.
//
// Frame of report/drawing/profile_shape.hpp, the cam between z = −thickness and z = 0. Only cams that close.
// Of a grooved cam the disk with its rim is the blank, and the program mills the groove into its upper face:
// in one pass with a cutter as wide as the groove, else along either flank (groove_passes.hpp). A conjugate
// cam is two such pieces (made_pieces). m.
#pragma once

#include "report/drawing/profile_shape.hpp"
#include "shop/nc/milling/milling_choice.hpp"

namespace camopt {

/// The allowance of the blank is around the cam; its faces are those of the cam.
struct DiskNcOptions : MillingOptions {
    std::optional<double> cutter_diameter = {};  ///< m; none: 16 mm, of a groove its width
    std::optional<double> groove_depth = {};     ///< m, in (0, thickness); none: half the thickness
    double thickness = 20e-3;                    ///< m: of the cam, chosen
    double tip_beyond = 1e-3;                    ///< m: the tip reaches so far below the cam, not of a groove
};

/// What is cut and what it is checked against, for checked_program(); keeps a reference to the shape. Throws
/// InputError for an open cam, for options that are not valid and for a blank that does not hold the cam.
[[nodiscard]] NcWork disk_nc_work(const ProfileShape& shape, const DiskNcOptions& options);

}  // namespace camopt
