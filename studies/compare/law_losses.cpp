// SPDX-License-Identifier: MIT
#include "studies/compare/law_losses.hpp"

#include "studies/least/least_value.hpp"
#include "studies/pareto/sweep_front.hpp"
#include "studies/search/planned_solve.hpp"

#include <Eigen/LU>

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
        : scene_(scene), reference_(reference), control_(control) {
        scene_.objective.tie_break = TieBreak::none;  // only peaks count, which equal optima share
    }

    void add_cut(const PeakTriple& peaks) {
        PeakTriple cut = peaks;
        for (std::size_t i = 0; i < 3; ++i) cut[i] /= reference_[i];
        cuts_.push_back(cut);
    }

    [[nodiscard]] std::optional<ClosestApproach> closest(const PeakTriple& law) {
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
    [[nodiscard]] std::optional<double> least(const PeakTriple& law, std::size_t peak) {
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
    [[nodiscard]] int solves() const { return solves_; }

 private:
    /// The scene with these weights; none where it has no motion or was stopped.
    [[nodiscard]] std::optional<Solution> solve(const Scene& scene, KnownSolutions& known) {
        if (control_.stopped()) return {};
        ++solves_;
        Solution solution = solve_without_explaining(scene, control_, &known);
        if (control_.stopped() || !has_feasible_motion(solution.certificate.verdict)) return {};
        return solution;
    }
    /// The best shares for all cuts. In shares u_i = w_i · (law's peak i over its reference) the law's
    /// objective is 1.
    [[nodiscard]] GameValue best_shares(const PeakTriple& law) const {
        std::vector<PeakTriple> rows = cuts_;
        for (PeakTriple& row : rows)
            for (std::size_t i = 0; i < 3; ++i) row[i] *= reference_[i] / law[i];
        if (rows.empty()) return {{1.0 / 3, 1.0 / 3, 1.0 / 3}, infinity, infinity};
        return solve_game_by_cuts(rows);
    }

    Scene scene_;
    const PeakTriple& reference_;
    const SolveControl& control_;
    KnownSolutions weighted_, capped_;
    std::vector<PeakTriple> cuts_;  ///< peaks of motions over the references: they serve every law
    int solves_ = 0;
};

// Corners of nearly parallel faces are far away, rounding or no numbers at all (the determinant may round to
// more than this where a pivot is zero); others of the same value stand beside them.
constexpr double singular = 1e-24;
// A share below zero by this much is zero.
constexpr double game_rounding = 1e-12;
// A row lower by less than this changes nothing.
constexpr double same_value = 1e-12;

double least_row(std::span<const std::array<double, 3>> rows, const Eigen::Vector3d& mix) {
    double least = infinity;
    for (const std::array<double, 3>& row : rows)
        least = std::min(least, row[0] * mix[0] + row[1] * mix[1] + row[2] * mix[2]);
    return least;
}

/// Faces over (u, t): row · u − t = 0 for each row, then u_i = 0.
std::vector<Eigen::Vector4d> faces_of(std::span<const std::array<double, 3>> rows) {
    std::vector<Eigen::Vector4d> faces;
    for (const std::array<double, 3>& row : rows) faces.emplace_back(row[0], row[1], row[2], -1.0);
    for (int i = 0; i < 3; ++i) faces.emplace_back(Eigen::Vector4d::Unit(i));
    return faces;
}

/// The most that any column has of these rows mixed.
double most_of_columns(std::span<const std::array<double, 3>> rows, const std::array<std::size_t, 3>& chosen,
                       const Eigen::Vector3d& shares) {
    std::array<double, 3> columns{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 3; ++k)
            if (const double share = shares[static_cast<Eigen::Index>(i)]; share > 0.0)
                columns[k] += share * rows[chosen[i]][k];
    return std::ranges::max(columns);
}

/// Three rows (some of them the same one: fewer) mixed so that `columns` of them are equal.
double bound_by(std::span<const std::array<double, 3>> rows, const std::array<std::size_t, 3>& chosen,
                std::span<const int> columns) {
    const auto count = static_cast<Eigen::Index>(columns.size());
    Eigen::MatrixXd system = Eigen::MatrixXd::Zero(count + 1, count + 1);
    for (Eigen::Index i = 0; i < count; ++i) {
        for (Eigen::Index j = 0; j < count; ++j)
            system(j, i) = rows[chosen[static_cast<std::size_t>(i)]]
                               [static_cast<std::size_t>(columns[static_cast<std::size_t>(j)])];
        system(i, count) = -1.0;
        system(count, i) = 1.0;
    }
    const Eigen::VectorXd solution = system.partialPivLu().solve(Eigen::VectorXd::Unit(count + 1, count));
    Eigen::Vector3d shares = Eigen::Vector3d::Zero();
    shares.head(count) = solution.head(count).cwiseMax(0.0);
    const double sum = shares.sum();
    if (!shares.allFinite() || !(sum > 0.0)) return infinity;
    return most_of_columns(rows, chosen, shares / sum);
}

/// The least bound of all mixes of one, two or three rows.
double least_bound(std::span<const std::array<double, 3>> rows) {
    static constexpr std::array<std::array<int, 2>, 3> pairs = {{{0, 1}, {0, 2}, {1, 2}}};
    static constexpr std::array<int, 3> all = {0, 1, 2};
    double least = infinity;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        least = std::min(least, std::ranges::max(rows[i]));
        for (std::size_t j = i + 1; j < rows.size(); ++j) {
            for (const std::array<int, 2>& pair : pairs)
                least = std::min(least, bound_by(rows, {i, j, j}, pair));
            for (std::size_t k = j + 1; k < rows.size(); ++k)
                least = std::min(least, bound_by(rows, {i, j, k}, all));
        }
    }
    return least;
}

}  // namespace

