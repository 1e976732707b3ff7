// SPDX-License-Identifier: MIT
#include "studies/sweep/scene_sweep.hpp"

#include "studies/solve/solve_sequence.hpp"

namespace camopt {

std::vector<SweptScene> sweep(const Scene& scene, std::span<const double> values, const SceneSetter& set,
                              const SolveControl& control,
                              const std::function<void(const SweptScene&)>& solved) {
    std::vector<SweptScene> rows;
    SolveSequence sequence;
    for (const double value : values) {
        if (control.ending()) break;
        Scene one = scene;
        set(one, value);
        SweptScene row{value, sequence.solve(one, control)};
        if (control.stopped()) break;  // perhaps stopped halfway
        rows.push_back(std::move(row));
        if (solved) solved(rows.back());
    }
    return rows;
}

}  // namespace camopt
