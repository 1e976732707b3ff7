// SPDX-License-Identifier: MIT
// Points of a CamProblem: starts, completion, and the projection onto its equalities.
#include "objectives/grid/cam_problem.hpp"
#include "objectives/rules/maxima/rule_maxima.hpp"

#include <Eigen/SparseLU>

#include <random>

namespace camopt {

// Starting points: the smoothest motion, or a random perturbation of it.

namespace {

// Random starting motions: this many loads, which perturb the smoothest motion by up to this part of a lift.
constexpr int random_loads = 3;
constexpr double farthest_random_move = 0.3;
constexpr int move_samples = 64;
/// max |a − b| over samples: affects only the size of a random perturbation.
double largest_move(const Motion& a, const Motion& b) {
    double largest = 0.0;
    for (int k = 0; k <= move_samples; ++k) {
        const double x = a.begin() + (a.end() - a.begin()) * k / move_samples;
        largest = std::max(largest, std::abs(a.at(x).derivative[0] - b.at(x).derivative[0]));
    }
    return largest;
}

bool has_kind(const CamModel& model, Parameter::Kind kind) {
    return std::ranges::any_of(model.parameters,
                               [kind](const Parameter& parameter) { return parameter.kind == kind; });
}

}  // namespace

/// The entries of least mean square jerk under a load: one linear system, always smooth.
Eigen::VectorXd CamProblem::smoothest(const Eigen::VectorXd& load) const {
    const MotionFamily& design = model_->design;
    const Eigen::Index size = design.size();
    const Eigen::Index rows = projection_->matrix().rows();
    const QuadraticForm energy = design.mean_square(3, model_->mean_square_weights(3));
    const Eigen::VectorXd scale = design_scales(*model_);
    const double unit = model_->jerk_reference * model_->jerk_reference;
    std::vector<Eigen::Triplet<double>> entries;
    for (int column = 0; column < energy.matrix.outerSize(); ++column) {
        for (Eigen::SparseMatrix<double>::InnerIterator e(energy.matrix, column); e; ++e) {
            entries.emplace_back(e.row(), column, scale[e.row()] * scale[column] * e.value() / unit);
        }
    }
    const Eigen::SparseMatrix<double>& equality = projection_->matrix();
    for (int column = 0; column < equality.outerSize(); ++column) {
        for (Eigen::SparseMatrix<double>::InnerIterator e(equality, column); e; ++e) {
            entries.emplace_back(size + e.row(), column, e.value());
            entries.emplace_back(column, size + e.row(), e.value());
        }
    }
    Eigen::SparseMatrix<double> system(size + rows, size + rows);
    system.setFromTriplets(entries.begin(), entries.end());
    Eigen::VectorXd right(size + rows);
    right << load - scale.cwiseProduct(energy.linear) / unit, -projection_->offset();
    Eigen::VectorXd x = Eigen::VectorXd::Zero(size);
    if (size == 0) return x;
    const Eigen::SparseLU<Eigen::SparseMatrix<double>> factor(system);
    if (factor.info() != Eigen::Success) return x;
    const Eigen::VectorXd solution = factor.solve(right);
    if (solution.allFinite()) x = solution.head(size);
    return x;
}

Eigen::VectorXd CamProblem::start() const {
    // Close to every optimum, unique, and the solution of one linear system. Dimensions start in the middle.
    const Eigen::Index size = model_->design.size();
    Eigen::VectorXd x = Eigen::VectorXd::Zero(grid_->shape().variables());
    x.head(size) = smoothest(Eigen::VectorXd::Zero(size));
    for (std::size_t p = 0; p < model_->parameters.size(); ++p) {
        const Parameter& parameter = model_->parameters[p];
        if (parameter.kind != Parameter::Kind::dimension) continue;
        x[size + static_cast<Eigen::Index>(p)] = 0.5 * (parameter.lower + parameter.upper);
    }
    return completed(x);
}

Eigen::VectorXd CamProblem::random_start(unsigned seed) const {
    const MotionFamily& design = model_->design;
    const Eigen::Index size = design.size();
    Eigen::VectorXd x = start();
    // Arithmetic on the engine's output: the standard's distributions differ between libraries.
    std::mt19937 engine(seed);
    const auto uniform = [&engine](double low, double high) {
        return low + (high - low) * static_cast<double>(engine()) / 4294967295.0;
    };
    const Eigen::VectorXd scale = design_scales(*model_);
    Eigen::VectorXd load = Eigen::VectorXd::Zero(size);
    for (int k = 0; k < random_loads; ++k) {
        const AffineRow place = design.functional(uniform(design.begin(), design.end()), 0);
        const double force = uniform(-1.0, 1.0);
        for (std::size_t j = 0; j < place.columns.size(); ++j) {
            load[place.columns[j]] += force * place.weights[j] * scale[place.columns[j]];
        }
    }
    const Eigen::VectorXd bend = smoothest(load) - x.head(size);
    Eigen::VectorXd bent = x;
    bent.head(size) += bend;
    const double size_of_bend = largest_move(motion(bent), motion(x));
    if (size_of_bend > 0.0) x.head(size) += uniform(0.0, farthest_random_move) / size_of_bend * bend;
    for (std::size_t p = 0; p < model_->parameters.size(); ++p) {
        const Parameter& parameter = model_->parameters[p];
        if (parameter.kind != Parameter::Kind::dimension) continue;
        x[size + static_cast<Eigen::Index>(p)] = uniform(parameter.lower, parameter.upper);
    }
    return completed(x);
}

// Completion: from any x to one whose equalities hold and whose peaks are those of its motion.

/// The peaks of DRD and RR, whose normalised motion is the spline itself.
void CamProblem::complete_peaks(const SplineCurve& curve, Eigen::VectorXd& x) const {
    for (std::size_t p = 0; p < model_->parameters.size(); ++p) {
        const Parameter& parameter = model_->parameters[p];
        double& value = x[model_->design.size() + static_cast<Eigen::Index>(p)];
        if (parameter.kind == Parameter::Kind::peak)
            value = peak_of(curve, parameter.order).value / parameter.reference;
        if (parameter.kind == Parameter::Kind::torque)
            value = torque_peak_of(curve).value / parameter.reference;
        if (parameter.kind == Parameter::Kind::rms)
            value = mean_of(curve, parameter.order) / parameter.reference;
    }
}

/// The normalised peaks of a program: each the largest over its stretches, by the rules that define it.
void CamProblem::complete_program_peaks(const MotionChain& chain, Eigen::VectorXd& x) const {
    const Eigen::Index size = model_->design.size();
    for (std::size_t p = 0; p < model_->parameters.size(); ++p) {
        const Parameter& parameter = model_->parameters[p];
        double& value = x[size + static_cast<Eigen::Index>(p)];
        if (parameter.kind == Parameter::Kind::peak || parameter.kind == Parameter::Kind::torque) value = 0.0;
        if (parameter.kind != Parameter::Kind::rms) continue;
        const QuadraticForm form =
            model_->design.mean_square(parameter.order, model_->mean_square_weights(parameter.order));
        value = std::sqrt(std::max(0.0, form.value(design_values(x)))) / parameter.reference;
    }
    for (const PlacedRule& rule : model_->rules) {
        if (rule->limit() || rule->parameters().empty() || rule->whole()) continue;
        const auto first = static_cast<std::size_t>(rule->parameters().front());
        if (model_->parameters[first].kind == Parameter::Kind::own) continue;
        double& peak = x[size + rule->parameters().front()];
        peak = std::max(peak,
                        largest_of(rule_maxima(rule, model_->design, chain, Eigen::VectorXd::Zero(1))).value);
    }
}

/// The peaks of user-defined terms.
void CamProblem::complete_own_peaks(const MotionChain& chain, Eigen::VectorXd& x) const {
    for (std::size_t p = 0; p < model_->parameters.size(); ++p) {
        const Parameter& parameter = model_->parameters[p];
        if (parameter.kind != Parameter::Kind::own) continue;
        const PlacedRule rule(parameter.defined_by);
        const Extremum largest =
            largest_of(rule_maxima(rule, model_->design, chain, Eigen::VectorXd::Zero(1)));
        x[model_->design.size() + static_cast<Eigen::Index>(p)] = std::max(0.0, largest.value);
    }
}

/// The response of the follower train or of the motor to the motion.
void CamProblem::complete_responses(Eigen::VectorXd& x) const {
    for (std::size_t p = 0; p < model_->parameters.size(); ++p) {
        const Parameter& parameter = model_->parameters[p];
        if (parameter.kind != Parameter::Kind::response && parameter.kind != Parameter::Kind::energy)
            continue;
        double largest = parameter.lower;
        const MotionChain chain = motion(x, parameter.seen);
        for (const auto& place : parameter.defined_by->whole()->maxima(chain, Eigen::VectorXd::Zero(1)))
            largest = std::max(largest, place.where.value);
        x[model_->design.size() + static_cast<Eigen::Index>(p)] = largest;
    }
}

/// Peaks and root mean squares are set to those of the motion of x; dimensions are clamped to their range.
void CamProblem::complete_parameters(Eigen::VectorXd& x) const {
    if (model_->stretch_scales.empty())
        complete_peaks(curve(x), x);
    else
        complete_program_peaks(motion(x), x);
    if (has_kind(*model_, Parameter::Kind::own)) complete_own_peaks(motion(x), x);
    if (has_kind(*model_, Parameter::Kind::response) || has_kind(*model_, Parameter::Kind::energy))
        complete_responses(x);
    const Eigen::Index size = model_->design.size();
    for (std::size_t p = 0; p < model_->parameters.size(); ++p) {
        const Parameter& parameter = model_->parameters[p];
        double& value = x[size + static_cast<Eigen::Index>(p)];
        if (parameter.kind == Parameter::Kind::dimension)
            value = std::clamp(value, parameter.lower, parameter.upper);
        if (parameter.kind == Parameter::Kind::magnitude) value = std::abs(x[size + parameter.order]);
    }
}

Eigen::VectorXd CamProblem::completed(const Eigen::VectorXd& x) const {
    Eigen::VectorXd full = x;
    const Eigen::Index size = model_->design.size();
    full.head(size) = projection_->project(x.head(size));
    if (full.allFinite()) complete_parameters(full);
    return full;
}

AffineRow unit_row(const AffineRow& row, const Eigen::VectorXd& column_scale) {
    AffineRow unit = row;
    double largest = 0.0;
    for (std::size_t k = 0; k < unit.columns.size(); ++k) {
        unit.weights[k] *= column_scale[unit.columns[k]];
        largest = std::max(largest, std::abs(unit.weights[k]));
    }
    for (double& weight : unit.weights) weight /= largest;
    unit.offset /= largest;
    return unit;
}

EqualityProjection::EqualityProjection(const std::vector<Equality>& rows, const Eigen::VectorXd& column_scale)
    : matrix_(static_cast<Eigen::Index>(rows.size()), column_scale.size()),
      offset_(static_cast<Eigen::Index>(rows.size())) {
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < static_cast<int>(rows.size()); ++i) {
        const AffineRow row = unit_row(rows[i].row, column_scale);
        for (std::size_t k = 0; k < row.columns.size(); ++k) {
            entries.emplace_back(i, row.columns[k], row.weights[k]);
        }
        offset_[i] = row.offset;
    }
    matrix_.setFromTriplets(entries.begin(), entries.end());
    if (matrix_.rows() > 0) normal_.compute(matrix_ * Eigen::SparseMatrix<double>(matrix_.transpose()));
}

Eigen::VectorXd EqualityProjection::project(Eigen::VectorXd x) const {
    if (matrix_.rows() == 0 || normal_.info() != Eigen::Success) return x;
    // The first step removes the residual, the next ones its round-off.
    constexpr int most_steps = 4;
    double defect = (matrix_ * x + offset_).cwiseAbs().maxCoeff();
    for (int step = 0; step < most_steps && defect > 0.0; ++step) {
        const Eigen::VectorXd next = x - matrix_.transpose() * normal_.solve(matrix_ * x + offset_);
        const double next_defect = (matrix_ * next + offset_).cwiseAbs().maxCoeff();
        if (!(next_defect < defect)) break;
        x = next;
        defect = next_defect;
    }
    return x;
}

}  // namespace camopt
