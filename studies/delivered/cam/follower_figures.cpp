// SPDX-License-Identifier: MIT
#include "studies/delivered/cam/follower_figures.hpp"

#include "core/infinity.hpp"
#include "objectives/rules/rest_places.hpp"
#include "profiles/disk/disk_mechanism.hpp"
#include "profiles/disk/disk_sides.hpp"
#include "studies/delivered/cam/cam_turn.hpp"
#include "studies/delivered/cam/follower_loads.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace camopt {

namespace {

// Of the mean velocity: what is slower rests.
constexpr double at_rest = 1e-9;

struct ForcedMotion {
    const ForceSpec& forces;
    double speed = 0.0;
};

/// Where one side carries: 0 elsewhere.
void add_side_loads(SideSummary& side, int station, const DiskCam& cam, const CamTurn& turn,
                    const ForcedMotion& forced) {
    const auto normal = [&](const CamPlace& place) {
        const double force = forced.forces.force(forced.speed, place.state.s, place.state.acceleration);
        return std::max(0.0, normal_force(cam, place.state, force, station));
    };
    side.normal_force = turn.largest(normal, station);
    if (!has_hertz_pressure(cam, forced.forces)) return;
    side.hertz_pressure = turn.largest(
        [&](const CamPlace& place) {
            return hertz_pressure(cam, forced.forces, place.point, normal(place), station);
        },
        station);
}

/// The larger of the two sides, each of which carries a part of the turn.
void set_largest_loads(ForceSummary& summary, const std::vector<SideSummary>& sides) {
    const auto larger = [](std::optional<CamExtreme>& largest, const std::optional<CamExtreme>& one) {
        if (one && (!largest || one->value > largest->value)) largest = one;
    };
    for (const SideSummary& side : sides) {
        larger(summary.normal_force, side.normal_force);
        larger(summary.hertz_pressure, side.hertz_pressure);
    }
}

ForceSummary force_summary(const DiskCam& cam, const CamTurn& turn, const ForcedMotion& forced,
                           CamSummary& of) {
    const std::optional<double>& no_contact = of.no_contact;
    const ForceSpec& forces = forced.forces;
    const double speed = forced.speed;
    const auto force = [&](const CamPlace& place) {
        return forces.force(speed, place.state.s, place.state.acceleration);
    };
    const auto normal = [&](const CamPlace& place) { return normal_force(cam, place.state, force(place)); };
    ForceSummary summary;
    summary.least_force = turn.least(force);
    summary.largest_force = turn.largest(force);
    summary.torque =
        turn.largest([&](const CamPlace& place) { return std::abs(force(place) * place.state.velocity); });
    const bool presses = has_hertz_pressure(cam, forces);
    if (no_contact) {
        // Formulas would go on with a negative radius or lever; there is no pressure to speak of.
        summary.normal_force = CamExtreme{infinity, *no_contact};
        if (presses) summary.hertz_pressure = summary.normal_force;
        for (SideSummary& side : of.sides) {
            side.normal_force = summary.normal_force;
            side.hertz_pressure = summary.hertz_pressure;
        }
        return summary;
    }
    if (!of.sides.empty()) {
        for (std::size_t i = 0; i < of.sides.size(); ++i)
            add_side_loads(of.sides[i], static_cast<int>(i), cam, turn, forced);
        set_largest_loads(summary, of.sides);
        return summary;
    }
    summary.normal_force = turn.largest(normal);
    if (!presses) return summary;
    summary.hertz_pressure = turn.largest(
        [&](const CamPlace& place) { return hertz_pressure(cam, forces, place.point, normal(place)); });
    if (of.cusp()) summary.hertz_pressure = CamExtreme{infinity, of.regularity.at};
    return summary;
}

/// Where 1 + σψ' of an oscillating flat face is least.
CamExtreme least_turning(const DiskCam& cam, const CamTurn& turn) {
    const double sense = sense_of(cam.rotation);
    return turn.least([sense](const CamPlace& place) { return 1.0 + sense * place.state.velocity; });
}

/// A face that turns back has no radius and no place of contact there: the formulas pass through infinity.
void set_turning_back(CamSummary& summary, const CamExtreme& turning) {
    summary.regularity = turning;
    summary.convex_radius = CamExtreme{-infinity, turning.at};
    summary.contact_offset = CamExtreme{infinity, turning.at};
}

std::optional<double> place_without_contact(const DiskCam& cam, const CamTurn& turn,
                                            const CamSummary& summary) {
    if (summary.undercut()) return summary.regularity.at;
    for (int side = 0; side < side_count(cam); ++side) {
        const CamExtreme height = turn.least(
            [&](const CamPlace& place) {
                return quantity(cam, place.state, MechanismQuantity::pressure_denominator, side).value;
            },
            side);
        if (!(height.value > 0.0)) return height.at;
    }
    return {};
}

CamExtreme rest_pressure(const CamTurn& turn, const Scene& scene) {
    CamExtreme worst;
    for (const double x : rest_places(scene)) {
        const double angle = turn.pressure_angle_at_rest(x);
        if (angle > worst.value) worst = {angle, x};
    }
    return worst;
}

}  // namespace

void add_follower_figures(CamSummary& summary, const DrivenMechanism& mechanism, const CamTurn& turn,
                          const Scene& scene) {
    const std::optional<DiskCam> cam = disk_cam(mechanism);
    if (!cam) return;
    const auto angle = [](const CamPlace& place) { return std::abs(place.point.pressure_angle); };
    const double still = at_rest * scene.motion.lift / scene.motion.unit_angle();
    summary.rise_pressure_angle = turn.largest(
        [&](const CamPlace& place) { return place.state.velocity > still ? angle(place) : 0.0; });
    summary.return_pressure_angle = turn.largest(
        [&](const CamPlace& place) { return place.state.velocity < -still ? angle(place) : 0.0; });
    summary.rest_pressure_angle = rest_pressure(turn, scene);
    if (has_turning_face(cam->follower)) {
        const CamExtreme turning = least_turning(*cam, turn);
        if (!(turning.value > 0.0)) set_turning_back(summary, turning);
    }
    summary.no_contact = place_without_contact(*cam, turn, summary);
    if (scene.forces && scene.motion.speed)
        summary.forces = force_summary(*cam, turn, {*scene.forces, *scene.motion.speed}, summary);
}

}  // namespace camopt
