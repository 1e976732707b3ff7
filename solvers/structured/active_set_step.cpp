// SPDX-License-Identifier: MIT
#include "solvers/structured/active_set_step.hpp"

namespace camopt::structured {

namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Triplets = std::vector<Eigen::Triplet<double>>;

constexpr int most_exchanges = 6;
constexpr double carrying = 1e-6;     // part of the largest multiplier: smaller ones are not active at first
constexpr double signless = 1e-9;     // part of the largest multiplier below which a sign is round-off
constexpr double held_shift = 1e-10;  // of the diagonal; refined away
constexpr double solved_residual = 1e-10;
constexpr double row_part = 0.1;       // of the tolerance: violation that adds a row
constexpr double bound_slack = 1e-13;  // relative, of a variable

}  // namespace

ActiveSetStep::ActiveSetStep(const NlpShape& shape, const RowMatrix& jacobian, const StepModel& model,
                             double tolerance)
    : shape_(shape),
      jacobian_(jacobian),
      model_(model),
      tolerance_(tolerance),
      variables_(shape.variables()),
      rows_(shape.constraints()),
      length_(rows_),
      side_(static_cast<std::size_t>(rows_ + variables_), Side::none),
      place_(static_cast<std::size_t>(rows_ + variables_), -1) {
    for (int i = 0; i < rows_; ++i) length_[i] = jacobian.row(i).norm();
    const double size = largest(model.slope);
    unit_ = size > 0.0 ? 1.0 / size : 1.0;
}

void ActiveSetStep::guess(const VectorXd& multipliers) {
    const VectorXd force = multipliers.cwiseProduct(length_);
    const double least = carrying * largest(force);
    for (int i = 0; i < rows_; ++i) {
        if (length_[i] == 0.0) continue;
        if (shape_.g_lower[i] == shape_.g_upper[i] || std::abs(force[i]) > least)
            side_[static_cast<std::size_t>(i)] = force[i] < 0.0 ? Side::lower : Side::upper;
    }
    const VectorXd rest = model_.slope + jacobian_.transpose() * multipliers;
    for (int j = 0; j < variables_; ++j) {
        const bool at_lower = model_.step_lower[j] >= -bound_slack,
                   at_upper = model_.step_upper[j] <= bound_slack;
        const int index = rows_ + j;
        if ((at_lower && rest[j] > least) || (at_lower && at_upper))
            side_[static_cast<std::size_t>(index)] = Side::lower;
        else if (at_upper && rest[j] < -least)
            side_[static_cast<std::size_t>(index)] = Side::upper;
    }
}

void ActiveSetStep::add_held(int index, Side side, double target) {
    place_[static_cast<std::size_t>(index)] = -1;
    if (side == Side::none) return;
    place_[static_cast<std::size_t>(index)] = static_cast<int>(held_.size());
    held_.push_back(index);
    target_.push_back(target);
}

