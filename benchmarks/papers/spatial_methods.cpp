// SPDX-License-Identifier: MIT
// Both methods of contact are written from the papers' transformations, not from the formulas of
// spatial_formulas.hpp, so that their agreement is an independent test.
#include "benchmarks/papers/spatial_methods.hpp"

#include "core/numbers/extremum.hpp"
#include "profiles/spatial/spatial_formulas.hpp"

#include <Eigen/Geometry>
#include <unsupported/Eigen/AutoDiff>

namespace camopt {

namespace {

using Eigen::Vector3d;

constexpr int refinements = 60;      // to neighbouring doubles
constexpr int height_steps = 16;     // g is smooth over a roller
constexpr int height_sections = 40;  // golden sections between two of them
constexpr int search_steps = 64;     // of the centre distance, until g < 0 is met
constexpr double end_share = 1e-12;  // of the motion: pieces are searched from this far inside their ends

using Slope = Eigen::AutoDiffScalar<Eigen::Matrix<double, 1, 1>>;

Slope along_theta(double value, double slope) {
    return {value, Eigen::Matrix<double, 1, 1>(slope)};
}

/// A vector and its derivative by θ.
struct Moving {
    Slope x, y, z;
    [[nodiscard]] Vector3d value() const { return {x.value(), y.value(), z.value()}; }
    [[nodiscard]] Vector3d rate() const {
        return {x.derivatives()[0], y.derivatives()[0], z.derivatives()[0]};
    }
};

Moving about_x(const Moving& v, const Slope& angle) {
    const Slope c = cos(angle), s = sin(angle);
    return {v.x, Slope(c * v.y - s * v.z), Slope(s * v.y + c * v.z)};
}
Moving about_y(const Moving& v, const Slope& angle) {
    const Slope c = cos(angle), s = sin(angle);
    return {Slope(c * v.x + s * v.z), v.y, Slope(c * v.z - s * v.x)};
}
Moving about_z(const Moving& v, const Slope& angle) {
    const Slope c = cos(angle), s = sin(angle);
    return {Slope(c * v.x - s * v.y), Slope(s * v.x + c * v.y), v.z};
}
Moving shifted(const Moving& v, double x, double y, double z) {
    return {Slope(v.x + x), Slope(v.y + y), Slope(v.z + z)};
}

/// From the roller's frame to the cam's. The roller's own third axis runs towards its far end.
class Chain {
 public:
    Chain(const SpatialCam& cam, double theta, const FollowerState& state)
        : cam_(cam),
          back_(along_theta(-sense_of(cam.rotation) * theta, -sense_of(cam.rotation))),
          position_(along_theta(cam.start + state.s, state.velocity)) {}

    [[nodiscard]] Moving point(const Vector3d& own) const { return mapped(own, 1.0); }
    [[nodiscard]] Vector3d direction(const Vector3d& own) const { return mapped(own, 0.0).value(); }

 private:
    /// `place`: 1 for points, 0 for directions.
    [[nodiscard]] Moving mapped(const Vector3d& own, double place) const {
        using enum SpatialDimension;
        Moving v{along_theta(own.x(), 0.0), along_theta(own.y(), 0.0), along_theta(own.z(), 0.0)};
        const double arm = place * cam_[arm_length];
        const double lateral = place * cam_[lateral_offset], distance = place * cam_[center_distance];
        const double axial = place * cam_.axial_offset;
        const Slope quarter = along_theta(0.5 * std::numbers::pi, 0.0);
        switch (cam_.follower) {
            case SpatialFollower::barrel:
                // Index frame: y is the index axis, the roller's axis points against it.
                v = about_y(shifted(about_x(v, quarter), arm, 0.0, 0.0), position_);
                v = shifted(v, -lateral, distance, -axial);
                break;
            case SpatialFollower::cylindrical_rotating:
                // T(dx, dy, dz) Rx(90°) Rx(−θ_f) T(0, 0, f_l)
                v = about_x(about_x(shifted(v, 0.0, 0.0, arm), Slope(-position_)), quarter);
                v = shifted(v, lateral, distance, axial);
                break;
            case SpatialFollower::cylindrical_translating:
                v = shifted(about_x(v, quarter), lateral, distance, axial);
                v.z += place * position_;
                break;
        }
        return about_z(v, back_);
    }

