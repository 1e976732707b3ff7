// SPDX-License-Identifier: MIT
// Both sides of grooved and conjugate cams against positions of their rollers alone, and their quantities'
// partials against differences.
#include "profiles/disk/disk_cam.hpp"
#include "tests/profiles/test_turn.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace camopt {
namespace disk_sides_test {

using Eigen::Vector2d;
using namespace test;
using enum DimensionIndex;

double& at(DiskCam& cam, DimensionIndex which) {
    return cam.dimensions[static_cast<std::size_t>(which)];
}

/// A cam that can be built, in mm and degrees around those of the reference cams.
DiskCam random_cam(FollowerType follower, CamForm form, std::mt19937& random) {
    const auto between = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random()) / 4294967295.0;
    };
    DiskCam cam;
    cam.follower = follower;
    cam.rotation = random() % 2 == 0 ? Rotation::clockwise : Rotation::counterclockwise;
    at(cam, base_radius) = between(38e-3, 46e-3);
    at(cam, roller_radius) = between(6e-3, 9e-3);
    cam.form.type = form;
    if (form == CamForm::grooved) cam.form.groove_clearance = between(0.0, 0.4e-3);
    if (is_oscillating(follower)) {
        at(cam, center_distance) = between(95e-3, 105e-3);
        at(cam, arm_length) = between(78e-3, 84e-3);
        if (form == CamForm::conjugate) {
            cam.form.arm_angle = between(72.0, 85.0) * degree;
            cam.form.second_arm_length = between(75e-3, 90e-3);
        }
    } else {
        at(cam, offset) = between(-10e-3, 10e-3);
        if (form == CamForm::conjugate) {
            cam.form.roller_distance = between(118e-3, 130e-3);
            cam.form.second_offset = between(-8e-3, 8e-3);
        }
    }
    if (form == CamForm::conjugate) cam.form.second_roller_radius = between(5e-3, 8e-3);
    EXPECT_EQ(geometry_fault(cam, 0.0, is_oscillating(follower) ? 0.35 : 18e-3), "");
    return cam;
}

double swing_of(const DiskCam& cam) {
    return is_oscillating(cam.follower) ? 16.0 * degree : 14e-3;
}

/// The roller's centre in the frame that stands still, from the drawing of the mechanism: no profile formula.
Vector2d drawn_center(const DiskCam& cam, double s, int side) {
    const double prime = cam[base_radius] + cam[roller_radius];
    const bool second = side == 1 && cam.form.is_conjugate();
    if (!is_oscillating(cam.follower)) {
        const double height = std::sqrt(prime * prime - cam[offset] * cam[offset]) + s;
        if (!second) return {cam[offset], height};
        return {cam.form.second_offset.value_or(cam[offset]), height - cam.form.roller_distance};
    }
    const double a = cam[center_distance], l = cam[arm_length];
    const double arm = std::acos((a * a + l * l - prime * prime) / (2.0 * a * l)) + s;
    const Vector2d pivot(a, 0.0);
    if (!second) return pivot + Eigen::Rotation2Dd(-arm) * Vector2d(-l, 0.0);
    const double length = cam.form.second_arm_length.value_or(l);
    return pivot + Eigen::Rotation2Dd(cam.form.arm_angle - arm) * Vector2d(-length, 0.0);
}

/// Its path as the cam sees it.
Vector2d seen_center(const DiskCam& cam, double theta, int side) {
    static const TestTurn turn;
    const double wrapped = std::fmod(theta + full_turn, full_turn);
    const double s = swing_of(cam) * turn.at(wrapped, Side::right).derivative[0];
    return Eigen::Rotation2Dd(-sense_of(cam.rotation) * theta) * drawn_center(cam, s, side);
}

FollowerState state_at(const DiskCam& cam, double theta) {
    const MotionPoint point = TestTurn().at(theta, Side::right);
    return {swing_of(cam) * point.derivative[0], swing_of(cam) * point.derivative[1],
            swing_of(cam) * point.derivative[2]};
}

/// Room between a point and the nearest position of the roller's centre over the whole turn.
double nearest_center(const DiskCam& cam, const Vector2d& point, int side) {
    double best = 1e300, place = 0.0;
    for (int i = 0; i < 720; ++i) {
        const double theta = full_turn * i / 720;
        const double distance = (seen_center(cam, theta, side) - point).norm();
        if (distance < best) best = distance, place = theta;
    }
    double low = place - full_turn / 720, high = place + full_turn / 720;
    for (int i = 0; i < 80; ++i) {
        const double third = (high - low) / 3.0;
        const auto distance = [&](double theta) { return (seen_center(cam, theta, side) - point).norm(); };
        if (distance(low + third) < distance(high - third))
            high -= third;
        else
            low += third;
    }
    return std::min(best, (seen_center(cam, 0.5 * (low + high), side) - point).norm());
}

