// SPDX-License-Identifier: MIT
#include "studies/delivered/delivered_objective.hpp"

#include "objectives/scene_model.hpp"
#include "profiles/scene_cam.hpp"
#include "scene/cost_table.hpp"

#include <cmath>

namespace camopt {

namespace {

double weighted_dimensions(const Solution& solution) {
    if (!solution.cam) return 0.0;
    const MechanismSpec spec = cam_of(solution.scene).value();
    const std::vector<double>& delivered = solution.cam->cam.dimensions;
    double sum = 0.0;
    for (std::size_t d = 0; d < delivered.size(); ++d)
        sum += dimension_weight(solution.scene, spec.dimensions[d].name) * std::abs(delivered[d]);
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
    if (solution.train)
        for (const ResponseTermReport& term : solution.train->terms)
            sum += term.weight * term.worst.value / term.reference;
    return sum;
}

}  // namespace camopt
