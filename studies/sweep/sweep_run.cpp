// SPDX-License-Identifier: MIT
#include "studies/sweep/sweep_run.hpp"

#include "studies/least/least_value.hpp"
#include "studies/sweep/row_chain.hpp"

#include <fmt/format.h>

#include <exception>

namespace camopt {

std::vector<SweepRow> solve_chunk(SweepScenes& scenes, RowRange rows, const SolveControl& control,
                                  const std::function<void(const SweepRow&)>& row_done,
                                  const FoundSolution& found) {
    const RowRun run{control, {}, {}, found};
    SweepTable solved;
    solved.columns.keys = scenes.plan().keys;
    RowChain chain(run, solved, rows.begin);
    for (int number = rows.begin; number < rows.end; ++number) {
        const std::span<const double> settings = scenes.plan().row(number);
        try {
            if (chain.solve(settings, [&] { return scenes.scene(number); }) == nullptr) break;
        } catch (const std::exception& error) {
            if (control.stopped()) break;
            chain.fail(settings, fmt::format("error: {}", error.what()));
        }
        if (row_done) row_done(solved.rows.back());
    }
    return std::move(solved.rows);
}

std::vector<SweptScene> sweep(const Scene& scene, std::span<const double> values, const SceneSetter& set,
                              const SolveControl& control,
                              const std::function<void(const SweptScene&)>& solved) {
    std::vector<SweptScene> rows;
    KnownSolutions known;
    for (const double value : values) {
        if (control.ending()) break;
        known.number = static_cast<int>(rows.size());
        Scene one = scene;
        set(one, value);
        SweptScene row{value, solve_asked(one, control, &known)};
        if (control.stopped()) break;  // perhaps stopped halfway
        rows.push_back(std::move(row));
        if (solved) solved(rows.back());
    }
    return rows;
}

}  // namespace camopt
