// SPDX-License-Identifier: MIT
#include "core/units.hpp"
#include "tests/soak/scenes/scene_numbers.hpp"
#include "tests/soak/stability/stability_cases.hpp"
#include "tests/soak/stability/stability_scenes.hpp"

#include <fmt/format.h>

#include <array>

namespace camopt::stability {

namespace {

constexpr MotionType drd = MotionType::drd;

/// [least, most] holds the edge between impossible and possible.
struct Edge {
    double least = 0.0, most = 0.0;
    std::string source;
};

/// What a limit `relative` beside its edge must lead to. Within the tolerance 1e-9 either answer keeps its
/// word.
Expectation at_edge(double relative, const std::string& source) {
    Expectation expected;
    expected.source = source;
    if (relative > 0.0)
        expected.verdicts = {Verdict::optimal, Verdict::local, Verdict::feasible};
    else if (relative <= -1e-7)
        expected.verdicts = {Verdict::infeasible};
    else
        expected.verdicts = {Verdict::optimal, Verdict::local, Verdict::feasible, Verdict::infeasible,
                             Verdict::failed};
    return expected;
}

double beside(const Edge& edge, double relative) {
    return (relative < 0.0 ? edge.least : edge.most) * (1.0 + relative);
}

/// The least peak alone: in closed form, else minimized and proved.
Edge least_peak(int order, int degree, int segments) {
    if (degree == 3 && order == 2) {
        const double least = 4.0 * segments / (segments - 2.0);
        return {least, least, "A >= 4n/(n − 2)"};
    }
    if (degree == 3 && order == 3) return {32.0, 32.0, "J >= 32"};
    SceneText scene = study_scene(drd, degree, segments);
    set_weights(scene, {});
    scene.at("objective").set(soak::peak_names[order], 1.0);
    set_reference(scene, {1.0, 1.0, 1.0});
    const Expectation optimum = proved_optimum(scene, "the least peak alone, proved");
    return {*optimum.least, *optimum.most, optimum.source};
}

StabilityRow capped(int order, int degree, double relative, const std::string& backend) {
    const Edge edge = least_peak(order, degree, 12);
    SceneText scene = study_scene(drd, degree, 12);
    scene.at("limits").set(soak::peak_names[order], beside(edge, relative));
    set_solver(scene, backend);
    return solved_row(scene, at_edge(relative, edge.source));
}

SceneText small_cam(int segments) {
    SceneText scene = study_scene(drd, 3, segments);
    scene.at("motion").set("lift_m", 20e-3);
    scene.at("motion").set("rise_rad", 60.0 * units::degree);
    scene.at("cam").set("type", soak::quoted("disk"));
    scene.at("cam").set("follower", soak::quoted("translating_roller"));
    scene.at("cam").set("roller_radius_m", 10e-3);
    scene.at("limits").set("pressure_angle_rad", 30.0 * units::degree);
    return scene;
}

/// The least base radius of a pressure angle of 30°, m.
SceneText smallest_cam(int segments) {
    SceneText scene = small_cam(segments);
    set_weights(scene, {});
    scene.at("objective").set("base_radius", 1.0);
    scene.at("cam").set("base_radius_m", "{ min = 1e-3, max = 0.2 }");
    return scene;
}

Edge least_base(int segments) {
    const Expectation optimum = proved_optimum(smallest_cam(segments), "the least base radius, proved");
    return {*optimum.least * 20e-3, *optimum.most * 20e-3, optimum.source};
}

StabilityRow base_radius(double relative, const std::string& backend) {
    const Edge edge = least_base(24);
    SceneText scene = small_cam(24);
    scene.at("cam").set("base_radius_m", beside(edge, relative));
    set_solver(scene, backend);
    return solved_row(scene, at_edge(relative, edge.source));
}

/// On the smallest cam for 30° the least pressure angle is 30°.
StabilityRow pressure_angle(double relative, const std::string& backend) {
    const Edge edge = least_base(24);
    SceneText scene = small_cam(24);
    // The edge of the angle moves with the base radius: take the end of the interval that keeps the claim
    // true.
    scene.at("cam").set("base_radius_m", relative < 0.0 ? edge.least : edge.most);
    scene.at("limits").set("pressure_angle_rad", 30.0 * units::degree * (1.0 + relative));
    set_solver(scene, backend);
    return solved_row(scene, at_edge(relative, "30° on the smallest cam for 30°"));
}

/// Least prime radii of C2 cubics, from independent linear programs.
StabilityRow smallest(int segments, double prime_mm) {
    Expectation expected = exactly((prime_mm - 10.0) / 20.0, "linear program, HiGHS");
    expected.digits = 1e-4 / prime_mm;
    expected.honest_gap = true;
    return solved_row(smallest_cam(segments), expected);
}

}  // namespace

std::vector<StabilityCase> limit_cases() {
    std::vector<StabilityCase> cases;
    const std::array<double, 9> steps = {1e-4, 1e-6, 1e-9, 0.0, -1e-9, -1e-8, -1e-7, -1e-6, -1e-4};
    for (const char* backend : {"structured", "ipopt", "nlopt.slsqp"}) {
        const bool own = std::string(backend) == "structured";
        for (const double step : steps) {
            for (const int degree : {3, 5})
                for (const int order : {1, 2, 3}) {
                    if (degree == 5 && !own) continue;
                    cases.push_back(make_case(
                        "limits",
                        fmt::format("{}, {} cap at the least possible {:+g}",
                                    degree == 3 ? "cubic" : "quintic", soak::peak_names[order], step),
                        own, [=] { return capped(order, degree, step, backend); }));
                }
            cases.push_back(make_case("limits", fmt::format("base radius at the least possible {:+g}", step),
                                      own, [=] { return base_radius(step, backend); }));
            cases.push_back(make_case("limits",
                                      fmt::format("pressure angle at the least possible {:+g}", step), own,
                                      [=] { return pressure_angle(step, backend); }));
        }
    }
    const std::pair<int, double> radii[] = {{24, 27.00587}, {48, 25.4783}, {96, 24.7645}, {192, 24.4192}};
    for (const auto& [segments, prime] : radii)
        cases.push_back(
            make_case("limits", fmt::format("least prime radius, n = {}", segments), segments <= 24,
                      [segments = segments, prime = prime] { return smallest(segments, prime); }));
    return cases;
}

}  // namespace camopt::stability
