// SPDX-License-Identifier: MIT
#include "studies/search/planned_solve.hpp"
#include "tests/soak/stability/stability_cases.hpp"
#include "tests/soak/stability/stability_scenes.hpp"

#include <fmt/format.h>

#include <cmath>

namespace camopt::stability {

namespace {

constexpr MotionType drd = MotionType::drd;

Expectation twelve(double accuracy) {
    return exactly(study_objective(12.0 / 7, 36.0 / 7, 432.0 / 7),
                   "the optimum without these points: fraction", accuracy);
}

/// Where condition and contradiction cannot be told apart any answer that keeps its word will do.
const std::vector<Verdict> either = {Verdict::optimal, Verdict::local, Verdict::feasible, Verdict::infeasible,
                                     Verdict::failed};

/// Points that the motion passes with a displacement, or a slope as well.
struct Point {
    double at = 0.0, displacement = 0.0;
    std::optional<double> velocity = {};
};

void set_points(SceneText& scene, const std::vector<Point>& points) {
    std::vector<soak::SceneTable> tables;
    for (const Point& point : points) {
        soak::SceneTable& table = tables.emplace_back();
        table.set("at", point.at);
        table.set("displacement", point.displacement);
        if (point.velocity) table.set("velocity", *point.velocity);
    }
    scene.at("motion").set("via", inline_text(tables));
}

/// The antisymmetric optimum passes (1/2, 1/2); the point says so again, wrong by `error`.
StabilityRow follows_from_symmetry(double error, const std::string& backend) {
    SceneText scene = study_scene(drd, 3, 12);
    scene.at("motion").set("symmetric", "true");
    set_points(scene, {{0.5, 0.5 + error}});
    set_solver(scene, backend);
    Expectation expected = twelve(1e-9);
    expected.source = "follows from symmetry; " + expected.source;
    if (error > 2e-9) {
        expected = {};
        expected.verdicts = {Verdict::infeasible};
        expected.source = "contradicts symmetry";
    } else if (error > 5e-10) {
        expected.verdicts = either;
        expected.violation = 1.1e-9;
    }
    return solved_row(scene, expected);
}

/// Two points of the optimum itself, a little apart.
StabilityRow twin_points(double distance, int degree, const std::string& backend) {
    SceneText scene = study_scene(drd, degree, 12);
    const Solution free = solve_without_explaining(scene_of(scene), {});
    std::vector<Point> points;
    for (const double x : {0.37, 0.37 + distance}) points.push_back({x, free.curve->at(x).derivative[0]});
    set_points(scene, points);
    set_solver(scene, backend);
    Expectation expected = known_optimum(drd, degree, 12);
    // The pair fixes y' to rounding / distance: so well is the optimum of the scene as written known.
    expected.digits += 1e-15 / distance;
    expected.honest_gap = true;
    expected.may_give_up = backend != "structured";
    expected.source = "two points of the optimum itself: " + expected.source;
    return solved_row(scene, expected);
}

/// y(x) and y(x + d) = y + v d say y' = v, up to y'' d / 2 and rounding / d.
StabilityRow points_that_say_a_slope(double distance, const std::string& backend) {
    SceneText slope = study_scene(drd, 3, 12);
    set_points(slope, {{0.5, 0.5, 1.5}});
    Expectation expected =
        proved_optimum(slope, "an exact velocity in the place of the second point, proved");
    expected.accuracy = 1e-9 + 10.0 * distance + 1e-15 / distance;
    SceneText scene = study_scene(drd, 3, 12);
    set_points(scene, {{0.5, 0.5}, {0.5 + distance, 0.5 + 1.5 * distance}});
    set_solver(scene, backend);
    // Nearer than the tolerance of a displacement the two may count as one point: both are met to 1e-9 all
    // the same.
    if (distance < 1e-9) expected.least = study_objective(12.0 / 7, 36.0 / 7, 432.0 / 7);
    expected.may_give_up = backend != "structured";
    return solved_row(scene, expected);
}

double polynomial_345(double x) {
    return x * x * x * (10.0 + x * (-15.0 + 6.0 * x));
}

/// Three points leave a quintic of four segments no freedom; five more lie on the same polynomial, the last
/// one wrong by `error`.
StabilityRow more_points_than_freedom(double error, const std::string& backend) {
    SceneText scene = study_scene(drd, 5, 4);
    std::vector<Point> points;
    for (const double x : {0.25, 0.5, 0.75, 0.1, 0.33, 0.6, 0.9, 0.95})
        points.push_back({x, polynomial_345(x)});
    points.back().displacement += error;
    set_points(scene, points);
    set_solver(scene, backend);
    if (error > 1e-7) {
        Expectation contradiction;
        contradiction.verdicts = {Verdict::infeasible};
        contradiction.source = "eight points, three freedoms, one point off";
        return solved_row(scene, contradiction);
    }
    return solved_row(scene, exactly(study_objective(1.875, 10.0 / std::sqrt(3.0), 60.0),
                                     "the polynomial 3-4-5 is the only motion"));
}

}  // namespace

std::vector<StabilityCase> exact_point_cases() {
    std::vector<StabilityCase> cases;
    for (const char* backend : {"structured", "ipopt", "nlopt.slsqp"}) {
        const auto add = [&](const std::string& name, std::function<StabilityRow()> run) {
            cases.push_back(make_case("exact points", name, true, std::move(run)));
        };
        for (const double error : {0.0, 1e-15, 1e-12, 1e-9, 1e-6})
            add(fmt::format("y(1/2) = 1/2 + {} beside symmetry", error),
                [=] { return follows_from_symmetry(error, backend); });
        for (const int degree : {3, 5})
            for (const double distance : {1e-4, 1e-7, 1e-10})
                add(fmt::format("{}, two points of the optimum {} apart", degree == 3 ? "cubic" : "quintic",
                                distance),
                    [=] { return twin_points(distance, degree, backend); });
        for (const double distance : {1e-7, 1e-10})
            add(fmt::format("two points {} apart that say y' = 1.5", distance),
                [=] { return points_that_say_a_slope(distance, backend); });
        for (const double error : {0.0, 1e-12, 1e-6})
            add(fmt::format("quintic, eight points for three freedoms, one off by {}", error),
                [=] { return more_points_than_freedom(error, backend); });
    }
    return cases;
}

}  // namespace camopt::stability
