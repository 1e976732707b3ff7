// SPDX-License-Identifier: MIT
// Random, seeded situations of every kind of spatial cam, turning either way.
#pragma once

#include "reference_cams.hpp"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

namespace camopt::test {

struct Case {
    SpatialFollower follower;
    Rotation rotation;
};

inline std::vector<Case> every_case() {
    std::vector<Case> cases;
    for (const SpatialFollower follower : {SpatialFollower::barrel, SpatialFollower::cylindrical_rotating,
                                           SpatialFollower::cylindrical_translating})
        for (const Rotation rotation : {Rotation::counterclockwise, Rotation::clockwise})
            cases.push_back({follower, rotation});
    return cases;
}
inline std::string case_name(const ::testing::TestParamInfo<Case>& information) {
    return std::string(name_of(information.param.follower)) + "_" + name_of(information.param.rotation);
}

/// One cam in one state of a lively motion, and a station.
struct Situation {
    SpatialCam cam;
    double theta = 0.0;
    FollowerState state;
    RollerStation station;

    /// By the index of the partials.
    [[nodiscard]] double& variable(int index) {
        double* const states[] = {&state.s, &state.velocity, &state.acceleration};
        return index < 3 ? *states[index] : cam.dimensions[static_cast<std::size_t>(index - 3)];
    }
};

/// Sizes like those of the reference cams, with every offset at work.
template <class Body>
void repeat(const Case& which, const Body& body) {
    std::mt19937 generator(20240913U);
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution(low, high)(generator);
    };
    for (int i = 0; i < 40; ++i) {
        Situation at;
        at.cam.follower = which.follower;
        at.cam.rotation = which.rotation;
        const bool swings = which.follower != SpatialFollower::cylindrical_translating;
        const bool barrel = which.follower == SpatialFollower::barrel;
        const double arm = between(0.06, 0.08);
        at.cam.dimensions = {between(0.005, 0.02), arm, between(0.14, 0.16),
                             barrel ? arm + between(-0.01, 0.01) : between(-0.015, 0.015)};
        at.cam.axial_offset = between(-0.02, 0.02);
        at.cam.start = swings ? -0.4 : 0.01;
        at.cam.roller_length = 0.03;
        const double size = swings ? 0.6 : 0.05;
        at.state = {between(0.0, size), between(-size, size), between(-2.0 * size, 2.0 * size)};
        at.station = {between(0.0, at.cam.roller_length), i % 2 == 0 ? 1 : -1};
        at.theta = between(0.0, full_turn);
        body(at);
    }
}

}  // namespace camopt::test
