// SPDX-License-Identifier: MIT
// A cost term of your own: the largest squared acceleration, to which the heat in a motor is proportional.
// camopt differentiates the formula, and since it is convex it proves the optimum.
#include <camopt/own_rules.hpp>
#include <camopt/solve.hpp>
#include <cstdio>

int main() {
    camopt::Scene scene;
    scene.spline.segments = 12;
    scene.objective.jerk = 0.3;

    camopt::OwnTerm term;
    term.name = "squared_acceleration";
    term.weight = 0.7;
    term.reference = 30.0;
    term.formula =
        camopt::motion_formula([](const auto&, const auto&, const auto& a, const auto&) { return a * a; });
    term.shape = camopt::Curvature::convex;  // checked at every point; lets the optimum be proved
    term.highest_order = 2;
    scene.own_terms = {term};
    const camopt::Solution solution = camopt::solve(scene);
    std::printf("%s: objective %.6f\n", name_of(solution.certificate.verdict),
                solution.certificate.objective);
    const camopt::OwnTermReport& found = solution.own_terms.front();
    std::printf("%s at most %.4f, at %.3f of the rise\n", found.name.c_str(), found.value, found.at);
}
