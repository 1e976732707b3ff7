// SPDX-License-Identifier: MIT
#include "shop/nc/checked_program.hpp"

#include "core/errors.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

constexpr double kinematics_rounding = 1e-9;  // m: of heights, far above what double precision loses
constexpr double arc_step = 2.0 * units::degree;
constexpr double least_clamp = 1e-3;   // m: diameter; below, there is no room for one
constexpr double held_beside = 0.5;    // m: of a drum, from its ends on
constexpr double beside_clamp = 1e-4;  // m: in addition to the safe distance, for chords and printed digits

std::string mm(double metres) {
    return fmt::format("{:.3g} mm", metres / units::millimetre);
}

/// Without the first rapids, before every axis has a value.
std::vector<NcMove> known_moves(std::span<const NcMove> moves) {
    std::vector<NcMove> known;
    for (const NcMove& move : moves)
        if (move.values.allFinite()) known.push_back(move);
    return known;
}

/// known_moves with arcs in short pieces, as the search along a block takes them.
std::vector<NcMove> short_moves(std::span<const NcMove> moves) {
    std::vector<NcMove> pieces;
    for (const NcMove& move : known_moves(moves)) {
        const Eigen::VectorXd from = pieces.empty() ? move.values : pieces.back().values;
        const double radius = move.arc ? (move.values.head<2>() - move.arc->center).norm() : 0.0;
        const int count =
            radius > 0.0 ? static_cast<int>(1.0 + linear_length(from, move) / (radius * arc_step)) : 1;
        for (int k = 1; k <= count; ++k) {
            pieces.push_back(move);
            if (k < count) pieces.back().values = values_along(from, move, static_cast<double>(k) / count);
        }
    }
    return pieces;
}

std::vector<SurfaceFinding> surface_findings(const std::vector<NcMove>& moves, const Machine& machine,
                                             const CuttingTask& task) {
    std::vector<SurfaceFinding> findings;
    for (const WantedSurface& surface : task.surfaces)
        findings.push_back({surface.name, check_surface(moves, machine, task.cutter, surface.points)});
    return findings;
}

bool is_plane(const Machine& machine) {
    return machine.axes().size() == 3;
}
bool is_tilting(const Machine& machine) {
    return machine.axes().size() > 4;
}

/// True where the tool, from its place at one parameter to that at another, goes against its own path there:
/// past the place where the path crosses itself.
bool runs_back(const ToolPath& path, double from, double to) {
    const double step = 1e-6 * (to - from);
    const Eigen::Vector3d here = path(to).tip;
    return (here - path(from).tip).dot(here - path(to - step).tip) < 0.0;
}

/// One pass of the task as poses, and what its check wants of it.
NcPass printed_pass(const CuttingPass& cut, const Machine& machine, const CuttingTask& task, bool arcs,
                    double& deviation) {
    BlockOptions options = task.blocks;
    options.chord_tolerance = std::max(cut.chord_tolerance.value_or(0.0), options.chord_tolerance);
    if (arcs) options.arcs = cut.keep ? cut.keep : [](double) { return true; };
    const BlockAngles blocks =
        block_angles(cut.path, machine, cut.knots.empty() ? task.knots : cut.knots, options);
    if (!cut.roughs) deviation = std::max(deviation, blocks.chord_deviation);
    NcPass pass{cut.name, cut.in.poses, {}, cut.compensation};
    const auto arc_to_next = [&](const std::optional<MoveArc>& arc) {
        if (arc) pass.arcs.push_back({pass.poses.size(), arc->center, arc->clockwise});
    };
    arc_to_next(cut.in.arc);
    auto arc = blocks.arcs.begin();
    std::optional<double> before;
    for (std::size_t i = 0; i < blocks.theta.size(); ++i) {
        const double theta = blocks.theta[i];
        const bool round = arc != blocks.arcs.end() && arc->end == i;
        if (round) pass.arcs.push_back({pass.poses.size(), Eigen::Vector2d::Zero(), (arc++)->clockwise});
        if (!round && cut.keep && (!cut.keep(theta) || (before && runs_back(cut.path, *before, theta))))
            continue;
        pass.poses.push_back(cut.path(theta));
        before = theta;
    }
    arc_to_next(cut.out.arc);
    pass.poses.insert(pass.poses.end(), cut.out.poses.begin(), cut.out.poses.end());
    return pass;
}

