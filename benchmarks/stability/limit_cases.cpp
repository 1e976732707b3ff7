// SPDX-License-Identifier: MIT
#include "benchmarks/stability/stability_cases.hpp"
#include "benchmarks/stability/stability_scenes.hpp"
#include "core/errors.hpp"
#include "core/units.hpp"
#include "profiles/disk/disk_cam.hpp"
#include "studies/search/planned_solve.hpp"

#include <fmt/format.h>

#include <array>
#include <map>
#include <memory>

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

enum class Peak { velocity, acceleration, jerk };
constexpr std::array<const char*, 3> peak_names = {"velocity", "acceleration", "jerk"};

PeakLimit cap(Peak peak, double value) {
    return {value, std::string("limits.") + peak_names[static_cast<int>(peak)], value, ""};
}

std::optional<PeakLimit>& limit_of(Scene& scene, Peak peak) {
    if (peak == Peak::velocity) return scene.limits.velocity;
    return peak == Peak::acceleration ? scene.limits.acceleration : scene.limits.jerk;
}

/// The least peak alone: in closed form, else minimized and proved.
Edge least_peak(Peak peak, int degree, int segments) {
    if (degree == 3 && peak == Peak::acceleration) {
        const double least = 4.0 * segments / (segments - 2.0);
        return {least, least, "A >= 4n/(n − 2)"};
    }
    if (degree == 3 && peak == Peak::jerk) return {32.0, 32.0, "J >= 32"};
    Scene scene = study_scene(drd, degree, segments);
    scene.objective.velocity = peak == Peak::velocity ? 1.0 : 0.0;
    scene.objective.acceleration = peak == Peak::acceleration ? 1.0 : 0.0;
    scene.objective.jerk = peak == Peak::jerk ? 1.0 : 0.0;
    scene.objective.reference = numeric_reference(1.0, 1.0, 1.0);
    const Expectation optimum = proved_optimum(scene, "the least peak alone, proved");
    return {*optimum.least, *optimum.most, optimum.source};
}

StabilityRow capped(Peak peak, int degree, double relative, const std::string& backend) {
    const Edge edge = least_peak(peak, degree, 12);
    Scene scene = study_scene(drd, degree, 12);
    limit_of(scene, peak) = cap(peak, beside(edge, relative));
    scene.solver.name = backend;
    return solved_row(scene, at_edge(relative, edge.source));
}

Scene small_cam(int segments) {
    Scene scene = study_scene(drd, 3, segments);
    scene.motion.lift = 20e-3;
    scene.motion.rise = 60.0 * units::degree;
    scene.cam = disk_spec({});
    scene.cam->set(DimensionIndex::roller_radius, 10e-3);
    scene.limits.pressure_angle =
        WrittenLimit{30.0 * units::degree, "limits.pressure_angle_deg", units::degree, "deg"};
    return scene;
}

/// The least base radius of a pressure angle of 30°, m.
Scene smallest_cam(int segments) {
    Scene scene = small_cam(segments);
    scene.objective.velocity = scene.objective.acceleration = scene.objective.jerk = 0.0;
    scene.objective.dimensions[static_cast<int>(DimensionIndex::base_radius)] = 1.0;
    scene.cam->set(DimensionIndex::base_radius, Dimension(1e-3, 0.2));
    return scene;
}

Edge least_base(int segments) {
    const Expectation optimum = proved_optimum(smallest_cam(segments), "the least base radius, proved");
    return {*optimum.least * 20e-3, *optimum.most * 20e-3, optimum.source};
}

StabilityRow base_radius(double relative, const std::string& backend) {
    const Edge edge = least_base(24);
    Scene scene = small_cam(24);
    scene.cam->set(DimensionIndex::base_radius, beside(edge, relative));
    scene.solver.name = backend;
    return solved_row(scene, at_edge(relative, edge.source));
}

/// On the smallest cam for 30° the least pressure angle is 30°.
StabilityRow pressure_angle(double relative, const std::string& backend) {
    const Edge edge = least_base(24);
    Scene scene = small_cam(24);
    // The edge of the angle moves with the base radius: take the end of the interval that keeps the claim
    // true.
    scene.cam->set(DimensionIndex::base_radius, relative < 0.0 ? edge.least : edge.most);
    scene.limits.pressure_angle->value = 30.0 * units::degree * (1.0 + relative);
    scene.solver.name = backend;
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
                for (const Peak peak : {Peak::velocity, Peak::acceleration, Peak::jerk}) {
                    if (degree == 5 && !own) continue;
                    cases.push_back(make_case("limits",
                                              fmt::format("{}, {} cap at the least possible {:+g}",
                                                          degree == 3 ? "cubic" : "quintic",
                                                          peak_names[static_cast<int>(peak)], step),
                                              own, [=] { return capped(peak, degree, step, backend); }));
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
