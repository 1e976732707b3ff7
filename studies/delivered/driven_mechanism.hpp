// SPDX-License-Identifier: MIT
// A cam of any kind along a motion: its points, and its limits enclosed.
#pragma once

#include "profiles/sampling.hpp"
#include "scene/scene.hpp"

namespace camopt {

/// About `count` points of one station, evenly by cam angle, the motion's breakpoints among them, and which
/// those are. Throws InputError for fewer than 2.
struct MechanismProfile {
    std::vector<MechanismPoint> points;
    std::vector<double> outputs;  ///< s of each, m or rad
    std::vector<int> breaks;
};
[[nodiscard]] MechanismProfile mechanism_profile(const DrivenMechanism& mechanism, const Motion& motion,
                                                 const MotionScale& scale, int count, int station = 0);

// A second look at every limit on the cam of a delivered motion: not at points, but along every stretch of
// it.

/// One rule that keeps a limit, along the whole motion.
struct EnclosedLimit {
    std::string key;     ///< "limits.pressure_angle_deg"
    double worst = 0.0;  ///< relative to the rule's scale; above 0 the limit is passed; infinite: no value
    double at = 0.0;     ///< x
    /// No larger one hides between points: enclosed by interval arithmetic, at every station there is.
    bool complete = false;
    std::string made =
        {};  ///< of a rule for one cam within tolerances: which (objectives/rules/made_cams.hpp)
    /// Between the ends of the tolerances: the worst cam there (`worst` −infinity: none is worse than those
    /// at the ends).
    std::optional<MadeParts> between = {};
};

/// Of every rule of the scene's limits on its cam, whose formulas and numbers are `cam`.
[[nodiscard]] std::vector<EnclosedLimit> enclosed_limits(const Scene& scene, const DrivenMechanism& cam,
                                                         const Motion& motion);

/// All rules of a limit are complete, and there is one.
[[nodiscard]] bool is_verified(const std::vector<EnclosedLimit>& limits, const std::string& key);

// What a follower that touches its cam carries at one cam angle, as a function of the motion there. SI.
//
//   force         F = m ω² s'' + k s + F_0 along the lift (swinging: a moment, N m)
//   torque        F s' on the camshaft, > 0 where the cam drives
//   normal force  F / lever, along the cam's normal (MechanismQuantity::normal_lever)
//   Hertz         √(N E* κ / (π b)),  κ = 1/ρ_cam + 1/r: line contact over the width b
//
// The cam carries the load (CamMechanism::carries_load). One that drives both ways carries F > 0 on its side
// 0, F < 0 on its side 1: the normal force is then that of the side that carries, >= 0. Where a side has
// several stations, of a roller's length, the largest of them counts.

/// F / lever; at a station of side 1 −F / lever. Of a cam that drives both ways < 0 where the other side
/// carries.
[[nodiscard]] double normal_force(const DrivenMechanism& cam, const FollowerState& state, double force,
                                  int station = 0);
/// Which side a force presses on: 0 of a cam that does not drive both ways.
[[nodiscard]] int carrying_side(const CamMechanism& cam, double force);

/// Of a normal force (N) at a point of the cam, at that station, Pa; 0 where nothing presses. The forces have
/// a contact width.
[[nodiscard]] double hertz_pressure(const DrivenMechanism& cam, const ForceSpec& forces,
                                    const MechanismPoint& point, double normal_force, int station = 0);

/// Whether there is a pressure to speak of: a contact width is given, and the follower has no edge.
[[nodiscard]] bool has_hertz_pressure(const CamMechanism& cam, const ForceSpec& forces);

struct FollowerLoads {
    double force = 0.0, torque = 0.0, normal_force = 0.0;
    std::optional<double> hertz_pressure;
    int side = 0;  ///< which carries
    std::optional<double> driving_force =
        {};  ///< N, along the travel of a cam that slides; > 0: it is pushed
};

/// force: N or N m; point_of: the cam there, by station.
[[nodiscard]] FollowerLoads follower_loads(const DrivenMechanism& cam, const ForceSpec& forces, double force,
                                           const FollowerState& state,
                                           const std::function<MechanismPoint(int station)>& point_of);

}  // namespace camopt
