// SPDX-License-Identifier: MIT
#include "output/nc/checked_program.hpp"

#include "core/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace camopt {

namespace {

std::string mm(double metres) {
    return fmt::format("{:.3g} mm", metres / units::millimetre);
}

}  // namespace

CheckedProgram checked_program(const Machine& machine, const PostProcessor& post, NcJob job,
                               const CuttingTask& task) {
    CheckedProgram result;
    std::vector<ToolPose> wanted;
    job.passes.clear();
    for (const CuttingPass& cut : task.passes) {
        const BlockAngles blocks = block_angles(cut.path, machine, task.knots, task.blocks);
        result.chord_deviation = std::max(result.chord_deviation, blocks.chord_deviation);
        NcPass pass{cut.name, {}};
        for (const double theta : blocks.theta) pass.poses.push_back(cut.path(theta));
        wanted.insert(wanted.end(), pass.poses.begin(), pass.poses.end());
        job.passes.push_back(std::move(pass));
    }
    result.program = nc_program(machine, post, job);
    const std::vector<NcMove> moves = read_nc_text(result.program.text, machine, post);
    result.poses = check_poses(moves, machine, post, wanted);
    for (const WantedSurface& surface : task.surfaces)
        result.surfaces.push_back({surface.name, check_surface(moves, machine, task.cutter, surface.points)});
    return result;
}

std::string nc_check_text(const CheckedProgram& result) {
    const NcPoseCheck& poses = result.poses;
    std::string text = fmt::format(
        "The printed program was read back and run through the machine's forward kinematics.\n"
        "  blocks             {}, {:.1f} s at the given feed\n"
        "  chord deviation    {} between blocks, before printing\n"
        "  tip at the blocks  {} off; the printed digits explain up to {}\n"
        "  axis at the blocks {:.2g} deg off; the printed digits explain up to {:.2g} deg\n"
        "  verdict            {}\n"
        "What the cutter leaves of the wanted surface (above 0: stock, below 0: gouged):\n",
        result.program.blocks, result.program.seconds, mm(result.chord_deviation), mm(poses.tip_deviation),
        mm(poses.tip_rounding), poses.axis_deviation / units::degree, poses.axis_rounding / units::degree,
        poses.within_rounding ? "every block is where it belongs, within the printed digits"
                              : "WRONG: a block is farther off than the printed digits explain");
    for (const SurfaceFinding& surface : result.surfaces)
        fmt::format_to(std::back_inserter(text), "  {}: {} to {}, at {} points\n", surface.name,
                       mm(surface.check.least_stock), mm(surface.check.stock), surface.check.points);
    return text;
}

}  // namespace camopt
