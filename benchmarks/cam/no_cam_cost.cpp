// SPDX-License-Identifier: MIT
// no_cam_cost: what a cam costs a scene that does not need one.
//
// Each scene is solved as it stands, and with a cam so large that its limits do not bite, in turns, in one
// run. CSV on the standard output: scene, medians of the processor seconds of solve() without and with the
// cam, median and quartiles of their ratio, ratio of the least wall seconds of the solve alone (no figures of
// the cam), pairs, profile points evaluated without and with it. Ends with code 1 if a scene without a cam
// evaluated one profile point, or the two optima differ.
#include "benchmarks/parts/combination.hpp"
#include "benchmarks/parts/measurement.hpp"
#include "benchmarks/parts/whole_output.hpp"
#include "core/units.hpp"
#include "profiles/disk/disk_cam.hpp"
#include "report/csv/csv_line.hpp"
#include "studies/solve/solve.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <exception>
#include <string>
#include <vector>

namespace camopt::benchmarks {

namespace {

constexpr int pairs = 40;
constexpr double agreement = 1e-7;  // relative, of the two optima: the gap asked for

struct Plain {
    std::string name;
    Combination combination;
};

std::vector<Plain> plain_scenes() {
    using enum MotionType;
    return {{"drd_cubic_12", {"structured", 3, drd, DesignKind::states, 12}},
            {"drd_cubic_64", {"structured", 3, drd, DesignKind::states, 64}},
            {"rr_cubic_24", {"structured", 3, rr, DesignKind::states, 24}},
            {"drd_quintic_12", {"structured", 5, drd, DesignKind::states, 12}}};
}

/// A cam of 1 m under a lift of 1 mm: a pressure angle of 80° is far away.
Scene with_idle_cam(Scene scene) {
    scene.cam = disk_spec({});
    scene.cam->set(DimensionIndex::base_radius, 1.0);
    scene.cam->set(DimensionIndex::roller_radius, 10 * units::millimetre);
    scene.limits.pressure_angle =
        WrittenLimit{80 * units::degree, "limits.pressure_angle_deg", units::degree, "deg"};
    return scene;
}

struct Sample {
    double seconds, solve_seconds, objective;
    long profile_points;
};

Sample sample(const Scene& scene) {
    // Processor time: others on the machine do not count in it.
    const std::clock_t begin = std::clock();
    const Solution solution = solve(scene);
    const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    return {seconds, solution.seconds_solve, solution.certificate.objective,
            solution.evaluations.profile_points};
}

double quantile(std::vector<double> values, double fraction) {
    std::ranges::sort(values);
    return values[static_cast<std::size_t>(fraction * static_cast<double>(values.size() - 1) + 0.5)];
}

/// No profile without a cam, one with it, and the same optimum.
bool keeps_promise(const Plain& plain, const Sample& without, const Sample& with) {
    const bool same = std::abs(without.objective - with.objective) <= agreement * without.objective;
    if (without.profile_points == 0 && with.profile_points > 0 && same) return true;
    std::fprintf(stderr, "no_cam_cost: %s: %ld and %ld profile points, optima %.10g and %.10g\n",
                 plain.name.c_str(), without.profile_points, with.profile_points, without.objective,
                 with.objective);
    return false;
}

bool print_row(const Plain& plain) {
    const Scene without = scene_of(plain.combination, 60.0), with = with_idle_cam(without);
    std::vector<double> seconds_without, seconds_with, ratios;
    double least_without = infinity, least_with = infinity;
    Sample first{}, second{};
    for (int i = 0; i < pairs; ++i) {
        if (i % 2 == 0) {
            first = sample(without);
            second = sample(with);
        } else {
            second = sample(with);
            first = sample(without);
        }
        seconds_without.push_back(first.seconds);
        seconds_with.push_back(second.seconds);
        ratios.push_back(second.seconds / first.seconds);
        least_without = std::min(least_without, first.solve_seconds);
        least_with = std::min(least_with, second.solve_seconds);
    }
    CsvLine line;
    line.words(plain.name).number(median(seconds_without)).number(median(seconds_with));
    line.number(median(ratios)).number(quantile(ratios, 0.25)).number(quantile(ratios, 0.75));
    line.number(least_with / least_without).count(pairs);
    line.count(first.profile_points).count(second.profile_points);
    std::fputs(line.finish().c_str(), stdout);
    return keeps_promise(plain, first, second);
}

bool print_table() {
    std::puts(
        "scene,seconds_without,seconds_with,ratio_median,ratio_lower_quartile,ratio_upper_quartile,ratio_of_"
        "solve,pairs,"
        "profile_points_without,profile_points_with");
    bool kept = true;
    for (const Plain& plain : plain_scenes()) kept = print_row(plain) && kept;
    return kept;
}

}  // namespace

}  // namespace camopt::benchmarks

int main() {
    const camopt::benchmarks::WholeOutput output;
    try {
        return camopt::benchmarks::print_table() ? 0 : 1;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "no_cam_cost: %s\n", error.what());
        return 1;
    }
}