    const SpatialCam& cam_;
    Slope back_, position_;
};

/// Of function(θ) over the motion.
template <class Function>
Extremum largest_over(const FollowerMotion& motion, const Function& function) {
    const double inset = end_share * (motion.end() - motion.begin());
    return largest_along(motion.breakpoints, [&](double theta, Side side) {
        return function(side == Side::left ? theta - inset : theta + inset);
    });
}

spatial_formulas::AxisMotion<double> motion_at(const SpatialCam& cam, const FollowerMotion& motion,
                                               double theta, double height) {
    return spatial_formulas::axis_motion(cam, spatial_formulas::variables_of(cam, motion.state(theta)),
                                         height);
}

/// Of −g over the cam angle.
Extremum worst_undercut(const SpatialCam& cam, const FollowerMotion& motion, const RollerStation& station) {
    using enum SpatialDimension;
    return largest_over(motion, [&](double theta) {
        return -spatial_formulas::undercut(motion_at(cam, motion, theta, station.height), cam[roller_radius],
                                           station.flank);
    });
}

}  // namespace

SpatialExtreme largest_pressure_angle(const SpatialCam& cam, const FollowerMotion& motion, double height) {
    const double sign = spatial_formulas::sign_of_b(cam);
    const Extremum worst = largest_over(motion, [&](double theta) {
        const auto axis = motion_at(cam, motion, theta, height);
        return std::abs(std::atan2(axis.across_travel, sign * axis.along_b));
    });
    return {worst.value, worst.at, height};
}

SpatialExtreme least_undercut(const SpatialCam& cam, const FollowerMotion& motion, int flank,
                              const HeightRange& heights) {
    const auto worst = [&](double height) { return worst_undercut(cam, motion, {height, flank}); };
    const double step = (heights.to - heights.from) / height_steps;
    int highest = 0;
    double value = -std::numeric_limits<double>::infinity();
    for (int i = 0; i <= height_steps; ++i)
        if (const double now = worst(heights.from + i * step).value; now > value) {
            value = now;
            highest = i;
        }
    double height = heights.from + highest * step;
    if (highest > 0 && highest < height_steps)
        height = golden_maximum([&](double place) { return worst(place).value; }, height - step,
                                height + step, height_sections)
                     .place();
    else if (highest == height_steps)
        height = heights.to;
    const Extremum found = worst(height);
    return {-found.value, found.at, height};
}

Vector3d envelope_contact(const SpatialCam& cam, double theta, const FollowerState& state,
                          const RollerStation& station) {
    using enum SpatialDimension;
    const Chain chain(cam, theta, state);
    const double r = cam[roller_radius];
    const auto on_roller = [&](double cosine, double sine) {
        return Vector3d(r * cosine, r * sine, station.height);
    };
    // S_h × S_β is along the roller's radius, so S_θ · radius = 0 decides; it is linear in (cos β, sin β).
    const double at_first = chain.point(on_roller(1.0, 0.0)).rate().dot(chain.direction(Vector3d::UnitX()));
    const double at_second = chain.point(on_roller(0.0, 1.0)).rate().dot(chain.direction(Vector3d::UnitY()));
    const double size = std::hypot(at_first, at_second) * (station.flank > 0 ? 1.0 : -1.0);
    // V × e has the components (V_2, −V_1) in a right-handed (1, 2, e).
    return chain.point(on_roller(at_second / size, -at_first / size)).value();
}

Vector3d relative_velocity_contact(const SpatialCam& cam, double theta, const FollowerState& state,
                                   const RollerStation& station) {
    using enum SpatialDimension;
    const double sense = sense_of(cam.rotation);
    // Everything at this moment, cam not rotated: the fixed frame.
    const RollerAxis axis = roller_axis(cam, 0.0, state.s);
    const Vector3d point = axis.foot + station.height * axis.direction;
    Vector3d of_follower = state.velocity * Vector3d::UnitZ();
    if (cam.follower == SpatialFollower::barrel) {
        const Vector3d pivot(-cam[lateral_offset], cam[center_distance], -cam.axial_offset);
        of_follower = state.velocity * Vector3d::UnitY().cross(point - pivot);
    } else if (cam.follower == SpatialFollower::cylindrical_rotating) {
        const Vector3d pivot(cam[lateral_offset], cam[center_distance], cam.axial_offset);
        of_follower = -state.velocity * Vector3d::UnitX().cross(point - pivot);
    }
    const Vector3d relative = of_follower - sense * Vector3d::UnitZ().cross(point);
    const Vector3d first = axis.travel.cross(axis.direction);
    const double direction = std::atan2(relative.dot(axis.travel), relative.dot(first));
    const double angle = direction - (station.flank > 0 ? 0.5 : -0.5) * std::numbers::pi;
    const Vector3d contact =
        point + cam[roller_radius] * (std::cos(angle) * first + std::sin(angle) * axis.travel);
    return Eigen::AngleAxisd(-sense * theta, Vector3d::UnitZ()) * contact;
}

std::optional<SpatialExtreme> critical_roller_radius(const SpatialCam& cam, const FollowerMotion& motion,
                                                     const RollerStation& station) {
    // 1/r is smooth and bounded where r may be infinite: r = 2/(b + sqrt(b² + 4 t²)), b = σ_f bend.
    const double side = station.flank > 0 ? 1.0 : -1.0;
    const Extremum worst = largest_over(motion, [&](double theta) {
        const auto terms = spatial_formulas::undercut_terms(motion_at(cam, motion, theta, station.height));
        const double bend = side * terms.bend;
        return 0.5 * (bend + std::hypot(bend, 2.0 * terms.twist));
    });
    if (!(worst.value > 0.0)) return std::nullopt;
    return SpatialExtreme{1.0 / worst.value, worst.at, station.height};
}

std::optional<SpatialExtreme> critical_center_distance(const SpatialCam& cam, const FollowerMotion& motion,
                                                       const RollerStation& station) {
    using enum SpatialDimension;
    const auto worst = [&](double distance) {
        SpatialCam moved = cam;
        moved[center_distance] = distance;
        return worst_undercut(moved, motion, station);
    };
    const bool arm_reaches = cam.follower == SpatialFollower::cylindrical_rotating;
    const double least = arm_reaches ? cam[arm_length] + station.height : station.height;
    double regular = cam[center_distance];
    if (worst(regular).value >= 0.0) return std::nullopt;
    const double step = (regular - least) / search_steps;
    double undercut = regular - step;
    for (int i = 2; i < search_steps && worst(undercut).value < 0.0; ++i) {
        regular = undercut;
        undercut -= step;
    }
    if (worst(undercut).value < 0.0) return std::nullopt;
    const auto is_regular = [&](double value) { return worst(value).value < 0.0; };
    undercut = bisected(is_regular, {regular, undercut}, refinements).without;
    return SpatialExtreme{undercut, worst(undercut).at, station.height};
}

}  // namespace camopt
