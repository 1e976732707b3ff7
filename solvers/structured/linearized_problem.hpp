// SPDX-License-Identifier: MIT
// Internal to solvers/structured/: a positive definite approximation of the Hessian H of the Lagrangian.
//
// Where H is not positive definite, first  H + c NᵀN  is tried, N the unit normals of the rows that carry a
// multiplier. With the term  c Nᵀr  in the slope (r: distance of those rows from their bounds) this adds c/2
// ‖N d + r‖², which is zero on the rows: the step remains that of the true Hessian, and convergence
// superlinear. Only where H has negative curvature along the rows too, a multiple of I is added. Source:
// Bertsekas, Constrained Optimization and Lagrange Multiplier Methods (1982), section 4.2.
#pragma once

#include "core/nlp.hpp"
#include "linear/sparse_symmetric.hpp"

namespace camopt::structured {

struct ActiveRows {
    Eigen::SparseMatrix<double, Eigen::RowMajor> normals;  ///< N
    Eigen::VectorXd residuals;                             ///< r

    /// Those of its rows that `chosen` names.
    [[nodiscard]] ActiveRows part(const std::function<bool(Eigen::Index)>& chosen) const;
};

struct ConvexifiedHessian {
    Eigen::SparseMatrix<double> lower;  ///< triangle
    Eigen::VectorXd slope;              ///< c Nᵀr
    double shift = 0.0;                 ///< multiple of I, beyond the proximal one
    bool holds = false;                 ///< to the active rows: c > 0
};

/// Keeps the pattern of the matrices tried, and its analysis, from one pass to the next: it grows where a row
/// is active for the first time.
class HessianConvexifier {
 public:
    using Matrix = Eigen::SparseMatrix<double>;
    /// `lower`: triangle of H. `least`: multiple of I that is added in any case; it makes the step unique.
    [[nodiscard]] ConvexifiedHessian convexified(const Matrix& lower, const ActiveRows& active, double least);

 private:
    void read(const Matrix& lower, const ActiveRows& active, double least);
    [[nodiscard]] bool read_values(const Matrix& lower, const ActiveRows& active);
    void grow(const Matrix& lower, const ActiveRows& active);
    /// H + weight NᵀN + shift I, left in trial_ without the shift.
    [[nodiscard]] bool is_definite(double weight, double shift);
    [[nodiscard]] double least_shift(double weight, double bound);

    Matrix trial_;                ///< lower triangle, every diagonal entry stored
    Eigen::VectorXd own_, gram_;  ///< values of H + least I, and of NᵀN, in the order of trial_
    std::unique_ptr<SymmetricFactor> factor_;
    std::vector<int> place_;  ///< of every row in a column of trial_; −1: no entry
};

// Internal to solvers/structured/: an Nlp linearized at one point, as a problem with linear rows for a step
// d = h u.
//
//     min (cᵀd + ½ dᵀHd + ν t) / (h F)   subject to   d_L <= d <= d_U,   t = t_0 + h τ >= 0,
//         g_L <= g + G d <= g_U            (linear rows),
//         g_L − w t <= g + G d <= g_U + w t  (nonlinear rows; ν = 0: t = 0, no relaxation).
//
// h (`unit`) and F (`cost_unit`) scale a small step of a large cost to order 1, where the interior point
// works to full accuracy; t_0 (`elastic_base`) is the violation at d = 0. Rows have the numbers of the Nlp;
// with ν > 0 the lower sides of nonlinear rows with two sides follow them.

/// Values of an Nlp at x; the derivatives only after differentiate().
struct NlpPoint {
    Eigen::VectorXd x, rows, gradient;
    std::vector<double> jacobian;
    double cost = infinity;
    [[nodiscard]] bool finite() const;
};
[[nodiscard]] NlpPoint evaluated(const Nlp& problem, Eigen::VectorXd x);
void differentiate(const Nlp& problem, NlpPoint& point);

/// A sparse matrix whose values come in the order of an Nlp's pattern.
template <class Matrix>
class PatternedMatrix {
 public:
    /// `symmetric`: the pattern names entries of the lower triangle, or their mirror images.
    PatternedMatrix(Eigen::Index rows, Eigen::Index columns, const SparsityPattern& pattern,
                    bool symmetric = false)
        : matrix_(rows, columns), place_(pattern.rows.size()) {
        std::vector<Eigen::Triplet<double>> entries;
        entries.reserve(pattern.rows.size());
        const auto row = [&](std::size_t e) {
            return symmetric ? std::max(pattern.rows[e], pattern.columns[e]) : pattern.rows[e];
        };
        const auto column = [&](std::size_t e) {
            return symmetric ? std::min(pattern.rows[e], pattern.columns[e]) : pattern.columns[e];
        };
        for (std::size_t e = 0; e < place_.size(); ++e) entries.emplace_back(row(e), column(e), 0.0);
        matrix_.setFromTriplets(entries.begin(), entries.end());
        for (std::size_t e = 0; e < place_.size(); ++e)
            place_[e] = &matrix_.coeffRef(row(e), column(e)) - matrix_.valuePtr();
    }

    [[nodiscard]] Matrix filled(std::span<const double> values) const {
        Matrix result = matrix_;
        for (std::size_t e = 0; e < place_.size(); ++e) result.valuePtr()[place_[e]] += values[e];
        return result;
    }

