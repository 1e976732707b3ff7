// SPDX-License-Identifier: MIT
// That the follower reaches the cam at rest is a row on the dimensions: exactly where their ranges do not
// keep it anyhow, and kept exactly by cams that can be built.
#include "core/units.hpp"
#include "objectives/grid/cam_problem.hpp"
#include "objectives/rules/cam_limits.hpp"
#include "objectives/scene_model.hpp"
#include "profiles/disk/disk_cam.hpp"
#include "tests/support/middle_cam.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

namespace camopt {
namespace cam_reach_test {

using enum DimensionIndex;

constexpr std::array followers = {FollowerType::translating_roller, FollowerType::translating_knife,
                                  FollowerType::translating_flat, FollowerType::oscillating_roller,
                                  FollowerType::oscillating_flat};

Scene scene_of(FollowerType follower) {
    Scene scene;
    scene.motion.lift_is_angle = is_oscillating(follower);
    scene.motion.lift = is_oscillating(follower) ? 15.0 * units::degree : 20e-3;
    scene.motion.rise = 90.0 * units::degree;
    scene.spline.segments = 3;
    scene.objective.velocity = 1.0;
    scene.cam = disk_spec({.follower = follower});
    return scene;
}

CamModel model_of(const Scene& scene) {
    return scene_model(scene, DesignKind::coefficients, reference_peaks(scene));
}

/// The dimensions that are numbers, and these.
DiskCam cam_of(const Scene& scene, const std::array<double, dimension_count>& values) {
    DiskCam cam = middle_cam(disk_of(*scene.cam));
    for (int d = 0; d < dimension_count; ++d) {
        const Dimension* const own = scene.cam->find(static_cast<DimensionIndex>(d));
        if (own != nullptr && own->is_variable()) cam.dimensions[static_cast<std::size_t>(d)] = values[d];
    }
    return cam;
}

bool keeps_rows(const CamModel& model, const DiskCam& cam) {
    Eigen::VectorXd parameters = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(model.parameters.size()));
    for (const CamVariables::Variable& variable : model.cam->variables)
        parameters[variable.parameter] =
            disk_mechanism(cam).dimensions[static_cast<std::size_t>(variable.dimension)] / variable.reference;
    return std::ranges::all_of(model.parameter_rows, [&](const ParameterRow& row) {
        double sum = 0.0;
        for (std::size_t i = 0; i < row.parameters.size(); ++i)
            sum += row.weights[i] * parameters[row.parameters[i]];
        return !row.limit || sum <= row.upper;
    });
}

class Random {
 public:
    explicit Random(unsigned seed) : engine_(seed) {}
    double between(double low, double high) {
        return low + (high - low) * static_cast<double>(engine_()) / 4294967295.0;
    }

 private:
    std::mt19937 engine_;
};

/// Every dimension a range from 1 (or −50 with a sign) to 50 mm, or, one in three, a number.
Scene random_scene(FollowerType follower, Random& random) {
    Scene scene = scene_of(follower);
    for (int d = 0; d < dimension_count; ++d) {
        const auto which = static_cast<DimensionIndex>(d);
        if (!has_dimension(follower, which)) continue;
        const double least = which == offset || which == face_offset ? -50e-3 : 1e-3;
        const double one = random.between(least, 50e-3), other = random.between(least, 50e-3);
        scene.cam->set(which, random.between(0.0, 3.0) < 1.0
                                  ? Dimension(one)
                                  : Dimension(std::min(one, other), std::max(one, other)));
    }
    return scene;
}

TEST(CamReach, AddsRowForFreeDimensions) {
    Random random(1);
    for (const FollowerType follower : followers) {
        int unbuildable = 0, different = 0;
        for (int k = 0; k < 40; ++k) {
            const Scene scene = random_scene(follower, random);
            // Where no cam can be built at all the scene is refused.
            if (find_fault(scene)) continue;
            const CamModel model = model_of(scene);
            for (int draw = 0; draw < 50; ++draw) {
                std::array<double, dimension_count> values{};
                for (int d = 0; d < dimension_count; ++d) {
                    const Dimension* const own = scene.cam->find(static_cast<DimensionIndex>(d));
                    const Dimension dimension = own != nullptr ? *own : Dimension();
                    values[static_cast<std::size_t>(d)] = random.between(dimension.low, dimension.high);
                }
                const DiskCam cam = cam_of(scene, values);
                const bool buildable = geometry_fault(cam, 0.0, 0.0).empty();
                if (!buildable) ++unbuildable;
                if (keeps_rows(model, cam) != buildable) ++different;
            }
        }
        if (follower != FollowerType::translating_flat) {
            EXPECT_GT(unbuildable, 100) << name_of(follower);
        }
        EXPECT_EQ(different, 0) << name_of(follower);
    }
}

/// An arm of 80 mm, 100 mm from the cam: a prime radius between 20 and 180 mm is reached.
Scene arm(const Dimension& base) {
    Scene scene = scene_of(FollowerType::oscillating_roller);
    scene.cam->set(center_distance, 100e-3);
    scene.cam->set(arm_length, 80e-3);
    scene.cam->set(roller_radius, 10e-3);
    scene.cam->set(base_radius, base);
    return scene;
}

TEST(CamReach, AddsNoRowWhenRangesSuffice) {
    EXPECT_TRUE(model_of(arm(Dimension(20e-3))).parameter_rows.empty());
    EXPECT_TRUE(model_of(arm(Dimension(11e-3, 169e-3))).parameter_rows.empty());
    EXPECT_EQ(model_of(arm(Dimension(9e-3, 169e-3))).parameter_rows.size(), 1u);
    EXPECT_EQ(model_of(arm(Dimension(11e-3, 171e-3))).parameter_rows.size(), 1u);
    EXPECT_EQ(model_of(arm(Dimension(9e-3, 171e-3))).parameter_rows.size(), 2u);
    const ParameterRow row = model_of(arm(Dimension(9e-3, 169e-3))).parameter_rows.front();
    EXPECT_EQ(row.name, "cam.base_radius");
    EXPECT_TRUE(row.limit);
    ASSERT_EQ(row.parameters.size(), 1u);
}

/// The row stands among what is violated, and names how far: by the longest dimension.
TEST(CamReach, UnbuildableCamViolatesIt) {
    const CamProblem problem(model_of(arm(Dimension(5e-3, 25e-3))));
    Eigen::VectorXd x = problem.start();
    const Eigen::Index base = x.size() - 1;
    const auto row = static_cast<int>(problem.model().rules.size());
    const auto amount = [&](double base_radius) {
        x[base] = base_radius / 25e-3;
        for (const Violation& violation : problem.violations(x, 1.0))
            if (violation.rule == row) return violation.amount;
        return -infinity;
    };
    EXPECT_NEAR(amount(5e-3), 0.05, 1e-5);
    EXPECT_NEAR(amount(20e-3), -0.10, 1e-5);
}

}  // namespace cam_reach_test
}  // namespace camopt
