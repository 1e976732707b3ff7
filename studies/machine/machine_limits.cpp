// SPDX-License-Identifier: MIT
// What stops a machine: the limits and clearances that carry the proof of impossibility, and what each alone
// would have to be for more speed.
#include "scene/limit_table.hpp"
#include "solvers/structured/structured_solver.hpp"
#include "studies/machine/machine_build.hpp"

namespace camopt {

namespace {

// Rows that carry less than this part of a proof do not explain anything.
constexpr double telling_share = 1e-3;

constexpr int most_passes = 30;

/// A limit of the motion or of the motor whose violation is relative to its own number, as written.
struct WrittenNumber {
    double given = 0.0;
    std::string unit;
    int side = 0;
    bool square = false;  ///< the rule holds half of its square

    /// With the violation that its rule is relaxed by.
    [[nodiscard]] double relaxed(double by) const {
        if (square) return given * std::sqrt(1.0 + 2.0 * by);
        return given + (side < 0 ? -1.0 : 1.0) * by * std::abs(given);
    }
};
std::optional<WrittenNumber> written_number(const Scene& scene, std::string_view key) {
    for (const PeakLimitRow& row : peak_limit_rows())
        if (const auto& limit = row.in(scene.limits); limit && limit->key == key)
            return WrittenNumber{limit->given, limit->unit, row.side};
    for (const LimitedFigure figure : {LimitedFigure::motor_torque, LimitedFigure::motor_torque_rms,
                                       LimitedFigure::motor_speed, LimitedFigure::spring_harmonic})
        if (const auto& limit = limit_on(scene.limits, figure); limit && limit->key == key)
            return WrittenNumber{limit->given(), limit->unit, 0, figure == LimitedFigure::motor_torque_rms};
    return {};
}

std::string rule_of(const MachineSpec& machine, const MachineLimit& limit) {
    if (limit.clearance >= 0) return name_of_clearance(limit.clearance);
    return machine.axes[static_cast<std::size_t>(limit.axis)].name + ": " + limit.key;
}

/// The least relaxation of one rule, relative to its scale, with which the others can hold; none: no
/// relaxation is enough, or it was not found.
std::optional<double> least_relaxation(MachineProblem& problem, const ExchangeOptions& exchange,
                                       const SolveControl& control) {
    ElasticProblem elastic(problem);
    Eigen::VectorXd start = elastic.start();
    for (int pass = 0; pass < most_passes && !control.ending(); ++pass) {
        const ExchangeResult result =
            minimize_by_exchange(elastic, *make_structured_solver(), start, exchange, control);
        if (!result.converged || result.last.termination != Termination::converged ||
            result.last.x.size() == 0)
            return {};
        // The exchange asks for the violations of the relaxed rule only: the others must hold as well.
        start = result.last.x;
        std::vector<Violation> worst = elastic.violations(start, 0.0);
        std::erase_if(worst, [&](const Violation& one) { return one.amount <= 10.0 * exchange.tolerance; });
        if (worst.empty()) return start[start.size() - 1];
        if (elastic.refine(worst) == 0) return {};
    }
    return {};
}

}  // namespace

std::vector<MachineLimit> limits_of_proof(const MachineSpec& machine, const MachineProblem& problem,
                                          const DualityProof& proof) {
    std::vector<MachineLimit> limits;
    std::vector<double> heaviest;
    double whole = 0.0;
    for (std::size_t i = 0; i < proof.origins.size(); ++i) {
        const RowOrigin& origin = proof.origins[i];
        const double weight = std::abs(proof.multipliers[static_cast<Eigen::Index>(i)]);
        if (!origin.limit || weight == 0.0) continue;
        whole += weight;
        const MachineOrigin place = problem.place(origin);
        auto found = std::ranges::find_if(limits, [&](const MachineLimit& limit) {
            return limit.axis == place.axis && limit.clearance == place.clearance &&
                   (place.clearance >= 0 || limit.key == place.rule);
        });
        if (found == limits.end()) {
            MachineLimit limit;
            limit.axis = place.axis;
            limit.clearance = place.clearance;
            limit.key = place.rule;
            found = limits.insert(limits.end(), limit);
            heaviest.push_back(0.0);
        }
        found->share += weight;
        double& most = heaviest[static_cast<std::size_t>(found - limits.begin())];
        if (weight > most) {
            most = weight;
            found->angle = place.angle;
        }
    }
    for (MachineLimit& limit : limits) {
        limit.share /= whole;
        if (limit.clearance >= 0) {
            const Clearance& written = machine.clearances[static_cast<std::size_t>(limit.clearance)];
            limit.key = written.key.empty() ? name_of_clearance(limit.clearance) + ".at_least" : written.key;
            limit.unit = written.unit;
            limit.given = as_written(written.at_least / written.unit_value);
        } else if (const std::optional<WrittenNumber> written =
                       written_number(machine.axes[static_cast<std::size_t>(limit.axis)].scene, limit.key)) {
            limit.unit = written->unit;
            limit.given = written->given;
        }
    }
    std::erase_if(limits, [](const MachineLimit& limit) { return limit.share < telling_share; });
    std::ranges::stable_sort(limits, std::greater{}, &MachineLimit::share);
    return limits;
}

void ask_what_is_needed(const MachineSpec& machine, const std::vector<Scene>& scenes,
                        const MachineMemory& memory, std::vector<MachineLimit>& limits,
                        const ExchangeOptions& exchange, const SolveControl& control) {
    PosedMachine posed = posed_machine(machine, scenes, memory);
    for (MachineLimit& limit : limits) {
        if (!limit.given || control.ending()) continue;
        posed.problem->relax_only(rule_of(machine, limit));
        const std::optional<double> relaxed = least_relaxation(*posed.problem, exchange, control);
        limit.asked = true;
        if (!relaxed) continue;
        limit.enough_alone = true;
        if (limit.clearance >= 0) {
            const Clearance& written = machine.clearances[static_cast<std::size_t>(limit.clearance)];
            const double scale = posed.problem->clearance_scale(limit.clearance);
            limit.needed = (written.at_least - *relaxed * scale) / written.unit_value;
        } else {
            limit.needed = written_number(machine.axes[static_cast<std::size_t>(limit.axis)].scene, limit.key)
                               .value()
                               .relaxed(*relaxed);
        }
    }
}

}  // namespace camopt
