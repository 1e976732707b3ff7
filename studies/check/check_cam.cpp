// SPDX-License-Identifier: MIT
#include "studies/check/check_cam.hpp"

#include "studies/check/point_curve.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

constexpr int follower_points = 2000, linkage_points = 6000;

constexpr int width_sections = 34;  // golden sections: to 1e-7 of a step, of whose square a distance depends

using Sides = std::array<ForwardCheckInput, 2>;
using Found = std::array<ForwardCheckResult, 2>;

Sides sides_with(const DrivenMechanism& mechanism, const Motion& motion, const MotionScale& scale, int points,
                 const std::array<double, 2>& rollers) {
    return {side_check_input(mechanism, motion, scale, {0, points, rollers[0]}),
            side_check_input(mechanism, motion, scale, {1, points, rollers[1]})};
}

Found run(const Sides& sides) {
    return {forward_check(sides[0]), forward_check(sides[1])};
}

double roller_radius(const DrivenMechanism& mechanism, int station) {
    return mechanism.dimensions[static_cast<std::size_t>(mechanism.formulas->roller_radius_at(station))];
}

double angle_of(const ForwardCheckInput& input, std::size_t index) {
    return input.begin + (input.end - input.begin) * (static_cast<double>(index) + 0.5) / input.angles;
}

/// Between the lift that side 0 keeps the follower above and the one that side 1 keeps it below.
ForwardCheckReport::Play play_of(const Sides& sides, const Found& found, double unit_angle) {
    ForwardCheckReport::Play play{infinity, -infinity, 0.0, 0.0, std::nullopt};
    for (std::size_t i = 0; i < found[0].found.size(); ++i) {
        const double free = found[1].found[i] - found[0].found[i];
        const double at = angle_of(sides[0], i) / unit_angle;
        if (free < play.least) play.least = free, play.least_at = at;
        if (free > play.largest) play.largest = free, play.largest_at = at;
    }
    return play;
}

}  // namespace

ForwardCheckReport check_cam(const Solution& solution, std::optional<int> points) {
    if (!solution.cam) throw InputError("the forward check needs a cam, and this solution has none");
    const DrivenMechanism& cam = solution.cam->cam;
    const MotionChain motion = cam_motion(solution);
    const MotionScale scale = motion_scale(solution.scene);
    const std::optional<FollowerGeometry> follower = cam.formulas->follower(cam.dimensions, 0);
    const int count = points.value_or(follower && follower->linkage ? linkage_points : follower_points);
    if (cam.formulas->stations() > 1) return two_sided_check(cam, motion, scale, count);
    const ForwardCheckResult result = forward_check(forward_check_input(cam, motion, scale, count));
    return {result.deviation, result.relative, result.theta / scale.unit_angle, result.points,
            result.seconds};
}

double least_width(const ForwardCheckInput& inner, const ForwardCheckInput& outer) {
    const PointCurve curve(outer.points, outer.breaks, outer.closed);
    const std::vector<double>& nodes = curve.nodes();
    double least = infinity;
    for (const Eigen::Vector2d& from : inner.points) {
        const auto nearer = [&](double parameter) { return -(curve.at(parameter) - from).norm(); };
        std::size_t nearest = 0;
        double best = -infinity;
        for (std::size_t i = 0; i < outer.points.size() && i < nodes.size(); ++i) {
            const double distance = -(outer.points[i] - from).squaredNorm();
            if (distance > best) best = distance, nearest = i;
        }
        const double low = nodes[nearest > 0 ? nearest - 1 : nearest],
                     high = nodes[std::min(nearest + 1, nodes.size() - 1)];
        least = std::min(least, -golden_maximum(nearer, low, high, width_sections).value());
        least = std::min(least, std::sqrt(-best));
    }
    return least;
}

ForwardCheckReport two_sided_check(const DrivenMechanism& mechanism, const Motion& motion,
                                   const MotionScale& scale, int points) {
    const CamMechanism& formulas = *mechanism.formulas;
    if (formulas.stations() < 2)
        throw InputError(
            "a check of both sides needs a groove or a conjugate cam, and this cam has one side");
    const std::array<double, 2> fill = {formulas.surface_offset(mechanism.dimensions, 0),
                                        formulas.surface_offset(mechanism.dimensions, 1)};
    const Sides filling = sides_with(mechanism, motion, scale, points, fill);
    Found found = run(filling);
    const ForwardCheckResult& worst = found[0].deviation >= found[1].deviation ? found[0] : found[1];
    ForwardCheckReport report{worst.deviation, std::max(found[0].relative, found[1].relative),
                              worst.theta / scale.unit_angle, found[0].points,
                              found[0].seconds + found[1].seconds};
    const std::array<double, 2> rollers = {roller_radius(mechanism, 0), roller_radius(mechanism, 1)};
    if (rollers == fill) {
        report.play = play_of(filling, found, scale.unit_angle);
    } else {
        const Sides own = sides_with(mechanism, motion, scale, points, rollers);
        const Found loose = run(own);
        report.seconds += loose[0].seconds + loose[1].seconds;
        report.play = play_of(own, loose, scale.unit_angle);
    }
    if (filling[1].follower.from_inside)
        report.play->least_groove_width = least_width(filling[0], filling[1]);
    return report;
}

void add_forward_check(Solution& solution, ForwardCheckReport (*check)(const Solution&, std::optional<int>)) {
    if (!solution.cam) return;
    try {
        solution.cam->forward_check = check(solution, {});
    } catch (const InputError& error) {
        solution.notes.push_back(fmt::format("the forward check could not run: {}", error.what()));
    }
}

}  // namespace camopt
