// SPDX-License-Identifier: MIT
#include "studies/inverse/inverse_forward.hpp"

#include "scene/cam_flanks.hpp"
#include "studies/check/point_curve.hpp"
#include "studies/delivered/delivered.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

using Eigen::Vector2d;

constexpr double nowhere = std::numeric_limits<double>::infinity();
constexpr int most_steps = 60;

void validate(const GuideCheckInput& input) {
    if (input.points.size() < 3)
        throw InputError(
            fmt::format("{} points of the guide were given; it needs at least 3", input.points.size()));
    if (input.places < 2 || !(input.end > input.begin) || !input.designed)
        throw InputError(
            "the check of a guide needs 2 positions or more, between a begin and a larger end, and the "
            "design");
    for (const Vector2d& point : input.points)
        if (!point.allFinite()) throw InputError("a point of the guide is not a finite number");
}

/// Runs over the places; `found` gives psi there from the one before, NaN where there is none.
template <class Found>
GuideCheckResult checked(const GuideCheckInput& input, const Found& found) {
    const Stopwatch watch;
    GuideCheckResult result;
    result.points = static_cast<int>(input.points.size());
    double angle = input.designed(input.begin);
    for (int i = 0; i < input.places; ++i) {
        const double distance = input.begin + (input.end - input.begin) * i / (input.places - 1);
        angle = found(distance, angle);
        const double deviation = std::abs(angle - input.designed(distance));
        if (deviation <= result.deviation) continue;
        result.deviation = !std::isnan(deviation) ? deviation : nowhere;
        result.distance = distance;
        if (std::isnan(deviation)) break;
    }
    result.seconds = watch.seconds();
    return result;
}

/// The wall under a roller: how far the roller's centre is from it, near the contact of before.
class Wall {
 public:
    explicit Wall(const GuideCheckInput& input) : curve_(input.points, input.breaks, false) {
        reach_ = 4.0 * curve_.length() / static_cast<double>(input.points.size());
        near_ = nearest_node(input.begin * Vector2d(std::cos(input.designed(input.begin)),
                                                    std::sin(input.designed(input.begin))));
    }

    [[nodiscard]] double distance_to(const Vector2d& center) {
        // Walk until the least distance lies inside the bracket, then narrow it down by the golden section.
        constexpr double narrow = 1e-9;  // relative: the distance is flat there
        constexpr int many = 200;        // far more than that takes
        const GoldenSection nearest = golden_maximum(
            [&](double parameter) { return -gap(center, parameter); }, near_ - reach_, near_ + reach_, many,
            [&](const GoldenSection& now) { return now.high - now.low <= narrow * curve_.length(); });
        last_ = 0.5 * (nearest.low + nearest.high);
        return std::sqrt(-nearest.value());
    }

    /// The next contact is searched around the last one.
    void keep() { near_ = last_; }
    void widen(double by) { reach_ = std::max(reach_, by); }

 private:
    [[nodiscard]] double gap(const Vector2d& center, double parameter) const {
        return (curve_.at(parameter) - center).squaredNorm();
    }

    [[nodiscard]] double nearest_node(const Vector2d& center) const {
        double best = nowhere, place = 0.0;
        for (const double node : curve_.nodes()) {
            const double here = gap(center, node);
            if (here >= best) continue;
            best = here;
            place = node;
        }
        return place;
    }

    PointCurve curve_;
    double reach_ = 0.0, near_ = 0.0, last_ = 0.0;
};

/// psi at which the roller touches: secant from the angle before.
double contact_angle(Wall& wall, double distance, double before, double radius) {
    constexpr double settled = 1e-15;
    const auto miss = [&](double angle) {
        return wall.distance_to(distance * Vector2d(std::cos(angle), std::sin(angle))) - radius;
    };
    double a = before, b = before + 1e-4 * radius / distance, at_a = miss(a), at_b = miss(b);
    for (int step = 0; step < most_steps; ++step) {
        if (at_a == at_b) break;
        const double next = b - at_b * (b - a) / (at_b - at_a);
        a = b;
        at_a = at_b;
        b = next;
        at_b = miss(b);
        if (std::abs(b - a) < settled) break;
    }
    wall.keep();
    constexpr double touching = 1e-9;  // of the radius: else no contact was found
    return std::abs(at_b) < touching * radius ? b : std::nan("");
}

constexpr int walls = 2;
constexpr int wall_points = 2000;  // of each
constexpr double margin = 1e-3;    // of the stroke: there the roller leaves the wall that is made

/// The guide of the solved scene and the motion that it shall make.
struct DrivenGuide {
    RollerGuide guide;
    const Motion* motion = nullptr;
    MotionScale scale;

    [[nodiscard]] double cam_angle(double distance) const {
        return std::clamp(guide.cam_angle(distance), scale.unit_angle * motion->begin(),
                          scale.unit_angle * motion->end());
    }
    [[nodiscard]] double angle(double distance) const {
        const double x = std::clamp(cam_angle(distance) / scale.unit_angle, motion->begin(), motion->end());
        return guide.angle(state_of(motion_at(*motion, x), scale));
    }
    /// |dY/dpsi|, m/rad.
    [[nodiscard]] double ratio(double distance) const { return guide.ratio(angle(distance)); }
};

}  // namespace

GuideCheckResult slot_check(const GuideCheckInput& input) {
    validate(input);
    if (!(input.roller_radius > 0.0))
        throw InputError(fmt::format("the roller's radius is {} m; it must be > 0", input.roller_radius));
    Wall wall(input);
    wall.widen(2.0 * (input.end - input.begin) / (input.places - 1));
    return checked(input, [&](double distance, double before) {
        return contact_angle(wall, distance, before, input.roller_radius);
    });
}

ForwardCheckReport check_guide(const Solution& solution, std::optional<int> points) {
    std::optional<RollerGuide> guide;
    if (solution.cam) guide = solution.cam->cam.formulas->guide(solution.cam->cam.dimensions);
    if (!guide) throw InputError("a cam with a guide is needed, and this solution has none");
    const MotionChain motion = cam_motion(solution);
    const DrivenGuide driven{*guide, &motion, motion_scale(solution.scene)};
    const double begin = guide->distance(driven.scale.unit_angle * motion.begin());
    const double end = guide->distance(driven.scale.unit_angle * motion.end());
    GuideCheckInput input;
    input.designed = [&driven](double distance) { return driven.angle(distance); };
    input.begin = begin + margin * (end - begin);
    input.end = end - margin * (end - begin);
    const int count = points.value_or(wall_points);
    input.places = count;
    input.roller_radius = guide->roller_radius;
    ForwardCheckReport report;
    for (int wall = 0; wall < walls; ++wall) {
        const MechanismProfile profile =
            mechanism_profile(solution.cam->cam, motion, driven.scale, count, wall);
        input.points.clear();
        for (const MechanismPoint& point : profile.points) input.points.emplace_back(point.contact.head<2>());
        input.breaks = profile.breaks;
        const GuideCheckResult found = slot_check(input);
        report.points += found.points;
        report.seconds += found.seconds;
        const double deviation = found.deviation * driven.ratio(found.distance);
        if (wall > 0 && deviation <= report.deviation) continue;
        report.deviation = deviation;
        report.relative = deviation / driven.scale.lift;
        report.at = driven.cam_angle(found.distance) / driven.scale.unit_angle;
    }
    return report;
}

}  // namespace camopt
