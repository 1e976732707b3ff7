// SPDX-License-Identifier: MIT
// A law, a term, a limit and a solver of the program's own, in one solve.
#include <camopt/laws.hpp>
#include <camopt/own_rules.hpp>
#include <camopt/scene_file.hpp>
#include <camopt/solve.hpp>
#include <camopt/solver_registry.hpp>
#include <iostream>
#include <memory>

// The host's own header of a name that camopt's sources have too.
#include "scene/scene.hpp"

namespace {

class Smoothstep final : public camopt::Law {
 public:
    Smoothstep() : Law(description()) {}
    std::vector<double> breakpoints() const override { return {0.0, 1.0}; }

 private:
    static camopt::LawInfo description() {
        camopt::LawInfo info;
        info.key = "smoothstep";
        info.title = "Smoothstep";
        info.continuity = 1;
        return info;
    }
    camopt::LawDerivatives evaluate(double x, camopt::Side) const override {
        return {x * x * (3.0 - 2.0 * x), 6.0 * x * (1.0 - x), 6.0 - 12.0 * x, -12.0, 0.0};
    }
};

/// Tells of each call and hands it on.
class Telling final : public camopt::Solver {
 public:
    std::string_view name() const override { return "telling"; }
    camopt::BackendResult minimize(const camopt::Nlp& problem, const Eigen::VectorXd& start,
                                   const camopt::BackendOptions& options,
                                   const camopt::SolveControl& control) const override {
        std::cout << "solves " << problem.shape().variables() << " variables\n";
        return camopt::make_solver("structured")->minimize(problem, start, options, control);
    }
};

}  // namespace

int main() {
    camopt::add_law([] { return std::make_unique<Smoothstep>(); });
    camopt::SolverEntry entry;
    entry.name = "telling";
    camopt::add_solver(entry, [] { return std::make_unique<Telling>(); });

    camopt::Scene scene = camopt::scene_of_toml(host_scene_text);
    camopt::OwnTerm term;
    term.name = "squared_acceleration";
    term.weight = 0.5;
    term.reference = 36.0;
    term.formula =
        camopt::motion_formula([](const auto&, const auto&, const auto& a, const auto&) { return a * a; });
    term.shape = camopt::Curvature::convex;
    term.highest_order = 2;
    scene.own_terms.push_back(term);
    camopt::OwnLimit limit;
    limit.name = "speed";
    limit.limit = 1.8;
    limit.formula =
        camopt::motion_formula([](const auto&, const auto& v, const auto&, const auto&) { return 1.0 * v; });
    limit.shape = camopt::Curvature::linear;
    limit.highest_order = 1;
    scene.own_limits.push_back(limit);
    const camopt::Solution solution = camopt::solve(scene);
    std::cout.precision(9);
    std::cout << name_of(solution.certificate.verdict) << ": own term " << solution.own_terms.front().value
              << ", " << solution.constraints.front().key << ' ' << solution.constraints.front().worst
              << '\n';
}
