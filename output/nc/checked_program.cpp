// SPDX-License-Identifier: MIT
#include "output/nc/checked_program.hpp"

#include "core/errors.hpp"
#include "core/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace camopt {

namespace {

constexpr double kinematics_rounding = 1e-9;  // m: of heights, far above what double precision loses

std::string mm(double metres) {
    return fmt::format("{:.3g} mm", metres / units::millimetre);
}

}  // namespace

std::string CheckedProgram::fault() const {
    if (!travel.good()) return travel.fault;
    if (!poses.within_rounding)
        return fmt::format("line {}: WRONG: a block is farther off than the printed digits explain",
                           poses.line);
    return {};
}

CheckedProgram checked_program(const Machine& machine, const PostProcessor& post, NcWork work) {
    CheckedProgram result;
    work.job.passes.clear();
    for (const CuttingPass& cut : work.task.passes) {
        const BlockAngles blocks = block_angles(cut.path, machine, work.task.knots, work.task.blocks);
        result.chord_deviation = std::max(result.chord_deviation, blocks.chord_deviation);
        NcPass pass{cut.name, {}};
        for (const double theta : blocks.theta) pass.poses.push_back(cut.path(theta));
        result.wanted.insert(result.wanted.end(), pass.poses.begin(), pass.poses.end());
        work.job.passes.push_back(std::move(pass));
    }
    result.program = nc_program(machine, post, work.job);
    verify(result, machine, post, work);
    return result;
}

void verify(CheckedProgram& program, const Machine& machine, const PostProcessor& post, const NcWork& work) {
    const CuttingTask& task = work.task;
    if (!(std::isfinite(task.gouge_tolerance) && task.gouge_tolerance > 0.0))
        throw InputError(fmt::format("NC check: the allowed gouge must be > 0 mm, found {:g}",
                                     task.gouge_tolerance / units::millimetre));
    const std::string& text = program.program.text;
    const std::vector<NcMove> moves = read_nc_text(text, machine, post);
    program.poses = check_poses(moves, machine, post, program.wanted);
    program.least_distance =
        work.job.safe_distance - half_last_digit(post, AxisKind::linear) - kinematics_rounding;
    program.most_depth = task.gouge_tolerance + task.blocks.chord_tolerance + program.poses.tip_rounding +
                         program.poses.axis_rounding * task.blocks.working_length;
    program.travel = check_travel(read_nc_travel(text, machine, post), machine,
                                  {work.job.blank, 0.5 * task.cutter.diameter, task.finished.get(),
                                   program.least_distance, program.most_depth});
    program.surfaces.clear();
    for (const WantedSurface& surface : task.surfaces)
        program.surfaces.push_back(
            {surface.name, check_surface(moves, machine, task.cutter, surface.points)});
}

std::string nc_check_text(const CheckedProgram& result) {
    const NcPoseCheck& poses = result.poses;
    const std::string fault = result.fault();
    std::string text = fmt::format(
        "The printed program was read back and run through the machine's forward kinematics.\n"
        "  blocks             {}, {:.1f} s at the given feed\n"
        "  chord deviation    {} between blocks, before printing\n"
        "  tip at the blocks  {} off; the printed digits explain up to {}\n"
        "  axis at the blocks {:.2g} deg off; the printed digits explain up to {:.2g} deg\n",
        result.program.blocks, result.program.seconds, mm(result.chord_deviation), mm(poses.tip_deviation),
        mm(poses.tip_rounding), poses.axis_deviation / units::degree, poses.axis_rounding / units::degree);
    const auto add = [&](const std::string& line) { text += line + "\n"; };
    if (result.travel.good()) {
        add(fmt::format(
            "  rapids             {}, all {:.4f} mm or more from the blank, at whatever speed each axis runs",
            result.travel.rapids, result.least_distance / units::millimetre));
        add(fmt::format(
            "  feeds              {}, at no point of their way more than {:.4f} mm inside the finished cam",
            result.travel.feeds, result.most_depth / units::millimetre));
    }
    add(fault.empty() ? "  verdict            every block is where it belongs, within the printed digits"
                      : fmt::format("  verdict            REFUSED: {}", fault));
    add("What the cutter leaves of the wanted surface (above 0: stock, below 0: gouged):");
    for (const SurfaceFinding& surface : result.surfaces)
        add(fmt::format("  {}: {} to {}, at {} points", surface.name, mm(surface.check.least_stock),
                        mm(surface.check.stock), surface.check.points));
    return text;
}

}  // namespace camopt