struct Kind {
    FollowerType follower;
    CamForm form;
};

class DiskSides : public ::testing::TestWithParam<Kind> {
 protected:
    template <class Body>
    void repeat(int times, const Body& body) const {
        std::mt19937 random(77U);
        for (int i = 0; i < times; ++i)
            body(random_cam(GetParam().follower, GetParam().form, random), random);
    }
};

TEST_P(DiskSides, BoundWhatTheRollersSweep) {
    repeat(4, [](const DiskCam& cam, std::mt19937&) {
        ASSERT_EQ(side_count(cam), 2);
        for (int side = 0; side < 2; ++side) {
            double sharpest = -1e300;
            for (const double theta : angles(1.3, 7.0)) {
                const ProfilePoint point = profile_point(cam, theta, state_at(cam, theta), side);
                sharpest = std::max(sharpest, -point.regularity);
                EXPECT_LT((point.pitch - seen_center(cam, theta, side)).norm(), 1e-13);
                EXPECT_NEAR((point.contact - point.pitch).norm(), surface_offset(cam, side), 1e-15);
                // Towards the roller, out of the material.
                EXPECT_NEAR(point.normal.dot(point.pitch - point.contact), surface_offset(cam, side), 1e-15);
                if (sharpest < -0.05) {
                    EXPECT_NEAR(nearest_center(cam, point.contact, side), surface_offset(cam, side), 1e-9)
                        << side << ' ' << theta;
                }
                if (cam.form.is_grooved()) {
                    EXPECT_EQ(point.contact.norm() < point.pitch.norm(), side == 0) << theta;
                }
            }
            EXPECT_LT(sharpest, -0.05) << "an undercut cam bounds nothing";
        }
    });
}

TEST_P(DiskSides, PressureAngleAndRadiusMatchPath) {
    repeat(4, [](const DiskCam& cam, std::mt19937&) {
        constexpr double step = 1e-4;
        for (int side = 0; side < 2; ++side)
            for (const double theta : angles(3.0, 11.0)) {
                if (std::abs(theta - 60 * degree) < 1e-2 || std::abs(theta - 160 * degree) < 1e-2 ||
                    std::abs(theta - 200 * degree) < 1e-2)
                    continue;
                const FollowerState state = state_at(cam, theta);
                const ProfilePoint point = profile_point(cam, theta, state, side);
                const Vector2d before = seen_center(cam, theta - step, side),
                               after = seen_center(cam, theta + step, side), here = point.pitch;
                const Vector2d along = (after - before) / (2.0 * step),
                               bend = (after - 2.0 * here + before) / (step * step);
                EXPECT_NEAR(point.normal.dot(along) / along.norm(), 0.0, 1e-7);
                // > 0: the path bends away from the normal.
                const double curvature = -bend.dot(point.normal) / along.squaredNorm();
                EXPECT_NEAR(point.pitch_curvature, curvature, 2e-4 * std::max(1.0, std::abs(curvature)));
                EXPECT_NEAR(point.regularity, 1.0 - surface_offset(cam, side) * point.pitch_curvature, 1e-13);
                EXPECT_NEAR(point.cam_radius, 1.0 / point.pitch_curvature - surface_offset(cam, side),
                            1e-9 * std::abs(point.cam_radius));
                // The path of the roller's centre as the follower moves by +s, against the normal.
                const Vector2d moved = drawn_center(cam, state.s + step * swing_of(cam), side) -
                                       drawn_center(cam, state.s - step * swing_of(cam), side);
                const Vector2d fixed_normal =
                    Eigen::Rotation2Dd(sense_of(cam.rotation) * theta) * point.normal;
                const double cosine = moved.normalized().dot(fixed_normal);
                EXPECT_NEAR(std::abs(cosine), std::cos(point.pressure_angle), 1e-7);
                // Side 0 pushes the follower up, side 1 pushes it down.
                EXPECT_GT((side == 0 ? 1.0 : -1.0) * cosine, 0.0);
            }
    });
}

constexpr MechanismQuantity side_quantities[] = {
    MechanismQuantity::pressure_numerator, MechanismQuantity::pressure_denominator,
    MechanismQuantity::pitch_curvature, MechanismQuantity::regularity, MechanismQuantity::normal_lever};

