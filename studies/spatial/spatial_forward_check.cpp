// SPDX-License-Identifier: MIT
#include "studies/spatial/spatial_forward_check.hpp"

#include "studies/delivered/delivered.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

void check_section(const SpatialForwardCheckInput& input, std::size_t index,
                   SpatialForwardCheckResult& result) {
    FlankContact contact(input.follower, input.sections[index], input.breaks, input.designed(input.begin));
    bool first = true;
    double begin_s = 0.0;
    for (int i = 0; i < input.angles; ++i) {
        const double theta = input.begin + (input.end - input.begin) * (i + 0.5) / input.angles;
        const FlankContact::Stand stand = contact.at(theta);
        if (stand.at_end) {
            ++result.beyond;
            continue;
        }
        ++result.angles;
        const double found = std::abs(stand.s - input.designed(theta));
        const double deviation = std::isfinite(found) ? found : std::numeric_limits<double>::infinity();
        if (deviation > result.deviation) {
            result.deviation = deviation;
            result.theta = theta;
            result.section = static_cast<int>(index);
        }
        if (index > 0) continue;
        if (first) begin_s = stand.s;
        first = false;
        result.travel = stand.s - begin_s;
    }
}

using Eigen::Vector3d;

constexpr int section_steps = 34;    // golden sections: to 1e-7 of a distance, of whose square all depends
constexpr int most_secants = 30;     // half a dozen are needed
constexpr double first_step = 1e-5;  // of the follower, rad, or of the roller's radius
constexpr double enough = 1e-15;     // m: what is left of a distance after its subtraction
constexpr double same_place = 1e-6;  // of the roller's radius

/// From the roller's axis, which goes on by a radius beyond either end but not through the cam to its far
/// side.
double distance_from(const CamFlanks& follower, const RollerAxis& axis, const Vector3d& point) {
    const double radius = follower.roller_radius;
    const Vector3d from_foot = point - axis.foot;
    const double along = std::clamp(from_foot.dot(axis.direction), -radius, follower.roller_length + radius);
    return (from_foot - along * axis.direction).norm();
}

constexpr int section_points = 2000;
constexpr int play_angles = 361;

/// Where a roller narrower than its groove can be moved to between all sections of both flanks: one of them
/// stops it on either side. `input` is that of a roller that fills the groove.
ForwardCheckReport::Play play_between(const SpatialForwardCheckInput& input) {
    CamFlanks roller = input.follower;
    roller.roller_radius -= 0.5 * roller.clearance;
    std::vector<FlankContact> flanks;
    for (const auto& section : input.sections)
        flanks.emplace_back(roller, section, input.breaks, input.designed(input.begin));
    ForwardCheckReport::Play play{HUGE_VAL, -HUGE_VAL, 0.0, 0.0, {}};
    for (int i = 0; i < play_angles; ++i) {
        const double theta = input.begin + (input.end - input.begin) * (i + 0.5) / play_angles;
        const double designed = input.designed(theta);
        double back = -HUGE_VAL, on = HUGE_VAL;
        for (FlankContact& flank : flanks) {
            const FlankContact::Stand stand = flank.at(theta);
            if (stand.at_end) continue;
            if (stand.s < designed)
                back = std::max(back, stand.s);
            else
                on = std::min(on, stand.s);
        }
        if (!std::isfinite(on - back)) continue;
        if (on - back < play.least) play.least = on - back, play.least_at = theta;
        if (on - back > play.largest) play.largest = on - back, play.largest_at = theta;
    }
    return play;
}

}  // namespace

void SpatialForwardCheckInput::validate() const {
    if (!designed) throw InputError("a forward check needs the designed motion");
    if (sections.empty()) throw InputError("a forward check needs at least one section of a flank");
    if (angles < 2) throw InputError(fmt::format("a forward check of {} angles: at least 2", angles));
    if (!(end > begin)) throw InputError(fmt::format("a forward check from {} to {} rad", begin, end));
    for (const auto& section : sections)
        for (const Eigen::Vector3d& point : section)
            if (!point.allFinite())
                throw InputError("a forward check takes finite points only, and one is not");
}

std::vector<std::vector<Eigen::Vector3d>> sections_of(const FlankGrid& grid) {
    std::vector<std::vector<Eigen::Vector3d>> sections;
    const auto width = static_cast<std::ptrdiff_t>(grid.angles.size());
    for (const FlankSurface& flank : grid.flanks)
        for (std::size_t i = 0; i < grid.heights.size(); ++i) {
            const auto first = flank.points.begin() + static_cast<std::ptrdiff_t>(grid.index(i, 0));
            sections.emplace_back(first, first + width);
        }
    return sections;
}

SpatialForwardCheckResult spatial_forward_check(const SpatialForwardCheckInput& input) {
    const Stopwatch watch;
    input.validate();
    SpatialForwardCheckResult result;
    result.points = static_cast<int>(input.sections.front().size());
    for (std::size_t i = 0; i < input.sections.size(); ++i) check_section(input, i, result);
    if (result.angles == 0) result.deviation = std::numeric_limits<double>::infinity();
    result.seconds = watch.seconds();
    return result;
}

