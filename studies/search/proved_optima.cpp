// SPDX-License-Identifier: MIT
#include "studies/search/proved_optima.hpp"

#include "objectives/cost_units.hpp"
#include "scene/cost_table.hpp"
#include "solvers/exchange/exchange.hpp"
#include "studies/delivered/delivered_audit.hpp"
#include "studies/delivered/smallest_of_any_motion.hpp"
#include "studies/delivered/solution_report.hpp"

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
// Parts of the largest multiplier and of the largest pivot: rows and directions with less are not held.
constexpr double carrying = 1e-6, least_pivot = 1e-11;
// Times the tolerance: a moved motion that violates a limit between its rows by less is corrected.
constexpr double most_corrected = 10.0;

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

bool is_proved_for(const Scene& scene, const Certificate& certificate) {
    return certificate.lower_bound && *certificate.gap <= scene.solver.tolerance &&
           *certificate.gap <= scene.solver.wanted_gap() &&
           !bound_passes(certificate.objective, *certificate.lower_bound, scene.solver.tolerance);
}

/// Whether an optimum of one scene may serve the other.
bool may_share_optima(const Scene& one, const Scene& other) {
    return differ_in_peak_weights_only(one, other) || differ_in_peak_limits_only(one, other);
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

bool differ_in_peak_limits_only(const Scene& one, const Scene& other) {
    const auto is_plain = [](const Scene& scene) {
        const MotionSpec& motion = scene.motion;
        return motion.type != MotionType::program && motion.via.empty() && motion.corridors.empty() &&
               !motion.start && !motion.end && !scene.cam && !scene.forces && !scene.dynamics &&
               !scene.drive && !scene.measured && scene.own_terms.empty() && scene.own_limits.empty();
    };
    if (!is_plain(one) || !is_plain(other)) return false;
    MotionSpec motion = other.motion;
    motion.lift = one.motion.lift;
    LimitSpec limits = other.limits;
    for (const CostTerm& term : cost_terms()) {
        if (term.limit == nullptr) continue;
        std::optional<PeakLimit>& limit = limits.*term.limit;
        const std::optional<PeakLimit>& wanted = one.limits.*term.limit;
        if (limit && wanted && limit->key == wanted->key) limit = wanted;
    }
    return one.objective == other.objective && one.motion == motion && one.spline == other.spline &&
           one.limits == limits && one.solver == other.solver && one.title == other.title &&
           one.length_unit == other.length_unit;
}

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

/// Of the rows on parameters; empty where a limit of the scene has none.
std::vector<double> ProvedOptimum::uppers_for(const Scene& scene) const {
    const CamModel& model = problem_.model();
    std::vector<double> uppers;
    for (const ParameterRow& row : model.parameter_rows) uppers.push_back(row.upper);
    for (const CostTerm& term : cost_terms()) {
        if (term.limit == nullptr || !(scene.limits.*term.limit)) continue;
        const PeakLimit& limit = *(scene.limits.*term.limit);
        const auto row = std::ranges::find(model.parameter_rows, limit.key, &ParameterRow::name);
        if (row == model.parameter_rows.end()) return {};
        const Parameter& peak = model.parameters[static_cast<std::size_t>(row->parameters.front())];
        uppers[static_cast<std::size_t>(row - model.parameter_rows.begin())] =
            limit.normalised / peak.reference;
    }
    return uppers;
}

double ProvedOptimum::rank_for(const Scene& scene) const {
    double objective = solution_.certificate.objective;
    if (differ_in_peak_weights_only(solution_.scene, scene)) {
        for (const int variable : weighed_) {
            const auto p = static_cast<std::size_t>(variable - problem_.model().design.size());
            objective +=
                (weight_of(problem_.model().parameters[p], scene.objective) - cost_[variable]) * x_[variable];
        }
        return objective;
    }
    const std::vector<double> own = uppers_for(solution_.scene), uppers = uppers_for(scene);
    const auto first = static_cast<Index>(problem_.model().design.equalities().size());
    for (std::size_t k = 0; k < std::min(own.size(), uppers.size()); ++k)
        objective -= multipliers_[first + static_cast<Index>(k)] * (uppers[k] - own[k]);
    return -objective;
}

/// The problem becomes that of the scene.
void ProvedOptimum::pose(const Scene& scene) {
    problem_.set_weights(weights_for(scene));
    problem_.set_uppers(uppers_for(scene));
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

Certificate ProvedOptimum::proved(const VectorXd& x, const VectorXd& multipliers) const {
    const Nlp& grid = problem_.grid();
    Certificate certificate = solution_.certificate;
    certificate.objective = grid.cost(x);
    forget_proof(certificate);
    if (!problem_.convex(certificate.objective)) return certificate;
    certificate.proof =
        duality_proof(grid, x, multipliers, problem_.box(certificate.objective, 0.0), "objective");
    certificate.proof_kind = ProofKind::duality;
    certificate.lower_bound = certificate.proof->bound;
    certificate.gap = relative_gap(certificate.objective, certificate.proof->bound);
    certificate.stationarity = stationarity_of(grid, x, multipliers, near_bound);
    return certificate;
}

Certificate ProvedOptimum::certificate_for(const Scene& scene) {
    pose(scene);
    VectorXd cost(x_.size());
    problem_.grid().gradient(x_, cost);
    return proved(x_, fitted(cost));
}

std::optional<Solution> ProvedOptimum::same_motion_for(const Scene& scene) {
    Certificate certificate = certificate_for(scene);
    if (!is_proved_for(scene, certificate)) return std::nullopt;
    Solution solution = solution_;
    solution.scene.objective = scene.objective;
    solution.certificate = std::move(certificate);
    solution.solver.proof_source = "multipliers fitted to a known optimum";
    return solution;
}

/// M, and in a last column the step that removes the rounding of x from these rows; of the posed problem.
/// Empty where the rows leave a direction open: several motions are optimal.
Eigen::MatrixXd ProvedOptimum::moves() const {
    const Nlp& grid = problem_.grid();
    const NlpShape& shape = grid.shape();
    const auto first = static_cast<Index>(problem_.model().design.equalities().size());
    const auto count = static_cast<Index>(problem_.model().parameter_rows.size());
    const double least = carrying * multipliers_.lpNorm<Eigen::Infinity>();
    VectorXd values(shape.constraints());
    grid.constraints(x_, values);
    SparseMatrix columns = jacobian_of(grid, x_).transpose();  // Nᵀ: its columns are unit rows, or 0
    Eigen::MatrixXd right = Eigen::MatrixXd::Zero(columns.rows(), count + 1);
    for (Index i = 0; i < columns.cols(); ++i) {
        const bool held = shape.g_lower[i] == shape.g_upper[i] || std::abs(multipliers_[i]) > least;
        const double length = columns.col(i).norm();
        columns.col(i) *= held && length > 0.0 ? 1.0 / length : 0.0;
        if (!held || !(length > 0.0)) continue;
        const double bound = multipliers_[i] < 0.0 ? shape.g_lower[i] : shape.g_upper[i];
        right.col(count) += (bound - values[i]) / length * columns.col(i);
        if (i >= first && i < first + count) right.col(i - first) = columns.col(i) / length;
    }
    SparseMatrix normal = columns * SparseMatrix(columns.transpose());
    // A peak that is limited but neither weighed nor at its limit is in no row: it follows from the motion.
    for (Index j = problem_.model().design.size(); j < normal.cols(); ++j)
        if (!(normal.coeff(j, j) > 0.0)) normal.coeffRef(j, j) = 1.0;
    const Eigen::SimplicialLDLT<SparseMatrix> factor(normal);
    if (factor.info() != Eigen::Success) return {};
    const VectorXd pivots = factor.vectorD();
    if (!(pivots.minCoeff() > least_pivot * pivots.maxCoeff())) return {};
    Eigen::MatrixXd moves = factor.solve(right);
    for (int round = 0; round < most_refinements; ++round)
        moves += factor.solve(right - normal * moves).eval();
    return moves;
}

/// The limits move the motion, and the rows that carry the multipliers hold it.
std::optional<Solution> ProvedOptimum::moved_motion_for(const Scene& scene) {
    if (!solution_.notes.empty()) return std::nullopt;  // they may be of the other motion
    if (!moves_) {
        pose(solution_.scene);
        moves_ = moves();
    }
    const std::vector<double> own = uppers_for(solution_.scene), uppers = uppers_for(scene);
    if (moves_->size() == 0 || uppers.empty()) return std::nullopt;
    pose(scene);
    const double tolerance = scene.solver.tolerance;
    double part = 1.0;  // of the limits
    Candidate moved;
    for (int pass = 0; pass < 2; ++pass) {
        VectorXd x = x_ + moves_->rightCols(1);
        for (std::size_t k = 0; k < uppers.size(); ++k)
            x += (part * uppers[k] - own[k]) * moves_->col(static_cast<Index>(k));
        moved = judged(problem_, x);
        if (moved.violation <= 0.0 || moved.violation > most_corrected * tolerance) break;
        part = 1.0 - moved.violation;  // between its rows, whose maximum moves along
    }
    if (!(moved.violation <= tolerance)) return std::nullopt;
    Solution solution;
    solution.certificate = proved(moved.x, multipliers_);
    solution.certificate.worst_violation = moved.violation;
    if (!is_proved_for(scene, solution.certificate)) return std::nullopt;
    solution.scene = scene;
    solution.plan = solution_.plan;
    solution.reference_peaks = solution_.reference_peaks;
    solution.solver = solution_.solver;
    solution.any_curve_limit = solution_.any_curve_limit;
    solution.design.kind = solution_.design.kind;
    solution.family = problem_.family();
    report_motion(solution, problem_, moved.x);
    audit_delivered(solution);
    if (solution.certificate.verdict != Verdict::optimal) return std::nullopt;
    solution.solver.proof_source = "multipliers of a known optimum";
    return solution;
}

std::optional<Solution> ProvedOptimum::solution_for(const Scene& scene) {
    const Stopwatch watch;
    const std::lock_guard turn(busy_);
    std::optional<Solution> solution = differ_in_peak_weights_only(solution_.scene, scene)
                                           ? same_motion_for(scene)
                                           : moved_motion_for(scene);
    if (!solution) return std::nullopt;
    if (solution->any_curve_limit) solution->any_curve_limit = limit_curve(scene, solution->reference_peaks);
    solution->solver.iterations = solution->solver.exchange_rounds = 0;
    solution->solver.proved_from = number_;
    solution->evaluations = {};
    solution->phases = {};
    solution->seconds_total = solution->seconds_solve = solution->phases.proof = watch.seconds();
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
        return !may_share_optima(other->solution().scene, solution.scene);
    });
    optimum->join(solution, number);
    known_.push_front(optimum);
    const std::size_t most = std::clamp(most_variables / static_cast<std::size_t>(optimum->variables()),
                                        least_optima, most_optima);
    if (known_.size() > most) known_.pop_back();
}

