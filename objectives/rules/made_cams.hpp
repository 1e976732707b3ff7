// SPDX-License-Identifier: MIT
// The limits of a scene with tolerances (scene/tolerance_spec.hpp) for every cam within them.
//
//   g(s + δ, s' + δ', s'' + δ''; d + Δ) <= 0   for all |δ^{(r)}| <= ε_r, |Δ_k| <= the tolerance of d_k
//
// A limit is held at the ends of these intervals, by one rule for each choice of ends. Of rules that are
// linear in s, s', s'' and differ by a constant the worst is left: the right side of such a limit loses
// Σ |w_r| ε_r, and of a number that only moves it (offset and prime radius of a translating roller) its worse
// end. A rule that does not depend on an error is held once.
//
// That is enough where a limit is linear, monotone or convex in each of the errors. Elsewhere
// objectives/rules/maxima/between_ends.hpp encloses the limit over the tolerances along the delivered motion;
// cams between the ends that would pass it join those that it is held for (ToleranceSpec::between).
#pragma once

#include "objectives/rules/cam_rule.hpp"

namespace camopt {

/// The errors of s, s', s'' in the words for made cams.
inline constexpr std::array made_cam_marks = {"s", "s'", "s''"};

/// Of the scene and the cam of each choice of ends: numbers are moved, CamVariables::motion_error is set.
using MadeCamVisit = std::function<void(const Scene& scene, const CamVariables& made)>;

/// Every choice of ends, the one with every number at its upper end first, then those between them.
void visit_made_cams(const Scene& scene, const CamVariables& variables, const MadeCamVisit& visit);

/// One cam.
void visit_made_cam(const Scene& scene, const CamVariables& variables, const MadeParts& parts,
                    const MadeCamVisit& visit);

/// All cams within the tolerances of a drawn one as one cam whose numbers are variables: parts, from −1 to 1,
/// of their tolerances. The errors of the motion are added to its states.
struct FreeCam {
    Scene scene;  ///< without tolerances
    CamVariables variables;
    std::vector<std::size_t> places;  ///< of each variable, among ToleranceSpec::numbers
};
[[nodiscard]] FreeCam with_free_numbers(const Scene& scene, const CamVariables& drawn);

/// CamVariables::made of the cam that a rule belongs to; empty: the one that is drawn.
[[nodiscard]] std::string made_cam_of(const CamRule& rule);

/// `one`: the limits of one cam, always the same rules in the same order. Their remarks say which cam they
/// belong to: "made s+ s'-, base_radius-".
[[nodiscard]] std::vector<std::shared_ptr<const CamRule>> limits_of_made_cams(
    const Scene& scene, const CamVariables& variables,
    const std::function<std::vector<std::shared_ptr<const CamRule>>(const Scene&, const CamVariables&)>& one);

}  // namespace camopt
