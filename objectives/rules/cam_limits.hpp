// SPDX-License-Identifier: MIT
// The limits of a scene on its cam, of any kind, as rules g <= 0, at every station that binds.
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
// Hertz pressure and torque speak of a follower that touches a regular cam: where no limit of the scene makes
// it so they add regularity, a face that does not turn back and a contact above the cam's centre as rules of
// their own.
//
// L: a length of the cam that makes the first dimensionless. Where rise and return have pressure limits of
// their own the upper side keeps that of the stroke it belongs to, and the angle a follower that leans would
// have at standstill keeps the stricter one everywhere. Where the follower is known to rest (rest_places.hpp)
// the least of all pressure limits that are given holds, the general one too where it is replaced.
#pragma once

#include "objectives/rules/cam_rule.hpp"
#include "scene/scene.hpp"

#include <memory>
#include <vector>

namespace camopt {

/// Every limit of the scene on its cam; empty where it asks for none. Throws InputError for a limit that the
/// follower cannot have.
[[nodiscard]] std::vector<std::shared_ptr<const CamRule>> cam_limits(const Scene& scene,
                                                                     const CamVariables& variables);

/// The limits on φ while rising and returning, rad; none where nothing limits it.
struct PressureLimits {
    std::optional<WrittenLimit> rise, back;
    std::optional<WrittenLimit> general;  ///< as given, even where both replace it
    /// Of rise and return.
    [[nodiscard]] std::optional<WrittenLimit> stricter() const;
    /// The least of all that are given: what holds where the follower rests.
    [[nodiscard]] std::optional<WrittenLimit> at_rest() const;
    /// The general one is stricter than both that replace it: it holds at rest alone.
    [[nodiscard]] bool general_at_rest_alone() const;
};
[[nodiscard]] PressureLimits pressure_limits(const LimitSpec& limits);

}  // namespace camopt
