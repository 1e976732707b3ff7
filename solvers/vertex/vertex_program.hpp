// SPDX-License-Identifier: MIT
// A simplex method for one linear program with many costs, for bounds over boxes, and its list of rows.
#pragma once

#include "solvers/solver.hpp"

namespace camopt {

/// Compressed sparse rows that can be appended and removed.
class SparseRowList {
 public:
    [[nodiscard]] int size() const { return static_cast<int>(begin_.size()) - 1; }
    void add(const Eigen::VectorXd& row) {
        for (Eigen::Index j = 0; j < row.size(); ++j) {
            if (row[j] != 0.0) entries_.push_back({static_cast<int>(j), row[j]});
        }
        begin_.push_back(entries_.size());
    }
    /// A row of another list.
    void add(const SparseRowList& other, int row) {
        other.each(row, [&](int column, double value) { entries_.push_back({column, value}); });
        begin_.push_back(entries_.size());
    }
    /// `stay`: ascending.
    void keep(const std::vector<int>& stay) {
        std::size_t to = 0, rows = 0;
        for (const int row : stay) {
            const auto from = static_cast<std::size_t>(row);
            const std::size_t end = begin_[from + 1];
            for (std::size_t k = begin_[from]; k < end; ++k) entries_[to++] = entries_[k];
            begin_[++rows] = to;
        }
        entries_.resize(to);
        begin_.resize(rows + 1);
    }
    /// visit(column, entry) of the nonzeros, in the order of the columns.
    template <class Visit>
    void each(int row, const Visit& visit) const {
        const auto at = static_cast<std::size_t>(row);
        for (std::size_t k = begin_[at]; k < begin_[at + 1]; ++k)
            visit(entries_[k].column, entries_[k].value);
    }
    [[nodiscard]] double dot(int row, const Eigen::VectorXd& x) const {
        double sum = 0.0;
        each(row, [&](int column, double value) { sum += value * x[column]; });
        return sum;
    }
    [[nodiscard]] Eigen::VectorXd times(const Eigen::VectorXd& x) const {
        Eigen::VectorXd product(size());
        for (int row = 0; row < size(); ++row) product[row] = dot(row, x);
        return product;
    }

 private:
    struct Entry {
        int column;
        double value;
    };
    std::vector<std::size_t> begin_{0};
    std::vector<Entry> entries_;
};

// The program is
//
//     min c·x   subject to   a_i·x <= b_i,   l <= x <= u,   l and u finite
//
// Another cost starts at the last corner (primal steps), new rows from the last optimum (dual steps). Steps
// look at the live rows, a few of all; those of the others that the optimum violates join them, and the
// steps go on. Right-hand sides are perturbed to avoid degeneracy. The reported bound uses the unperturbed
// values.
//
// The bound is valid regardless of the steps: for any multipliers λ >= 0 of the rows,
//     c·x >= −Σ λ_i b_i + Σ_j min(r_j l_j, r_j u_j),   r = c + Σ λ_i a_i,
// added up in long double and rounded outward.

struct VertexBound {
    enum class Status {
        optimal,
        infeasible,  ///< proved: the multipliers give 0 > 0
        stopped      ///< by the clock or by round-off: the bound still holds
    };
    Status status = Status::stopped;
    double bound = -infinity;                         ///< a lower bound of c·x; infeasible: +infinity
    Eigen::VectorXd x;                                ///< the corner; empty where there is none
    std::vector<std::pair<int, double>> multipliers;  ///< row, λ > 0
};

class VertexProgram {
 public:
    /// Throws ModelError where a bound is infinite.
    VertexProgram(Eigen::VectorXd lower, Eigen::VectorXd upper);

