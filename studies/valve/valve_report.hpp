// SPDX-License-Identifier: MIT
// A delivered valve lobe in the words of engine builders. Lengths in m, at the valve unless said otherwise;
// crank angles in rad (two of the cam), counted from the nose.
#pragma once

#include "studies/delivered/solution.hpp"

namespace camopt {

/// Where the valve has a lift: the last place before the nose, and the first one after it.
struct ValveEvent {
    double height = 0.0;
    double opens = 0.0, closes = 0.0;  ///< crank angles: before the nose < 0
    double area = 0.0;                 ///< ∫ valve lift d(crank angle) between them, m rad

    [[nodiscard]] double duration() const { return closes - opens; }
};

/// What presses the follower on a part of the cam, where it is least.
struct ValveMargin {
    double least_force = 0.0;  ///< N, or N m of a swinging follower
    double at = 0.0;           ///< crank angle
    double share = 0.0;        ///< of spring, preload and load there
};
/// The nose lies between the places where the follower is fastest before and after its top; the flanks are
/// the rest.
struct ValveMargins {
    double engine_speed = 0.0;  ///< rad/s
    ValveMargin nose, flank;

    [[nodiscard]] const ValveMargin& least() const {
        return nose.least_force < flank.least_force ? nose : flank;
    }
};

struct ValveReport {
    /// By ascending height: the checking height, 0.05 in, 0.2 in, and 0.1 mm, 1 mm or, where lengths are in
    /// inches, 0.004 in, 0.006 in, 0.02 in; those below the lift.
    std::vector<ValveEvent> events;
    std::vector<std::pair<double, double>> tappet_durations;  ///< crank angle above a lift of the tappet
    double opening_velocity = 0.0, closing_velocity = 0.0;  ///< of the valve at lift 0, m/rad of the cam, > 0
    /// Of the follower by the cam angle, m/rad² or 1/rad: largest on each flank, and least (the nose's).
    double opening_acceleration = 0.0, closing_acceleration = 0.0, nose_acceleration = 0.0;
    std::optional<Extremum> nose_radius;   ///< least of the cam's surface on the nose, `at` a crank angle
    std::optional<double> contact_offset;  ///< largest on a flat face
    std::vector<ValveMargins> margins;     ///< with forces and a speed: at 0.5, 0.75, 1, 1.1, 1.25 of it
    std::optional<double>
        lift_off_speed;  ///< engine's, rad/s: no force is left; none up to ten times its own

    [[nodiscard]] const ValveEvent& at(double height) const;  ///< the nearest one
};

/// The scene is a valve lobe and has a motion.
[[nodiscard]] ValveReport valve_report(const Solution& solution);

/// Displacement of the follower as the lift of the valve: negative while the lash is open.
[[nodiscard]] double valve_lift_at(const Solution& solution, double x);
/// Crank angle from the nose, and back.
[[nodiscard]] double crank_angle_at(const Solution& solution, double x);
[[nodiscard]] double x_of_crank_angle(const Solution& solution, double crank);

/// Two valves whose axes meet the line between their nearest edges at 90° − included / 2, in one plane. Their
/// edges are `gap` apart when both are shut; lifts l, k leave √((gap − (l + k) sin(included / 2))² +
/// ((l − k) cos(included / 2))²) between them.
struct ValveGap {
    double gap = 0.0, included = 0.0;
};

/// Intake and exhaust on one crankshaft. Crank angles after top dead centre.
struct ValvePair {
    double lobe_separation = 0.0;  ///< between the noses, cam rad
    struct Overlap {
        double height = 0.0, opens = 0.0, closes = 0.0;                   ///< of the intake, of the exhaust
        [[nodiscard]] double duration() const { return closes - opens; }  ///< <= 0: none
    };
    std::vector<Overlap> overlaps;                     ///< at the heights both have
    double intake_at_tdc = 0.0, exhaust_at_tdc = 0.0;  ///< lifts
    double common_lift = 0.0, common_at = 0.0;         ///< largest of the lesser lift
    std::optional<ValveGap> gap;
    std::optional<double> clearance, clearance_at;  ///< least, with a gap
};

/// Lift of a valve at a crank angle after top dead centre; 0 where it is shut. The lobe has a motion and a
/// centerline.
[[nodiscard]] double valve_lift_over_crank(const Solution& solution, double crank);
/// The distance of valves with these lifts; negative: they touch.
[[nodiscard]] double valve_clearance(const ValveGap& gap, double intake, double exhaust);

/// Throws InputError where one is no valve lobe, has no motion or no centerline.
[[nodiscard]] ValvePair valve_pair(const Solution& intake, const Solution& exhaust,
                                   const std::optional<ValveGap>& gap = {});

}  // namespace camopt