LawLosses law_losses(const Scene& scene, const SolveControl& control, std::span<const PeakTriple> known) {
    refuse_sought_number(scene, "how far laws are from the best");
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

GameValue solve_game(std::span<const std::array<double, 3>> rows) {
    const std::vector<Eigen::Vector4d> faces = faces_of(rows);
    GameValue best{{1.0, 0.0, 0.0}, -infinity, 0.0};
    Eigen::Matrix4d system;
    system.row(3) << 1.0, 1.0, 1.0, 0.0;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        for (std::size_t j = i + 1; j < faces.size(); ++j) {
            for (std::size_t k = j + 1; k < faces.size(); ++k) {
                system.row(0) = faces[i];
                system.row(1) = faces[j];
                system.row(2) = faces[k];
                if (std::abs(system.determinant()) < singular) continue;
                Eigen::Vector3d mix = system.partialPivLu().solve(Eigen::Vector4d::Unit(3)).head<3>();
                if (!mix.allFinite() || mix.minCoeff() < -game_rounding) continue;
                mix = mix.cwiseMax(0.0) / mix.cwiseMax(0.0).sum();
                const double value = least_row(rows, mix);
                if (value > best.value) best = {{mix[0], mix[1], mix[2]}, value};
            }
        }
    }
    best.bound = least_bound(rows);
    return best;
}

GameValue solve_game_by_cuts(std::span<const std::array<double, 3>> rows) {
    GameValue game{{1.0 / 3, 1.0 / 3, 1.0 / 3}, infinity, infinity};
    std::vector<std::array<double, 3>> chosen;
    while (true) {
        const std::array<double, 3>* lowest = nullptr;
        double least = game.value - same_value;
        for (const std::array<double, 3>& row : rows) {
            const double value = game.mix[0] * row[0] + game.mix[1] * row[1] + game.mix[2] * row[2];
            if (!(value < least)) continue;
            least = value;
            lowest = &row;
        }
        // A row that is in the game already is lower by rounding alone.
        if (lowest == nullptr || std::ranges::find(chosen, *lowest) != chosen.end()) return game;
        chosen.push_back(*lowest);
        game = solve_game(chosen);
    }
}

}  // namespace camopt
