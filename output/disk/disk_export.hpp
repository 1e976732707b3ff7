// SPDX-License-Identifier: MIT
// Plane cams for the machine: the checked program of an end mill around them.
//
// Frame of profiles/disk/disk_cam.hpp, the cam between z = −thickness and z = 0. Only cams that close. m.
#pragma once

#include "output/drawing/profile_shape.hpp"
#include "output/nc/checked_program.hpp"
#include "output/nc/milling/milling_choice.hpp"

#include <string>

namespace camopt {

struct DiskNcOptions {
    double cutter_diameter = 16e-3;  ///< m
    double stock = 0.0;              ///< m, left around the cam
    double thickness = 20e-3;        ///< m: of the cam, chosen
    double tip_beyond = 1e-3;        ///< m: the tip reaches so far below the cam
    double feed = 5e-3;              ///< m/s
    double spindle_rpm = 0.0;        ///< rev/min; 0: no word
    double chord_tolerance = 1e-6;   ///< m
    double gouge_tolerance = 1e-5;   ///< m: checked_program.hpp
    BlankChoice blank;               ///< allowance: around the cam; its faces are those of the cam
    double clearance = 0.02;         ///< m: of the clearance plane above the blank
    double safe_distance = 2e-3;     ///< m: rapids keep so far from the blank
    MillingChoice milling;
    std::string title = "cam";
};

/// What is cut and what it is checked against; keeps a reference to the shape. Throws InputError for an open
/// cam, for options that are not valid and for a blank that does not hold the cam.
[[nodiscard]] NcWork disk_nc_work(const ProfileShape& shape, const DiskNcOptions& options);

/// Throws like disk_nc_work. A program with a fault is returned with it.
[[nodiscard]] CheckedProgram disk_nc(const ProfileShape& shape, const Machine& machine,
                                     const PostProcessor& post, const DiskNcOptions& options);

}  // namespace camopt
