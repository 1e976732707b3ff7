// SPDX-License-Identifier: MIT
// A program together with what its check found: paths are cut into blocks, printed, read back, followed past
// blank and finished cam, and run against points of the wanted surface. m, rad, s.
#pragma once

#include "shop/nc/block_angles.hpp"
#include "shop/nc/cutter_compensation.hpp"
#include "shop/nc/nc_check.hpp"
#include "shop/nc/nc_program.hpp"
#include "shop/nc/nc_travel.hpp"

namespace camopt {

/// Into the cam or out of it, beside the blocks of the path.
struct CuttingWay {
    std::vector<ToolPose> poses;
    /// Into: from its last pose to the path's first; out: from the path's last to its first. Three axes only.
    std::optional<MoveArc> arc = {};
};

struct CuttingPass {
    std::string name;
    ToolPath path;
    std::vector<double> knots = {};  ///< of this path; empty: the task's
    CuttingWay in = {}, out = {};
    std::optional<double> chord_tolerance = {};  ///< m; none, or finer: the task's
    std::function<bool(double)> keep = {};       ///< blocks end only where it holds; empty: everywhere
    bool roughs = false;
    double stock = 0.0;  ///< m: what it must leave of the cam; finishing passes: 0
    CompensationSide compensation = CompensationSide::none;
    std::optional<bool> climbs = {};  ///< none: it has no direction (both flanks at once)
    std::string warning = {};         ///< for header and check
};

/// Points of the wanted surface that are reported together.
struct WantedSurface {
    std::string name;
    std::vector<Eigen::Vector3d> points;
    /// m: the most that the cutter leaves there where it stands at its place; more is a fault.
    double most_stock = HUGE_VAL;
};

struct CuttingTask {
    std::vector<CuttingPass> passes;
    std::vector<double> knots;  ///< cam angles, as in block_angles
    BlockOptions blocks;
    CutterShape cutter;
    std::vector<WantedSurface> surfaces;
    std::shared_ptr<FinishedCam> finished;  ///< must be given
    /// m, > 0: how deep the cutter may enter the finished cam, beside the chord tolerance and what the
    /// printed digits explain at either end of its working length.
    double gouge_tolerance = 1e-5;
    /// Lines of the finished cam, cam frame, for pictures; the check does not look at them.
    std::vector<std::vector<Eigen::Vector3d>> outlines = {};
};

/// What the cutter does along a move.
enum class MoveRole { rapid, way, roughing, finishing };

/// A move that the verifier followed: of the cutter's centre, on `machine`'s axes.
struct FollowedMove {
    NcMove move;
    MoveRole role = MoveRole::rapid;  ///< way: down, in, out and up beside the blocks of a pass
    int pass = 0;                     ///< from 0; of a rapid: the one that follows
};

struct NcWork {
    NcJob job;  ///< without its passes
    CuttingTask task;
};

struct SurfaceFinding {
    std::string name;
    NcSurfaceCheck check;
};

struct CheckedProgram {
    NcProgram program;
    std::vector<std::string> warnings;              ///< warnings_of: not a fault
    std::optional<Blank> clamp;                     ///< where no move goes: room to hold the cam by its bore
    std::vector<ToolPose> wanted;                   ///< one a cutting block
    double chord_deviation = 0.0;                   ///< m, of the blocks
    NcPoseCheck poses;                              ///< of the printed text, read back
    NcTravelCheck travel;                           ///< of the same text
    DirectionCheck direction;                       ///< likewise
    std::vector<FollowedMove> moves;                ///< all that `travel` went along, in their order
    std::string spindle_fault;                      ///< the text turns it the other way; empty: it does not
    double least_distance = 0.0, most_depth = 0.0;  ///< m: what `travel` asked for
    std::vector<SurfaceFinding> surfaces, roughed;  ///< at the end; after roughing alone
    std::string unfinished;                         ///< the first surface with more stock than it may have

    /// No reason not to run it; empty: none was found.
    [[nodiscard]] std::string fault() const;
};

/// Throws InputError for anything that is not valid. A program with a fault is returned with it.
[[nodiscard]] CheckedProgram checked_program(const Machine& machine, const PostProcessor& post, NcWork work);

/// Reads program.program.text again and finds everything anew. Throws InputError for a text that cannot be
/// read or has another number of cutting blocks.
void verify(CheckedProgram& program, const Machine& machine, const PostProcessor& post, const NcWork& work);

/// What the check found, in words for a machinist. mm, deg.
[[nodiscard]] std::string nc_check_text(const CheckedProgram& result);

}  // namespace camopt
