// SPDX-License-Identifier: MIT
#include "tests/soak/known/balance.hpp"

#include "tests/soak/known/nonnegative.hpp"

#include <Eigen/SVD>

#include <algorithm>
#include <cmath>

namespace camopt::soak {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

void Balance::add(const PiecewiseSpace& space, const VectorXd& motion) {
    parts_.push_back({&space, &motion, size_, freedom_});
    size_ += space.size();
    freedom_ += space.freedom();
}

void Balance::add(ActiveRow& row, bool of_all) {
    rows_.push_back({&row, of_all ? 0 : parts_.back().first, parts_.size() - 1});
}

VectorXd Balance::on_directions(const VectorXd& gradient, Index first) const {
    VectorXd on = VectorXd::Zero(freedom_);
    for (const Part& part : parts_) {
        const Index begin = part.first - first, count = part.space->size();
        if (begin < 0 || begin + count > gradient.size()) continue;
        on.segment(part.first_direction, part.space->freedom()) =
            part.space->directions().transpose() * gradient.segment(begin, count);
    }
    return on;
}

bool Balance::find(bool with_costs) {
    struct Column {
        ActiveRow* row;
        double sign, scale;
        VectorXd on;
        std::size_t part;
    };
    std::vector<Column> columns;
    for (const auto& [row, first, part] : rows_) {
        if (!with_costs && row->is_cost()) continue;
        const VectorXd on = on_directions(row->gradient, first);
        // No motion of the space changes it: it is fixed by the ends.
        if (on.norm() < 1e-7 * row->gradient.norm()) continue;
        columns.push_back({row, row->sign, row->preference / on.norm(), on, part});
        if (row->free) columns.push_back({row, -row->sign, row->preference / on.norm(), on, part});
    }
    // Every motion has a cost: 1 in sum. Without costs it is the inequalities that make 1.
    const auto sums = static_cast<Index>(with_costs ? parts_.size() : 1);
    MatrixXd a = MatrixXd::Zero(freedom_ + sums, static_cast<Index>(columns.size()));
    for (std::size_t j = 0; j < columns.size(); ++j) {
        const auto& [row, sign, scale, on, part] = columns[j];
        const auto column = static_cast<Index>(j);
        a.col(column).head(freedom_) = on * (sign * scale);
        if (with_costs ? row->is_cost() : !row->free)
            a(freedom_ + (with_costs ? static_cast<Index>(part) : 0), column) = 1.0;
    }
    VectorXd wanted = VectorXd::Zero(freedom_ + sums);
    wanted.tail(sums).setOnes();
    const std::optional<VectorXd> found = balanced(a, wanted);
    if (!found) return false;
    for (std::size_t j = 0; j < columns.size(); ++j) {
        const double multiplier = (*found)[static_cast<Index>(j)] * columns[j].scale;
        if (multiplier == 0.0) continue;
        columns[j].row->multiplier = multiplier;
        columns[j].row->sign = columns[j].sign;
    }
    return true;
}

VectorXd Balance::weighted_sum() const {
    VectorXd sum = VectorXd::Zero(size_);
    for (const auto& [row, first, part] : rows_)
        if (row->multiplier != 0.0)
            sum.segment(first, row->gradient.size()) += row->multiplier * row->sign * row->gradient;
    return sum;
}

double Balance::sensitivity(const VectorXd& sum) const {
    double all = 0.0;
    for (const Part& part : parts_)
        all += part.space->sensitivity(sum.segment(part.first, part.space->size()), *part.motion);
    return all;
}

double Balance::drift() const {
    double all = 0.0;
    for (const Part& part : parts_) all += part.space->drift(*part.motion);
    return all;
}

VectorXd Balance::correction() const {
    VectorXd all(size_);
    for (const Part& part : parts_)
        all.segment(part.first, part.space->size()) = part.space->correction(*part.motion);
    return all;
}

/// How far two motions that satisfy the scene may be apart, coefficients of lifts.
double Balance::reach() const {
    return 2.0 * std::sqrt(static_cast<double>(size_));
}

/// Rows with multipliers follow a change of the numbers: by how much the motion, and so the cost, may move.
void Balance::judge_growth(double lipschitz, KnownAnswer& answer) const {
    std::vector<Row> hard;
    for (const Row& one : rows_)
        if (!one.row->is_cost() && (one.row->multiplier > 0.0 || one.row->written)) hard.push_back(one);
    const double drift = this->drift();
    const VectorXd correction = this->correction();
    answer.growth = -1.0;
    if (hard.empty()) answer.growth = lipschitz * drift;
    if (hard.empty()) return;
    MatrixXd a(static_cast<Index>(hard.size()), freedom_);
    double violation = 0.0, left = 0.0;
    for (std::size_t k = 0; k < hard.size(); ++k) {
        // Each row in its own size.
        const ActiveRow& row = *hard[k].row;
        a.row(static_cast<Index>(k)) = on_directions(row.gradient, hard[k].first).transpose() / row.size;
        const double own = 1.0 + row.gradient.norm() * drift / row.size;
        violation += own * own;
        left +=
            std::pow(row.gradient.dot(correction.segment(hard[k].first, row.gradient.size())) / row.size, 2);
    }
    if (a.rows() > a.cols()) return;
    const VectorXd stretches = Eigen::BDCSVD<MatrixXd>(a).singularValues();
    const double least = stretches[a.rows() - 1];
    if (least < 1e-10 * stretches[0]) return;
    answer.room = lipschitz * std::sqrt(static_cast<double>(a.rows())) / least;
    answer.error += lipschitz * std::sqrt(left) / least;
    answer.growth = lipschitz * (drift + std::sqrt(violation) / least);
}

KnownAnswer Balance::optimum(double total, double objective) {
    KnownAnswer answer;
    double sizes = 0.0, slack = 0.0, lipschitz = 0.0;
    for (const Row& one : rows_) one.row->multiplier *= objective / total;
    for (const auto& [row, first, part] : rows_) {
        if (row->multiplier == 0.0) continue;
        sizes += row->multiplier * row->size;
        slack += row->multiplier * row->gap;
        if (row->is_cost()) lipschitz += row->multiplier * row->gradient.norm();
    }
    const VectorXd sum = weighted_sum();
    sizes += sensitivity(sum);
    answer.objective = objective;
    answer.error = roundings * rounding * sizes + on_directions(sum, 0).norm() * reach() + slack;
    answer.condition = std::max(1.0, sizes / objective);
    judge_growth(2.0 * lipschitz, answer);
    if (answer.growth >= 0.0) answer.growth += sizes;
    return answer;
}

const ActiveRow* Balance::heaviest() const {
    const ActiveRow* most = nullptr;
    for (const auto& [row, first, part] : rows_)
        if (row->multiplier > 0.0 && !row->free &&
            (!most || row->multiplier * row->scale > most->multiplier * most->scale))
            most = row;
    return most;
}

std::optional<KnownAnswer> Balance::contradiction(double shift) const {
    const ActiveRow& moved = *heaviest();
    double total = 0.0, sizes = 0.0;
    for (const auto& [row, first, part] : rows_) {
        if (row->multiplier == 0.0) continue;
        sizes += row->multiplier * (row->size + row->gap / rounding);
        if (!row->free) total += row->multiplier * row->scale;
    }
    const VectorXd sum = weighted_sum();
    sizes += sensitivity(sum);
    const double weight = moved.multiplier * moved.scale;
    const double gap = weight * std::abs(shift);
    const double error = roundings * rounding * sizes + on_directions(sum, 0).norm() * reach();
    // Whether it is one is only known beyond rounding.
    if (gap <= 10.0 * error || sizes >= 1e12 * total) return std::nullopt;
    KnownAnswer answer;
    answer.condition = std::max(1.0, sizes / weight);
    answer.feasible = shift <= 0.0;
    answer.margin = gap / total;
    answer.error = error / total;
    return answer;
}

}  // namespace camopt::soak