FlankContact::FlankContact(const CamFlanks& follower, std::span<const Vector3d> points,
                           std::span<const int> breaks, double s)
    : follower_(follower), curve_(points, breaks, false), s_(s) {
    for (const double node : curve_.nodes()) places_.push_back(curve_.at(node));
}

FlankContact::Nearest FlankContact::nearest(double theta, double s) {
    const RollerAxis axis = follower_.axis(theta, s);
    const auto at_place = [&](std::size_t i) { return distance_from(follower_, axis, places_[i]); };
    const auto on_curve = [&](double parameter) {
        return distance_from(follower_, axis, curve_.at(parameter));
    };
    if (!placed_) {
        // Of a groove that closes, begin and end are one place but for rounding: it is followed from the
        // begin on.
        const double same = same_place * follower_.roller_radius;
        for (std::size_t i = 0; i < places_.size(); ++i)
            if (at_place(i) < at_place(place_) - same) place_ = i;
        placed_ = true;
    }
    while (place_ + 1 < places_.size() && at_place(place_ + 1) < at_place(place_)) ++place_;
    while (place_ > 0 && at_place(place_ - 1) < at_place(place_)) --place_;
    const std::vector<double>& nodes = curve_.nodes();
    const double low = nodes[place_ > 0 ? place_ - 1 : 0],
                 high = nodes[std::min(place_ + 1, nodes.size() - 1)];
    const auto nearness = [&](double parameter) { return -on_curve(parameter); };
    const double end = at_place(place_), inner = -golden_maximum(nearness, low, high, section_steps).value();
    const bool is_end = place_ == 0 || place_ + 1 == places_.size();
    return {std::min(end, inner), is_end && end <= inner};
}

FlankContact::Stand FlankContact::at(double theta) {
    const double radius = follower_.roller_radius;
    const double step = follower_.swings ? first_step : first_step * radius;
    double before = s_ + step, s = s_;
    double gap_before = nearest(theta, before).distance - radius;
    Nearest found = nearest(theta, s);
    double gap = found.distance - radius;
    for (int i = 0; i < most_secants && std::abs(gap) > enough && gap != gap_before; ++i) {
        const double next = s - gap * (s - before) / (gap - gap_before);
        if (!std::isfinite(next)) break;
        before = std::exchange(s, next);
        gap_before = gap;
        found = nearest(theta, s);
        gap = found.distance - radius;
    }
    // Rounding in the coordinates is what may be left.
    if (!(std::abs(gap) < 1e-12 * (1.0 + radius))) return {std::numeric_limits<double>::quiet_NaN(), false};
    s_ = s;
    return {s, found.at_end};
}

FollowerMotion follower_motion(const Motion& motion, const MotionScale& scale) {
    FollowerMotion result;
    result.state = [&motion, scale](double theta) {
        const double x = std::clamp(theta / scale.unit_angle, motion.begin(), motion.end());
        return state_of(motion_at(motion, x), scale);
    };
    for (const double x : motion.breakpoints()) result.breakpoints.push_back(scale.unit_angle * x);
    return result;
}

bool has_flanks(const Solution& solution) {
    const std::optional<CamSpec>& cam = solution.scene.cam;
    return cam && cam->formulas()->flanks(cam->middle()).has_value();
}

CamFlanks solved_flanks(const Solution& solution) {
    std::optional<CamFlanks> flanks;
    if (solution.cam) flanks = solution.cam->cam.formulas->flanks(solution.cam->cam.dimensions);
    if (!flanks) throw InputError("a three-dimensional cam is needed, and this solution has none");
    if (solution.scene.drawing) flanks->body.bore = solution.scene.drawing->bore;
    return *std::move(flanks);
}

ForwardCheckReport check_flanks(const Solution& solution, std::optional<int> points) {
    const CamFlanks cam = solved_flanks(solution);
    const MotionScale scale = motion_scale(solution.scene);
    const MotionChain motion = whole_turn(solution);
    const FollowerMotion turn = follower_motion(motion, scale);
    const FlankGrid grid =
        flank_grid(cam, turn, FlankSampling{.sections = 2, .angles = points.value_or(section_points)});
    SpatialForwardCheckInput input;
    input.sections = sections_of(grid);
    input.breaks = grid.breaks;
    input.follower = cam;
    input.designed = [&turn](double theta) { return turn.state(theta).s; };
    input.begin = turn.begin();
    input.end = turn.end();
    const SpatialForwardCheckResult result = spatial_forward_check(input);
    ForwardCheckReport report{result.deviation, result.deviation / scale.lift,
                              result.theta / scale.unit_angle, result.points, result.seconds};
    if (!(cam.clearance > 0.0)) return report;
    report.play = play_between(input);
    for (double* const at : {&report.play->least_at, &report.play->largest_at}) *at /= scale.unit_angle;
    return report;
}

}  // namespace camopt