    [[nodiscard]] int variables() const { return static_cast<int>(lower_.size()); }
    [[nodiscard]] int rows() const { return static_cast<int>(side_.size()); }
    /// a·x <= b; its number is rows() before.
    void add_row(const Eigen::VectorXd& a, double b);
    /// Removes rows whose entry in `kept` is 0, except those active at the current corner. Returns the
    /// remaining ones, by old numbers, ascending.
    std::vector<int> drop_rows(std::vector<char> kept);
    /// l <= x_j <= u, inside the previous bounds.
    void set_bounds(int j, double lower, double upper);
    [[nodiscard]] double lower(int j) const { return lower_[j]; }
    [[nodiscard]] double upper(int j) const { return upper_[j]; }
    /// b_i − a_i·x >= 0 if the row is satisfied.
    [[nodiscard]] double slack(int row, const Eigen::VectorXd& x) const;

    [[nodiscard]] VertexBound minimize(const Eigen::VectorXd& cost, const SolveControl& control);
    /// The proved bound that these multipliers give.
    [[nodiscard]] double bound_of(const Eigen::VectorXd& cost,
                                  const std::vector<std::pair<int, double>>& multipliers) const;
    [[nodiscard]] long steps() const { return steps_; }

 private:
    enum class Outcome { done, infeasible, stuck, ended };

    /// An active constraint of a corner: a row (>= 0), the lower bound of variable j (−1 − 2j), the upper one
    /// (−2 − 2j).
    using Face = int;
    [[nodiscard]] static Face lower_face(Eigen::Index j) { return -1 - 2 * static_cast<int>(j); }
    [[nodiscard]] static Face upper_face(Eigen::Index j) { return -2 - 2 * static_cast<int>(j); }
    [[nodiscard]] Eigen::VectorXd normal(Face face) const;
    [[nodiscard]] double side(Face face) const;
    void start_at_bounds(const Eigen::VectorXd& cost);
    void make_live(int row);
    void keep_live(const std::vector<int>& rows);
    void rest_idle_rows();
    [[nodiscard]] bool wake_violated_rows();
    [[nodiscard]] Outcome reach(const Eigen::VectorXd& cost, const SolveControl& control);
    [[nodiscard]] bool refactor();
    /// `shares`: of the corner's normals in the entering one; `rise`: −(normals of the live rows) · (column
    /// `leaving` of the inverse).
    [[nodiscard]] bool exchange(Eigen::Index leaving, Face entering, const Eigen::VectorXd& shares,
                                const Eigen::VectorXd& rise);
    [[nodiscard]] Eigen::VectorXd cost_of_corner(const Eigen::VectorXd& cost);
    /// From 1 to 2, the same in every run.
    [[nodiscard]] double noise();
    [[nodiscard]] Outcome reach_feasible(const Eigen::VectorXd& cost, const SolveControl& control);
    [[nodiscard]] Outcome reach_optimal(const Eigen::VectorXd& cost, const SolveControl& control);
    [[nodiscard]] Eigen::VectorXd face_multipliers(const Eigen::VectorXd& cost) const {
        return -(inverse_.transpose() * cost);
    }
    [[nodiscard]] VertexBound bound_at_corner(const Eigen::VectorXd& cost) const;
    [[nodiscard]] VertexBound infeasible_bound() const;
    [[nodiscard]] bool on_face(Face face) const;
    void mark(Face face, char on);

    Eigen::VectorXd lower_, upper_;
    SparseRowList normals_;       ///< each scaled by a power of two
    std::vector<double> factor_;  ///< that power
    std::vector<double> side_;    ///< b, scaled equally
    std::vector<double> moved_;   ///< b perturbed
    std::vector<Face> corner_;    ///< empty: none yet
    std::vector<char> row_on_, lower_on_, upper_on_;
    Eigen::MatrixXd inverse_;  ///< of the matrix whose rows are the normals of the corner's faces
    Eigen::VectorXd x_;
    std::vector<int> live_;  ///< rows that steps look at, those of the corner among them
    std::vector<char> is_live_;
    SparseRowList live_normals_;
    Eigen::VectorXd room_;  ///< of the live rows at x, to their perturbed right-hand sides
    Eigen::VectorXd ray_;   ///< multipliers of the faces that prove infeasibility
    Face ray_face_ = 0;
    int since_refactor_ = 0;
    long steps_ = 0;
    unsigned long long noise_ = 88172645463325252ULL;
};

}  // namespace camopt
