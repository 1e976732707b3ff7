// SPDX-License-Identifier: MIT
// What an NC program is to do: passes of cutter poses, feeds, heights, spindle and tool. m, rad, s.
#pragma once

#include "shop/nc/blank.hpp"
#include "shop/nc/nc_reader.hpp"

namespace camopt {

/// The block that ends at a pose goes round: three axes only.
struct NcArc {
    std::size_t pose = 0;                 ///< > 0: where it ends
    Eigen::Vector2d center = {0.0, 0.0};  ///< m, cam frame
    bool clockwise = false;               ///< seen along the tool
};

struct NcPass {
    std::string name;
    std::vector<ToolPose> poses;  ///< at least one
    std::vector<NcArc> arcs = {};
    /// The words G41 or G42 from the first block on, G40 in the last: the poses are the cutter's edge, the
    /// control keeps its centre off. Three axes only; at least three poses, no arcs at either end.
    CompensationSide compensation = CompensationSide::none;
};

/// Which way the spindle turns, seen from it down onto the work: M3, M4.
enum class SpindleSense { clockwise, counterclockwise };
[[nodiscard]] const char* name_of(SpindleSense sense);  ///< "clockwise"

struct NcJob {
    std::string title, tool;           ///< of the program; what the cutter is, in words
    std::vector<std::string> remarks;  ///< comment lines
    std::vector<NcPass> passes;        ///< at least one
    double stock = 0.0;                ///< m, >= 0: left on the finished surface for the next program
    double feed = 5e-3;                ///< m/s, > 0: of the tip in the cam
    double plunge_feed = 1e-3;         ///< m/s, > 0
    double rotary_speed = 0.0;         ///< rad/s, >= 0: the fastest a rotary axis may turn; 0: no limit
    Blank blank;                       ///< must be given
    double clearance = 0.02;           ///< m, >= safe_distance: of the clearance plane, above the blank
    double safe_distance = 2e-3;       ///< m, > 0: rapids keep so far from the blank
    double spindle_rpm = 0.0;          ///< rev/min, >= 0; 0: no word for the spindle
    SpindleSense spindle = SpindleSense::clockwise;
    std::optional<int> tool_number = {};     ///< 1 … 9999; none: no tool call
    int compensation_register = 1;           ///< 1 … 9999: D of G41 and G42
    double cutter_diameter = 0.0;            ///< m, >= 0; 0: not known, every plunge is one into the blank
    std::vector<std::string> warnings = {};  ///< for header and check

    void validate() const;  ///< throws InputError
};

/// The job's warnings, and what the operator must do because the program has no words for it: no spindle
/// speed, no tool call. Words in the post's own lines count.
[[nodiscard]] std::vector<std::string> warnings_of(const PostProcessor& post, const NcJob& job);

}  // namespace camopt