/// Of a block: what lies below all that the cutter passes, over its length.
std::optional<Blank> clamp_below(const NcJob& job) {
    const Eigen::AlignedBox2d& block = *job.blank.block;
    double least = block.max().y();
    for (const NcPass& pass : job.passes) {
        // Under compensation the poses are the cutter's edge.
        const double radius = pass.compensation == CompensationSide::none ? 0.5 * job.cutter_diameter : 0.0;
        for (const ToolPose& pose : pass.poses) least = std::min(least, pose.tip.y() - radius);
    }
    const double room = least - job.safe_distance - beside_clamp;
    const double upper = units::millimetre * std::floor(room / units::millimetre);
    if (upper < block.min().y() + least_clamp) return std::nullopt;
    Blank clamp{0.0, job.blank.lower, job.blank.upper + job.clearance - job.safe_distance};
    clamp.block = Eigen::AlignedBox2d(block.min(), Eigen::Vector2d(block.max().x(), upper));
    return clamp;
}

/// Room about the cam's axis for what holds the cam by its bore: the cutter keeps the safe distance from it.
/// On three axes it is clamped from above. A table that tilts raises what sticks out of the blank: it ends
/// where rapids in the clearance plane pass it at any angle. None: there is no room.
std::optional<Blank> clamp_of(const NcJob& job, const Machine& machine) {
    if (job.blank.block) return clamp_below(job);
    const double above = is_plane(machine) ? job.clearance - job.safe_distance : 0.0;
    const double beside = is_plane(machine) ? 0.0 : held_beside;
    Blank clamp{0.0, job.blank.lower - beside, job.blank.upper + above + beside};
    double least = job.blank.radius;
    for (const NcPass& pass : job.passes) {
        const double radius = pass.compensation == CompensationSide::none ? 0.5 * job.cutter_diameter : 0.0;
        for (const ToolPose& pose : pass.poses)
            least = std::min(least, distance_to_blank(clamp, pose, radius));
    }
    const double diameter = 2.0 * (least - job.safe_distance - beside_clamp);
    clamp.radius = 0.5 * units::millimetre * std::floor(diameter / units::millimetre);
    if (clamp.radius < 0.5 * least_clamp) return std::nullopt;
    if (is_tilting(machine)) {
        const double passed =
            greatest_height(job.blank, machine) + job.clearance - job.safe_distance - beside_clamp;
        const double reach = std::sqrt(passed * passed - clamp.radius * clamp.radius);
        const double whole = units::millimetre * std::floor(reach / units::millimetre);
        clamp.lower = std::max(clamp.lower, -whole);
        clamp.upper = std::min(clamp.upper, whole);
    }
    return clamp;
}

std::string words_of_clamp(const NcJob& job, const Machine& machine, const Blank& clamp) {
    if (clamp.block)
        return fmt::format(
            "fixture: the plate is held below y = {:g} mm, clamps lie at most {:g} mm above the blank",
            clamp.block->max().y() / units::millimetre, (clamp.upper - job.blank.upper) / units::millimetre);
    const double diameter = 2.0 * clamp.radius / units::millimetre;
    if (is_plane(machine))
        return fmt::format(
            "fixture: the cam is held by its bore, clamps lie within diameter {:g} mm about its axis, at "
            "most {:g} mm above the blank",
            diameter, (clamp.upper - job.blank.upper) / units::millimetre);
    return fmt::format("fixture: the cam is clamped at both ends within diameter {:g} mm about its axis",
                       diameter) +
           (is_tilting(machine) ? fmt::format(", at most {:g} mm from its centre",
                                              std::min(-clamp.lower, clamp.upper) / units::millimetre)
                                : "");
}

/// Moves of each pass, from the first feed to the last.
std::vector<std::span<const NcMove>> passes_of(std::span<const NcMove> moves) {
    std::vector<std::span<const NcMove>> passes;
    for (std::size_t i = 0; i < moves.size();) {
        std::size_t end = i;
        while (end < moves.size() && !moves[end].rapid) ++end;
        if (end > i) passes.push_back(moves.subspan(i, end - i));
        i = std::max(end, i + 1);
    }
    return passes;
}

