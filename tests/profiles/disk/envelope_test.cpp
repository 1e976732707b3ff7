// SPDX-License-Identifier: MIT
// The cam as what the follower leaves standing: follower positions alone, rotated into the cam frame over the
// whole turn, bound it. Nothing here uses a derivative of the motion or a formula of profiles/.
#include "tests/profiles/test_turn.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>

namespace camopt {
namespace envelope_test {

using Eigen::Vector2d;
using namespace test;
using enum DimensionIndex;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Where `function` turns from negative to positive.
double root_between(const std::function<double(double)>& function, double low, double high) {
    for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (low + high);
        (function(middle) < 0.0 ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

/// The follower in the frame that stands still, by its displacement.
class Follower {
 public:
    explicit Follower(const DiskCam& cam) : cam_(cam) {
        const double radius = cam[base_radius] + roller();
        if (has_flat_face(cam.follower))
            rest_ = root_between([&](double p) { return face_distance(p) - radius; }, -1.5, 1.5);
        else
            rest_ = root_between([&](double p) { return center_at(p).norm() - radius; }, 0.0, 3.0);
    }

    [[nodiscard]] double roller() const { return has_roller(cam_.follower) ? cam_[roller_radius] : 0.0; }
    [[nodiscard]] Vector2d center(double s) const { return center_at(rest_ + s); }
    /// Normal of the face, away from the cam, and its distance from the cam centre.
    [[nodiscard]] Vector2d face_normal(double s) const {
        if (!is_oscillating(cam_.follower)) return Vector2d::UnitY();
        return {std::sin(rest_ + s), std::cos(rest_ + s)};
    }
    [[nodiscard]] double face_distance_at(double s) const { return face_distance(rest_ + s); }

 private:
    [[nodiscard]] Vector2d center_at(double position) const {
        if (!is_oscillating(cam_.follower)) return {cam_[offset], position};
        // From the pivot towards the cam centre, raised by the angle: clockwise seen from above.
        const Vector2d arm = Eigen::Rotation2Dd(-position) * Vector2d(-cam_[arm_length], 0.0);
        return Vector2d(cam_[center_distance], 0.0) + arm;
    }
    [[nodiscard]] double face_distance(double position) const {
        if (!is_oscillating(cam_.follower)) return position;
        const Vector2d normal(std::sin(position), std::cos(position));
        return Vector2d(cam_[center_distance], 0.0).dot(normal) - cam_[face_offset];
    }

    const DiskCam& cam_;
    double rest_ = 0.0;
};

/// The boundary of the cam as the nearest follower position along a ray, and distances to the positions.
class Envelope {
 public:
    explicit Envelope(const TestCam& cam) : cam_(cam), follower_(cam.cam) {}

    /// Distance of the cam's boundary from its centre in a direction of the cam frame.
    [[nodiscard]] double boundary(const Vector2d& direction) const {
        return least([&](double theta) { return hit(direction, theta); });
    }
    /// Room between a point of the cam frame and the follower, least over the turn: < 0 inside the follower.
    [[nodiscard]] double clearance(const Vector2d& point) const {
        return least([&](double theta) { return room(point, theta); });
    }
    [[nodiscard]] double room(const Vector2d& point, double theta) const {
        const double s = displacement(theta);
        if (has_flat_face(cam_.cam.follower))
            return follower_.face_distance_at(s) - seen(follower_.face_normal(s), theta).dot(point);
        return (seen(follower_.center(s), theta) - point).norm() - follower_.roller();
    }

 private:
    [[nodiscard]] double displacement(double theta) const {
        return cam_.lift * turn_.at(theta, Side::right).derivative[0];
    }
    [[nodiscard]] Vector2d seen(const Vector2d& fixed, double theta) const {
        const double sense = cam_.cam.rotation == Rotation::clockwise ? -1.0 : 1.0;
        return Eigen::Rotation2Dd(-sense * theta) * fixed;
    }
    [[nodiscard]] double hit(const Vector2d& direction, double theta) const {
        const double s = displacement(theta);
        if (has_flat_face(cam_.cam.follower)) {
            const double slope = seen(follower_.face_normal(s), theta).dot(direction);
            return slope > 0.0 ? follower_.face_distance_at(s) / slope : infinity;
        }
        const Vector2d center = seen(follower_.center(s), theta);
        const double along = center.dot(direction);
        const double beside = center.x() * direction.y() - center.y() * direction.x();
        const double half_chord_squared = std::pow(follower_.roller(), 2) - beside * beside;
        return along > 0.0 && half_chord_squared >= 0.0 ? along - std::sqrt(half_chord_squared) : infinity;
    }
    /// The least value over the turn: each valley of a grid of half degrees, by golden section.
    template <class Function>
    [[nodiscard]] static double least(const Function& function) {
        constexpr int steps = 720;
        const auto at = [&](int i) { return function(full_turn * ((i + steps) % steps) / steps); };
        double best = infinity;
        for (int i = 0; i < steps; ++i) {
            const double here = at(i);
            if (here == infinity || here > at(i - 1) || here > at(i + 1)) continue;
            best = std::min(best, valley(function, full_turn * (i - 1) / steps, full_turn * (i + 1) / steps));
        }
        return best;
    }
    template <class Function>
    [[nodiscard]] static double valley(const Function& function, double low, double high) {
        const auto wrapped = [&](double theta) {
            return function(theta < 0.0 ? theta + full_turn : theta > full_turn ? theta - full_turn : theta);
        };
        const double ratio = 0.5 * (std::sqrt(5.0) - 1.0);
        for (int i = 0; i < 45; ++i) {
            const double left = high - ratio * (high - low), right = low + ratio * (high - low);
            (wrapped(left) < wrapped(right) ? high : low) = wrapped(left) < wrapped(right) ? right : left;
        }
        return wrapped(0.5 * (low + high));
    }

    TestTurn turn_;
    TestCam cam_;
    Follower follower_;
};

class EnvelopeOf : public ::testing::TestWithParam<TestCam> {};

TEST_P(EnvelopeOf, ContactPointsTouchWithoutPenetration) {
    const TestTurn turn;
    const Envelope envelope(GetParam());
    for (const double theta : angles(1.25, 5.0)) {
        const ProfilePoint point = GetParam().at(theta, turn);
        ASSERT_GT(point.regularity, 0.0);
        EXPECT_NEAR(envelope.room(point.contact, theta), 0.0, 1e-16) << theta / degree;
        EXPECT_NEAR(envelope.clearance(point.contact), 0.0, 1e-15) << theta / degree;
    }
}

TEST_P(EnvelopeOf, ContactPointsLieOnTheBoundary) {
    const TestTurn turn;
    const Envelope envelope(GetParam());
    for (const double theta : angles(1.25, 5.0)) {
        const Vector2d contact = GetParam().at(theta, turn).contact;
        EXPECT_NEAR(envelope.boundary(contact.normalized()), contact.norm(), 1e-15) << theta / degree;
    }
}

class PitchCurveOf : public EnvelopeOf {};

TEST_P(PitchCurveOf, IsRollerOrEdgePath) {
    const TestTurn turn;
    const Envelope envelope(GetParam());
    const double radius = has_roller(GetParam().cam.follower) ? GetParam().cam[roller_radius] : 0.0;
    for (const double theta : angles(1.25, 5.0)) {
        const ProfilePoint point = GetParam().at(theta, turn);
        EXPECT_NEAR(envelope.room(point.pitch, theta), -radius, 1e-15);
        EXPECT_LT((point.pitch - radius * point.normal - point.contact).norm(), 1e-16);
    }
}

// A knife edge leaves a path and no envelope, a face no pitch curve.
INSTANTIATE_TEST_SUITE_P(All, EnvelopeOf, ::testing::ValuesIn(regular_cams([](FollowerType follower) {
                             return follower != FollowerType::translating_knife;
                         })),
                         [](const auto& item) { return item.param.name; });
INSTANTIATE_TEST_SUITE_P(All, PitchCurveOf, ::testing::ValuesIn(regular_cams([](FollowerType follower) {
                             return !has_flat_face(follower);
                         })),
                         [](const auto& item) { return item.param.name; });

}  // namespace envelope_test
}  // namespace camopt
