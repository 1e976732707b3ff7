// SPDX-License-Identifier: MIT
// mechanism_check SCENES: how closely the finished cams of the mechanisms move their outputs as designed,
// against the number of points that are exported, and what that costs.
//
// CSV on the standard output: scene, type, points a turn or section asked for, points in all, deviation of
// the output (m or rad), relative (as the check of that mechanism counts it), theta_deg of the largest
// deviation, seconds to make the points and to look up the design, seconds of the contact simulation. The
// motion is the scene's optimum from one start.
#include "benchmarks/parts/whole_output.hpp"
#include "core/units.hpp"
#include "input/loading/load_scene.hpp"
#include "input/scene_reader.hpp"
#include "report/csv/csv_line.hpp"
#include "studies/checked/checked_cam.hpp"
#include "studies/solve/solve.hpp"

#include <chrono>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

namespace camopt::benchmarks {

namespace {

Solution solved(const std::string& file) {
    const std::vector<std::string> one_start = {"solver.starts=1"};
    Scene scene = input::read_scene_file(file, known_names(), one_start);
    Solution solution = solve(scene);
    if (!solution.motion || !solution.cam) throw std::runtime_error(file + ": no cam was delivered");
    return solution;
}

void print_row(const std::string& name, const Solution& solution, int points) {
    const auto begin = std::chrono::steady_clock::now();
    const ForwardCheckReport report = checked_cam(solution, points);
    const double all = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    CsvLine line;
    line.words(name).words(solution.cam->cam.formulas->type()).count(points).count(report.points);
    line.number(report.deviation).number(report.relative);
    line.number(report.at * solution.scene.motion.unit_angle() / units::degree);
    line.number(all - report.seconds).number(report.seconds);
    std::fputs(line.finish().c_str(), stdout);
}

void print_table(const std::string& folder) {
    std::puts("scene,type,asked,points,deviation,relative,theta_deg,seconds_points,seconds");
    for (const char* name :
         {"tappet_75", "barrel_paper_cup", "ocrf_indexing", "cylinder_slide", "inverse_feeder"}) {
        const Solution solution = solved(folder + "/" + name + ".toml");
        for (const int points : {125, 250, 500, 1000, 2000, 4000, 8000}) print_row(name, solution, points);
    }
}

}  // namespace

}  // namespace camopt::benchmarks

int main(int count, char** arguments) {
    const camopt::benchmarks::WholeOutput output;
    try {
        if (count != 2) throw std::runtime_error("give the folder of the scenes");
        camopt::benchmarks::print_table(arguments[1]);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "mechanism_check: %s\n", error.what());
        return 1;
    }
}
