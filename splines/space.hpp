// SPDX-License-Identifier: MIT
// The space of piecewise polynomials of degree p on breakpoints x_0 < … < x_n that are C^k at the interior
// ones.
//
// Dimension N = (p + 1) + (n − 1)(p − k). Clamped knots: ends of multiplicity p + 1, interior breakpoints of
// multiplicity p − k.
#pragma once

#include "core/numbers/extremum.hpp"

#include <vector>

namespace camopt {

class SplineSpace {
 public:
    /// Throws InputError: degree < 1, continuity not in 0 … degree − 1, fewer than two breakpoints, not
    /// ascending.
    SplineSpace(int degree, int continuity, std::vector<double> breakpoints);
    [[nodiscard]] static SplineSpace uniform(int degree, int continuity, int segments, double length);

    [[nodiscard]] int degree() const { return degree_; }
    [[nodiscard]] int continuity() const { return continuity_; }
    [[nodiscard]] int segments() const { return static_cast<int>(breakpoints_.size()) - 1; }
    [[nodiscard]] int dimension() const { return degree_ + 1 + (segments() - 1) * (degree_ - continuity_); }
    [[nodiscard]] const std::vector<double>& breakpoints() const { return breakpoints_; }
    [[nodiscard]] double begin() const { return breakpoints_.front(); }
    [[nodiscard]] double end() const { return breakpoints_.back(); }
    [[nodiscard]] double width(int segment) const {
        return breakpoints_[segment + 1] - breakpoints_[segment];
    }

    [[nodiscard]] double knot(int index) const;
    [[nodiscard]] std::vector<double> knots() const;
    /// First of the degree + 1 basis functions with support on a segment.
    [[nodiscard]] int first_basis_function(int segment) const { return segment * (degree_ - continuity_); }

    /// The segment that contains x; at a breakpoint the one on `side`. Throws InputError outside [begin, end]
    /// (a round-off excess is clamped).
    [[nodiscard]] int segment_of(double x, Side side = Side::right) const;

    /// Whether the breakpoints lie symmetrically about the middle, to round-off.
    [[nodiscard]] bool is_symmetric() const;

 private:
    int degree_, continuity_;
    std::vector<double> breakpoints_;
};

}  // namespace camopt