struct Situation {
    DiskCam cam;
    FollowerState state;
    double& variable(int index) {
        double* const states[] = {&state.s, &state.velocity, &state.acceleration};
        return index < 3 ? *states[index] : cam.dimensions[static_cast<std::size_t>(index - 3)];
    }
};

TEST_P(DiskSides, PartialsMatchDifferences) {
    const double step = 1e-6;
    repeat(12, [&](const DiskCam& given, std::mt19937& random) {
        DiskCam cam = given;
        if (random() % 2 == 0) cam.form.second_roller_radius.reset();  // follows the first
        const double size = swing_of(cam);
        const auto unit = [&] { return 2.0 * static_cast<double>(random()) / 4294967295.0 - 1.0; };
        const Situation here{cam, {size * (0.5 + 0.5 * unit()), 0.7 * size * unit(), size * unit()}};
        for (int side = 0; side < 2; ++side) {
            const ProfilePoint point = profile_point(cam, 0.4, here.state, side);
            for (const MechanismQuantity which : side_quantities) {
                const QuantityValue value = quantity(cam, here.state, which, side);
                if (which == MechanismQuantity::pitch_curvature) {
                    EXPECT_NEAR(value.value, point.pitch_curvature, 1e-10);
                }
                if (which == MechanismQuantity::regularity) {
                    EXPECT_NEAR(value.value, point.regularity, 1e-12);
                }
                const double most = std::max({std::abs(value.value), value.gradient.cwiseAbs().maxCoeff(),
                                              value.hessian.cwiseAbs().maxCoeff()});
                for (int i = 0; i < quantity_variables; ++i) {
                    if (i >= 3 && !has_dimension(cam.follower, static_cast<DimensionIndex>(i - 3))) continue;
                    Situation up = here, down = here;
                    up.variable(i) += step;
                    down.variable(i) -= step;
                    const QuantityValue above = quantity(up.cam, up.state, which, side),
                                        below = quantity(down.cam, down.state, which, side);
                    EXPECT_NEAR(value.gradient(i), (above.value - below.value) / (2 * step), 1e-6 * most)
                        << side << ' ' << static_cast<int>(which) << ' ' << i;
                    EXPECT_LT((value.hessian.col(i) - (above.gradient - below.gradient) / (2 * step))
                                  .cwiseAbs()
                                  .maxCoeff(),
                              1e-6 * most)
                        << side << ' ' << static_cast<int>(which) << ' ' << i;
                }
            }
        }
    });
}

TEST_P(DiskSides, AreTheStationsOfTheMechanism) {
    repeat(2, [](const DiskCam& cam, std::mt19937&) {
        const DrivenMechanism mechanism = disk_mechanism(cam);
        ASSERT_EQ(mechanism.formulas->stations(), 2);
        ASSERT_EQ(mechanism.dimensions.size(),
                  dimensions_of(cam.follower).size() + form_dimensions(cam.follower, cam.form).size());
        const FollowerState state = state_at(cam, 1.9);
        for (int side = 0; side < 2; ++side) {
            EXPECT_EQ(mechanism.formulas->station_name(side), side_name(cam.form, side));
            const MechanismPoint point = mechanism.formulas->point(1.9, {mechanism.dimensions, state}, side);
            EXPECT_EQ(point.contact.head<2>(), profile_point(cam, 1.9, state, side).contact);
        }
        EXPECT_EQ(disk_cam(mechanism)->form.type, cam.form.type);
    });
}

INSTANTIATE_TEST_SUITE_P(All, DiskSides,
                         ::testing::Values(Kind{FollowerType::translating_roller, CamForm::grooved},
                                           Kind{FollowerType::oscillating_roller, CamForm::grooved},
                                           Kind{FollowerType::translating_roller, CamForm::conjugate},
                                           Kind{FollowerType::oscillating_roller, CamForm::conjugate}),
                         [](const auto& which) {
                             return std::string(name_of(which.param.follower)) + "_" +
                                    name_of(which.param.form);
                         });

TEST(DiskSides, UnbuildableCamGivesReason) {
    std::mt19937 random(5U);
    DiskCam cam = random_cam(FollowerType::translating_roller, CamForm::conjugate, random);
    cam.form.roller_distance = 60e-3;
    EXPECT_NE(geometry_fault(cam, 0.0, 18e-3).find("the second roller would pass the cam centre"),
              std::string::npos);
    cam = random_cam(FollowerType::oscillating_roller, CamForm::conjugate, random);
    cam.form.arm_angle = 30.0 * degree;
    EXPECT_NE(geometry_fault(cam, 0.0, 0.3).find("the second roller would pass the line of centres"),
              std::string::npos);
    cam = random_cam(FollowerType::translating_roller, CamForm::grooved, random);
    cam.form.groove_clearance = 0.2;
    EXPECT_NE(geometry_fault(cam, 0.0, 18e-3).find("the groove's clearance"), std::string::npos);
}

