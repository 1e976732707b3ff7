// SPDX-License-Identifier: MIT
// The smallest cam: the least prime radius with which any motion at all can keep a pressure angle.
//
// A translating follower with a roller or a knife edge, lift h, offset e, prime radius rp, s0 = √(rp² - e²):
//   tan φ = (s' - e) / (s0 + s),   |φ| <= φm,   t = tan φm,   E = exp(β t) for a stroke of cam angle β
// On the rise s' <= t (s0 + s) + e, on the return -s' <= t (s0 + s) - e. So with σ = +1 on the rise, -1 on
// the return, no motion needs less than the time of the steepest one allowed, whose φ is φm throughout:
//   s(θ) = (s0 + σe/t) (exp(tθ) - 1),   θ from the stroke's lower end
//   β >= ln((σe + t (s0 + h)) / (σe + t s0)) / t,   that is   s0 >= h / (E - 1) - σe/t
// At e = 0 its pitch curve is a logarithmic spiral, r = s0 exp(tθ). It starts and ends with a jump of s', so
// motions with continuous s' come as close as one likes and never reach it. Such motions also pass through
// s' = 0 at the lower end, where tan φ = -e/s0: so s0 >= |e|/t besides.
//
// SI units (one length unit throughout will do), radians. e as DiskSpec has it for a cam that turns
// counterclockwise; for a clockwise one take -e. Errors: lift or angle not positive or not finite, e not
// finite, φm outside (0, π/2): InputError. Source: derived here; for e = 0 the result is classical.
#pragma once

namespace camopt {

enum class Stroke { rise, return_stroke };

struct CamStroke {
    double lift = 0.0;    ///< h, m
    double offset = 0.0;  ///< e, m
    Stroke stroke = Stroke::rise;
};

/// The steepest motion that keeps the pressure angle: s(θ) = scale (exp(growth θ) - 1) up to θ = angle.
struct SteepestStroke {
    double scale = 0.0;   ///< s0 + σe/t, m
    double growth = 0.0;  ///< t, per rad
    double angle = 0.0;   ///< rad, its own: below β where the rest decides

    [[nodiscard]] double displacement(double theta) const;
    [[nodiscard]] double slope(double theta) const;  ///< |ds/dθ|, m/rad
};

/// What keeps the cam from being smaller.
enum class SmallestCamLimit {
    stroke,  ///< the pressure angle during the stroke
    rest     ///< the pressure angle that the offset causes at the lower end already
};

struct SmallestCam {
    double prime_coordinate = 0.0;  ///< s0, m
    double prime_radius = 0.0;      ///< √(s0² + e²), m
    SmallestCamLimit limit = SmallestCamLimit::stroke;
    SteepestStroke motion;
};

/// The least s0 that the stroke itself allows, h / (E - 1) - σe/t, whatever its ends do: of a stroke that
/// need not begin at rest. Not positive where the offset alone does it.
[[nodiscard]] double least_stroke_coordinate(const CamStroke& stroke, double angle, double pressure_angle);

/// The infimum over all motions of the stroke with |φ| <= pressure_angle.
[[nodiscard]] SmallestCam smallest_cam(const CamStroke& stroke, double angle, double pressure_angle);

}  // namespace camopt
