// SPDX-License-Identifier: MIT
// Piecewise polynomials with linear conditions, written down without the library: what trials with a known
// answer (known_scene.hpp) are made of.
//
// A piece [a, b] of degree p has the Bernstein coefficients c_0 … c_p over t = (x − a) / (b − a); all pieces
// together are one vector c. Continuity, ends, joints and symmetry are rows E c = e. Motions are c_p + Z z
// with the columns of Z an orthonormal basis of the null space of E. x has no unit, y counts in lifts.
#pragma once

#include "tests/soak/figures/polynomial.hpp"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace camopt::soak {

/// Weights of y, y', …, y⁽⁷⁾.
using Combination = std::array<double, 8>;
[[nodiscard]] Combination derivative_alone(int order);

/// A value of a combination where it is locally extreme, or at an end of a piece.
struct Extreme {
    double x = 0.0;
    int piece = 0;
    double value = 0.0;
};

class PiecewiseSpace {
 public:
    explicit PiecewiseSpace(int degree) : degree_(degree) {}

    /// Neighbouring pieces that join with this continuity; the number of the first one.
    int add_run(const std::vector<double>& breakpoints, int continuity);
    /// The end of one piece and the begin of another have the same derivatives up to this order.
    void join(int left, int right, int continuity);
    /// The derivative of this order at an end of a piece.
    void fix_begin(int piece, int order, double value);
    void fix_end(int piece, int order, double value);
    void fix(double x, int order, double value);
    /// y(x) + y(begin + end − x) = 1 (odd) or y(x) = y(begin + end − x) (even).
    void reflect(bool odd);
    /// After the last condition. False: the conditions contradict each other.
    [[nodiscard]] bool close();

    [[nodiscard]] int degree() const { return degree_; }
    [[nodiscard]] int pieces() const { return static_cast<int>(begins_.size()); }
    [[nodiscard]] double begin(int piece) const { return begins_[static_cast<std::size_t>(piece)]; }
    [[nodiscard]] double end(int piece) const { return ends_[static_cast<std::size_t>(piece)]; }
    [[nodiscard]] double width(int piece) const { return end(piece) - begin(piece); }
    [[nodiscard]] int piece_of(double x) const;
    [[nodiscard]] Eigen::Index size() const { return static_cast<Eigen::Index>(pieces()) * (degree_ + 1); }
    [[nodiscard]] Eigen::Index freedom() const { return directions_.cols(); }
    [[nodiscard]] const Eigen::MatrixXd& directions() const { return directions_; }  ///< Z
    /// Of least ∫ y'''².
    [[nodiscard]] const Eigen::VectorXd& smoothest() const { return smoothest_; }

    /// The row that takes c to the value of a combination.
    [[nodiscard]] Eigen::VectorXd row(const Combination& weights, int piece, double x) const;
    /// The row of ∫ y dx over all pieces.
    [[nodiscard]] Eigen::VectorXd integral() const;
    /// ∫ (combination + constant)² dx over some pieces at a motion, and half its gradient.
    struct Square {
        double value = 0.0;
        Eigen::VectorXd slope;
    };
    /// From values along the motion: the form cᵀ gram c of a narrow piece cancels to 1e-16 / width³ and
    /// worse.
    void add_square(const Eigen::VectorXd& motion, const Combination& weights, double constant, int first,
                    int count, Square& sum) const;
    /// A combination along a piece, of t from 0 to 1.
    [[nodiscard]] Polynomial polynomial(const Eigen::VectorXd& motion, const Combination& weights,
                                        int piece) const;
    /// Extremes and ends of pieces between two locations, of one piece.
    [[nodiscard]] std::vector<Extreme> extremes(const Eigen::VectorXd& motion, const Combination& weights,
                                                int piece, double low, double high) const;
    [[nodiscard]] std::vector<Extreme> extremes(const Eigen::VectorXd& motion, const Combination& weights,
                                                int piece) const {
        return extremes(motion, weights, piece, begin(piece), end(piece));
    }

    /// How much the value of a program changes by a relative change of what E and its pieces say, where v is
    /// the sum of all other rows, each times its multiplier: Σ |multiplier of E| · size of its terms, and
    /// of what the motion leaves of them by rounding.
    [[nodiscard]] double sensitivity(const Eigen::VectorXd& v, const Eigen::VectorXd& motion) const;
    /// How far c may have to move for such a change: about |E⁺| · size of its terms.
    [[nodiscard]] double drift(const Eigen::VectorXd& motion) const;
    /// From c to the next that meets its conditions exactly.
    [[nodiscard]] Eigen::VectorXd correction(const Eigen::VectorXd& motion) const;

 private:
    struct Condition {
        Eigen::VectorXd row;
        double value;
        double growth;  ///< relative change of its terms by one of a breakpoint
    };
    void require(const Eigen::VectorXd& row, double value, double growth);
    /// Calls visit(x, weight) for quadrature along a piece.
    template <class Visit>
    void visit_nodes(int piece, Visit&& visit) const;
    /// c' form c = ∫ y'''² dx.
    [[nodiscard]] Eigen::MatrixXd jerk_form() const;

    int degree_;
    std::vector<double> begins_, ends_;
    struct Join {
        int left, right, continuity;
    };
    struct Fixed {
        int piece;
        double x;
        int order;
        double value;
    };
    std::vector<Join> joins_;
    std::vector<Fixed> fixed_;
    int reflection_ = 0;  ///< 1: odd, 2: even
    std::vector<Condition> conditions_;
    Eigen::MatrixXd equations_, directions_;
    Eigen::VectorXd smoothest_;
    double least_pivot_ = 1.0;  ///< of E: its least singular value but for a factor of about √size
};

}  // namespace camopt::soak
