// SPDX-License-Identifier: MIT
// A second opinion on the limits of a delivered cam, from the path of the roller's centre as a complex
// number.
//
// Fixed frame: c = e + i (s0 + s), or a + l exp(i (π − ψ)). In the frame of a cam turning with σ the path is
// p = c exp(−iσθ), hence p' exp(iσθ) = T = c_s s' − iσ c, p'' exp(iσθ) = c_ss s'² + c_s s'' − 2iσ c_s s' − c;
// curvature κ = −σ Im(conj(T) p'') / |T|³, pressure angle between iT and c_s.
#pragma once

#include "studies/delivered/solution.hpp"

#include <string>
#include <vector>

namespace camopt::stability {

struct BrokenLimit {
    std::string name;
    double amount = 0.0;  ///< relative; > 0 is broken
};

/// Pressure angle (rollers, knife edges), least convex radius (rollers, sliding flat faces), least contact
/// force: the largest amount of each that the scene demands. 64 places a piece of the motion, refined by
/// golden section.
[[nodiscard]] std::vector<BrokenLimit> broken_limits(const Solution& solution);

}  // namespace camopt::stability
