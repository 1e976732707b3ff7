// SPDX-License-Identifier: MIT
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
// everywhere. Where the follower is known to rest (rest_places) the smallest of all given pressure limits
// holds, including a general one that is replaced elsewhere.
#pragma once

#include "objectives/rules/cam_rule.hpp"

namespace camopt {

/// Every limit of the scene on its cam, with tolerances for every cam within them; empty if it has none.
/// Throws InputError for a limit that the follower cannot have.
[[nodiscard]] std::vector<std::shared_ptr<const CamRule>> cam_limits(const Scene& scene,
                                                                     const CamVariables& variables);

/// The limits on φ during rise and return, rad; none: unlimited.
struct PressureLimits {
    std::optional<WrittenLimit> rise, back;
    std::optional<WrittenLimit> general;  ///< as given, even where both replace it
    /// Of rise and return.
    [[nodiscard]] std::optional<WrittenLimit> stricter() const;
    /// The smallest of all given ones: it holds where the follower rests.
    [[nodiscard]] std::optional<WrittenLimit> at_rest() const {
        return general_at_rest_alone() ? general : stricter();
    }
    /// The general one is stricter than both that replace it: it holds at rest only.
    [[nodiscard]] bool general_at_rest_alone() const { return general && general->value < stricter()->value; }
};
[[nodiscard]] PressureLimits pressure_limits(const LimitSpec& limits);

// The cam can be built at rest, where its dimensions are variable: each sum of CamMechanism::reach is a
// linear row, unless the ranges imply it.

/// After the cam's variables are in the model.
void add_reach_rows(CamModel& model, const CamSpec& spec);

// Cam angles at which the follower rests for every motion of the scene: known before any search.
//
// Both ends of a motion (DRD, RR, an open program), the top of RR, via points of velocity 0, and in a program
// both ends of every dwell and of every law that begins or ends at rest. Points inside a spline where s'
// happens to vanish are not included.

/// x, ascending, each once. Throws InputError for an unknown law.
[[nodiscard]] std::vector<double> rest_places(const Scene& scene);

}  // namespace camopt
