// SPDX-License-Identifier: MIT
// The numbers of a scene that can be moved: one list, for the least value of one of them and for suggested
// changes. Each has its range and the scene that has another value of it.
#pragma once

#include "scene/key_row.hpp"
#include "studies/delivered/solution.hpp"

namespace camopt {

/// In the order in which changes are searched: what costs a user least comes first.
enum class Usefulness { angle, base_radius, limit, speed, lift, other };

/// The first change tried, relative; then it doubles.
inline constexpr double first_change = 0.02;
/// Pressure angles end short of the right angle.
inline constexpr double largest_pressure_angle = 89.9 * units::degree;

/// One number of a scene. Values are in the unit of the key.
struct Adjustment {
    std::string key;  ///< "limits.pressure_angle_deg"
    double given = 0.0;
    double step = 0.0;  ///< the first change to try, > 0
    bool may_grow = true, may_shrink = true;
    double least = 0.0, most = 0.0;                               ///< the range it may move in
    std::function<Scene(const Scene& scene, double value)> with;  ///< that scene with the value
    Usefulness usefulness = Usefulness::other;
    /// A limit: a motion that satisfies it satisfies every looser one, so that its end settles it.
    bool limit = false;
    /// Searched only where no angle before it made the scene feasible.
    bool fallback = false;
    double begin = 0.0, end = infinity;  ///< the stretch of the motion that it changes, x
    /// The numbers that change along with it: the dwell that an angle is taken from. Empty: none.
    std::function<std::vector<CompanionChange>(double value)> also = {};
};

/// The first value tried lies a fiftieth of `size` away; all of them lie within `range`. `set`: puts a value
/// into a scene.
[[nodiscard]] Adjustment number_adjustment(std::string key, double given, double size, const Range& range,
                                           std::function<void(Scene& scene, double value)> set);

/// Everything that may be changed but set points: bounds of corridors, caps on peaks, angles, every other
/// limit, springs, speed, every dimension of the cam, lift and displacements of a program.
[[nodiscard]] std::vector<Adjustment> adjustments(const Scene& scene);

/// Angles of rise, return and segments (each with the dwell that gives way), the lift, displacements `to`,
/// velocities of motion.start and motion.end.
[[nodiscard]] std::vector<Adjustment> motion_adjustments(const Scene& scene);

/// A set point, the scene without it, and its numbers.
struct SetPointChanges {
    /// One wanted number. Where the point has it at one angle only, the scene without it says which values
    /// it may have.
    struct Value {
        Adjustment change;
        std::optional<Scene> without;  ///< the scene without this number; none: of a region's velocity
        int order = 0;                 ///< of the derivative
        double per_normalised = 1.0;   ///< WrittenValue::per_normalised
    };
    std::string member;  ///< "motion.via[0]"
    double at = 0.0;     ///< x
    Scene without;
    std::vector<Value> values;
    std::optional<Adjustment> place;  ///< its cam angle; not of a region
};
[[nodiscard]] std::vector<SetPointChanges> set_point_changes(const Scene& scene);

}  // namespace camopt
