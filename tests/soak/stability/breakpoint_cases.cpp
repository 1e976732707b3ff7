// SPDX-License-Identifier: MIT
#include "tests/soak/stability/stability_cases.hpp"
#include "tests/soak/stability/stability_scenes.hpp"

#include <fmt/format.h>

#include <cmath>

namespace camopt::stability {

namespace {

constexpr double any_curve = any_curve_limit_of_study;
constexpr MotionType drd = MotionType::drd;

SceneText with_breakpoints(int degree, const std::vector<double>& breakpoints, const std::string& backend) {
    SceneText scene = study_scene(drd, degree, 12);
    scene.at("spline").erase("segments");
    scene.at("spline").set("breakpoints", soak::list_text(breakpoints));
    set_solver(scene, backend);
    scene.at("solver").set("max_seconds", 10.0);
    return scene;
}

/// Twelve equal segments and one more breakpoint at a distance of `ratio` of their width.
std::vector<double> close_pair(int beside, double ratio) {
    std::vector<double> places;
    for (int k = 0; k <= 12; ++k) places.push_back(k / 12.0);
    const double place = places[beside] + (beside == 12 ? -1.0 : 1.0) * ratio / 12.0;
    places.insert(places.begin() + beside + (beside == 12 ? 0 : 1), place);
    return places;
}

/// Widths w, w q, w q², … with q^(count − 1) = ratio, over [0, 1].
std::vector<double> graded(int count, double ratio) {
    std::vector<double> places = {0.0};
    const double q = std::pow(ratio, 1.0 / (count - 1));
    double width = 1.0;
    for (int k = 0; k < count; ++k, width *= q) places.push_back(places.back() + width);
    for (double& place : places) place /= places.back();
    places.back() = 1.0;
    return places;
}

/// The same twice, mirrored: narrow at the ends, or in the middle.
std::vector<double> graded_both_ways(int count, double ratio, bool narrow_at_ends) {
    std::vector<double> half = graded(count, ratio);
    if (!narrow_at_ends) {
        std::vector<double> turned;
        for (auto x = half.rbegin(); x != half.rend(); ++x) turned.push_back(1.0 - *x);
        half = turned;
    }
    std::vector<double> places;
    for (const double x : half) places.push_back(0.5 * x);
    for (auto x = half.rbegin() + 1; x != half.rend(); ++x) places.push_back(1.0 - 0.5 * *x);
    return places;
}

Expectation of_pair(int degree) {
    Expectation expected = known_optimum(drd, degree, 12);
    // The space contains that of twelve segments. Cubic: y'' changes by at most J times the width on the
    // narrow segment, 3e-7, so that the optimum is at most 1e-7 lower. Quintic: the pair gives y'''' a jump.
    expected.source = "no worse than twelve equal segments, which it contains";
    expected.least = degree == 3 ? *expected.most * (1.0 - 1e-7) : any_curve;
    return expected;
}

void add_pairs(std::vector<StabilityCase>& cases) {
    for (const int degree : {3, 5})
        for (const int beside : {0, 5, 12})
            for (const double ratio : {1e-4, 1e-8})
                for (const char* backend : {"structured", "ipopt"})
                    cases.push_back(make_case(
                        "breakpoints",
                        fmt::format("{}, 12 segments and one of {} beside breakpoint {}",
                                    degree == 3 ? "cubic" : "quintic", ratio, beside),
                        std::string(backend) == "structured", [=] {
                            Expectation expected = of_pair(degree);
                            if (degree == 3 && ratio > 1e-6) expected.least = any_curve;
                            expected.honest_gap = true;
                            expected.may_give_up = degree == 5;
                            return solved_row(with_breakpoints(degree, close_pair(beside, ratio), backend),
                                              expected);
                        }));
}

void add_graded(std::vector<StabilityCase>& cases) {
    struct Shape {
        const char* name;
        std::vector<double> places;
    };
    const Shape shapes[] = {{"widths from 1e-8 to 1", graded(9, 1e8)},
                            {"widths 1e-8 at both ends", graded_both_ways(9, 1e8, true)},
                            {"widths 1e-8 in the middle", graded_both_ways(9, 1e8, false)},
                            {"33 widths from 1e-8 to 1", graded(33, 1e8)}};
    for (const int degree : {3, 5})
        for (const Shape& shape : shapes)
            for (const char* backend : {"structured", "ipopt"})
                cases.push_back(make_case(
                    "breakpoints", fmt::format("{}, {}", degree == 3 ? "cubic" : "quintic", shape.name),
                    std::string(backend) == "structured", [=, places = shape.places] {
                        Expectation expected;
                        expected.least = any_curve;
                        expected.source = "the limit of any curve; the proof";
                        expected.may_give_up = degree == 5;
                        return solved_row(with_breakpoints(degree, places, backend), expected);
                    }));
}

}  // namespace

std::vector<StabilityCase> breakpoint_cases() {
    std::vector<StabilityCase> cases;
    add_pairs(cases);
    add_graded(cases);
    return cases;
}

}  // namespace camopt::stability
