// SPDX-License-Identifier: MIT
// In which units a person reads a scene: one concept for console, reports, pictures and pages.
//
//     shown = factor · SI value        (m, rad, m/s, N, N m, Pa; per radian of the cam m/rad, m/rad², m/rad³)
//     shown = per_normalised · y⁽ʳ⁾    (derivatives of the motion, y = s / lift over x = θ / unit angle)
//
// With a speed the motion stands first in time, v = ω ds/dθ, a = ω² d²s/dθ², j = ω³ d³s/dθ³, in mm/s, m/s²,
// m/s³ (swinging: rad/s, rad/s², rad/s³; where the scene writes a cap or a set point in deg/s, deg/s²,
// deg/s³ these), and beside it by the cam angle in mm/rad, mm/rad², mm/rad³
// (swinging: deg/deg …). Without a speed it stands by the cam angle only. Where the scene is written in
// inches (Scene::length_unit) in, in/s, in/s², in/s³ and in/rad take their places. Angles are in degrees,
// forces in N and N m, pressures in MPa, whatever the lengths are in. Files keep the units that their columns
// say (DisplayScale).
#pragma once

#include "output/view/number_text.hpp"
#include "scene/scene.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string>

namespace camopt {

struct ShownUnit {
    std::string name;     ///< "mm/s", "m/s²"
    double factor = 1.0;  ///< shown value = factor · SI value

    /// "12.5 mm", with that many significant digits; "–" and "∞" for what is not finite.
    [[nodiscard]] std::string text(double si, int digits = 6) const;
};

/// The unit of a derivative of the motion.
struct MotionUnit : ShownUnit {
    std::size_t order = 0;        ///< r
    double per_normalised = 1.0;  ///< shown value = per_normalised · y⁽ʳ⁾
    std::string
        symbol;  ///< what is shown: "s", "v", "a", "j"; by the cam angle "ds/dθ", "d²s/dθ²", "d³s/dθ³"
    std::string column;  ///< the column of motion.csv in this unit: "v_mm_s"; empty: none

    [[nodiscard]] std::string normalised_text(double y, int digits = 6) const;
};

struct ShownDerivative {
    std::string name;                  ///< "displacement", "velocity", "acceleration", "jerk"
    MotionUnit first;                  ///< in time where there is a speed
    std::optional<MotionUnit> beside;  ///< then by the cam angle

    /// first, or what stands beside it where there is anything: by the cam angle.
    [[nodiscard]] const MotionUnit& by_angle() const { return beside ? *beside : first; }
};

struct ShownUnits {
    std::array<ShownDerivative, 4> motion;  ///< displacement, velocity, acceleration, jerk
    bool in_time = false;                   ///< the scene has a speed: `first` is in time
    ShownUnit length;                       ///< mm, in: dimensions, radii, points of the cam
    ShownUnit curvature;                    ///< 1/mm, 1/in
    ShownUnit angle;                        ///< deg
    ShownUnit load;  ///< of what presses the follower on the cam: N, or N m where it swings
    ShownUnit force, torque, pressure;  ///< N, N m, MPa
    ShownUnit mass, spring_rate;        ///< kg, N/mm; swinging: kg m², N m/rad
    ShownUnit speed;                    ///< rpm
    double degrees_per_x = 0.0;         ///< cam angle in degrees = degrees_per_x · x
};

[[nodiscard]] ShownUnits shown_units(const Scene& scene);

/// The same of a motion alone.
[[nodiscard]] ShownUnits shown_units(const MotionSpec& motion, LengthUnit length = LengthUnit::millimetre);

// From the normalised motion back to the units on the drawing.
//
//     θ = rise · x,   dʳs/dθʳ = lift / riseʳ · y⁽ʳ⁾,   dʳs/dtʳ = lift (ω / rise)ʳ · y⁽ʳ⁾
//
// A translating output is shown in mm and mm/radʳ, a swinging one in deg and deg/degʳ; the cam angle always
// in degrees.

/// One scale a derivative: shown value = factor[r] · y⁽ʳ⁾.
struct DerivativeScale {
    std::array<double, 4> factor{};
    std::array<std::string, 4> unit;    ///< for people: "mm", "mm/rad", "mm/rad²", "mm/rad³"
    std::array<std::string, 4> column;  ///< for files: "s_mm", "ds_mm_rad", "dds_mm_rad2", "ddds_mm_rad3"
};

struct DisplayScale {
    double degrees_per_x = 0.0;  ///< θ in degrees = degrees_per_x · x
    DerivativeScale by_angle;
    double seconds_per_x = 0.0;              ///< 0 where the scene has no speed
    std::optional<DerivativeScale> by_time;  ///< where the scene has a speed
};

[[nodiscard]] DisplayScale display_scale(const MotionSpec& motion);

}  // namespace camopt
