// SPDX-License-Identifier: MIT
#include "studies/cam_summary.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace camopt {

namespace {

struct Place {
    ProfilePoint point;
    FollowerState state;
};
using Figure = std::function<double(const Place&)>;

class Turn {
 public:
    Turn(const DiskCam& cam, const Motion& motion, const MotionScale& scale)
        : cam_(cam), motion_(motion), scale_(scale), points_(motion.breakpoints()) {}

    [[nodiscard]] CamExtreme largest(const Figure& figure) const {
        return largest_along(points_, [&](double x, Side side) { return value_at(figure, x, side); });
    }
    [[nodiscard]] CamExtreme least(const Figure& figure) const {
        return least_along(points_, [&](double x, Side side) { return value_at(figure, x, side); });
    }

 private:
    const DiskCam& cam_;
    const Motion& motion_;
    MotionScale scale_;
    std::vector<double> points_;

    [[nodiscard]] double value_at(const Figure& figure, double x, Side side) const {
        const FollowerState state = state_of(motion_.at(x, side), scale_);
        return figure({profile_point(cam_, x * scale_.unit_angle, state), state});
    }
};

ForceSummary force_summary(const DiskCam& cam, const Turn& turn, const ForceSpec& forces, double speed) {
    const auto force = [&](const Place& place) {
        return forces.force(speed, place.state.s, place.state.acceleration);
    };
    const auto lever = [&](const Place& place) {
        return quantity(cam, place.state, Quantity::normal_lever).value;
    };
    ForceSummary summary;
    summary.least_force = turn.least(force);
    summary.largest_force = turn.largest(force);
    summary.torque =
        turn.largest([&](const Place& place) { return std::abs(force(place) * place.state.velocity); });
    summary.normal_force = turn.largest([&](const Place& place) { return force(place) / lever(place); });
    if (!forces.contact_width || cam.follower == FollowerType::translating_knife) return summary;
    summary.hertz_pressure = turn.largest([&](const Place& place) {
        const double curvature = has_roller(cam.follower)
                                     ? 1.0 / (cam[DimensionIndex::roller_radius] * place.point.regularity)
                                     : 1.0 / place.point.cam_radius;
        const double squared = force(place) / lever(place) * curvature /
                               (forces.compliance() * std::numbers::pi * *forces.contact_width);
        return squared > 0.0 ? std::sqrt(squared) : 0.0;
    });
    return summary;
}

}  // namespace

CamSummary cam_summary(const DiskCam& cam, const Motion& motion, const Scene& scene) {
    const Turn turn(cam, motion, {scene.motion.lift, scene.motion.unit_angle()});
    const auto angle = [](const Place& place) { return std::abs(place.point.pressure_angle); };
    CamSummary summary;
    summary.pressure_angle = turn.largest(angle);
    summary.rise_pressure_angle =
        turn.largest([&](const Place& place) { return place.state.velocity > 0.0 ? angle(place) : 0.0; });
    summary.return_pressure_angle =
        turn.largest([&](const Place& place) { return place.state.velocity < 0.0 ? angle(place) : 0.0; });
    if (has_flat_face(cam.follower)) {
        summary.convex_radius = turn.least([](const Place& place) { return place.point.cam_radius; });
        summary.contact_offset =
            turn.largest([](const Place& place) { return std::abs(place.point.contact_offset); });
    } else {
        // Radii of the cam follow from the pitch curve's: the curvature is smooth where a radius is not.
        const double roller = has_roller(cam.follower) ? cam[DimensionIndex::roller_radius] : 0.0;
        const auto curvature = [](const Place& place) { return place.point.pitch_curvature; };
        const CamExtreme sharpest = turn.largest(curvature);
        summary.convex_radius = {1.0 / std::max(sharpest.value, 1e-300) - roller, sharpest.at};
        const CamExtreme hollow = turn.least(curvature);
        if (hollow.value < 0.0) summary.concave_radius = CamExtreme{roller - 1.0 / hollow.value, hollow.at};
    }
    summary.regularity = turn.least([](const Place& place) { return place.point.regularity; });
    if (scene.forces && scene.motion.speed) {
        summary.forces = force_summary(cam, turn, *scene.forces, *scene.motion.speed);
    }
    return summary;
}

}  // namespace camopt
