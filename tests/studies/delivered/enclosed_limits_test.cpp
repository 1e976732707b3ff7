// SPDX-License-Identifier: MIT
// Limits along all of a delivered motion: which are verified and which are not, and what passes a limit
// between the places that figures come from.
#include "studies/delivered/delivered_audit.hpp"
#include "studies/delivered/driven_mechanism.hpp"
#include "tests/support/solved_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace camopt {
namespace enclosed_limits_test {

using namespace testing_support;

using Keys = std::vector<std::string>;

const Solution& solved(const std::string& name) {
    return testing_support::solved(scene_named(name).with("solver.starts = 1"));
}

struct Wanted {
    const char* scene;
    Keys verified, unverified;
};

void PrintTo(const Wanted& wanted, std::ostream* stream) {
    *stream << wanted.scene;
}

class EnclosedLimits : public testing::TestWithParam<Wanted> {};

TEST_P(EnclosedLimits, AreNamedInTheCertificate) {
    const Solution& solution = solved(GetParam().scene);
    ASSERT_TRUE(solution.motion);
    EXPECT_EQ(solution.certificate.verified, GetParam().verified);
    EXPECT_EQ(solution.certificate.unverified, GetParam().unverified);
    for (const EnclosedLimit& limit : solution.cam->limits_along) {
        EXPECT_LE(limit.worst, figure_rounding) << limit.key;
        // A bound of what the samples of the solver saw: no larger than they say by more than the tolerance.
        EXPECT_LE(limit.worst, solution.certificate.worst_violation + 1e-8) << limit.key;
    }
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, EnclosedLimits,
    testing::Values(
        Wanted{"cam_forces",
               {"limits.pressure_angle_deg", "limits.cam_radius_min_mm", "limits.contact_force_min_n",
                "limits.torque_max_nm", "limits.hertz_pressure_max_mpa"},
               {}},
        Wanted{"cam_flat", {"limits.cam_radius_min_mm", "cam.face_half_width_mm"}, {}},
        Wanted{"cam_laws_and_splines", {"limits.pressure_angle_deg"}, {}},
        Wanted{"cam_grooved",
               {"limits.pressure_angle_deg", "limits.cam_radius_min_mm", "limits.hertz_pressure_max_mpa"},
               {}},
        Wanted{"inverse_feeder", {"limits.pressure_angle_deg", "limits.undercut_margin"}, {}},
        // Where along the roller a flank folds first depends: a few heights are looked at.
        Wanted{"cylinder_slide", {"limits.pressure_angle_deg"}, {"limits.undercut_margin"}}));

/// Between what the enclosures say and a dense sample there is no room.
TEST(EnclosedLimits, EqualMaximaOfDenseSample) {
    const Solution& solution = solved("cam_roller");
    ASSERT_TRUE(solution.cam);
    double most = 0.0;
    const Motion& motion = *solution.motion;
    for (int k = 0; k <= 20000; ++k) {
        const double x = motion.begin() + (motion.end() - motion.begin()) * k / 20000.0;
        const MotionPoint y = motion.at(x);
        const double lift = solution.scene.motion.lift, unit = solution.scene.motion.unit_angle();
        const auto& cam = *solution.scene.cam;
        const double prime =
            solution.cam->cam.dimensions[static_cast<std::size_t>(DimensionIndex::base_radius)] +
            cam.find(DimensionIndex::roller_radius)->middle();
        const double offset = cam.find(DimensionIndex::offset)->middle();
        const double height = std::sqrt(prime * prime - offset * offset) + lift * y.derivative[0];
        const double sense = cam.rotation == Rotation::clockwise ? -1.0 : 1.0;
        most = std::max(most, std::abs(std::atan((lift / unit * y.derivative[1] - sense * offset) / height)));
    }
    const double limit = solution.scene.limits.pressure_angle->value;
    EXPECT_NEAR(most, limit, 1e-6);  // it shapes the motion
    double worst = -1.0;
    for (const EnclosedLimit& found : solution.cam->limits_along)
        if (found.key == "limits.pressure_angle_deg") worst = std::max(worst, found.worst);
    EXPECT_GE(worst, -1e-6);
    EXPECT_LE(worst, figure_rounding);
}

TEST(EnclosedLimits, ViolationsBetweenSamplesFailVerdict) {
    Solution solution = solved("cam_knife");
    ASSERT_EQ(solution.certificate.verdict, Verdict::optimal);
    ASSERT_FALSE(solution.cam->limits_along.empty());
    solution.cam->limits_along.front().worst = 1e-5;
    audit_delivered(solution);
    EXPECT_EQ(solution.certificate.verdict, Verdict::failed);
    EXPECT_EQ(solution.certificate.reason, Reason::limit_not_kept);
    EXPECT_NE(solution.notes.back().find("limits.pressure_angle_deg is violated"), std::string::npos);
}

TEST(EnclosedLimits, OfSeveralRulesAreVerifiedTogether) {
    const std::vector<EnclosedLimit> limits = {
        {"limits.a_mm", 0.0, 0.0, true}, {"limits.a_mm", 0.0, 0.0, false}, {"cam.width", 0.0, 0.0, true}};
    EXPECT_FALSE(is_verified(limits, "limits.a_mm"));
    EXPECT_TRUE(is_verified(limits, "cam.width_mm"));
    EXPECT_FALSE(is_verified(limits, "limits.unknown"));
}

}  // namespace enclosed_limits_test
}  // namespace camopt
