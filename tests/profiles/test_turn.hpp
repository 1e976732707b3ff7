// SPDX-License-Identifier: MIT
// The turn of the reference cams: 4-5-6-7 polynomial, dwell to 60 deg, rise to 160, dwell to 200, fall to
// 360; and the reference cams themselves, in mm and degrees.
#pragma once

#include "core/units.hpp"
#include "motions/laws/law_catalogue.hpp"
#include "profiles/disk/disk_cam.hpp"
#include "profiles/sampling.hpp"

#include <cmath>
#include <memory>
#include <numbers>
#include <ostream>
#include <string>
#include <vector>

namespace camopt::test {

using units::degree;
using units::millimetre;
inline constexpr double full_turn = 2.0 * std::numbers::pi;

/// Cam angles over the turn, rad; first and step in degrees.
inline std::vector<double> angles(double first, double step) {
    std::vector<double> result;
    while (first + step * static_cast<double>(result.size()) <= 360.0)
        result.push_back((first + step * static_cast<double>(result.size())) * degree);
    return result;
}

/// x is the cam angle in radians, y the displacement by the lift.
class TestTurn : public Motion {
 public:
    [[nodiscard]] double begin() const override { return 0.0; }
    [[nodiscard]] double end() const override { return full_turn; }
    [[nodiscard]] std::vector<double> breakpoints() const override {
        return {0.0, 60.0 * degree, 160.0 * degree, 200.0 * degree, full_turn};
    }
    [[nodiscard]] MotionPoint at(double x, Side) const override {
        if (x > 60.0 * degree && x < 160.0 * degree) return law_point(x, 60.0 * degree, 100.0 * degree, 1.0);
        if (x >= 160.0 * degree && x <= 200.0 * degree) return {x, {1.0, 0.0, 0.0, 0.0}};
        if (x > 200.0 * degree && x < full_turn) return law_point(x, 200.0 * degree, 160.0 * degree, -1.0);
        return {x, {0.0, 0.0, 0.0, 0.0}};
    }

 private:
    [[nodiscard]] MotionPoint law_point(double x, double from, double width, double direction) const {
        const MotionPoint inner = law_->at((x - from) / width);
        MotionPoint point{x, {}};
        double factor = direction;
        for (std::size_t i = 0; i < 4; ++i, factor /= width)
            point.derivative[i] = factor * inner.derivative[i];
        if (direction < 0.0) point.derivative[0] += 1.0;
        return point;
    }

    std::unique_ptr<Law> law_ = make_law("polynomial_4567");
};

/// A cam with its lift (m or rad).
struct TestCam {
    std::string name;
    DiskCam cam;
    double lift = 0.0;

    [[nodiscard]] ProfilePoint at(double theta, const Motion& motion) const {
        return profile_point(cam, theta, state_of(motion.at(theta), {lift, 1.0}));
    }
};

inline void PrintTo(const TestCam& value, std::ostream* stream) {
    *stream << value.name;
}

/// Translating roller or knife from its prime radius, mm.
inline TestCam translating_roller(double prime, double roller, double offset = 8.0, double lift = 25.0) {
    const auto follower = roller > 0.0 ? FollowerType::translating_roller : FollowerType::translating_knife;
    DiskCam cam{follower, Rotation::counterclockwise, {}};
    cam.dimensions = {(prime - roller) * millimetre, roller * millimetre, offset * millimetre, 0.0, 0.0, 0.0};
    return {name_of(follower), cam, lift * millimetre};
}

inline TestCam translating_flat(double base, double lift = 14.0) {
    DiskCam cam{FollowerType::translating_flat, Rotation::counterclockwise, {}};
    cam.dimensions[0] = base * millimetre;
    return {"translating_flat", cam, lift * millimetre};
}

/// a = 100, l = 80, psi0 = 32 deg, swing 22 deg.
inline TestCam oscillating_roller(double roller) {
    const double prime = std::sqrt(100.0 * 100.0 + 80.0 * 80.0 - 16000.0 * std::cos(32.0 * degree));
    DiskCam cam{FollowerType::oscillating_roller, Rotation::counterclockwise, {}};
    cam.dimensions = {(prime - roller) * millimetre, roller * millimetre, 0.0, 0.1, 0.08, 0.0};
    return {"oscillating_roller", cam, 22.0 * degree};
}

/// a = 100, psi0 = 22 deg, swing 10 deg.
inline TestCam oscillating_flat(double face_offset, double swing = 10.0) {
    const double base = 100.0 * std::sin(22.0 * degree) - face_offset;
    DiskCam cam{FollowerType::oscillating_flat, Rotation::counterclockwise, {}};
    cam.dimensions = {base * millimetre, 0.0, 0.0, 0.1, 0.0, face_offset * millimetre};
    return {"oscillating_flat", cam, swing * degree};
}

/// One regular cam of each follower in each rotation. Turning clockwise, the swinging face must not swing as
/// far: there the steeper stroke meets the smaller radii.
inline std::vector<TestCam> regular_cams() {
    std::vector<TestCam> cams;
    for (const Rotation rotation : {Rotation::counterclockwise, Rotation::clockwise}) {
        const double swing = rotation == Rotation::clockwise ? 5.0 : 10.0;
        for (TestCam cam : {translating_roller(45, 10), translating_roller(45, 0), translating_flat(60),
                            oscillating_roller(10), oscillating_flat(4, swing)}) {
            cam.cam.rotation = rotation;
            cam.name += std::string("_") + name_of(rotation);
            cams.push_back(cam);
        }
    }
    return cams;
}

/// Those of them whose follower is of a kind.
template <class Kind>
std::vector<TestCam> regular_cams(const Kind& kind) {
    std::vector<TestCam> cams = regular_cams();
    std::erase_if(cams, [&](const TestCam& cam) { return !kind(cam.cam.follower); });
    return cams;
}

}  // namespace camopt::test
