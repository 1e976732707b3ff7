// SPDX-License-Identifier: MIT
#include "output/nc/nc_program.hpp"

#include "core/errors.hpp"
#include "core/units.hpp"
#include "output/nc/nc_writer.hpp"
#include "output/nc/requirement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace camopt {

namespace {

// A block that does not move takes a control no time, and 1 / 0 is no feed.
constexpr double least_block_seconds = 1e-3;

constexpr Requirement require_job{"NC job"};

double seconds_between(const NcJob& job, const Machine& machine, const NcStep& from, const NcStep& to) {
    double seconds = (to.pose.tip - from.pose.tip).norm() / job.feed;
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

void NcJob::validate() const {
    require_job(std::isfinite(feed) && feed > 0.0, "the feed must be > 0 m/s", feed);
    require_job(std::isfinite(plunge_feed) && plunge_feed > 0.0, "the plunge feed must be > 0 m/s",
                plunge_feed);
    require_job(std::isfinite(rotary_speed) && rotary_speed >= 0.0, "the rotary speed must be >= 0 rad/s",
                rotary_speed);
    blank.validate();
    require_job(std::isfinite(safe_distance) && safe_distance > 0.0,
                "the safe distance of rapids from the blank must be > 0 m", safe_distance);
    if (!(std::isfinite(clearance) && clearance >= safe_distance))
        throw InputError(
            fmt::format("NC job: the clearance plane must lie above the blank by the safe distance of {:g} "
                        "mm or more, found {:g} mm{}",
                        safe_distance / units::millimetre, clearance / units::millimetre,
                        clearance < 0.0 ? ", which is inside the blank" : ""));
    require_job(std::isfinite(spindle_rpm) && spindle_rpm >= 0.0, "the spindle speed must be >= 0 rev/min",
                spindle_rpm);
    require_job(!passes.empty(), "there must be a pass", 0);
    for (const NcPass& pass : passes) require_job(!pass.poses.empty(), "each pass must have a pose", 0);
}

NcProgram nc_program(const Machine& machine, const PostProcessor& post, const NcJob& job) {
    job.validate();
    post.validate();
    check_feed_mode(machine, post);
    NcWriter writer(machine, post);
    const auto passes = steps_of(machine, job);
    const Heights heights(machine, job);
    NcProgram program;
    writer.begin(job, heights.plane());
    for (std::size_t p = 0; p < passes.size(); ++p) {
        const std::vector<NcStep>& steps = passes[p];
        writer.approach(job.passes[p].name, steps.front(),
                        {heights.plane(), heights.safe(steps.front().pose)});
        writer.plunge(steps.front(), job.plunge_feed);
        for (std::size_t i = 1; i < steps.size(); ++i) {
            const double seconds = seconds_between(job, machine, steps[i - 1], steps[i]);
            writer.cut(steps[i], seconds, job.feed);
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
