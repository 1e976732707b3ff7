// SPDX-License-Identifier: MIT
#include "studies/search/stroke_excursions.hpp"

#include "objectives/program_family.hpp"
#include "studies/delivered/solution_parts.hpp"

namespace camopt {

std::vector<std::size_t> passed_turning_points(const Scene& scene, const MotionFamily& family,
                                               const MotionChain& motion,
                                               std::vector<StrokeDirection> directions) {
    constexpr double standing = 1e-9;  // lifts, and lifts by x
    std::size_t k = 0;
    for (const StrokeRange& stroke : strokes_of(scene, family)) {
        if (!stroke.is_free()) continue;
        if (k == directions.size()) directions.push_back(StrokeDirection::open);
        StrokeDirection& direction = directions[k++];
        const double moved = motion.at(stroke.end, Side::left).derivative[0] -
                             motion.at(stroke.begin, Side::right).derivative[0];
        if (direction == StrokeDirection::open && std::abs(moved) > standing)
            direction = moved > 0.0 ? StrokeDirection::rises : StrokeDirection::falls;
    }
    if (directions.empty()) return {};
    std::vector<std::size_t> passed = turning_segments(scene.motion, directions);
    std::erase_if(passed, [&](std::size_t i) {
        return std::abs(motion.at(family.own_stretches()[i].begin, Side::right).derivative[1]) <= standing;
    });
    return passed;
}

bool leaves_its_strokes(const Scene& scene, const MotionFamily& family, const MotionChain& motion) {
    return std::ranges::any_of(excursions_of(scene, family, motion),
                               [&](double excursion) { return excursion > scene.solver.tolerance; }) ||
           !passed_turning_points(scene, family, motion).empty();
}

bool leaves_its_strokes(const Solution& solution) {
    return solution.motion &&
           leaves_its_strokes(solution.scene, *family_of(solution), solution.output_motion());
}

}  // namespace camopt
