// SPDX-License-Identifier: MIT
//
// Set points of a motion, from all lists of the scene, on the whole motion: x = cam angle / unit angle, y
// in lifts, y' = dy/dx.
//
// A set point is stored normalised by its own stretch (the rise, or a program's segment). In units:
//   location θ = at · angle,   s = y · lift,   ds/dθ = y' · lift / angle,   ds/dt = y' · lift · speed /
//   angle.
#pragma once

#include "scene/key_row.hpp"
#include "scene/set_point_scale.hpp"

namespace camopt {

/// The spelling of a set point's derivative of `order` in this unit. Throws InputError if there is none.
[[nodiscard]] const Spelling& spelling_of_unit(int order, std::string_view unit);
/// Of a location: "deg", "rad", "crank deg"; that without a unit for another.
[[nodiscard]] const Spelling& spelling_of_place(std::string_view unit);

/// The wanted number of derivative `order`.
[[nodiscard]] std::optional<double>& value_of(SetPoint& point, int order);

/// A set point on the whole motion.
struct PlacedPoint {
    std::string member;                           ///< "motion.via[0]", "motion.segments[2].via[0]"
    int segment = -1;                             ///< of a program
    double begin = 0.0, end = 0.0;                ///< x; the same but of a region
    std::array<std::optional<double>, 3> wanted;  ///< y, y', y''; of a region at its beginning
    SetPointUnits units;

    [[nodiscard]] bool is_region() const { return end > begin; }
};

/// One wanted number, as written.
struct WrittenValue {
    std::string key;              ///< "motion.via[0].velocity_mm_s"
    std::string unit;             ///< "mm/s"; empty: normalised by its stretch
    double per_normalised = 1.0;  ///< factor from y^(order) of the whole motion to the unit
};

/// In the order of the scene.
[[nodiscard]] std::vector<PlacedPoint> placed_points(const MotionSpec& motion);

/// y' and y'' where a motion that is not periodic starts or ends: as given; in a program the velocity of a
/// region that reaches the end; else 0.
[[nodiscard]] std::array<double, 2> end_velocities(const MotionSpec& motion, bool at_end);

/// The spelling of the wanted number of derivative `order`.
[[nodiscard]] WrittenValue written_value(const MotionSpec& motion, const PlacedPoint& point, int order);

/// "velocity of set point 1 = 120 mm/s at 40 deg", "… = 80 mm/s from 30 deg to 50 deg"; in normalised units
/// if written so.
[[nodiscard]] std::string words_of(const MotionSpec& motion, const PlacedPoint& point, int order);

/// Inserts regions into the spline's breakpoints: those given (including the ends) with the ends of every
/// region replacing those inside it or close to its ends. `regions`: pairs of begin and end, x. `closest`: an
/// own breakpoint closer than this to an end of a region is removed.
[[nodiscard]] std::vector<double> with_regions(std::vector<double> breakpoints,
                                               std::vector<std::array<double, 2>> regions, double closest);

/// Makes every copy of a repeated part equal to the first.
void copy_repeats(MotionSpec& motion);

/// After angles, lift or speed changed: set points and displacements `to` written in units retain their
/// physical values.
void keep_written(MotionSpec& changed, const MotionSpec& before);

/// After angles, lift or speed changed: set points, displacements and limits in time say what they said
/// before.
void keep_written(Scene& changed, const MotionSpec& before);

/// The scene with these angles of its segments, everything else as it is written. Ranges of angles stay.
[[nodiscard]] Scene with_segment_angles(const Scene& scene, const std::vector<double>& angles);

}  // namespace camopt
