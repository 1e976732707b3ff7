// SPDX-License-Identifier: MIT
//
// The limits of a scene on its cam, of any kind, as rules g <= 0, at every binding station.
//
//   pressure angle   (± N cos φm − D sin φm)/L,  tan φ = N/D:  linear or convex: docs/theory/
//   convex radius    (r + ρ_min) κ − 1 where the cam has a pitch curve, (ρ_min − ρ)/base for flat faces
//   concave radius   −(ρ_c − r) κ − 1
//   undercut margin  margin − regularity
//   face width       (± s' − w)/w
//   contact force    (F_min − m ω² s'' − k s − F_0)/F_ref
//   torque           (± F s' − T_max)/T_max
//   Hertz pressure   (F − lever R π b p_max² c)/F_ref,  c = (1−ν₁²)/E₁ + (1−ν₂²)/E₂,  1/R = 1/ρ_cam + 1/r;
//                    linear for a pushed flat face
//
// Hertz pressure and torque assume contact with a regular cam: unless a limit of the scene ensures it, they
// add
// regularity, a face without reversal and a contact above the cam's centre as separate rules.
//
// L: a length of the cam that makes the first dimensionless. With separate pressure limits for rise and
// return
// the upper side has that of its stroke, and the angle of an inclined follower at rest has the stricter one
// everywhere. Where the follower is known to rest (rest_places.hpp) the smallest of all given pressure limits
// holds, including a general one that is replaced elsewhere.
#pragma once

#include "objectives/rules/cam_rule.hpp"
#include "scene/scene.hpp"

#include <memory>
#include <vector>

namespace camopt {

/// Every limit of the scene on its cam; empty if it has none. Throws InputError for a limit that the follower
/// cannot have.
[[nodiscard]] std::vector<std::shared_ptr<const CamRule>> cam_limits(const Scene& scene,
                                                                     const CamVariables& variables);

/// The limits on φ during rise and return, rad; none: unlimited.
struct PressureLimits {
    std::optional<WrittenLimit> rise, back;
    std::optional<WrittenLimit> general;  ///< as given, even where both replace it
    /// Of rise and return.
    [[nodiscard]] std::optional<WrittenLimit> stricter() const;
    /// The smallest of all given ones: it holds where the follower rests.
    [[nodiscard]] std::optional<WrittenLimit> at_rest() const;
    /// The general one is stricter than both that replace it: it holds at rest only.
    [[nodiscard]] bool general_at_rest_alone() const;
};
[[nodiscard]] PressureLimits pressure_limits(const LimitSpec& limits);

}  // namespace camopt
