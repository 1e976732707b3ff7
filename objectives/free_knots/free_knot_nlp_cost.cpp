// SPDX-License-Identifier: MIT
// Cost, its partials, and the Hessian of all.
#include "objectives/free_knots/free_knot_problem.hpp"

namespace camopt {

std::vector<int> FreeKnotNlp::energy_columns(int segment, int order) const {
    std::vector<int> columns;
    for (int m = order; m <= form_->degree(); ++m) columns.push_back(form_->coefficient(segment, m));
    columns.push_back(form_->breakpoint(segment));
    columns.push_back(form_->breakpoint(segment + 1));
    return columns;
}

double FreeKnotNlp::mean_square(const RmsTerm& term, const Eigen::VectorXd& x, Eigen::VectorXd* slope) const {
    const double factor = energy_factor(term);
    double value = 0.0;
    for (int i = 0; i < form_->segments(); ++i) {
        const SegmentEnergy energy = segment_energy(*form_, x, i, term.order);
        value += factor * energy.value;
        if (slope == nullptr) continue;
        const std::vector<int> columns = energy_columns(i, term.order);
        for (std::size_t k = 0; k < columns.size(); ++k) {
            if (columns[k] < 0) continue;
            (*slope)[columns[k]] += factor * scale_[columns[k]] * energy.slope[static_cast<Eigen::Index>(k)];
        }
    }
    return value;
}

double FreeKnotNlp::cost(const ConstVectorRef& x) const {
    double value = model_->cost_constant + linear_cost_.dot(x);
    if (rms_.empty()) return value;
    const Eigen::VectorXd own = physical(x);
    for (const RmsTerm& term : rms_) {
        const double q = x[term.variable];
        value += 0.5 * term.weight * (mean_square(term, own, nullptr) / q + q);
    }
    return value;
}

void FreeKnotNlp::gradient(const ConstVectorRef& x, VectorRef out) const {
    out = linear_cost_;
    const Eigen::VectorXd own = physical(x);
    for (const RmsTerm& term : rms_) {
        const double q = x[term.variable];
        Eigen::VectorXd slope = Eigen::VectorXd::Zero(shape_.variables());
        const double square = mean_square(term, own, &slope);
        out += 0.5 * term.weight / q * slope;
        out[term.variable] += 0.5 * term.weight * (1.0 - square / (q * q));
    }
}

void FreeKnotNlp::fix_patterns() {
    const auto claim = [&](int row, int column) { hessian_slots_.claim(shape_.hessian, row, column); };
    for (int i = 0; i < static_cast<int>(rows_.size()); ++i) {
        const Row& row = rows_[i];
        for (const int column : row.columns) {
            shape_.jacobian.rows.push_back(i);
            shape_.jacobian.columns.push_back(column);
        }
        if (row.kind == Row::Kind::linear) continue;
        for (int a = 0; a < static_cast<int>(row.columns.size()); ++a) {
            for (int b = 0; b <= a; ++b) {
                if (may_curve(row, a, b)) {
                    claim(row.columns[a], row.columns[b]);
                }
            }
        }
    }
    for (const RmsTerm& term : rms_) {
        for (int i = 0; i < form_->segments(); ++i) {
            const std::vector<int> columns = energy_columns(i, term.order);
            for (std::size_t a = 0; a < columns.size(); ++a) {
                for (std::size_t b = 0; b <= a; ++b) {
                    if (columns[a] >= 0 && columns[b] >= 0) claim(columns[a], columns[b]);
                }
            }
        }
        for (int j = 0; j < form_->size(); ++j) claim(term.variable, j);
        claim(term.variable, term.variable);
    }
}

void FreeKnotNlp::hessian(const ConstVectorRef& x, double sigma, const ConstVectorRef& lambda,
                          std::span<double> out) const {
    std::ranges::fill(out, 0.0);
    auto add = hessian_slots_.into(out);
    const Eigen::VectorXd own = physical(x);
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const Row& row = rows_[i];
        if (row.kind == Row::Kind::linear) continue;
        const Eigen::MatrixXd curvature = lambda[static_cast<Eigen::Index>(i)] * row_curvature(row, own);
        for (int a = 0; a < static_cast<int>(row.columns.size()); ++a) {
            for (int b = 0; b <= a; ++b) {
                if (may_curve(row, a, b)) add(curvature(a, b));
            }
        }
    }
    for (const RmsTerm& term : rms_) {
        const double q = x[term.variable];
        const double factor = 0.5 * sigma * term.weight / q;
        for (int i = 0; i < form_->segments(); ++i) {
            const std::vector<int> columns = energy_columns(i, term.order);
            const Eigen::MatrixXd curvature =
                factor * energy_factor(term) * segment_energy(*form_, own, i, term.order).curvature;
            for (std::size_t a = 0; a < columns.size(); ++a) {
                for (std::size_t b = 0; b <= a; ++b) {
                    if (columns[a] < 0 || columns[b] < 0) continue;
                    add(curvature(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b)) *
                        scale_[columns[a]] * scale_[columns[b]]);
                }
            }
        }
        Eigen::VectorXd slope = Eigen::VectorXd::Zero(shape_.variables());
        const double square = mean_square(term, own, &slope);
        for (int j = 0; j < form_->size(); ++j) add(-factor / q * slope[j]);
        add(2.0 * factor / (q * q) * square);
    }
}

}  // namespace camopt