 private:
    Matrix matrix_;
    std::vector<std::ptrdiff_t> place_;
};

struct StepModel {
    Eigen::VectorXd slope;                   ///< c
    Eigen::SparseMatrix<double> curvature;   ///< H, lower triangle, positive semidefinite
    Eigen::VectorXd rows;                    ///< g
    Eigen::VectorXd step_lower, step_upper;  ///< d_L, d_U
    Eigen::VectorXd weights;                 ///< w, one for every row
    double penalty = 0.0;                    ///< ν
    double elastic_base = 0.0;               ///< t_0
    double unit = 1.0, cost_unit = 1.0;      ///< h, F
    bool without_nonlinear_rows = false;
    bool sharp = false;  ///< to be solved to round-off
};

class LinearizedProblem final : public Nlp {
 public:
    /// `point` with its derivatives; everything must outlive this object.
    LinearizedProblem(const Nlp& problem, const NlpPoint& point, const StepModel& model);

    [[nodiscard]] double cost(const ConstVectorRef& u) const override;
    void gradient(const ConstVectorRef& u, VectorRef out) const override;
    void constraints(const ConstVectorRef& u, VectorRef out) const override;
    void jacobian(const ConstVectorRef&, std::span<double> out) const override {
        std::copy(values_.begin(), values_.end(), out.begin());
    }
    void hessian(const ConstVectorRef&, double sigma, const ConstVectorRef&,
                 std::span<double> out) const override;
    [[nodiscard]] std::string variable_name(int index) const override {
        return index < variables_ ? problem_.variable_name(index) : "common violation";
    }
    [[nodiscard]] std::string row_name(int index) const override {
        return problem_.row_name(source_row(index));
    }
    [[nodiscard]] RowOrigin row_origin(int index) const override {
        return problem_.row_origin(source_row(index));
    }

    [[nodiscard]] Eigen::VectorXd step_of(const Eigen::VectorXd& u) const;
    [[nodiscard]] double elastic_of(const Eigen::VectorXd& u) const;  ///< t
    /// λ of the Nlp's rows from those of this problem.
    [[nodiscard]] Eigen::VectorXd multipliers_of(const Eigen::VectorXd& lambda) const;

 private:
    /// Of the problem, the origin of row `index` of this one.
    [[nodiscard]] int source_row(int index) const;
    void drop_nonlinear_rows();
    void add_elastic_rows();
    const Nlp& problem_;
    const StepModel& model_;
    int variables_;
    std::vector<double> values_;   ///< of the Jacobian
    std::vector<int> extra_rows_;  ///< rows of the Nlp behind the rows after its own
};

/// min ½ ‖x − start‖² over the linear rows and the bounds of the Nlp.
[[nodiscard]] StepModel projection_model(const Nlp& problem, const NlpPoint& start);

// Internal to solvers/structured/: constraint violation and stationarity of a point of an Nlp.

using RowMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

[[nodiscard]] inline const RowKind& kind_of(const NlpShape& shape, Eigen::Index row) {
    return shape.rows[static_cast<std::size_t>(row)];
}

/// Largest violation of the rows that are linear or of those that are not, each relative to its scale; >= 0.
[[nodiscard]] double violation_of(const NlpShape& shape, const Eigen::VectorXd& rows, bool linear);

/// Every row to the tolerance of its scale, or to round-off.
[[nodiscard]] bool keeps_rows(const NlpShape& shape, const NlpPoint& point, const RowMatrix& jacobian,
                              double tolerance);

/// Σ |λ_i| scale_i of the nonlinear rows: the least ν that makes the penalty exact.
[[nodiscard]] double needed_penalty(const NlpShape& shape, const Eigen::VectorXd& multipliers);

/// A point, its Jacobian, and multipliers of its rows.
struct Stationarity {
    const NlpShape& shape;
    const NlpPoint& point;
    const RowMatrix& jacobian;
    const Eigen::VectorXd& multipliers;

    [[nodiscard]] Eigen::VectorXd lagrangian_gradient() const {
        return point.gradient + jacobian.transpose() * multipliers;
    }
    /// ‖∇L + z‖∞ with the best z for the active bounds of x.
    [[nodiscard]] double error() const;
    /// Rows and bounds that carry a multiplier, unless the point is further than `reach` from them.
    [[nodiscard]] ActiveRows active_rows(double reach) const;
};

/// −gradient where a finite bound of the right side exists, 0 elsewhere.
[[nodiscard]] Eigen::VectorXd bound_multipliers(const NlpShape& shape, const Eigen::VectorXd& gradient);

/// Variables in which the cost or some row is not linear.
[[nodiscard]] std::vector<bool> curved_variables(const NlpShape& shape);

/// ∇²f + Σ λ_i ∇²g_i in the order of the Nlp's pattern; entries that are not finite count as 0.
[[nodiscard]] std::vector<double> lagrangian_hessian(const Nlp& problem, const Eigen::VectorXd& x,
                                                     const Eigen::VectorXd& multipliers);

// Internal to solvers/structured/: norms of vectors in the inner loop, written for vectorization.

/// max |v_i|, 0 for none. NaN may hide.
[[nodiscard]] inline double largest(const Eigen::VectorXd& v) {
    return v.size() > 0 ? v.cwiseAbs().maxCoeff() : 0.0;
}

/// Whether every entry is finite (and their sum, which is equivalent for practical numbers).
[[nodiscard]] inline bool finite(const Eigen::VectorXd& v) {
    return std::isfinite(v.sum());
}

}  // namespace camopt::structured
