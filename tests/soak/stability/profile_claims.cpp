// SPDX-License-Identifier: MIT
#include "core/text/parsing.hpp"
#include "core/units.hpp"
#include "motions/laws/law_catalogue.hpp"
#include "profiles/disk/disk_cam.hpp"
#include "report/cam/cam_files.hpp"
#include "report/drawing/profile_shape.hpp"
#include "studies/check/forward_check_input.hpp"
#include "studies/solve/solve.hpp"
#include "tests/soak/stability/stability_cases.hpp"
#include "tests/soak/stability/stability_scenes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace camopt::stability {

namespace {

using units::degree, units::millimetre;

/// benchmarks/README.md: a turn with a dwell, a rise, a dwell and a fall on a roller with offset.
StabilityRow law_on_points(const std::string& law, int points, double claimed) {
    const std::shared_ptr<const Motion> shape = make_law(law);
    const MotionChain motion({{0.0, 60 * degree, nullptr, 0.0, 1.0, 0.0, 1.0},
                              {60 * degree, 160 * degree, shape, 60 * degree, 100 * degree, 0.0, 1.0},
                              {160 * degree, 200 * degree, nullptr, 0.0, 1.0, 1.0, 1.0},
                              {200 * degree, 360 * degree, shape, 200 * degree, 160 * degree, 1.0, -1.0}});
    double worst = 0.0;
    for (const Rotation rotation : {Rotation::counterclockwise, Rotation::clockwise}) {
        DiskCam cam{FollowerType::translating_roller, rotation, {35e-3, 10e-3, 8e-3, 0, 0, 0}};
        const auto input = forward_check_input(disk_mechanism(cam), motion, {25 * millimetre, 1.0}, points);
        worst = std::max(worst, forward_check(input).relative);
    }
    return figure_row("deviation / prime radius", worst, at_most(claimed, "benchmarks/README.md"));
}

Solution solved(const std::string& file) {
    return solve(scene_of_file(file));
}

StabilityRow deviation_of(const std::string& file, const Expectation& expected, bool limited) {
    Scene scene = scene_of_file(file);
    if (!limited) scene.limits = {};
    const Solution solution = solve(scene);
    const MotionScale scale{scene.motion.lift, scene.motion.unit_angle()};
    const auto input = forward_check_input(solution.cam.value().cam, *solution.motion, scale, 2000);
    return figure_row("deviation, mm", forward_check(input).deviation / millimetre, expected);
}

/// Points of profile.csv as its reader sees them, against the cam between them.
StabilityRow polyline_of(const std::string& file) {
    const Solution solution = solved(file);
    const Scene& scene = solution.scene;
    const ProfileShape shape = profile_shape(solution.cam.value().cam, *solution.motion,
                                             {scene.motion.lift, scene.motion.unit_angle()});
    std::istringstream lines(cam_files(solution).front().text);
    std::string line;
    std::getline(lines, line);
    double worst = 0.0;
    double before_theta = 0.0;
    Eigen::Vector2d before = Eigen::Vector2d::Zero();
    for (bool first = true; std::getline(lines, line); first = false) {
        std::vector<double> cells;
        std::istringstream words(line);
        for (std::string cell; std::getline(words, cell, ',');)
            cells.push_back(cell.empty() ? 0.0 : required_number(cell));
        const double theta = cells[0] * degree;
        const Eigen::Vector2d here = Eigen::Vector2d(cells[4], cells[5]) * millimetre;
        const Eigen::Vector2d chord = here - before;
        if (!first && theta > before_theta && theta <= shape.end() && chord.norm() > 0.0) {
            for (const double part : {0.25, 0.5, 0.75}) {
                const Eigen::Vector2d away =
                    in_plane(shape.at(before_theta + part * (theta - before_theta)).contact) - before;
                worst = std::max(worst, std::abs(chord.x() * away.y() - chord.y() * away.x()) / chord.norm());
            }
        }
        before = here;
        before_theta = theta;
    }
    return figure_row("chord error, µm", worst * 1e6, at_most(1.0, "docs/results.md: within 1 µm"));
}

/// benchmarks/README.md: the part of a peak that equally spaced samples miss, in per cent.
StabilityRow sampled(const Motion& motion, int order, double exact, double claimed) {
    constexpr int samples = 180;
    double peak = 0.0;
    for (int k = 0; k <= samples; ++k) {
        const double x = motion.begin() + (motion.end() - motion.begin()) * k / samples;
        peak = std::max(peak, std::abs(motion.at(x).derivative[order]));
    }
    Expectation expected = exactly(claimed, "benchmarks/README.md", 0.0);
    expected.digits = 0.5001 * 0.01 / claimed;
    return figure_row("lost by 180 samples, %", 100.0 * (1.0 - peak / exact), expected);
}

StabilityRow sampled_quintic() {
    SceneText scene = study_scene(MotionType::drd, 5, 12);
    set_tie_break(scene, TieBreak::none);
    const Solution solution = solve(scene_of(scene));
    return sampled(*solution.curve, 3, solution.peaks.jerk.value, 0.08);
}

StabilityRow sampled_law() {
    const auto law = make_law("mcv_50");
    return sampled(*law, 2, law->peaks().acceleration.value, 0.06);
}

}  // namespace

std::vector<StabilityCase> profile_claims() {
    std::vector<StabilityCase> cases;
    const auto add = [&](const std::string& name, bool quick, std::function<StabilityRow()> run) {
        cases.push_back(make_case("claims", name, quick, std::move(run)));
    };
    add("polynomial 4-5-6-7 on 500 points", true,
        [] { return law_on_points("polynomial_4567", 500, 1e-10); });
    add("polynomial 4-5-6-7 on 2000 points", true,
        [] { return law_on_points("polynomial_4567", 2000, 7e-15); });
    add("modified sine on 500 points", true, [] { return law_on_points("modified_sine", 500, 1.5e-10); });
    add("modified sine on 2000 points", true, [] { return law_on_points("modified_sine", 2000, 1.3e-14); });
    add("cam_roller.toml: forward check", false, [] {
        return deviation_of("cam_roller.toml", at_most(1e-11, "docs/cams.md: something like 1e-12 mm"), true);
    });
    add("cam_undercut.toml without its limit: forward check", false, [] {
        Expectation expected = exactly(0.45, "docs/cams.md", 0.0);
        expected.digits = 0.0051 / 0.45;
        return deviation_of("cam_undercut.toml", expected, false);
    });
    for (const char* file : {"cam_roller.toml", "cam_flat.toml", "cam_arm_roller.toml"})
        add(fmt::format("{}: points of profile.csv", file), false, [file] { return polyline_of(file); });
    add("jerk of a quintic of 12 segments by samples", true, sampled_quintic);
    add("acceleration of MCV50 by samples", true, sampled_law);
    return cases;
}

}  // namespace camopt::stability
