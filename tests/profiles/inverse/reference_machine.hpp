// SPDX-License-Identifier: MIT
// The reference machine of the tests: round values near those recovered from the paper's Table 1 (chosen, not
// printed in it), its roller, and the arcs of its guides by the paper's own formulas.
#pragma once

#include "core/units.hpp"
#include "profiles/inverse/inverse_mechanism.hpp"

namespace camopt::test {

inline constexpr double inch = units::inch;

inline FeederLinkage reference_linkage() {
    return {15.0 * inch, 9.0 * units::degree, {18.3756 * inch, 0.93306 * inch}, 4.0 * inch};
}

inline RollerStroke forward_stroke() {
    return {0.0, 0.158, 0.0, 1.5 * inch, 0.0, 1000.0 * inch};
}

inline RollerStroke return_stroke() {
    return {0.158, 0.258, 0.258, 1.5 * inch, 0.0, 2496.4 * inch};
}

/// An arc of a guide, in inches: the distances of the roller that it serves, its centre (u, v), and its
/// radius, > 0 where it bends to the left.
struct ArcGuide {
    double from, to, u, v, radius;

    /// Eqs. 7 to 12 of the paper, corrected (docs/papers/000.md), for a roller speed of 1.
    [[nodiscard]] PolarNode node(double distance) const {
        const double L = distance / inch;
        const double D = 2.0 * L * u, E = 2.0 * L * v, F = radius * radius - L * L - u * u - v * v;
        const double root = std::sqrt(D * D + E * E - F * F);
        // Of both crossings of the circle the one near the body's x axis.
        const double a = 2.0 * std::atan((-E + root) / (F - D)), b = 2.0 * std::atan((-E - root) / (F - D));
        const double psi = std::abs(a) < std::abs(b) ? a : b;
        const double s = std::sin(psi), c = std::cos(psi), bottom = L * (v * c - u * s);
        const double slope = (L - v * s - u * c) / bottom;
        const double bend =
            (2.0 * slope * (u * s - v * c) + L * slope * slope * (u * c + v * s) + 1.0) / bottom;
        return {distance, psi, slope / inch, bend / (inch * inch)};
    }
    [[nodiscard]] BodyMotion body(const RollerState& roller) const {
        const PolarNode at = node(roller.distance);
        return {-at.angle, -at.slope * roller.velocity,
                -(at.bend * roller.velocity * roller.velocity + at.slope * roller.acceleration)};
    }
    [[nodiscard]] Eigen::Vector2d place(double distance) const {
        const double angle = node(distance).angle;
        return distance * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    }
    /// Unit vector to the left of the guide, seen outwards.
    [[nodiscard]] Eigen::Vector2d left(double distance) const {
        return ((inch * Eigen::Vector2d(u, v) - place(distance)) / (radius * inch)).normalized();
    }
};

/// From the end of the first line at 5.25 in on; the arcs join a line at 9 deg through the pivot.
inline constexpr ArcGuide forward_arcs[] = {
    {5.25, 9.7178601331381351, 5.25, 9.92, 9.92},
    {9.7178601331381351, 12.89833835114832, 14.408694144459574, -8.5208899342803388, -10.67}};
inline constexpr ArcGuide return_arcs[] = {
    {5.0, 9.4063115628767626, 5.0, 10.092, 10.092},
    {9.4063115628767626, 12.745552843309087, 14.428303246648705, -9.621371144713768, -11.76}};

inline const ArcGuide& arc_at(const ArcGuide (&arcs)[2], double distance) {
    return arcs[distance < arcs[0].to * inch ? 0 : 1];
}

}  // namespace camopt::test
