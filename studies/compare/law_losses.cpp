// SPDX-License-Identifier: MIT
#include "studies/compare/law_losses.hpp"

#include "objectives/scene_model.hpp"
#include "studies/compare/matrix_game.hpp"
#include "studies/pareto/front_goal.hpp"
#include "studies/solve/solve_sequence.hpp"

#include <algorithm>
#include <cmath>

namespace camopt {

namespace {

constexpr std::array<FrontFigure, 3> goals = {FrontFigure::velocity, FrontFigure::acceleration,
                                              FrontFigure::jerk};
// Of the objective: closer bounds do not change a printed per cent.
constexpr double settled_gap = 1e-6;
constexpr int most_cuts = 40;

bool usable(double value) {
    return std::isfinite(value) && value > 0.0;
}

PeakTriple triple(const Peaks& peaks) {
    return {peaks.velocity.value, peaks.acceleration.value, peaks.jerk.value};
}

Scene with_weights(const Scene& scene, const PeakTriple& weights) {
    Scene weighted = scene;
    scale_weights(weighted, 0.0);
    for (std::size_t i = 0; i < goals.size(); ++i) set_weight(weighted, goals[i], weights[i]);
    return weighted;
}

class LossFinder {
 public:
    LossFinder(const Scene& scene, const PeakTriple& reference, const SolveControl& control)
        : scene_(scene), reference_(reference), control_(control) {}

    void add_cut(const PeakTriple& peaks);

    [[nodiscard]] std::optional<ClosestApproach> closest(const PeakTriple& law);
    [[nodiscard]] std::optional<double> least(const PeakTriple& law, std::size_t peak);
    [[nodiscard]] int solves() const { return solves_; }

 private:
    /// The scene with these weights; none where it has no motion or was stopped.
    [[nodiscard]] std::optional<Solution> solve(const Scene& scene, SolveSequence& sequence);
    /// The best shares for all cuts. In shares u_i = w_i · (law's peak i over its reference) the law's
    /// objective is 1.
    [[nodiscard]] GameValue best_shares(const PeakTriple& law) const;

    const Scene& scene_;
    const PeakTriple& reference_;
    const SolveControl& control_;
    SolveSequence weighted_, capped_;
    std::vector<PeakTriple> cuts_;  ///< peaks of motions over the references: they serve every law
    int solves_ = 0;
};

std::optional<Solution> LossFinder::solve(const Scene& scene, SolveSequence& sequence) {
    if (control_.stopped()) return {};
    ++solves_;
    Solution solution = sequence.solve(scene, control_);
    const Verdict verdict = solution.certificate.verdict;
    const bool feasible =
        verdict == Verdict::optimal || verdict == Verdict::local || verdict == Verdict::feasible;
    if (control_.stopped() || !feasible) return {};
    return solution;
}

void LossFinder::add_cut(const PeakTriple& peaks) {
    PeakTriple cut = peaks;
    for (std::size_t i = 0; i < 3; ++i) cut[i] /= reference_[i];
    cuts_.push_back(cut);
}

GameValue LossFinder::best_shares(const PeakTriple& law) const {
    std::vector<PeakTriple> rows = cuts_;
    for (PeakTriple& row : rows)
        for (std::size_t i = 0; i < 3; ++i) row[i] *= reference_[i] / law[i];
    if (rows.empty()) return {{1.0 / 3, 1.0 / 3, 1.0 / 3}, infinity, infinity};
    return solve_game_by_cuts(rows);
}

std::optional<ClosestApproach> LossFinder::closest(const PeakTriple& law) {
    std::optional<ClosestApproach> best;
    for (int round = 0; round < most_cuts; ++round) {
        const GameValue game = best_shares(law);
        PeakTriple weights{};
        for (std::size_t i = 0; i < 3; ++i) weights[i] = game.mix[i] * reference_[i] / law[i];
        const double sum = weights[0] + weights[1] + weights[2];
        for (double& weight : weights) weight /= sum;
        const std::optional<Solution> solution = solve(with_weights(scene_, weights), weighted_);
        if (!solution) return best;
        const double reached = solution->certificate.objective * sum;  // the law's is 1
        const double loss = 100.0 * (1.0 / reached - 1.0);
        const bool settled = reached >= game.value - settled_gap;
        if (!best || loss < best->loss_percent || settled) best = ClosestApproach{weights, loss, settled};
        if (settled) return best;
        add_cut(triple(solution->peaks));
    }
    return best;
}

std::optional<double> LossFinder::least(const PeakTriple& law, std::size_t peak) {
    Scene scene = scene_;
    scale_weights(scene, 0.0);
    set_weight(scene, goals[peak], 1.0);
    for (std::size_t i = 0; i < 3; ++i) {
        if (i == peak) continue;
        if (!can_be_capped(scene_, goals[i])) return {};
        set_cap(scene, goals[i], std::min(law[i], limit_on(scene_, goals[i]).value_or(infinity)));
    }
    const std::optional<Solution> solution = solve(scene, capped_);
    return solution ? std::optional(triple(solution->peaks)[peak]) : std::nullopt;
}

}  // namespace

LawLosses law_losses(const Scene& scene, const SolveControl& control, std::span<const PeakTriple> known) {
    LawLosses losses;
    losses.reference = triple(reference_peaks(scene));
    if (!std::ranges::all_of(losses.reference, usable)) return losses;
    const Comparison comparison = compare(scene, control);
    LossFinder finder(scene, losses.reference, control);
    for (const PeakTriple& peaks : known) finder.add_cut(peaks);
    for (const ComparisonRow& row : comparison.rows) {
        if (row.is_optimum() || !row.misfit.empty() || !meets_conditions(row)) continue;
        const PeakTriple peaks = triple(row.peaks);
        if (!std::ranges::all_of(peaks, usable)) continue;
        if (control.progress) {
            const std::string line = "how far from the best: " + row.title;
            control.progress(line);
        }
        LawLoss loss{row.key, row.title, peaks, row.feasible, row.loss_percent, finder.closest(peaks), {}};
        if (loss.closest && loss.closest->loss_percent < 0.0 && !row.feasible) loss.closest.reset();
        for (std::size_t i = 0; i < 3; ++i) loss.least[i] = finder.least(peaks, i);
        losses.laws.push_back(std::move(loss));
    }
    std::ranges::stable_sort(losses.laws, {}, [](const LawLoss& loss) {
        return loss.closest ? loss.closest->loss_percent : infinity;
    });
    losses.solves = finder.solves();
    losses.complete = !control.stopped();
    return losses;
}

}  // namespace camopt
