// SPDX-License-Identifier: MIT
// Shapes of motion laws by their numbers: what the rows of the catalogue are made of (law_catalogue.cpp).
// x and y in units of the rise; shapes need not be normalised.
#pragma once

#include "motions/laws/harmonic_law.hpp"

namespace camopt {

/// Pieces narrower than this are indistinguishable from jumps in double precision.
inline constexpr double kNarrowestPiece = 1e-9;

/// The first half of an SCCA law (sine, constant, cosine, and a coast at constant velocity); the second by
/// y''(1 − x) = −y''(x). Widths by x, 0 or at least kNarrowestPiece, 1/2 in all.
struct SccaParts {
    double sine = 0.0;      ///< quarter sine, from 0 up
    double constant = 0.0;  ///< at its height
    double cosine = 0.0;    ///< quarter cosine, down to 0
    double coast = 0.0;     ///< 0
};
[[nodiscard]] std::vector<AccelerationPiece> scca_pieces(const SccaParts& parts);
/// y'' jumps where a part stands alone that ends above 0.
[[nodiscard]] int scca_continuity(const SccaParts& parts);

/// Acceleration, constant velocity, deceleration. The first and the last each rise and fall along straight
/// lines, `ramp` of their width at either end, and are constant between; ramp = 0: y'' jumps.
struct RampedParts {
    double acceleration = 0.0, coast = 0.0;  ///< widths by x; the rest is deceleration
    double ramp = 0.0;                       ///< 0 <= ramp <= 1/2
};
[[nodiscard]] std::vector<AccelerationPiece> ramped_pieces(const RampedParts& parts);

// Shapes whose return follows at once and mirrors them (TopEnd::turning_point): at x = 0 a dwell ends, so y =
// y' = y'' = 0; at the top y' = y''' = 0 and y'' < 0 continues smoothly into the return.

/// Quarter sine up over [0, Ta], quarter cosine down to 0 at b, quarter sine down over [b, 1] to the top.
/// Rest at the top and continuous y''' at b require b = 1/(2 − Ta) and a deceleration 1/(1 − Ta) times the
/// acceleration. Ta <= widest_one_dwell_sine: towards 0 it becomes simple harmonic, there it is the cycloidal
/// one: a half sine over [0, 2 − √2].
[[nodiscard]] std::vector<AccelerationPiece> one_dwell_sine_pieces(double ta);
inline constexpr double widest_one_dwell_sine = 1.0 - 0.5 * std::numbers::sqrt2;

/// Quarter sine up over [0, Ta], constant to b − Ta, half cosine down to minus that constant at b + Ta,
/// constant over the top. Rest at the top requires b = 1/2 + Ta (1/2 − 1/π). Ta <=
/// widest_one_dwell_trapezoid, where the constant acceleration vanishes; towards 0 it becomes parabolic.
[[nodiscard]] std::vector<AccelerationPiece> one_dwell_trapezoid_pieces(double ta);
inline constexpr double widest_one_dwell_trapezoid = std::numbers::pi / (3.0 * std::numbers::pi + 2.0);

/// y' and y'' at both ends of a rise; an acceleration that is not given is free.
struct EndStates {
    double start_velocity = 0.0, end_velocity = 0.0;
    std::optional<double> start_acceleration = {}, end_acceleration = {};
};
/// The polynomial of least degree, 3 to 5, with these ends: its expansions about both (PolynomialLaw).
struct EndPolynomial {
    std::vector<double> from_below, from_top;
};
[[nodiscard]] EndPolynomial polynomial_between(const EndStates& ends);

}  // namespace camopt
