// SPDX-License-Identifier: MIT
// In which units a person reads a scene: one concept for console, reports, pictures and pages.
//
//     shown = SI value / size          (m, rad, m/s, N, N m, Pa; per radian of the cam m/rad, m/rad², m/rad³)
//     shown = per_normalised · y⁽ʳ⁾    (derivatives of the motion, y = s / lift over x = θ / unit angle)
//
// With a speed the motion stands first in time, v = ω ds/dθ, a = ω² d²s/dθ², j = ω³ d³s/dθ³, in mm/s, m/s²,
// m/s³ (swinging: deg/s, deg/s², deg/s³), and beside it by the cam angle in mm/rad, mm/rad², mm/rad³
// (swinging: deg/deg …). Without a speed it stands by the cam angle only. Where the scene is written in
// inches (Scene::length_unit) in, in/s, in/s², in/s³ and in/rad take their places, and lbf, lbf in, ksi, lb
// and lbf/in those of N, N m, MPa, kg and N/mm. Angles are in degrees. Files keep the units that their
// columns say: mm and N (file_units).
#pragma once

#include "report/view/number_text.hpp"
#include "scene/scene.hpp"

namespace camopt {

/// The x that is shown as this number, where `guess` is to within round-off: multiplication does not always
/// undo division.
template <class Shown>
[[nodiscard]] double value_shown_as(double number, double guess, const Shown& shown) {
    for (const double x : {guess, std::nextafter(guess, -infinity), std::nextafter(guess, infinity)})
        if (shown(x) == number) return x;
    return guess;
}

struct ShownUnit {
    std::string name;         ///< "mm/s", "m/s²"
    double size = 1.0;        ///< of the unit, SI
    std::string suffix = {};  ///< of keys of files: "_mm_s", "_m_s2"

    ShownUnit() = default;
    explicit ShownUnit(std::string unit, double si = 1.0, std::string key_suffix = {})
        : name(std::move(unit)), size(si), suffix(std::move(key_suffix)) {}
    explicit(false) ShownUnit(const Spelling& unit)
        : name(unit.sign), size(unit.factor), suffix(unit.suffix) {}

    [[nodiscard]] double of(double si) const { return si / size; }
    /// The value that is so many of the unit, to the last bit.
    [[nodiscard]] double si_of(double shown) const {
        return value_shown_as(shown, shown * size, [this](double si) { return of(si); });
    }
    /// "12.5 mm", with that many significant digits; "–" and "∞" for what is not finite.
    [[nodiscard]] std::string text(double si, int digits = 6) const;
    /// A length that somebody asked for: thousandths of an inch as they are spoken, "0.050 in".
    [[nodiscard]] std::string asked_text(double si) const;
};

// The same for every scene.
inline const ShownUnit degrees_shown = unit_named<"deg">, rpm_shown = unit_named<"rpm">,
                       hertz_shown = unit_named<"Hz">, millimetres_shown = unit_named<"mm">;

/// Of the transmission of a motor.
[[nodiscard]] inline ShownUnit transmission_shown(const MotionSpec& motion, LengthUnit length) {
    if (motion.lift_is_angle) return unit_named<"deg/rev">;
    return length == LengthUnit::inch ? unit_named<"in/rev"> : unit_named<"mm/rev">;
}

/// The unit of a derivative of the motion.
struct MotionUnit : ShownUnit {
    using ShownUnit::ShownUnit;

    std::size_t order = 0;        ///< r
    double per_normalised = 1.0;  ///< shown value = per_normalised · y⁽ʳ⁾
    std::string
        symbol;  ///< what is shown: "s", "v", "a", "j"; by the cam angle "ds/dθ", "d²s/dθ²", "d³s/dθ³"
    std::string column;  ///< of tables in this unit (report/view/columns.hpp): "v_mm_s"

    [[nodiscard]] double si(double y) const { return size * per_normalised * y; }
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
    ShownUnit load;  ///< of what presses the follower on the cam: of a force, or a torque where it swings
    ShownUnit force, torque, pressure, modulus;  ///< N, N m, MPa, GPa; lbf, lbf in, ksi
    ShownUnit vibration;                         ///< µm, mil (0.001 in), mdeg: amplitudes
    ShownUnit mass, spring_rate;  ///< kg, N/mm; lb, lbf/in; swinging: kg m², N m/rad or lbf in/rad
    ShownUnit speed;              ///< rpm
    ShownUnit number;             ///< what has no unit
    double degrees_per_x = 0.0;   ///< cam angle in degrees = degrees_per_x · x
};

/// Of lengths: mm or in.
[[nodiscard]] ShownUnit length_shown(LengthUnit length);

/// Of masses: kg or lb.
[[nodiscard]] ShownUnit weight_shown(LengthUnit length);

[[nodiscard]] ShownUnits shown_units(const Scene& scene);

/// The same of a motion alone.
[[nodiscard]] ShownUnits shown_units(const MotionSpec& motion, LengthUnit length = LengthUnit::millimetre);

/// Of the output at this speed of the camshaft, from lifts by x²: in the unit that is shown of accelerations.
[[nodiscard]] double acceleration_at(const Scene& scene, double normalised, double speed);

/// Of files whose columns and keys say mm, also for a scene written in inches.
[[nodiscard]] inline ShownUnits file_units(const Scene& scene) {
    return shown_units(scene.motion);
}

}  // namespace camopt
