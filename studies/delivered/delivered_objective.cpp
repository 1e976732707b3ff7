// SPDX-License-Identifier: MIT
#include "studies/delivered/delivered_objective.hpp"

#include "objectives/scene_model.hpp"
#include "scene/cost_table.hpp"

#include <array>
#include <cmath>

namespace camopt {

namespace {

double weighted_dimensions(const Solution& solution) {
    const std::array<double, dimension_count>& weights = solution.scene.objective.dimensions;
    double sum = 0.0;
    if (solution.cam) {
        const double unit = dimension_unit(solution.scene);
        for (int d = 0; d < dimension_count; ++d) {
            const double weight = weights[static_cast<std::size_t>(d)];
            if (weight > 0.0)
                sum += weight / unit * std::abs(solution.cam->cam[static_cast<DimensionIndex>(d)]);
        }
    }
    if (solution.mechanism) {
        const std::vector<double>& delivered = solution.mechanism->mechanism.dimensions;
        for (std::size_t d = 0; d < delivered.size(); ++d)
            sum += mechanism_weight(solution.scene, solution.scene.mechanism->dimensions[d].name) *
                   std::abs(delivered[d]);
    }
    return sum;
}

}  // namespace

double defined_objective(const Solution& solution) {
    const ObjectiveSpec& weights = solution.scene.objective;
    const Peaks& peaks = solution.peaks;
    const Peaks& reference = solution.reference_peaks;
    double sum = weighted_dimensions(solution);
    // A reference that a term of no weight would need may be infinite or absent.
    for (const CostTerm& term : cost_terms())
        if (const double weight = term.weight_in(weights); weight > 0.0)
            sum += weight * term.measured.of(peaks) / term.measured.of(reference);
    for (const OwnTermReport& term : solution.own_terms) sum += term.weight * term.value / term.reference;
    return sum;
}

}  // namespace camopt
