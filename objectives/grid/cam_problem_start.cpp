// SPDX-License-Identifier: MIT
// Starting points: the smoothest motion, or a random perturbation of it.
#include "objectives/grid/cam_problem.hpp"

#include <Eigen/SparseLU>

#include <algorithm>
#include <cmath>
#include <random>

namespace camopt {

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

}  // namespace camopt
