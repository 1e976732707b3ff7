// SPDX-License-Identifier: MIT
// Private to studies/machine/: the optimization problem of a machine at one speed, and its trial.
#pragma once

#include "objectives/machine/machine_problem.hpp"
#include "studies/machine/machine_solution.hpp"
#include "studies/search/planned_solve.hpp"

namespace camopt {

/// The axes posed at one speed; their models are in the problem.
struct PosedMachine {
    std::vector<std::unique_ptr<const Scene>> scenes;
    std::vector<std::unique_ptr<PosedScene>> posed;
    std::vector<std::shared_ptr<const SolvePlan>> plans;
    std::unique_ptr<MachineProblem> problem;
    /// Of each axis: limits that are not convex and left out of the problem, at a given speed.
    std::vector<std::vector<std::string>> left_out;
};

/// What one speed leaves for the next: rows, motions, and which axes are held within their strokes.
struct MachineMemory {
    /// Of axes that do not name theirs: few variables and no equalities, so that the factor of a machine,
    /// which is no chain, needs no shift. Measured with 12 axes of 32 segments and 20 clearances.
    DesignKind design = DesignKind::coefficients;
    std::vector<std::vector<RuleSample>> axes;
    std::vector<std::vector<double>> clearances;
    std::vector<bool> held;
    Eigen::VectorXd x;  ///< by `design`
    void keep(const MachineProblem& problem);
};

/// Throws SceneError for an axis whose problem is not convex; at a given speed only for a term.
[[nodiscard]] PosedMachine posed_machine(const MachineSpec& machine, const std::vector<Scene>& scenes,
                                         const MachineMemory& memory);
/// Tolerances of the machine: the tightest of its axes.
[[nodiscard]] ExchangeOptions machine_exchange(const MachineSpec& machine, double seconds);

/// What stops a machine, from the proof of impossibility; `problem`: of that proof.
[[nodiscard]] std::vector<MachineLimit> limits_of_proof(const MachineSpec& machine,
                                                        const MachineProblem& problem,
                                                        const DualityProof& proof);
/// Fills MachineLimit::needed for the speed of `scenes`.
void ask_what_is_needed(const MachineSpec& machine, const std::vector<Scene>& scenes,
                        const MachineMemory& memory, std::vector<MachineLimit>& limits,
                        const ExchangeOptions& exchange, const SolveControl& control);

/// The least total objective, from the start of the problem. `persistent`: what is left without a proof is
/// tried in every way that a single motion is (studies/search/convex_solve.hpp).
[[nodiscard]] ContinuousResult least_total(MachineProblem& problem, const ExchangeOptions& exchange,
                                           const JudgeOptions& judge, const SolveControl& control,
                                           bool persistent);

/// True: an axis that was not held leaves the range of a stroke at x; it is held from now on.
[[nodiscard]] bool hold_strokes(const PosedMachine& posed, const Eigen::VectorXd& x, MachineMemory& memory);

/// One axis as solve() delivers it. `x`: of the machine.
[[nodiscard]] Solution delivered_axis(PosedMachine& machine, int index, const Eigen::VectorXd& x);

/// Of a machine whose angles are fixed.
struct FixedMachine {
    std::function<MachineSolution(const MachineSpec&, const MachineOptions&, const SolveControl&)> solve;
    /// A speed of motions, no less than the machine's least one, without the search for the largest; none: at
    /// the least there are none, or that is not decided.
    std::function<std::optional<double>(const MachineSpec&, const MachineOptions&, const SolveControl&)>
        passing;
};
/// Whether an axis has two segments or more whose angles are ranges.
[[nodiscard]] bool searches_timing(const MachineSpec& machine);
[[nodiscard]] MachineSolution solve_with_timing(const MachineSpec& machine, const MachineOptions& options,
                                                const SolveControl& control, const FixedMachine& fixed);

}  // namespace camopt