DirectCamDrawing drawing_of(const DrivenMechanism& cam) {
    return cam.formulas->direct()->drawing(cam.dimensions);
}

TEST(DiskMechanism, NamesItsDimensionsInTheirOrder) {
    std::mt19937 random(6U);
    const DrivenMechanism cam =
        disk_mechanism(random_cam(FollowerType::oscillating_roller, CamForm::conjugate, random));
    const DirectCamDrawing drawing = drawing_of(cam);
    const std::vector<NamedDimension>& names = drawing.dimensions;
    ASSERT_EQ(names.size(), cam.dimensions.size());
    for (std::size_t i = 0; i < names.size(); ++i) EXPECT_EQ(names[i].value, cam.dimensions[i]) << i;
    const NamedDimension& base = names[static_cast<std::size_t>(cam.formulas->base_radius_index())];
    EXPECT_EQ(base.name, "base_radius");
    EXPECT_FALSE(base.of_form);
    EXPECT_EQ(names.back().name, "second_roller_radius");
    EXPECT_TRUE(names.back().of_form);
    for (const NamedDimension& one : names) EXPECT_EQ(one.is_angle, one.name == "arm_angle") << one.name;
    EXPECT_EQ(drawing.follower, "oscillating_roller");
    EXPECT_EQ(drawing.form, "conjugate");
}

TEST(DiskMechanism, OnlyConjugateCamsHavePieces) {
    std::mt19937 random(7U);
    for (const FollowerType follower : {FollowerType::translating_roller, FollowerType::oscillating_roller}) {
        const DiskCam disk = random_cam(follower, CamForm::conjugate, random);
        const DrivenMechanism cam = disk_mechanism(disk);
        const std::vector<DrivenMechanism> pieces = drawing_of(cam).pieces;
        ASSERT_EQ(pieces.size(), 2U);
        for (int side = 0; side < 2; ++side) {
            const DrivenMechanism& piece = pieces[static_cast<std::size_t>(side)];
            EXPECT_EQ(piece.formulas->stations(), 1);
            EXPECT_EQ(drawing_of(piece).form, "");
            EXPECT_EQ(piece.dimensions[static_cast<std::size_t>(piece.formulas->roller_radius())],
                      roller_radius_of(disk, side));
        }
        EXPECT_EQ(pieces.front().formulas->base_radius(pieces.front().dimensions), disk[base_radius]);
        const DrivenMechanism grooved = disk_mechanism(random_cam(follower, CamForm::grooved, random));
        EXPECT_TRUE(drawing_of(grooved).pieces.empty());
    }
}

TEST(DiskMechanism, OnlyGroovesHaveAWall) {
    std::mt19937 random(8U);
    DiskCam cam = random_cam(FollowerType::translating_roller, CamForm::grooved, random);
    const auto wall = [](const DiskCam& disk) { return drawing_of(disk_mechanism(disk)).groove_wall; };
    EXPECT_EQ(wall(cam), cam[roller_radius]);
    cam.form.groove_wall = 3e-3;
    EXPECT_EQ(wall(cam), 3e-3);
    EXPECT_FALSE(wall(random_cam(FollowerType::translating_roller, CamForm::open, random)));
    EXPECT_FALSE(wall(random_cam(FollowerType::translating_roller, CamForm::conjugate, random)));
}

TEST(DiskMechanism, ShapesShowArmPivot) {
    std::mt19937 random(9U);
    for (const FollowerType follower : {FollowerType::translating_roller, FollowerType::oscillating_roller}) {
        const DiskCam disk = random_cam(follower, CamForm::open, random);
        const DrivenMechanism cam = disk_mechanism(disk);
        int pivots = 0;
        for (const MechanismShape& shape : cam.formulas->plane()->shapes({cam.dimensions, {}, 0.0})) {
            if (shape.name != "arm_pivot") continue;
            ++pivots;
            EXPECT_EQ(shape.points.front(), Vector2d(disk[center_distance], 0.0));
        }
        EXPECT_EQ(pivots, cam.formulas->swings() ? 1 : 0);
    }
}

}  // namespace disk_sides_test
}  // namespace camopt
