// SPDX-License-Identifier: MIT
#include "shop/nc/nc_program.hpp"

#include "shop/nc/cutter_compensation.hpp"
#include "shop/nc/nc_writer.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

// A block that does not move takes a control no time, and 1 / 0 is no feed.
constexpr double least_block_seconds = 1e-3;

double seconds_between(const NcJob& job, const Machine& machine, const NcStep& from, const NcStep& to,
                       const NcArc* arc) {
    double length = (to.pose.tip - from.pose.tip).norm();
    if (arc != nullptr)
        length = linear_length(from.values, {0, false, to.values, 0.0, MoveArc{arc->center, arc->clockwise}});
    double seconds = length / job.feed;
    if (job.rotary_speed > 0.0)
        for (std::size_t i = 0; i < machine.axes().size(); ++i) {
            const auto k = static_cast<Eigen::Index>(i);
            if (machine.axes()[i].kind == AxisKind::rotary)
                seconds = std::max(seconds, std::abs(to.values(k) - from.values(k)) / job.rotary_speed);
        }
    return std::max(seconds, least_block_seconds);
}

/// What mm / min means while the table turns is every control's own affair.
void check_feed_mode(const Machine& machine, const PostProcessor& post) {
    if (post.feed_mode == FeedMode::inverse_time) return;
    for (const MachineAxis& axis : machine.axes())
        if (axis.kind == AxisKind::rotary)
            throw InputError(fmt::format(
                "post-processor {}: feed = \"per_minute\" is for machines without rotary axes; this one ({}) "
                "needs \"inverse_time\"",
                post.name, machine.name()));
}

void check_plane_words(const Machine& machine, const PostProcessor& post, const NcJob& job) {
    for (const NcPass& pass : job.passes) {
        if (pass.arcs.empty() && pass.compensation == CompensationSide::none) continue;
        if (takes_arcs(machine, post)) continue;
        if (machine.axes().size() != 3)
            throw InputError("NC job: arcs and cutter compensation are for machines with three axes");
        throw InputError(fmt::format(
            "post-processor {}: arcs and cutter compensation need the letters X and Y for axes.x and axes.y",
            post.name));
    }
}

/// Z of heights over the origin along the tool (machine.hpp).
class Heights {
 public:
    Heights(const Machine& machine, const NcJob& job) : job_(job) {
        const auto axes = static_cast<Eigen::Index>(machine.axes().size());
        const ToolPose rest = machine.pose(Eigen::VectorXd::Zero(axes));
        offset_ = -rest.axis.dot(rest.tip);
        plane_ = greatest_height(job.blank, machine) + job.clearance - offset_;
    }
    [[nodiscard]] double plane() const { return plane_; }
    /// The cutter goes down beside the blank.
    [[nodiscard]] bool beside_blank(const ToolPose& pose) const {
        return job_.cutter_diameter > 0.0 &&
               distance_to_blank(job_.blank, pose, 0.5 * job_.cutter_diameter) >= job_.safe_distance;
    }
    /// As the table stands for this pose.
    [[nodiscard]] double safe(const ToolPose& pose) const {
        return job_.blank.support(-pose.axis) + job_.safe_distance - offset_;
    }

 private:
    const NcJob& job_;
    double offset_ = 0.0, plane_ = 0.0;
};

/// Axis values of every pose, rotary axes running on from pose to pose and pass to pass.
std::vector<std::vector<NcStep>> steps_of(const Machine& machine, const NcJob& job) {
    std::vector<std::vector<NcStep>> passes;
    Eigen::VectorXd before;
    for (const NcPass& pass : job.passes) {
        std::vector<NcStep>& steps = passes.emplace_back();
        for (const ToolPose& pose : pass.poses) {
            Eigen::VectorXd values = machine.values(pose);
            if (!values.allFinite()) throw InputError("NC job: a pose of the cutter is not finite");
            if (before.size() > 0) values = nearest_turn(machine, values, before);
            before = values;
            steps.push_back({pose, values});
        }
    }
    return passes;
}

}  // namespace

bool takes_arcs(const Machine& machine, const PostProcessor& post) {
    return machine.axes().size() == 3 && post_axis(post, machine.axes()[0]).letter == "X" &&
           post_axis(post, machine.axes()[1]).letter == "Y";
}

NcProgram nc_program(const Machine& machine, const PostProcessor& post, const NcJob& job) {
    job.validate();
    post.validate();
    check_feed_mode(machine, post);
    check_plane_words(machine, post, job);
    NcWriter writer(machine, post);
    const auto passes = steps_of(machine, job);
    const Heights heights(machine, job);
    NcProgram program;
    writer.begin(job, heights.plane());
    for (std::size_t p = 0; p < passes.size(); ++p) {
        const std::vector<NcStep>& steps = passes[p];
        const NcPass& pass = job.passes[p];
        const bool compensates = pass.compensation != CompensationSide::none;
        writer.approach(job.passes[p].name, steps.front(),
                        {heights.plane(), heights.safe(steps.front().pose)});
        writer.plunge(steps.front(), heights.beside_blank(steps.front().pose) ? job.feed : job.plunge_feed);
        for (std::size_t i = 1; i < steps.size(); ++i) {
            const auto found = std::ranges::find(pass.arcs, i, &NcArc::pose);
            const NcArc* const arc = found == pass.arcs.end() ? nullptr : &*found;
            const double seconds = seconds_between(job, machine, steps[i - 1], steps[i], arc);
            if (compensates && i == 1) writer.compensate(pass.compensation, job.compensation_register);
            if (compensates && i + 1 == steps.size()) writer.end_compensation();
            writer.cut(steps[i], seconds, job.feed, arc);
            program.seconds += seconds;
            ++program.blocks;
        }
        writer.retract({heights.plane(), heights.safe(steps.back().pose)}, job.feed);
        for (const NcStep& step : steps) program.values.push_back(step.values);
    }
    program.text = writer.finish();
    return program;
}

}  // namespace camopt
