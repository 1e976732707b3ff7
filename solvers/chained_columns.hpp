// SPDX-License-Identifier: MIT
//
// The same problem with its dense columns split into local copies, which avoids fill.
//
// A variable v in many rows (a peak, a dimension) makes a sparse factorization fill in. Here each group of
// rows
// has its own copy, and linear rows tie the copies together:
//
//     g_i(x, v),  i in group k   →   g_i(x, v_k),      v_k − v_{k+1} = 0.
//
// Rows are ordered along the chain by the smallest index of their other columns, so that neighbours in the
// chain are neighbours in x. The bounds of v, its part of the cost, and rows without other columns stay with
// the first copy, which has the index of v. Variables: those of the base problem, then the further copies;
// rows: those of the base problem, then the ties.
//
// Exact for a column that enters linearly: one without an entry in the pattern of the Hessian, so that
// g_i(x, v) = h_i(x) + a_i v with a number a_i. Others are unchanged. The a_i are read once, at a given
// point.
//
// Multipliers of the base problem are those of its own rows and variables: the ties cancel in the sum over
// the copies.
#pragma once

#include "core/nlp.hpp"

namespace camopt {

/// Columns worth chaining: without Hessian entries, in at least `share` of the rows. None if more than `most`
/// qualify: an entirely dense problem gains nothing.
[[nodiscard]] std::vector<int> dense_columns(const NlpShape& shape, double share = 0.05, int most = 12);

class ChainedColumns final : public Nlp {
 public:
    /// `base` must outlive this. `point`: where the constants a_i are read; size variables. Throws ModelError
    /// for a column that does not exist or has an entry in the Hessian, and the exceptions of
    /// base.jacobian().
    ChainedColumns(const Nlp& base, const std::vector<int>& columns, const ConstVectorRef& point);

    [[nodiscard]] double cost(const ConstVectorRef& x) const override {
        return base_.cost(x.head(base_variables_));
    }
    void gradient(const ConstVectorRef& x, VectorRef out) const override;
    void constraints(const ConstVectorRef& x, VectorRef out) const override;
    void jacobian(const ConstVectorRef& x, std::span<double> out) const override;
    void hessian(const ConstVectorRef& x, double sigma, const ConstVectorRef& lambda,
                 std::span<double> out) const override {
        base_.hessian(x.head(base_variables_), sigma, lambda.head(base_rows_), out);
    }
    [[nodiscard]] std::string variable_name(int index) const override;
    [[nodiscard]] std::string row_name(int index) const override;
    [[nodiscard]] RowOrigin row_origin(int index) const override {
        return index < base_rows_ ? base_.row_origin(index) : Nlp::row_origin(index);
    }

    /// Every copy at the value of its variable.
    [[nodiscard]] Vector chained(const ConstVectorRef& base_x) const;
    /// A point, or multipliers of the bounds, of the base problem from those of this one.
    [[nodiscard]] Vector unchained(const ConstVectorRef& x) const { return x.head(base_variables_); }
    /// Multipliers of the base problem's rows.
    [[nodiscard]] Vector unchained_rows(const ConstVectorRef& lambda) const {
        return lambda.head(base_rows_);
    }

    [[nodiscard]] int copies() const { return static_cast<int>(copy_of_.size()); }

 private:
    /// a (v_copy − v) is added to a row of the base problem.
    struct Shift {
        int row, column, copy;
        double slope;
    };
    struct Tie {
        int column, first, second;  ///< of which variable, between which copies
    };
    void chain(int column, const std::vector<int>& smallest, const std::vector<double>& jacobian);
    void add_ties();

    const Nlp& base_;
    int base_variables_, base_rows_;
    std::vector<int> copy_of_;  ///< further copies: of which variable
    std::vector<Shift> shifts_;
    std::vector<Tie> ties_;
};

}  // namespace camopt