/// solution_ with every held row as an equality; false: not solved.
bool ActiveSetStep::solve_equalities() {
    held_.clear();
    target_.clear();
    for (int i = 0; i < rows_; ++i) {
        const Side side = side_[static_cast<std::size_t>(i)];
        const double bound = side == Side::lower ? shape_.g_lower[i] : shape_.g_upper[i];
        add_held(i, side, side == Side::none ? 0.0 : (bound - model_.rows[i]) / length_[i]);
    }
    for (int j = 0; j < variables_; ++j) {
        const int index = rows_ + j;
        const Side side = side_[static_cast<std::size_t>(index)];
        add_held(index, side, side == Side::lower ? model_.step_lower[j] : model_.step_upper[j]);
    }
    const auto held = static_cast<int>(held_.size()), size = variables_ + held;
    Triplets entries;
    entries.reserve(static_cast<std::size_t>(model_.curvature.nonZeros() + size + Index{8} * held));
    for (int i = 0; i < size; ++i) entries.emplace_back(i, i, 0.0);
    for (Index j = 0; j < model_.curvature.outerSize(); ++j)
        for (Eigen::SparseMatrix<double>::InnerIterator entry(model_.curvature, j); entry; ++entry)
            entries.emplace_back(static_cast<int>(entry.row()), static_cast<int>(j), unit_ * entry.value());
    for (int k = 0; k < held; ++k) {
        const int index = held_[static_cast<std::size_t>(k)];
        if (index >= rows_) {
            entries.emplace_back(variables_ + k, index - rows_, 1.0);
            continue;
        }
        for (RowMatrix::InnerIterator entry(jacobian_, index); entry; ++entry)
            entries.emplace_back(variables_ + k, static_cast<int>(entry.col()),
                                 entry.value() / length_[index]);
    }
    SymmetricFactor::Matrix lower(size, size);
    lower.setFromTriplets(entries.begin(), entries.end());
    std::vector<int> signs(static_cast<std::size_t>(size), 1);
    std::fill(signs.begin() + variables_, signs.end(), -1);
    const auto factor = make_symmetric_factor(FactorKind::automatic, lower, signs);
    const FactorOutcome outcome = factor->factorize(lower, VectorXd::Constant(size, held_shift));
    if (outcome != FactorOutcome::ok && outcome != FactorOutcome::wrong_sign) return false;
    VectorXd right_side(size);
    right_side << -unit_ * model_.slope, Eigen::Map<const VectorXd>(target_.data(), held);
    const RefinedSolve solved = refined_solve(*factor, lower, right_side);
    solution_ = solved.solution;
    return solved.finite && solved.residual <= solved_residual;
}

ActiveSetStep::Side ActiveSetStep::corrected_side(int index, double value, double lower, double upper,
                                                  double slack) {
    const Side side = side_[static_cast<std::size_t>(index)];
    if (side == Side::none)
        return value > upper + slack ? Side::upper : value < lower - slack ? Side::lower : Side::none;
    if (lower == upper) return side;
    const double multiplier = solution_[variables_ + place_[static_cast<std::size_t>(index)]];
    const double limit = signless * solution_.tail(static_cast<Index>(held_.size())).cwiseAbs().maxCoeff();
    const bool wrong = side == Side::upper ? multiplier < -limit : multiplier > limit;
    return wrong ? Side::none : side;
}

/// How many sides change.
int ActiveSetStep::corrected() {
    const VectorXd step = solution_.head(variables_), values = jacobian_ * step;
    int changes = 0;
    const auto take = [&](int index, Side side) {
        if (side == side_[static_cast<std::size_t>(index)]) return;
        side_[static_cast<std::size_t>(index)] = side;
        ++changes;
    };
    for (int i = 0; i < rows_; ++i) {
        if (length_[i] == 0.0) continue;
        const double slack = row_part * tolerance_ * kind_of(shape_, i).scale;
        take(i, corrected_side(i, values[i] + model_.rows[i], shape_.g_lower[i], shape_.g_upper[i], slack));
    }
    for (int j = 0; j < variables_; ++j)
        take(rows_ + j,
             corrected_side(rows_ + j, step[j], model_.step_lower[j], model_.step_upper[j], bound_slack));
    return changes;
}

std::optional<ActiveSetStep::Solution> ActiveSetStep::solve(const VectorXd& multipliers) {
    guess(multipliers);
    for (int k = 0; k < most_exchanges; ++k) {
        const auto free = std::ranges::count(side_, Side::none);
        if (rows_ - free > 0 || !solve_equalities()) return std::nullopt;
        if (corrected() > 0) continue;
        Solution result{solution_.head(variables_), VectorXd::Zero(rows_)};
        for (std::size_t h = 0; h < held_.size(); ++h)
            if (held_[h] < rows_)
                result.multipliers[held_[h]] =
                    solution_[variables_ + static_cast<Index>(h)] / (unit_ * length_[held_[h]]);
        return result;
    }
    return std::nullopt;
}

}  // namespace camopt::structured
