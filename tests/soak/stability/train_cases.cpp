// SPDX-License-Identifier: MIT
// Elastic followers over eight decades of stiffness, damped from not at all to twice critical: the response
// against one in 113 bits, and solves with the train in the cost and in the limits.
#include "benchmarks/trains/exact_chain.hpp"
#include "dynamics/train_formulas.hpp"
#include "motions/laws/law_catalogue.hpp"
#include "tests/soak/stability/stability_cases.hpp"
#include "tests/soak/stability/stability_scenes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace camopt::stability {

namespace {

constexpr std::array<double, 9> stiffness_ratios = {1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8};
constexpr std::array<double, 6> damping_ratios = {0.0, 0.02, 0.3, 0.999, 1.0, 2.0};
// What is claimed of a response: the rounding of the fastest frequency, which is its phase, and a little.
constexpr double digits_by_radian = 2e-15, digits_at_all = 1e-14;

/// Of place and rate of the output at the end of a rise, by their largest over it.
double response_error(const trains::Chain& chain) {
    DynamicsSpec spec;
    for (const trains::Mass& mass : chain.masses)
        spec.stages.push_back({mass.mass, mass.stiffness, mass.damping});
    spec.mass = spec.stages.back().mass;
    spec.stiffness = spec.stages.back().stiffness;
    spec.damping = spec.stages.back().damping;
    spec.stages.pop_back();
    const auto formulas = train_formulas(spec);
    const auto train = formulas->at(1.0, 1.0, 1.0);
    const auto states = train->states_along(formulas->pieces(*make_law("polynomial_345")),
                                            Eigen::VectorXd::Zero(train->states()), 0.0);
    const Eigen::VectorXd& end = states.back();
    const double place = train->deflection().state.dot(end) / chain.size;
    const double rate = end[end.size() - 1] / (std::sqrt(spec.mass) * chain.size * chain.frequency);
    const trains::ExactResponse truth = exact_response(chain);
    return std::max(std::abs(place - truth.output) / truth.largest_output,
                    std::abs(rate - truth.rate) / truth.largest_rate);
}

StabilityRow response_row(const trains::Chain& chain) {
    double fastest = 0.0;
    for (const trains::Mass& mass : chain.masses)
        fastest = std::max(fastest, std::sqrt(2.0 * mass.stiffness / mass.mass));
    return figure_row("error of the end state", response_error(chain),
                      at_most(digits_by_radian * fastest + digits_at_all, "matrix exponential, 113 bits"));
}

constexpr double rise_seconds = 0.05;  // 90 degrees at 300 rpm

/// What the output lags by at a usual acceleration, in lifts.
double usual_lag(double ratio) {
    const double radians = 2.0 * M_PI * std::sqrt(ratio);
    return 5.5 / (radians * radians);
}

SceneText train_scene(double ratio, double damping, const std::string& rest) {
    return SceneText::parse(fmt::format(
        "[motion]\ntype = \"DRD\"\nlift_mm = 24\nrise_deg = 90\nspeed_rpm = 300\n[spline]\ndegree = 5\n"
        "segments = 14\n[dynamics]\nmass_kg = 2.5\nnatural_frequency_hz = {}\ndamping_ratio = {}\n{}",
        std::sqrt(ratio) / rise_seconds, damping, rest));
}

Expectation true_verdict() {
    Expectation expected;
    expected.source = "residual and force from the spline alone, 113 bits";
    return expected;
}

StabilityRow train_in_cost(double ratio, double damping) {
    const std::string text = fmt::format(
        "[objective]\nacceleration = 0.6\njerk = 0.1\nresidual = 0.3\nreference = {{ velocity = 1.76, "
        "acceleration = 5.53, jerk = 69, residual = {} }}\n",
        0.1 * usual_lag(ratio));
    Expectation expected = true_verdict();
    // The claim of the response itself, by its weight and reference.
    expected.rounding = 3.0 * (digits_by_radian * 2.0 * M_PI * std::sqrt(ratio) + digits_at_all);
    return solved_row(train_scene(ratio, damping, text), expected);
}

StabilityRow residual_limit(double ratio, double damping) {
    const std::string text =
        fmt::format("[objective]\nacceleration = 0.9\njerk = 0.1\n[limits]\nresidual_um = {}\n",
                    1e-3 * usual_lag(ratio) * 24e3);
    return solved_row(train_scene(ratio, damping, text), true_verdict());
}

/// A preload that would let go of the output at a normalised acceleration of 5.7.
StabilityRow force_limit(double ratio, double damping) {
    const double preload = 5.7 * 2.5 * 24e-3 / (rise_seconds * rise_seconds);
    const std::string text = fmt::format(
        "preload_n = {}\n[objective]\nacceleration = 0.8\njerk = 0.2\n[limits]\n"
        "dynamic_contact_force_min_n = 1\n",
        preload);
    Expectation expected = true_verdict();
    // A soft train cannot follow so quickly: then no spline of so many pieces does.
    if (ratio < 30.0) expected.verdicts.push_back(Verdict::infeasible);
    return solved_row(train_scene(ratio, damping, text), expected);
}

}  // namespace

std::vector<StabilityCase> train_cases() {
    std::vector<StabilityCase> cases;
    const auto add = [&](const char* what, double ratio, double damping, bool quick,
                         std::function<StabilityRow()> run) {
        cases.push_back(make_case("stiff trains",
                                  fmt::format("{}, stiffness {:g}, damping {:g}", what, ratio, damping),
                                  quick, std::move(run)));
    };
    for (const double ratio : stiffness_ratios)
        for (const double damping : damping_ratios) {
            add("response of one mass", ratio, damping, true,
                [=] { return response_row(trains::one_mass(ratio, damping)); });
            add("response of two masses", ratio, damping, true,
                [=] { return response_row(trains::two_masses(ratio, damping)); });
        }
    for (const double ratio : stiffness_ratios)
        for (const double damping : {0.0, 0.02, 0.3}) {
            const bool quick = damping == 0.02;
            add("residual in the cost", ratio, damping, quick, [=] { return train_in_cost(ratio, damping); });
            add("residual as a limit", ratio, damping, quick, [=] { return residual_limit(ratio, damping); });
        }
    for (const double ratio : {1.0, 1e2, 1e4, 1e6, 1e8})
        for (const double damping : {0.02, 1.0, 2.0})
            add("least contact force", ratio, damping, ratio <= 1e2 && damping < 1.5,
                [=] { return force_limit(ratio, damping); });
    return cases;
}

}  // namespace camopt::stability
