// SPDX-License-Identifier: MIT
#include "tests/soak/known/draft.hpp"

#include <fmt/format.h>

#include <cmath>

namespace camopt::soak {

Spelling drawn_spelling(Draw& draw, const Units& units, int order, double normal) {
    if (draw.chance(0.4)) return {"", normal};
    using Unit = std::pair<const char*, double>;
    static const std::vector<Unit> lengths = {{"mm", 1e-3}, {"in", 0.0254}, {"m", 1.0}};
    static const std::vector<Unit> angles = {{"deg", degree_angle}, {"rad", 1.0}};
    const auto [output, size] = draw.one_of(units.swings ? angles : lengths);
    const double physical = units.lift / std::pow(units.unit, order) / size;
    if (order == 0) return {fmt::format("_{}", output), physical};
    const std::string power = order > 1 ? std::to_string(order) : "";
    if (units.speed > 0.0 && draw.chance(0.5))
        return {fmt::format("_{}_s{}", output, power), physical * std::pow(units.speed, order)};
    // mm_deg and in_deg, but no m_deg; deg_deg and rad_rad.
    if (units.swings)
        return {fmt::format("_{0}_{0}{1}", output, power),
                physical * (order > 0 ? std::pow(size, order) : 1.0)};
    const bool by_degree = size < 0.5 && draw.chance(0.5);
    return {fmt::format("_{}_{}{}", output, by_degree ? "deg" : "rad", power),
            physical * (by_degree ? std::pow(degree_angle, order) : 1.0)};
}

}  // namespace camopt::soak
