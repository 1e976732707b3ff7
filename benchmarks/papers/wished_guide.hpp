// SPDX-License-Identifier: MIT
// The guide that moves the feeder as wished, and what any guide makes the feeder do.
//
// The wish: while the roller goes from one distance to another in a stroke, the feeder rises from its lower
// to its upper place by a motion y(x) (x: time in units of the rise, y: in units of the lift); before and
// after it rests. Backwards through feeder, rocker, pin and body (profiles/inverse/inverse_mechanism.hpp)
// every moment gives one point of the guide with its slope and curvature: a quintic polar spline through
// them, between two lines that point to the pivot. The objective of the motion (camopt::solve) is thereby
// that of the guide. Where both strokes have a constant acceleration from and to rest at the same place, the
// return is the forward motion run backwards, faster: its velocities are larger by sqrt(a_r/a_f), its
// accelerations by a_r/a_f, regardless of the guide. Then the best guide of one stroke is the best of
// both. Lengths m, angles rad, time s.
#pragma once

#include "benchmarks/papers/guided_feeder.hpp"
#include "core/motion.hpp"

namespace camopt {

struct FeederWish {
    FeederLinkage linkage;
    RollerStroke stroke;                        ///< in which the feeder rises
    double from = 0.0, to = 0.0;                ///< L where the rise begins and ends; the roller moves there
    double lower = 0.0, upper = 0.0;            ///< Y
    double guide_begin = 0.0, guide_end = 0.0;  ///< L; <= from, >= to

    void validate() const;                   ///< throws InputError
    [[nodiscard]] double rise_time() const;  ///< s
};

/// nodes: of the spline, about so many, evenly by L between the motion's breakpoints; >= 2. Throws InputError
/// naming the fault where the machine cannot move so.
[[nodiscard]] Guide wished_guide(const FeederWish& wish, const Motion& motion, int nodes);

/// What the wish asks of the feeder at a time of its stroke.
[[nodiscard]] FollowerState wished_feeder(const FeederWish& wish, const Motion& motion, double time);

/// Largest magnitudes over one stroke of the roller, on a fine grid and on both sides of every joint of the
/// guide.
struct StrokePeaks {
    double velocity = 0.0, acceleration = 0.0;  ///< of the feeder, m/s, m/s²
    double acceleration_step =
        0.0;            ///< largest jump of it at a joint of the guide, m/s²: there the jerk is infinite
    double jerk = 0.0;  ///< between the joints, m/s³
};

struct GuideFigures {
    StrokePeaks forward, back;
    double pressure_angle = 0.0, pressure_angle_at = 0.0;  ///< largest |mu| and L there
    double least_radius = 0.0, least_radius_at = 0.0;      ///< of curvature, and L there
};

/// Throws InputError naming the fault where the machine does not reach.
[[nodiscard]] GuideFigures guide_figures(const Guide& guide, const FeederLinkage& linkage,
                                         const RollerLaw& roller);

/// Largest |Y - wished Y| over the stroke.
[[nodiscard]] double feeder_deviation(const Guide& guide, const FeederWish& wish, const Motion& motion);

}  // namespace camopt
