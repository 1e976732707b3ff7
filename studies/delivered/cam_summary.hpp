// SPDX-License-Identifier: MIT
// The figures a cam of any kind is judged by: extremes over every cam angle and all stations, found between
// the samples too. What a kind has not, is absent.
#pragma once

#include "profiles/sampling.hpp"
#include "scene/scene.hpp"

namespace camopt {

/// A value in SI and rad, and the x where it is reached.
using CamExtreme = Extremum;

/// Figures by LimitedFigure; none where the cam has nothing it could be computed from.
using LimitedFigures = std::array<std::optional<CamExtreme>, limited_figure_count>;

struct ForceSummary {
    CamExtreme least_force, largest_force;  ///< F (N) or M (N m), see ForceSpec
    CamExtreme torque;                      ///< largest |camshaft torque|, N m
    /// The lowest speed of the cam, rad/s, at which a follower of one side has no force left, and where; none
    /// up to ten times the scene's own, or where nothing presses even the cam at rest.
    std::optional<CamExtreme> lift_off_speed;
    std::optional<CamExtreme> driving_force;  ///< N, largest magnitude; of a cam that slides
    /// Infinite where the cam cannot be touched as designed (CamSummary::no_contact).
    std::optional<CamExtreme> normal_force;    ///< largest force along the normal, N
    std::optional<CamExtreme> hertz_pressure;  ///< Pa; with a contact width, not for a knife edge
};

/// One side of a cam that drives both ways: a flank of its groove, a disk of a conjugate pair.
struct SideSummary {
    std::string name;  ///< "outer flank"
    CamExtreme pressure_angle, regularity;
    std::optional<CamExtreme> convex_radius, concave_radius;
    /// Largest, of the cam angles at which this side carries; 0 where it never does. None without forces, the
    /// pressure without a width of contact; infinite without contact.
    std::optional<CamExtreme> normal_force, hertz_pressure;
    LimitedFigures limited;  ///< those that differ from side to side
};

struct CamSummary {
    CamExtreme pressure_angle;  ///< largest |φ|
    /// Of a direct cam, of the parts where s' > 0, s' < 0; 0 where there are none.
    std::optional<CamExtreme> rise_pressure_angle, return_pressure_angle;
    /// Of a direct cam, where the follower is known to rest (cam_limits.hpp).
    std::optional<CamExtreme> rest_pressure_angle;
    /// Least, of the surface of a planar cam; none where it is nowhere convex. <= 0: undercut. −infinity
    /// where a flat face turns back.
    std::optional<CamExtreme> convex_radius;
    /// Least, > 0, of a planar cam with a pitch curve; none where it is nowhere concave.
    std::optional<CamExtreme> concave_radius;
    /// Least; 0, to rounding: a cusp; below 0: undercut. Where an oscillating flat face turns back, 1 + σψ'
    /// in its place: not above 0 either.
    CamExtreme regularity;
    double base_radius = 0.0;  ///< planar, m: the dimension, or the least distance of the cam from its centre
    std::optional<CamExtreme> contact_offset;  ///< largest magnitude on a flat face; may be infinite
    /// Of a direct cam, and of a drum with forces: x of a place where the follower cannot touch it as
    /// designed: undercut, a face that turns back, a contact below the cam's centre. None where it can
    /// everywhere.
    std::optional<double> no_contact;
    std::optional<ForceSummary> forces;  ///< of a loaded cam where the scene has forces and a speed
    /// The same at the other ends of the range of speeds (Scene::load_speeds), with "at 0 rpm".
    std::vector<std::pair<std::string, ForceSummary>> other_loads;
    std::vector<SideSummary> sides;  ///< of a loaded cam that drives both ways; of a drum only with forces
    LimitedFigures limited;          ///< what the scene's limits compare with; of a scene's cam

    [[nodiscard]] bool undercut() const { return !(regularity.value >= 0.0); }
    /// Touched as designed, and pointed: what a limit of 0 on the radius or on the margin allows.
    [[nodiscard]] bool cusp() const { return regularity.value == 0.0; }
};

/// What every cam has.
[[nodiscard]] CamSummary cam_summary(const DrivenMechanism& cam, const Motion& motion,
                                     const MotionScale& scale);

/// And what only direct cams have: strokes, contact, forces; and what the scene's limits compare with.
[[nodiscard]] CamSummary cam_summary(const DrivenMechanism& cam, const Motion& motion, const Scene& scene);

}  // namespace camopt
