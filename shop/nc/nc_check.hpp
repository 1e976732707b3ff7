// SPDX-License-Identifier: MIT
// The verifier: what a printed program makes of the cam. Where its moves go at all is nc_travel.hpp's.
//
// It knows the text, the machine's forward kinematics and what is wanted, no formula that made the program.
//   poses    at every G1 block: where tip and axis stand in the cam, against where they belong. Rounding to
//            the printed digits explains a deviation up to Σ |∂tip/∂axis| · half its last digit. The last G1
//            before a rapid and before the end leads out of the cam: it has no pose of its own and moves Z up
//            alone, or it is not where it belongs.
//   surface  the cutter, a cylinder, moves as a control moves it: all axes in proportion between blocks. For
//            each point of the wanted surface the least distance from the cutter's side over the whole
//            program: > 0 stock is left there, < 0 it is gouged.
// m, rad, s.
#pragma once

#include "shop/nc/nc_reader.hpp"

namespace camopt {

struct NcPoseCheck {
    int blocks = 0;               ///< G1 blocks read: one a pose, without those that lead out
    double tip_deviation = 0.0;   ///< the largest, m
    double axis_deviation = 0.0;  ///< the largest angle, rad
    int line = 0;                 ///< of the text, where the tip deviates most
    /// The largest deviations that rounding explains at any block.
    double tip_rounding = 0.0, axis_rounding = 0.0;
    /// At every block the deviation is what rounding explains there, beside what two kinematics in double
    /// precision may differ by (1e-12 of the lever arms).
    bool within_rounding = false;
    double cutting_seconds = 0.0;  ///< of the blocks under G93
};

/// wanted: the poses in the order of the G1 blocks that do not lead out. Throws InputError for a text that
/// cannot be read and for another number of blocks.
[[nodiscard]] NcPoseCheck check_poses(std::span<const NcMove> moves, const Machine& machine,
                                      const PostProcessor& post, std::span<const ToolPose> wanted);

struct CutterShape {
    double diameter = 0.0;  ///< m, > 0
    double length = 0.0;    ///< m, > 0: cutting length from the tip up

    void validate() const;  ///< throws InputError
};

/// From the side or the lower end of the cutter, outwards; beyond its ends from its rim.
[[nodiscard]] double cutter_clearance(const ToolPose& pose, const CutterShape& cutter,
                                      const Eigen::Vector3d& point);

struct NcSurfaceCheck {
    double gouge = 0.0;                            ///< the deepest, m, >= 0
    double stock = 0.0;                            ///< the highest left, m, >= 0
    double least_stock = 0.0;                      ///< the lowest, m; negative: −gouge
    std::size_t gouge_point = 0, stock_point = 0;  ///< indices of the points
    std::size_t points = 0;
};

/// points: of the wanted surface, cam frame. Rapids do not cut.
[[nodiscard]] NcSurfaceCheck check_surface(std::span<const NcMove> moves, const Machine& machine,
                                           const CutterShape& cutter,
                                           std::span<const Eigen::Vector3d> points);

}  // namespace camopt
