// SPDX-License-Identifier: MIT
#include "studies/inverse/solved_guide.hpp"

#include "core/errors.hpp"
#include "profiles/inverse/inverse_feeder.hpp"
#include "profiles/inverse/inverse_mechanism.hpp"
#include "profiles/inverse/inverse_spec.hpp"
#include "profiles/sampling.hpp"
#include "studies/check/check_cam.hpp"
#include "studies/delivered/driven_mechanism.hpp"
#include "studies/inverse/inverse_forward.hpp"

#include <algorithm>
#include <cmath>

namespace camopt {

namespace {

constexpr int walls = 2;
constexpr int wall_points = 2000;  // of each
constexpr double margin = 1e-3;    // of the stroke: there the roller leaves the wall that is made

/// The machine of the solved scene and the motion it shall have.
struct Machine {
    FeederLinkage linkage;
    RollerStroke stroke;
    double feeder_start = 0.0;
    const Motion* motion = nullptr;
    MotionScale scale;

    [[nodiscard]] double angle_at(double distance) const {
        return std::clamp(time_at(stroke, distance), scale.unit_angle * motion->begin(),
                          scale.unit_angle * motion->end());
    }
    [[nodiscard]] FollowerState feeder_at(double distance) const {
        const double x = std::clamp(angle_at(distance) / scale.unit_angle, motion->begin(), motion->end());
        FollowerState feeder = state_of(motion->at(x, x < motion->end() ? Side::right : Side::left), scale);
        feeder.s += feeder_start;
        return feeder;
    }
    [[nodiscard]] double guide_angle(double distance) const {
        return -body_motion(linkage, feeder_at(distance)).body.angle;
    }
    /// |dY/dpsi|, m/rad.
    [[nodiscard]] double ratio(double distance) const {
        return std::abs(feeder_motion(linkage, {-guide_angle(distance), 1.0, 0.0}).feeder.velocity);
    }
};

Machine machine_of(const Solution& solution, const Motion& motion) {
    const std::vector<double>& numbers = solution.cam->cam.dimensions;
    return {linkage_of(numbers), stroke_of(numbers),
            numbers.at(static_cast<std::size_t>(InverseNumber::feeder_start)), &motion,
            motion_scale(solution.scene)};
}

}  // namespace

ForwardCheckReport check_inverse_cam(const Solution& solution, std::optional<int> points) {
    if (!solution.cam || !solution.cam->cam.formulas->has_guide())
        throw InputError("an inverse cam is needed, and this solution has none");
    const MotionChain motion = cam_motion(solution);
    const Machine machine = machine_of(solution, motion);
    const std::vector<double>& numbers = solution.cam->cam.dimensions;
    const double begin = state_of(machine.stroke, machine.scale.unit_angle * motion.begin()).distance;
    const double end = state_of(machine.stroke, machine.scale.unit_angle * motion.end()).distance;
    GuideCheckInput input;
    input.designed = [&machine](double distance) { return machine.guide_angle(distance); };
    input.begin = begin + margin * (end - begin);
    input.end = end - margin * (end - begin);
    const int count = points.value_or(wall_points);
    input.places = count;
    input.roller_radius = numbers.at(static_cast<std::size_t>(InverseNumber::roller_radius));
    ForwardCheckReport report;
    for (int wall = 0; wall < walls; ++wall) {
        const MechanismProfile profile =
            mechanism_profile(solution.cam->cam, motion, machine.scale, count, wall);
        input.points.clear();
        for (const MechanismPoint& point : profile.points) input.points.push_back(point.contact.head<2>());
        input.breaks = profile.breaks;
        const GuideCheckResult found = slot_check(input);
        report.points += found.points;
        report.seconds += found.seconds;
        const double deviation = found.deviation * machine.ratio(found.distance);
        if (wall > 0 && deviation <= report.deviation) continue;
        report.deviation = deviation;
        report.relative = deviation / machine.scale.lift;
        report.at = machine.angle_at(found.distance) / machine.scale.unit_angle;
    }
    return report;
}

}  // namespace camopt
