// SPDX-License-Identifier: MIT
#include "studies/relaxation.hpp"

#include "studies/solve_without_explaining.hpp"

#include <array>

namespace camopt {

namespace {

struct LimitedPeak {
    std::optional<PeakLimit> LimitSpec::*limit;
    double ObjectiveSpec::*weight;
    Extremum Peaks::*peak;
};

constexpr std::array<LimitedPeak, 3> limited_peaks = {{
    {&LimitSpec::velocity, &ObjectiveSpec::velocity, &Peaks::velocity},
    {&LimitSpec::acceleration, &ObjectiveSpec::acceleration, &Peaks::acceleration},
    {&LimitSpec::jerk, &ObjectiveSpec::jerk, &Peaks::jerk},
}};

/// The scene that asks for the least of one limited peak and keeps every other limit.
Scene without_limit(const Scene& scene, const LimitedPeak& one) {
    Scene relaxed = scene;
    (relaxed.limits.*one.limit).reset();
    relaxed.objective = {};
    relaxed.objective.*one.weight = 1.0;
    relaxed.objective.tie_break = TieBreak::none;
    relaxed.solver.name = "structured";
    relaxed.solver.options.clear();
    return relaxed;
}

}  // namespace

std::vector<Relaxation> relaxations(const Scene& scene, const SolveControl& control) {
    std::vector<Relaxation> found;
    for (const LimitedPeak& one : limited_peaks) {
        const std::optional<PeakLimit>& limit = scene.limits.*one.limit;
        if (!limit) continue;
        Relaxation relaxation{limit->key, limit->given, {}};
        const Solution least = solve_without_explaining(without_limit(scene, one), control);
        if (least.curve) {
            relaxation.needed = (least.peaks.*one.peak).value * limit->unit_per_normalised();
        }
        found.push_back(std::move(relaxation));
    }
    return found;
}

}  // namespace camopt
