// SPDX-License-Identifier: MIT
#include "output/nc/path/milling_direction.hpp"

#include "output/nc/path/nc_path.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <cmath>

namespace camopt {

namespace {

constexpr double least_way = 2e-6;   // m: below, printed digits decide
constexpr double least_sine = 0.05;  // the way must pass the flank, not lead to it
constexpr double small_step = 1e-3;  // of a block: for the tip's direction in its middle

/// (w × m) · v of unit vectors; 0 where there is no direction.
double sense_of(const Machine& machine, FinishedCam& cam, const Eigen::VectorXd& from, const NcMove& move,
                SpindleSense spindle) {
    const ToolPose middle = machine.pose(values_along(from, move, 0.5));
    const Eigen::Vector3d before = machine.pose(values_along(from, move, 0.5 - small_step)).tip;
    const Eigen::Vector3d after = machine.pose(values_along(from, move, 0.5 + small_step)).tip;
    const Eigen::Vector3d way = after - before;
    if (way.norm() < 2.0 * small_step * least_way) return 0.0;
    const Eigen::Vector3d turn =
        spindle == SpindleSense::clockwise ? middle.axis : Eigen::Vector3d(-middle.axis);
    return turn.cross(cam.towards_flank(middle)).dot(way.normalized());
}

}  // namespace

DirectionCheck check_direction(std::span<const NcMove> moves, const Machine& machine, FinishedCam& cam,
                               SpindleSense spindle, const CutterInBlank& cutter,
                               std::span<const FlankBlocks> blocks) {
    DirectionCheck check;
    std::size_t place = 0;
    for (std::size_t i = 1; i < moves.size() && place < blocks.size(); ++i) {
        while (place < blocks.size() && moves[i].line > blocks[place].last_line) ++place;
        if (place == blocks.size() || moves[i].line < blocks[place].first_line || moves[i].rapid) continue;
        if (distance_to_blank(cutter.blank, machine.pose(moves[i].values), cutter.radius) > 0.0) continue;
        const double sense = sense_of(machine, cam, moves[i - 1].values, moves[i], spindle);
        if (!(std::abs(sense) > least_sine)) continue;
        const bool climbs = sense < 0.0;
        ++(climbs ? check.climb : check.conventional);
        if (climbs != blocks[place].climbs && check.fault.empty())
            check.fault = fmt::format("line {}: the block is {}, not {}", moves[i].line,
                                      climbs ? "climb" : "conventional", climbs ? "conventional" : "climb");
    }
    return check;
}

}  // namespace camopt
