// SPDX-License-Identifier: MIT
// The optimization problem for every backend:
//
//     min f(x)   subject to   x_L <= x <= x_U,   g_L <= g(x) <= g_U
//
// x has `variables` entries, g has `constraints` rows. Equalities are equal bounds; missing bounds are
// +-infinity. The Lagrangian is L = sigma f(x) + lambdaᵀ g(x): at a minimum, lambda > 0 belongs to an active
// upper bound g_U, lambda < 0 to an active lower bound g_L.
// Sizes, bounds, patterns and flags are fixed on construction; only values are computed later.
#pragma once

#include "core/numbers/extremum.hpp"

#include <Eigen/Core>

#include <map>

namespace camopt {

// What identifies a row among those of its rule, for programs: what `RowOrigin::rule` and `remark` say in
// words.
struct RowFields {
    std::string axis = {};  ///< of a machine: whose rule it is; empty: of no axis
    std::string key = {};   ///< of the limit in the scene; of a term its own: "velocity" of a peak
    std::string part = {};  ///< what the limit needs beside itself: "undercut", "contact_height", "face_turn"
    /// Numbers of the row: "station", "harmonic", "rpm" … (docs/results.md).
    std::map<std::string, double> which = {};
    /// Of a made cam: parts of the tolerances, from −1 to 1, by their names; of the motion "s", "s'", "s''".
    std::map<std::string, double> made = {};

    friend bool operator==(const RowFields&, const RowFields&) = default;
};

// Where a constraint row comes from, for reports and explanations. Names of rows are for users.
struct RowOrigin {
    std::string rule;          ///< of a limit of the scene: its key, "limits.velocity_mm_s"
    std::string remark;        ///< which part of the rule: "face turns back"; mostly empty
    std::optional<double> at;  ///< x; none: not located in the motion
    Side side = Side::right;   ///< of x, where something may jump
    bool limit = false;        ///< a hard limit of the user's scene
    std::optional<int> order =
        {};        ///< the highest derivative that the rule reads; none: no rule of the motion
    int sign = 0;  ///< ±1 where a rule has two sides, one for each sign; else 0
    RowFields fields = {};

    /// "limits.velocity_mm_s (face turns back) at x = 0.25-"; the minus: the side below x.
    [[nodiscard]] std::string text() const;
    friend bool operator==(const RowOrigin&, const RowOrigin&) = default;
};

/// Positions of the entries of a sparse matrix, without duplicates, in the order their values are written.
struct SparsityPattern {
    std::vector<int> rows;
    std::vector<int> columns;
    [[nodiscard]] int size() const { return static_cast<int>(rows.size()); }
};

/// What is known of one constraint row before anything is evaluated.
struct RowKind {
    bool linear = true;  ///< its Jacobian entries do not depend on x
    /// A hard limit of the user's scene (a cap, a pressure angle). Only these rows may make a problem
    /// infeasible; the elastic problem relaxes them in proportion to `scale`.
    bool limit = false;
    double scale = 1.0;        ///< size of the limit, > 0: a violation of `scale` is one of 100 %
    double rounding = 0.0;     ///< of its value, at points of the usual size: proofs relax its sides by this
    double uncertainty = 0.0;  ///< likewise, by round-off of its numbers: contradictions are larger
};

/// Multipliers prove a contradiction (0 >= excess, that is no feasible point) where the excess of rows of
/// size 1, relative to the sum of their multipliers, is above this. Below it round-off of the rows' own
/// numbers decides.
inline constexpr double least_contradiction = 1e-11;

struct NlpShape {
    Eigen::VectorXd x_lower, x_upper;  ///< size variables
    Eigen::VectorXd g_lower, g_upper;  ///< size constraints
    std::vector<RowKind> rows;         ///< size constraints
    SparsityPattern jacobian;          ///< constraints x variables
    SparsityPattern hessian;           ///< lower triangle of the Lagrangian's Hessian
    bool convex = false;               ///< f convex and the feasible set convex
    bool linear_cost = false;          ///< the gradient of f does not depend on x
    bool quadratic_cost = false;       ///< the Hessian of f does not depend on x (true for linear_cost too)

    [[nodiscard]] int variables() const { return static_cast<int>(x_lower.size()); }
    [[nodiscard]] int constraints() const { return static_cast<int>(g_lower.size()); }
};

class Nlp {
 public:
    using Vector = Eigen::VectorXd;
    using ConstVectorRef = Eigen::Ref<const Eigen::VectorXd>;
    using VectorRef = Eigen::Ref<Eigen::VectorXd>;

    virtual ~Nlp() = default;
    Nlp(const Nlp&) = delete;
    Nlp& operator=(const Nlp&) = delete;

    [[nodiscard]] const NlpShape& shape() const noexcept { return shape_; }

    [[nodiscard]] virtual double cost(const ConstVectorRef& x) const = 0;
    virtual void gradient(const ConstVectorRef& x, VectorRef out) const = 0;
    virtual void constraints(const ConstVectorRef& x, VectorRef out) const = 0;
    /// Values in the order of shape().jacobian.
    virtual void jacobian(const ConstVectorRef& x, std::span<double> out) const = 0;
    /// Values of sigma ∇²f + Σ lambda_i ∇²g_i in the order of shape().hessian (lower triangle).
    virtual void hessian(const ConstVectorRef& x, double sigma, const ConstVectorRef& lambda,
                         std::span<double> out) const = 0;

    [[nodiscard]] virtual std::string variable_name(int index) const = 0;
    [[nodiscard]] virtual std::string row_name(int index) const = 0;
    /// The same for programs.
    [[nodiscard]] virtual RowOrigin row_origin(int index) const {
        RowOrigin origin;
        origin.rule = row_name(index);
        origin.limit = shape_.rows[static_cast<std::size_t>(index)].limit;
        return origin;
    }

 protected:
    Nlp() = default;
    explicit Nlp(NlpShape shape) : shape_(std::move(shape)) {}
    NlpShape shape_;
};

// Counts the evaluations that a backend requests of a problem.

struct EvaluationCounts {
    long cost = 0, gradient = 0, constraints = 0, jacobian = 0, hessian = 0;
    long profile_points = 0;  ///< no [cam]: none, ever
};

/// Forwards everything to `base`; both `base` and `counts` must outlive it.
class CountingNlp final : public Nlp {
 public:
    CountingNlp(const Nlp& base, EvaluationCounts& counts)
        : Nlp(base.shape()), base_(base), counts_(counts) {}

    [[nodiscard]] double cost(const ConstVectorRef& x) const override {
        ++counts_.cost;
        return base_.cost(x);
    }
    void gradient(const ConstVectorRef& x, VectorRef out) const override {
        ++counts_.gradient;
        base_.gradient(x, out);
    }
    void constraints(const ConstVectorRef& x, VectorRef out) const override {
        ++counts_.constraints;
        base_.constraints(x, out);
    }
    void jacobian(const ConstVectorRef& x, std::span<double> out) const override {
        ++counts_.jacobian;
        base_.jacobian(x, out);
    }
    void hessian(const ConstVectorRef& x, double sigma, const ConstVectorRef& lambda,
                 std::span<double> out) const override {
        ++counts_.hessian;
        base_.hessian(x, sigma, lambda, out);
    }
    [[nodiscard]] std::string variable_name(int index) const override { return base_.variable_name(index); }
    [[nodiscard]] std::string row_name(int index) const override { return base_.row_name(index); }
    [[nodiscard]] RowOrigin row_origin(int index) const override { return base_.row_origin(index); }

 private:
    const Nlp& base_;
    EvaluationCounts& counts_;
};

}  // namespace camopt
