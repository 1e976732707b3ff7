// SPDX-License-Identifier: MIT
// Linear rules on the motion itself: limits of one side, corridors, limits of a motor that follows it, and
// the lost area as a term.
#pragma once

#include "objectives/rules/model.hpp"
#include "objectives/rules/peak_rule.hpp"
#include "scene/scene.hpp"

namespace camopt {

/// sign · y^{(order)} <= bound from `from` to `until`, both included. In lifts, by x of the whole motion. Of
/// a motor: a sum of y', y'' and 1 in SI units in place of sign · y^{(order)}.
struct MotionBound {
    std::string name;  ///< "acceleration_min", "corridor_displacement_max"
    std::string key;   ///< "limits.acceleration_m_s2.min", "motion.corridor[0].displacement_mm.min"
    std::string unit;  ///< of the key; empty: normalised
    int order = 0, sign = 1;
    double bound = 0.0;
    double given = 0.0;                         ///< in the unit
    double per_normalised = 1.0;                ///< the unit's number for y^{(order)} = 1
    double from = -infinity, until = infinity;  ///< x
    int stretch = -1;                           ///< of the family; -1: any
    int corridor = -1;                          ///< which one it is of; -1: a limit
    std::array<double, 3> weights{};            ///< of y', y'' and 1: of a motor
    double size = 0.0;                          ///< of a motor: what a violation is measured by
    bool magnitude = false;                     ///< its values are shown without their sign
    std::string remark = {};                    ///< as of BoundRule::Bound

    /// Exceeding the bound by this is a violation of 100 %.
    [[nodiscard]] double scale() const;
    [[nodiscard]] BoundRule::Bound rule(double most, double one) const {
        return {
            .order = order, .sign = sign, .bound = most, .scale = one, .weights = weights, .remark = remark};
    }
    [[nodiscard]] BoundRule::Bound rule() const { return rule(bound, scale()); }
    [[nodiscard]] bool of_motor() const { return weights != std::array<double, 3>{}; }
    /// Where the motion comes nearest to the bound, or exceeds it most: sign · y^{(order)}, or the sum.
    [[nodiscard]] Extremum extreme_of(const Motion& motion) const;
};

/// Limits of one side and corridors of the scene. A normalised limit of a program holds for each spline
/// segment (of a prescribed one: each law) by its own angle and displacement.
[[nodiscard]] std::vector<MotionBound> motion_bounds(const Scene& scene, const MotionFamily& family);
/// Those of scene_family; a scene without any needs no family.
[[nodiscard]] std::vector<MotionBound> motion_bounds(const Scene& scene);

/// 1 − (1/L) ∫ y dx over all of the motion of length L, y in lifts; exact for splines, of laws to round-off.
[[nodiscard]] double lost_area(const Motion& motion);
/// What objective.area is divided by: the scene's number, or the lost area of the reference law on the
/// strokes of the scene. Throws SceneError where that is not above 0.
[[nodiscard]] double area_reference(const Scene& scene, const MotionFamily& family);

/// The rules of all of these.
void add_motion_bounds(CamModel& model, const Scene& scene);

/// What a displacement is normalised by in each stretch of the family.
[[nodiscard]] std::vector<StretchScale> stretch_scales(const MotionFamily& family);

}  // namespace camopt
