// SPDX-License-Identifier: MIT
#include "tests/soak/stability/stability_cases.hpp"
#include "tests/soak/stability/stability_scenes.hpp"

#include <fmt/format.h>

#include <array>

namespace camopt::stability {

namespace {

using Weights = std::array<double, 3>;

struct Space {
    const char* name;
    MotionType type;
    int degree, segments;
};

SceneText weighted_scene(const Space& space, const Weights& weights, const std::string& backend) {
    SceneText scene = study_scene(space.type, space.degree, space.segments);
    set_weights(scene, {weights[0], weights[1], weights[2]});
    set_solver(scene, backend);
    return scene;
}

/// The optimum of a corner in closed form, where there is one.
std::optional<Expectation> closed_form(const Space& space, const Weights& corner) {
    if (space.type != MotionType::drd || space.degree != 3) return {};
    const double n = space.segments;
    // y'' is a broken line with its ends at 0; bang-bang at the breakpoints is best: A = 4n/(n − 2), n even.
    if (corner[1] == 1.0 && space.segments % 2 == 0)
        return exactly(4.0 * n / (n - 2.0) / 5.53, "A = 4n/(n − 2)");
    // Jerk ±32 switching at 1/4 and 3/4: breakpoints where 4 divides n.
    if (corner[2] == 1.0 && space.segments % 4 == 0) return exactly(32.0 / 69.0, "J = 32");
    return {};
}

Expectation corner_optimum(const Space& space, const Weights& corner) {
    if (const auto known = closed_form(space, corner)) return *known;
    return proved_optimum(weighted_scene(space, corner, "structured"), "structured, states, proved");
}

std::string text_of_weights(const Weights& weights) {
    return fmt::format("({}, {}, {})", weights[0], weights[1], weights[2]);
}

void add_corners(std::vector<StabilityCase>& cases, const Space& space) {
    for (int corner = 0; corner < 3; ++corner)
        for (const double beside : {0.0, 1e-12, 1e-9})
            for (const char* backend : {"structured", "ipopt"}) {
                Weights at{}, weights{beside, beside, beside};
                at[corner] = weights[corner] = 1.0;
                cases.push_back(
                    make_case("weights", fmt::format("{} {}", space.name, text_of_weights(weights)),
                              space.segments <= 24 && std::string(backend) == "structured", [=] {
                                  Expectation expected = corner_optimum(space, at);
                                  // The others cost what they are at the corner's own optimum: V, A, J <=
                                  // 3000 at these n.
                                  expected.digits += 1000.0 * beside;
                                  expected.honest_gap = true;
                                  return solved_row(weighted_scene(space, weights, backend), expected);
                              }));
            }
}

void add_multiples(std::vector<StabilityCase>& cases) {
    const Space space = {"cubic 12", MotionType::drd, 3, 12};
    for (const double factor : {1e-12, 1e-9, 1e-6, 1e6, 1e9, 1e12})
        for (const char* backend : {"structured", "ipopt", "nlopt.slsqp"})
            cases.push_back(
                make_case("weights", fmt::format("cubic 12, all weights × {}", factor), true, [=] {
                    const Weights weights = {0.4 * factor, 0.4 * factor, 0.2 * factor};
                    const double optimum = factor * study_objective(12.0 / 7, 36.0 / 7, 432.0 / 7);
                    return solved_row(weighted_scene(space, weights, backend), exactly(optimum, "fraction"));
                }));
    for (const double factor : {1e-9, 1e9})
        cases.push_back(make_case("weights", fmt::format("cubic 12, reference × {}", factor), true, [=] {
            SceneText scene = weighted_scene(space, {0.4, 0.4, 0.2}, "structured");
            set_reference(scene, {1.76 * factor, 5.53 * factor, 69.0 * factor});
            const double optimum = study_objective(12.0 / 7, 36.0 / 7, 432.0 / 7) / factor;
            return solved_row(scene, exactly(optimum, "fraction"));
        }));
}

}  // namespace

std::vector<StabilityCase> weight_cases() {
    std::vector<StabilityCase> cases;
    add_corners(cases, {"cubic 12", MotionType::drd, 3, 12});
    add_corners(cases, {"cubic 64", MotionType::drd, 3, 64});
    add_corners(cases, {"quintic 12", MotionType::drd, 5, 12});
    add_corners(cases, {"RR cubic 24", MotionType::rr, 3, 24});
    add_multiples(cases);
    return cases;
}

}  // namespace camopt::stability
