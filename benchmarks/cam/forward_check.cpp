// SPDX-License-Identifier: MIT
// forward_check: how closely a follower on the exported points of a cam moves as designed, against their
// number.
//
// CSV on the standard output: follower, rotation, law, points, deviation (m or rad), relative (deviation at
// the contact by the prime radius), theta_deg of the largest deviation, angles checked, seconds. The turn:
// dwell to 60°, rise to 160°, dwell to 200°, fall to 360°; the cams are those of
// tests/studies/cam_samples.hpp (e = 8, prime radius 45, roller radius 10 mm; flat 60 mm; a = 100, l = 80
// mm).

#include "benchmarks/parts/whole_output.hpp"
#include "core/units.hpp"
#include "motions/laws/law_catalogue.hpp"
#include "profiles/disk/disk_cam.hpp"
#include "report/csv/csv_line.hpp"
#include "splines/motion_chain.hpp"
#include "studies/check/forward_check_input.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <memory>
#include <string>
#include <vector>

namespace camopt::benchmarks {

namespace {

using units::degree, units::millimetre;

struct Case {
    DiskCam cam;
    double lift = 0.0;  ///< m or rad
};

/// Dimensions by DimensionIndex, mm.
Case make_case(FollowerType follower, std::array<double, dimension_count> dimensions, double lift) {
    Case result{{follower, Rotation::counterclockwise, dimensions}, lift};
    for (double& dimension : result.cam.dimensions) dimension *= millimetre;
    return result;
}

std::vector<Case> cases() {
    const double prime = std::sqrt(100.0 * 100 + 80 * 80 - 2 * 100 * 80 * std::cos(32 * degree));
    const double flat = 100 * std::sin(22 * degree) - 4;
    return {make_case(FollowerType::translating_roller, {35, 10, 8, 0, 0, 0}, 25 * millimetre),
            make_case(FollowerType::translating_knife, {45, 0, 8, 0, 0, 0}, 25 * millimetre),
            make_case(FollowerType::translating_flat, {60, 0, 0, 0, 0, 0}, 14 * millimetre),
            make_case(FollowerType::oscillating_roller, {prime - 10, 10, 0, 100, 80, 0}, 22 * degree),
            make_case(FollowerType::oscillating_flat, {flat, 0, 0, 100, 0, 4}, 6 * degree)};
}

MotionChain turn_motion(const std::string& law) {
    const std::shared_ptr<const Motion> shape = make_law(law);
    return MotionChain({{0.0, 60 * degree, nullptr, 0.0, 1.0, 0.0, 1.0},
                        {60 * degree, 160 * degree, shape, 60 * degree, 100 * degree, 0.0, 1.0},
                        {160 * degree, 200 * degree, nullptr, 0.0, 1.0, 1.0, 1.0},
                        {200 * degree, 360 * degree, shape, 200 * degree, 160 * degree, 1.0, -1.0}});
}

void print_row(const Case& one, const std::string& law, int points) {
    const MotionChain motion = turn_motion(law);
    const ForwardCheckResult result =
        forward_check(forward_check_input(disk_mechanism(one.cam), motion, {one.lift, 1.0}, points));
    CsvLine line;
    line.words(name_of(one.cam.follower)).words(name_of(one.cam.rotation)).words(law).count(result.points);
    line.number(result.deviation).number(result.relative).number(result.theta / degree).count(result.angles);
    std::fputs(line.number(result.seconds).finish().c_str(), stdout);
}

void print_table() {
    std::puts("follower,rotation,law,points,deviation,relative,theta_deg,angles,seconds");
    for (const Case& one : cases())
        for (const Rotation rotation : {Rotation::counterclockwise, Rotation::clockwise}) {
            Case turned = one;
            turned.cam.rotation = rotation;
            for (const std::string law : {"polynomial_4567", "modified_sine"})
                for (const int points : {125, 250, 500, 1000, 2000, 4000, 8000})
                    print_row(turned, law, points);
        }
}

}  // namespace

}  // namespace camopt::benchmarks

int main() {
    const camopt::benchmarks::WholeOutput output;
    try {
        camopt::benchmarks::print_table();
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "forward_check: %s\n", error.what());
        return 1;
    }
}
