// SPDX-License-Identifier: MIT
#include "core/errors.hpp"
#include "tests/soak/stability/stability_cases.hpp"
#include "tests/soak/stability/stability_scenes.hpp"

#include <fmt/format.h>

#include <cmath>

namespace camopt::stability {

namespace {

constexpr MotionType drd = MotionType::drd;

SceneText with_weights(int degree, int segments, double velocity, double acceleration, double jerk) {
    SceneText scene = study_scene(drd, degree, segments);
    set_weights(scene, {velocity, acceleration, jerk});
    return scene;
}

/// A mean square alone, in units of its own.
SceneText with_mean_square(int degree, int segments, const char* term) {
    SceneText scene = with_weights(degree, segments, 0, 0, 0);
    soak::SceneTable& objective = scene.at("objective");
    objective.set(term, 1.0);
    soak::SceneTable reference = soak::inline_table(*objective.find("reference"));
    reference.set(term, 1.0);
    objective.set("reference", inline_text(reference));
    return scene;
}

class Cases {
 public:
    /// The same scene on every backend that takes it.
    void add(const std::string& name, const SceneText& scene, const Expectation& expected,
             bool own_only = false) {
        for (const char* backend : {"structured", "ipopt", "nlopt.slsqp"}) {
            if (own_only && std::string(backend) != "structured") continue;
            SceneText on = scene;
            set_solver(on, backend);
            list.push_back(
                make_case("degenerate", name, true, [on, expected] { return solved_row(on, expected); }));
        }
    }
    std::vector<StabilityCase> list;
};

/// The pure peaks, where many motions share the optimum.
void add_pure_peaks(Cases& cases) {
    for (const int n : {4, 8, 12, 16, 64})
        cases.add(fmt::format("cubic, jerk alone, n = {}", n), with_weights(3, n, 0, 0, 1),
                  exactly(32.0 / 69.0, "J = 32"), n > 16);
    for (const int n : {4, 7, 12, 33}) {
        const double even = 4.0 * n / (n - 2.0);
        const double odd = 4.0 * n * n / ((n - 1.0) * (n - 1.0));
        cases.add(
            fmt::format("cubic, acceleration alone, n = {}", n), with_weights(3, n, 0, 1, 0),
            exactly((n % 2 == 0 ? even : odd) / 5.53, n % 2 == 0 ? "A = 4n/(n − 2)" : "A = 4n²/(n − 1)²"),
            n > 16);
    }
    for (const int n : {12, 64}) {
        // Not attained by any curve; in the spline space it is. The ramp of a quadratic spline takes two
        // segments.
        Expectation expected = exactly(n / (n - 2.0) / 1.76, "1 < V <= n/(n − 2)");
        expected.least = 1.0 / 1.76;
        cases.add(fmt::format("cubic, velocity alone, n = {}", n), with_weights(3, n, 1, 0, 0), expected,
                  n > 16);
    }
}

/// Spaces with one motion, or none.
void add_single_motions(Cases& cases) {
    // Jerk +27, −54, +27 at thirds? The three conditions at either end leave one cubic of three segments.
    cases.add("cubic, n = 3: a single motion", study_scene(drd, 3, 3),
              exactly(study_objective(2.25, 9.0, 54.0), "J = 27, −54, 27 is the only motion"));
    cases.add("quintic, n = 1: a single motion", study_scene(drd, 5, 1),
              exactly(study_objective(1.875, 10.0 / std::sqrt(3.0), 60.0), "the polynomial 3-4-5"));
    Expectation none;
    none.verdicts = {Verdict::infeasible};
    none.source = "n + 3 coefficients, 6 conditions";
    cases.add("cubic, n = 2: no motion", study_scene(drd, 3, 2), none);
    cases.add("cubic, n = 1: no motion", study_scene(drd, 3, 1), none);
}

/// Mirror images are equally good; weights of 0 leave peaks free; ties are broken or not.
void add_twins(Cases& cases) {
    for (const int n : {12, 13}) {
        const SceneText scene = study_scene(drd, 3, n);
        const Expectation expected = known_optimum(drd, 3, n);
        for (const bool symmetric : {false, true})
            for (const TieBreak ties : {TieBreak::none, TieBreak::rms_jerk}) {
                SceneText one = scene;
                if (symmetric) one.at("motion").set("symmetric", "true");
                set_tie_break(one, ties);
                cases.add(
                    fmt::format("cubic, n = {}, symmetric {}, tie_break {}", n, symmetric, name_of(ties)),
                    one, expected);
            }
    }
    SceneText capped = with_weights(3, 12, 0, 0, 1);
    capped.at("limits").set("velocity", 2.0);
    capped.at("limits").set("acceleration", 8.0);
    cases.add("jerk alone, V and A capped at their value", capped,
              exactly(32.0 / 69.0, "J = 32 has V = 2, A = 8"));
}

/// Peaks of weight 0 and mean squares: the least ∫ y'''² of all splines is the polynomial spline itself.
void add_mean_squares(Cases& cases) {
    // Least ∫ y'''² with y, y', y'' given at both ends: the quintic 3-4-5, ∫ (60 − 360x + 360x²)² dx = 720.
    cases.add("quintic, mean square jerk alone", with_mean_square(5, 8, "rms_jerk"),
              exactly(std::sqrt(720.0), "the polynomial 3-4-5: √720"), true);
    Expectation expected;
    expected.least = std::sqrt(12.0);
    expected.source = "√12 of the parabola with free y'' at the ends; the proof";
    cases.add("cubic, mean square acceleration alone", with_mean_square(3, 12, "rms_acceleration"), expected,
              true);
}

}  // namespace

std::vector<StabilityCase> degenerate_cases() {
    Cases cases;
    add_pure_peaks(cases);
    add_single_motions(cases);
    add_twins(cases);
    add_mean_squares(cases);
    return std::move(cases.list);
}

}  // namespace camopt::stability
