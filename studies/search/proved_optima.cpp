// SPDX-License-Identifier: MIT
#include "studies/search/proved_optima.hpp"

#include "scene/cost_table.hpp"
#include "studies/delivered/smallest_of_any_motion.hpp"
#include "studies/search/cost_scale.hpp"

namespace camopt {

namespace {

using Eigen::Index;
using Eigen::VectorXd;
using SparseMatrix = Eigen::SparseMatrix<double>;

// Of ten thousand weights with 32 segments some sixty motions serve most; between these the optimum moves
// with every weight. The more are known the better, as long as memory allows: so many variables altogether.
constexpr std::size_t least_optima = 16, most_optima = 128, most_variables = 16384;
constexpr std::size_t most_tries = 3;  // equal optima differ in their multipliers
// The diagonal shift of the normal matrix, by its largest entry, and the refinements that remove it.
constexpr double normal_shift = 1e-13;
constexpr int most_refinements = 3;
// Fits after the first: where signs turn in all of them, there are none for this motion, or only a solve
// finds them.
constexpr int most_fits = 6;
constexpr double rounded_multiplier = 1e-13;  // turned by less: rounding of 0
constexpr double near_bound = 1e-6;           // relative: rows that may have a multiplier (certificate.hpp)

bool is_weighed_peak(const Parameter& parameter) {
    const bool peak = parameter.kind == Parameter::Kind::peak || parameter.kind == Parameter::Kind::torque;
    return peak && parameter.weight > 0.0;
}

/// Of the term that a parameter stands for.
double weight_of(const Parameter& parameter, const ObjectiveSpec& objective) {
    const bool torque = parameter.kind == Parameter::Kind::torque;
    for (const CostTerm& term : cost_terms())
        if (term.kind == (torque ? CostTerm::Kind::torque : CostTerm::Kind::peak) &&
            (torque || term.measured.order == parameter.order))
            return term.weight_in(objective);
    return parameter.weight;
}

SparseMatrix jacobian_of(const Nlp& problem, const VectorXd& x) {
    const SparsityPattern& pattern = problem.shape().jacobian;
    std::vector<double> values(static_cast<std::size_t>(pattern.size()));
    problem.jacobian(x, values);
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(values.size());
    for (std::size_t k = 0; k < values.size(); ++k)
        entries.emplace_back(pattern.rows[k], pattern.columns[k], values[k]);
    SparseMatrix jacobian(problem.shape().constraints(), problem.shape().variables());
    jacobian.setFromTriplets(entries.begin(), entries.end());
    return jacobian;
}

}  // namespace

ProvedOptimum::ProvedOptimum(CamProblem problem, VectorXd x, VectorXd multipliers)
    : problem_(std::move(problem)), x_(std::move(x)), multipliers_(std::move(multipliers)) {
    const Index proved = multipliers_.size();
    multipliers_.conservativeResize(problem_.grid().shape().constraints());  // the tie-break added rows
    multipliers_.tail(multipliers_.size() - proved).setZero();
    cost_.resize(x_.size());
    problem_.grid().gradient(x_, cost_);
    const CamModel& model = problem_.model();
    for (std::size_t p = 0; p < model.parameters.size(); ++p)
        if (is_weighed_peak(model.parameters[p]))
            weighed_.push_back(model.design.size() + static_cast<int>(p));
}

void ProvedOptimum::join(Solution solution, int number) {
    solution_ = std::move(solution);
    number_ = number;
}

std::vector<double> ProvedOptimum::weights_for(const Scene& scene) const {
    std::vector<double> weights;
    for (const Parameter& parameter : problem_.model().parameters)
        weights.push_back(is_weighed_peak(parameter) ? weight_of(parameter, scene.objective)
                                                     : parameter.weight);
    return weights;
}

double ProvedOptimum::objective_for(const Scene& scene) const {
    double objective = solution_.certificate.objective;
    for (const int variable : weighed_) {
        const auto p = static_cast<std::size_t>(variable - problem_.model().design.size());
        objective +=
            (weight_of(problem_.model().parameters[p], scene.objective) - cost_[variable]) * x_[variable];
    }
    return objective;
}

/// The step Λ G y of least Σ step² / |λ| with Gᵀ step = rest, in the columns of `rest`; refined on its own
/// residual.
Eigen::MatrixXd ProvedOptimum::step_for(const VectorXd& multipliers, Eigen::MatrixXd rest) {
    if (rows_.size() == 0) {
        rows_ = jacobian_of(problem_.grid(), x_);
        columns_ = rows_.transpose();
    }
    const SparseMatrix weighted = multipliers.cwiseAbs().asDiagonal() * rows_;
    SparseMatrix normal = columns_ * weighted;
    const double shift = normal_shift * normal.diagonal().maxCoeff();
    for (Index j = 0; j < normal.cols(); ++j) normal.coeffRef(j, j) += shift;
    if (slopes_.size() == 0) factor_.analyzePattern(normal);
    factor_.factorize(normal);
    Eigen::MatrixXd step = Eigen::MatrixXd::Zero(multipliers.size(), rest.cols());
    if (factor_.info() != Eigen::Success) return step;
    double size = rest.lpNorm<Eigen::Infinity>();
    for (int round = 0; round < most_refinements; ++round) {
        const Eigen::MatrixXd more = weighted * factor_.solve(rest);
        rest -= columns_ * more;
        const double now = rest.lpNorm<Eigen::Infinity>();
        if (!(now < size)) break;
        step += more;
        size = now;
    }
    return step;
}

/// For a cost that has changed. Signs that turn are set to 0, and what this leaves over is fitted again.
VectorXd ProvedOptimum::fitted(const VectorXd& cost) {
    if (slopes_.size() == 0) {
        Eigen::MatrixXd units = Eigen::MatrixXd::Zero(x_.size(), static_cast<Index>(weighed_.size()));
        for (std::size_t k = 0; k < weighed_.size(); ++k) units(weighed_[k], static_cast<Index>(k)) = -1.0;
        slopes_ = step_for(multipliers_, units);
    }
    VectorXd result = multipliers_;
    for (std::size_t k = 0; k < weighed_.size(); ++k)
        result += (cost - cost_)[weighed_[k]] * slopes_.col(static_cast<Index>(k));
    const NlpShape& shape = problem_.grid().shape();
    for (int round = 0; round < most_fits; ++round) {
        double turned = 0.0;
        for (Index i = 0; i < result.size(); ++i) {
            if (shape.g_lower[i] == shape.g_upper[i] || result[i] * multipliers_[i] >= 0.0) continue;
            turned = std::max(turned, std::abs(result[i]));
            result[i] = 0.0;
        }
        if (turned <= rounded_multiplier) break;
        result += step_for(result, -cost - columns_ * result);
    }
    return result;
}

Certificate ProvedOptimum::certificate_for(const Scene& scene) {
    problem_.set_weights(weights_for(scene));
    const Nlp& grid = problem_.grid();
    Certificate certificate = solution_.certificate;
    certificate.objective = grid.cost(x_);
    forget_proof(certificate);
    if (!problem_.convex(certificate.objective)) return certificate;
    VectorXd cost(x_.size());
    grid.gradient(x_, cost);
    const VectorXd multipliers = fitted(cost);
    certificate.proof =
        duality_proof(grid, x_, multipliers, problem_.box(certificate.objective, 0.0), "objective");
    certificate.proof_kind = ProofKind::duality;
    certificate.lower_bound = certificate.proof->bound;
    certificate.gap = relative_gap(certificate.objective, certificate.proof->bound);
    certificate.stationarity = stationarity_of(grid, x_, multipliers, near_bound);
    return certificate;
}

std::optional<Solution> ProvedOptimum::solution_for(const Scene& scene) {
    const Stopwatch watch;
    const std::lock_guard turn(busy_);
    Certificate certificate = certificate_for(scene);
    const bool proved =
        certificate.lower_bound && *certificate.gap <= scene.solver.tolerance &&
        *certificate.gap <= scene.solver.wanted_gap() &&
        !bound_passes(certificate.objective, *certificate.lower_bound, scene.solver.tolerance);
    if (!proved) return std::nullopt;
    Solution solution = solution_;
    solution.scene.objective = scene.objective;
    solution.certificate = std::move(certificate);
    if (solution.any_curve_limit) solution.any_curve_limit = limit_curve(scene, solution.reference_peaks);
    solution.solver.iterations = solution.solver.exchange_rounds = 0;
    solution.solver.proof_source = "multipliers fitted to a known optimum";
    solution.solver.proved_from = number_;
    solution.evaluations = {};
    solution.phases = {};
    solution.seconds_total = solution.seconds_solve = solution.phases.proof = watch.seconds();
    return solution;
}

void ProvedOptima::propose(CamProblem problem, const VectorXd& x, const VectorXd& multipliers) {
    proposed_ = std::make_shared<ProvedOptimum>(std::move(problem), x, multipliers);
}

void ProvedOptima::settle(const Solution& solution, int number) {
    const std::shared_ptr<ProvedOptimum> optimum = std::exchange(proposed_, nullptr);
    const bool useful = optimum && solution.certificate.verdict == Verdict::optimal && solution.motion &&
                        !solution.measured && !solution.scene.drive &&
                        !weighs_any(solution.scene.objective, CostTerm::Kind::rms);
    if (!useful) return;
    std::erase_if(known_, [&](const auto& other) {
        return !differ_in_peak_weights_only(other->solution().scene, solution.scene);
    });
    optimum->join(solution, number);
    known_.push_front(optimum);
    const std::size_t most = std::clamp(most_variables / static_cast<std::size_t>(optimum->variables()),
                                        least_optima, most_optima);
    if (known_.size() > most) known_.pop_back();
}

std::optional<Solution> ProvedOptima::proved(const Scene& scene) {
    if (known_.empty() || !differ_in_peak_weights_only(known_.front()->solution().scene, scene))
        return std::nullopt;
    std::vector<std::pair<double, ProvedOptimum*>> tries;  // by their objectives
    for (const std::shared_ptr<ProvedOptimum>& optimum : known_)
        if (weigh_same_peaks(optimum->solution().scene.objective, scene.objective) &&
            CostScale::are_near_one(scene, optimum->solution().reference_peaks))
            tries.emplace_back(optimum->objective_for(scene), optimum.get());
    std::ranges::stable_sort(tries, {}, [](const auto& one) { return one.first; });
    tries.resize(std::min(tries.size(), most_tries));
    for (const auto& [objective, optimum] : tries) {
        const double least = tries.front().first;
        if (objective > least + scene.solver.tolerance * std::max(1.0, std::abs(least))) break;
        if (std::optional<Solution> solution = optimum->solution_for(scene)) return solution;
    }
    return std::nullopt;
}

}  // namespace camopt