/// By the numbers of poses that lead in and out; the last block of a pass is the way out along the tool.
std::vector<FlankBlocks> flank_blocks(std::span<const NcMove> moves, const CuttingTask& task) {
    std::vector<FlankBlocks> result;
    const auto passes = passes_of(moves);
    for (std::size_t p = 0; p < passes.size() && p < task.passes.size(); ++p) {
        const CuttingPass& cut = task.passes[p];
        const std::size_t first = cut.in.poses.size() + 1, after = cut.out.poses.size() + 1;
        if (!cut.climbs || first + after >= passes[p].size()) continue;
        result.push_back({passes[p][first].line, passes[p][passes[p].size() - after - 1].line, *cut.climbs});
    }
    return result;
}

/// Every move with what it is for: a pass is feeds between rapids, its ways are those that flank_blocks
/// leaves out.
std::vector<FollowedMove> followed_moves(std::span<const NcMove> printed, std::span<const NcMove> moves,
                                         const CuttingTask& task) {
    struct Blocks {
        int first, last;  // lines
    };
    std::vector<Blocks> blocks;
    const auto passes = passes_of(printed);
    for (std::size_t p = 0; p < passes.size(); ++p) {
        const bool known = p < task.passes.size();
        const std::size_t first = known ? task.passes[p].in.poses.size() + 1 : 1;
        const std::size_t after = known ? task.passes[p].out.poses.size() + 1 : 1;
        const bool some = first + after < passes[p].size();
        blocks.push_back(some ? Blocks{passes[p][first].line, passes[p][passes[p].size() - after - 1].line}
                              : Blocks{0, -1});
    }
    std::vector<FollowedMove> result;
    int pass = -1;
    bool feeding = false;
    for (const NcMove& move : moves) {
        if (!move.rapid && !std::exchange(feeding, true)) ++pass;
        if (move.rapid) feeding = false;
        FollowedMove followed{move, MoveRole::rapid, move.rapid ? pass + 1 : pass};
        const auto p = static_cast<std::size_t>(pass);
        if (!move.rapid) {
            const bool cuts =
                p < blocks.size() && move.line >= blocks[p].first && move.line <= blocks[p].last;
            const bool roughs = p < task.passes.size() && task.passes[p].roughs;
            followed.role = !cuts ? MoveRole::way : roughs ? MoveRole::roughing : MoveRole::finishing;
        }
        result.push_back(std::move(followed));
    }
    return result;
}

/// Roughing passes come first.
std::span<const NcMove> roughing_moves(std::span<const NcMove> moves, const CuttingTask& task) {
    const auto roughs = static_cast<std::size_t>(std::ranges::count_if(task.passes, &CuttingPass::roughs));
    const auto passes = passes_of(moves);
    if (roughs == 0 || roughs >= passes.size()) return {};
    return moves.first(static_cast<std::size_t>(passes[roughs].data() - moves.data()));
}

std::string spindle_fault(const NcWords& words, SpindleSense spindle) {
    const bool clockwise = spindle == SpindleSense::clockwise;
    if (!(clockwise ? words.counterclockwise : words.clockwise)) return {};
    return clockwise ? "the program turns the spindle counterclockwise (M4), clockwise (M3) is required"
                     : "the program turns the spindle clockwise (M3), counterclockwise (M4) is required";
}

}  // namespace

std::string CheckedProgram::fault() const {
    if (!travel.good()) return travel.fault;
    if (!poses.within_rounding)
        return fmt::format("line {}: WRONG: a block deviates more than the printed digits explain",
                           poses.line);
    if (!direction.fault.empty()) return direction.fault;
    return spindle_fault.empty() ? unfinished : spindle_fault;
}

CheckedProgram checked_program(const Machine& machine, const PostProcessor& post, NcWork work) {
    CheckedProgram result;
    work.job.passes.clear();
    work.job.cutter_diameter = work.task.cutter.diameter;
    for (const CuttingPass& cut : work.task.passes) {
        work.job.passes.push_back(
            printed_pass(cut, machine, work.task, takes_arcs(machine, post), result.chord_deviation));
        const std::vector<ToolPose>& poses = work.job.passes.back().poses;
        result.wanted.insert(result.wanted.end(), poses.begin(), poses.end());
        if (!cut.warning.empty()) work.job.warnings.push_back(cut.warning);
    }
    work.job.blank.validate();
    result.clamp = clamp_of(work.job, machine);
    if (result.clamp)
        work.job.remarks.push_back(words_of_clamp(work.job, machine, *result.clamp));
    else
        work.job.warnings.emplace_back(
            work.job.blank.block
                ? "the cutter leaves no space below the surface to hold the plate"
                : "the cutter leaves no space about the cam's axis to hold the cam by its bore");
    result.program = nc_program(machine, post, work.job);
    result.warnings = warnings_of(post, work.job);
    verify(result, machine, post, work);
    return result;
}