std::optional<Solution> ProvedOptima::proved(const Scene& scene,
                                             const std::function<bool(const Solution&)>& accepts) {
    if (known_.empty()) return std::nullopt;
    const bool weights = differ_in_peak_weights_only(known_.front()->solution().scene, scene);
    const auto serves = [&](const Scene& own) {
        if (differ_in_peak_weights_only(own, scene)) return weights;
        return !weights && differ_in_peak_limits_only(own, scene);
    };
    std::vector<std::pair<double, ProvedOptimum*>> tries;
    for (const std::shared_ptr<ProvedOptimum>& optimum : known_)
        if (serves(optimum->solution().scene) &&
            weigh_same_peaks(optimum->solution().scene.objective, scene.objective) &&
            cost_units(scene, optimum->solution().reference_peaks).cost == 1.0)
            tries.emplace_back(optimum->rank_for(scene), optimum.get());
    if (tries.empty()) return std::nullopt;
    std::ranges::stable_sort(tries, {}, [](const auto& one) { return one.first; });
    tries.resize(std::min(tries.size(), most_tries));
    for (const auto& [rank, optimum] : tries) {
        const double least = tries.front().first;
        if (rank > least + scene.solver.tolerance * std::max(1.0, std::abs(least))) break;
        if (std::optional<Solution> solution = optimum->solution_for(scene); solution && accepts(*solution))
            return solution;
    }
    return std::nullopt;
}

}  // namespace camopt
