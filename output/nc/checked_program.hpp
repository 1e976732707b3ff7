// SPDX-License-Identifier: MIT
// A program together with what its check found: paths are cut into blocks, printed, read back, and run
// against points of the wanted surface. m, rad, s.
#pragma once

#include "output/nc/block_angles.hpp"
#include "output/nc/nc_check.hpp"
#include "output/nc/nc_program.hpp"
#include "output/nc/post_processor.hpp"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace camopt {

struct CuttingPass {
    std::string name;
    ToolPath path;
};

/// Points of the wanted surface that are reported together.
struct WantedSurface {
    std::string name;
    std::vector<Eigen::Vector3d> points;
};

struct CuttingTask {
    std::vector<CuttingPass> passes;
    std::vector<double> knots;  ///< cam angles, as in block_angles
    BlockOptions blocks;
    CutterShape cutter;
    std::vector<WantedSurface> surfaces;
};

struct SurfaceFinding {
    std::string name;
    NcSurfaceCheck check;
};

struct CheckedProgram {
    NcProgram program;
    double chord_deviation = 0.0;  ///< m, of the blocks
    NcPoseCheck poses;             ///< of the printed text, read back
    std::vector<SurfaceFinding> surfaces;
};

/// job: without its passes. Throws InputError for whatever is not valid.
[[nodiscard]] CheckedProgram checked_program(const Machine& machine, const PostProcessor& post, NcJob job,
                                             const CuttingTask& task);

/// What the check found, in words for a machinist. mm, deg.
[[nodiscard]] std::string nc_check_text(const CheckedProgram& result);

}  // namespace camopt