void verify(CheckedProgram& program, const Machine& machine, const PostProcessor& post, const NcWork& work) {
    const CuttingTask& task = work.task;
    if (!(std::isfinite(task.gouge_tolerance) && task.gouge_tolerance > 0.0))
        throw InputError(fmt::format("NC check: the allowed gouge must be > 0 mm, found {:g}",
                                     task.gouge_tolerance / units::millimetre));
    const std::string& text = program.program.text;
    const std::vector<NcMove> printed = read_nc_travel(text, machine, post);
    const std::vector<NcMove> moves = compensated(printed, 0.5 * task.cutter.diameter);
    program.poses = check_poses(known_moves(printed), machine, post, program.wanted);
    program.least_distance =
        work.job.safe_distance - half_last_digit(post, AxisKind::linear) - kinematics_rounding;
    program.most_depth = task.gouge_tolerance + task.blocks.chord_tolerance + program.poses.tip_rounding +
                         program.poses.axis_rounding * task.blocks.working_length;
    NcTravelTask travel{work.job.blank,
                        0.5 * task.cutter.diameter,
                        task.finished.get(),
                        program.least_distance,
                        program.most_depth,
                        false,
                        {}};
    // On four axes the blank's height is the same however the table turns.
    travel.rapids_above = !is_tilting(machine);
    travel.rapids_above_as_it_stands = is_tilting(machine);
    travel.clamp = program.clamp;
    for (const CuttingPass& cut : task.passes) travel.stocks.push_back(cut.stock);
    program.travel = check_travel(moves, machine, travel);
    program.moves = followed_moves(printed, moves, task);
    program.direction =
        check_direction(moves, machine, *task.finished, work.job.spindle,
                        {work.job.blank, 0.5 * task.cutter.diameter}, flank_blocks(printed, task));
    program.spindle_fault = spindle_fault(read_nc_words(text, machine, post), work.job.spindle);
    program.surfaces = surface_findings(short_moves(moves), machine, task);
    program.unfinished.clear();
    for (std::size_t i = 0; i < task.surfaces.size() && program.unfinished.empty(); ++i) {
        const double found = program.surfaces[i].check.stock, most = task.surfaces[i].most_stock;
        if (found > most + program.most_depth)
            program.unfinished = fmt::format("the program leaves {} of {}, allowed: {}", mm(found),
                                             task.surfaces[i].name, mm(most + program.most_depth));
    }
    program.roughed.clear();
    const std::span<const NcMove> rough = roughing_moves(moves, task);
    if (!rough.empty()) program.roughed = surface_findings(short_moves(rough), machine, task);
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
            "  rapids             {}, all {:.4f} mm or more from the blank, at any speed of each axis",
            result.travel.rapids, result.least_distance / units::millimetre));
        add(fmt::format("  feeds              {}, nowhere more than {:.4f} mm inside the finished cam",
                        result.travel.feeds, result.most_depth / units::millimetre));
    }
    if (result.travel.good() && result.clamp)
        add("  fixture            no move comes " + clamp_words(*result.clamp));
    if (result.direction.climb + result.direction.conventional > 0)
        add(fmt::format("  direction          climb in {} blocks along the flanks, conventional in {}",
                        result.direction.climb, result.direction.conventional));
    for (const std::string& warning : result.warnings) add("  WARNING            " + warning);
    add(fault.empty() ? "  verdict            every block is correct within the printed digits"
                      : fmt::format("  verdict            REFUSED: {}", fault));
    const auto add_surfaces = [&](const char* what, const std::vector<SurfaceFinding>& surfaces) {
        add(what);
        for (const SurfaceFinding& surface : surfaces)
            add(fmt::format("  {}: {} to {}, at {} points", surface.name, mm(surface.check.least_stock),
                            mm(surface.check.stock), surface.check.points));
    };
    add_surfaces("Deviation of the cut surface (above 0: stock, below 0: gouged):", result.surfaces);
    if (!result.roughed.empty()) add_surfaces("Deviation after roughing:", result.roughed);
    return text;
}

}  // namespace camopt
