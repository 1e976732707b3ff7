// SPDX-License-Identifier: MIT
#include "studies/delivered/cam_summary.hpp"

#include "core/nlp.hpp"
#include "objectives/rules/rest_places.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace camopt {

namespace {

// Of the mean velocity: what is slower rests.
constexpr double at_rest = 1e-9;

struct Place {
    ProfilePoint point;
    FollowerState state;
};
using Figure = std::function<double(const Place&)>;

class DiskTurn {
 public:
    DiskTurn(const DiskCam& cam, const Motion& motion, const MotionScale& scale)
        : cam_(cam), motion_(motion), scale_(scale), points_(motion.breakpoints()) {}

    [[nodiscard]] CamExtreme largest(const Figure& figure) const {
        return largest_along(points_, [&](double x, Side side) { return value_at(figure, x, side); });
    }
    [[nodiscard]] CamExtreme least(const Figure& figure) const {
        return least_along(points_, [&](double x, Side side) { return value_at(figure, x, side); });
    }
    /// With s' = 0 put in, whatever rounding made of it; |φ|.
    [[nodiscard]] double pressure_angle_at(double x) const {
        FollowerState state = state_of(motion_.at(x, x < motion_.end() ? Side::right : Side::left), scale_);
        state.velocity = 0.0;
        return std::abs(profile_point(cam_, x * scale_.unit_angle, state).pressure_angle);
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

struct ForcedMotion {
    const ForceSpec& forces;
    double speed = 0.0;
};

ForceSummary force_summary(const DiskCam& cam, const DiskTurn& turn, const ForcedMotion& forced,
                           const std::optional<double>& no_contact) {
    const ForceSpec& forces = forced.forces;
    const double speed = forced.speed;
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
    const bool presses = forces.contact_width && !has_edge(cam.follower);
    if (no_contact) {
        // Formulas would go on with a negative radius or lever; there is no pressure to speak of.
        summary.normal_force = CamExtreme{infinity, *no_contact};
        if (presses) summary.hertz_pressure = summary.normal_force;
        return summary;
    }
    summary.normal_force = turn.largest([&](const Place& place) { return force(place) / lever(place); });
    if (!presses) return summary;
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

/// Where 1 + σψ' of an oscillating flat face is least.
CamExtreme least_turning(const DiskCam& cam, const DiskTurn& turn) {
    const double sense = sense_of(cam.rotation);
    return turn.least([sense](const Place& place) { return 1.0 + sense * place.state.velocity; });
}

/// A face that turns back has no radius and no place of contact there: the formulas pass through infinity.
void set_turning_back(CamSummary& summary, const CamExtreme& turning) {
    summary.regularity = turning;
    summary.convex_radius = {-infinity, turning.at};
    summary.contact_offset = {infinity, turning.at};
}

std::optional<double> place_without_contact(const DiskCam& cam, const DiskTurn& turn,
                                            const CamSummary& summary) {
    if (summary.undercut()) return summary.regularity.at;
    const CamExtreme height = turn.least(
        [&](const Place& place) { return quantity(cam, place.state, Quantity::pressure_denominator).value; });
    if (!(height.value > 0.0)) return height.at;
    return {};
}

CamExtreme rest_pressure(const DiskTurn& turn, const Scene& scene) {
    CamExtreme worst;
    for (const double x : rest_places(scene)) {
        const double angle = turn.pressure_angle_at(x);
        if (angle > worst.value) worst = {angle, x};
    }
    return worst;
}

}  // namespace

CamSummary cam_summary(const DiskCam& cam, const Motion& motion, const Scene& scene) {
    const DiskTurn turn(cam, motion, {scene.motion.lift, scene.motion.unit_angle()});
    const auto angle = [](const Place& place) { return std::abs(place.point.pressure_angle); };
    CamSummary summary;
    summary.pressure_angle = turn.largest(angle);
    const double still = at_rest * scene.motion.lift / scene.motion.unit_angle();
    summary.rise_pressure_angle =
        turn.largest([&](const Place& place) { return place.state.velocity > still ? angle(place) : 0.0; });
    summary.return_pressure_angle =
        turn.largest([&](const Place& place) { return place.state.velocity < -still ? angle(place) : 0.0; });
    summary.rest_pressure_angle = rest_pressure(turn, scene);
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
    if (has_turning_face(cam.follower)) {
        const CamExtreme turning = least_turning(cam, turn);
        if (!(turning.value > 0.0)) set_turning_back(summary, turning);
    }
    summary.no_contact = place_without_contact(cam, turn, summary);
    if (scene.forces && scene.motion.speed) {
        summary.forces = force_summary(cam, turn, {*scene.forces, *scene.motion.speed}, summary.no_contact);
    }
    return summary;
}

}  // namespace camopt
