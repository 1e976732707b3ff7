// SPDX-License-Identifier: MIT
#include "benchmarks/stability/cam_audit.hpp"

#include "profiles/disk/disk_cam.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>

namespace camopt::stability {

namespace {

using Complex = std::complex<double>;

constexpr double at_rest = 1e-9;  // of the mean velocity: what is slower rests

struct FollowerPoint {
    double s = 0.0, first = 0.0, second = 0.0;  ///< s and its derivatives by the cam angle
};

struct RollerPath {
    double pressure_tangent = 0.0, curvature = 0.0;
};

class CamAudit {
 public:
    explicit CamAudit(const Solution& solution)
        : scene_(solution.scene), motion_(*solution.motion), cam_(disk_cam(solution.cam->cam).value()) {
        rest_ = rest();
    }

    [[nodiscard]] std::vector<BrokenLimit> limits() const {
        std::vector<BrokenLimit> all;
        const LimitSpec& limit = scene_.limits;
        const bool flat = cam_.follower == FollowerType::translating_flat;
        const bool path = !flat && cam_.follower != FollowerType::oscillating_flat;
        if (path && (limit.pressure_angle || limit.rise_pressure_angle || limit.return_pressure_angle))
            all.push_back({"pressure angle", largest([this](double x) { return pressure(x); })});
        if (limit.cam_radius_min && path)
            all.push_back({"cam radius", largest([this](double x) { return sharpness(x); })});
        if (limit.cam_radius_min && flat)
            all.push_back({"cam radius", largest([this](double x) { return flat_sharpness(x); })});
        if (limit.contact_force_min)
            all.push_back({"contact force", largest([this](double x) { return lightness(x); })});
        return all;
    }

 private:
    using Amount = std::function<double(double x)>;

    [[nodiscard]] double dimension(DimensionIndex index) const { return cam_[index]; }

    [[nodiscard]] double rest() const {
        using enum DimensionIndex;
        const double prime = dimension(base_radius) + dimension(roller_radius);
        if (!is_oscillating(cam_.follower))
            return std::sqrt(prime * prime - dimension(offset) * dimension(offset));
        const double a = dimension(center_distance);
        const double l = dimension(arm_length);
        return std::acos((a * a + l * l - prime * prime) / (2 * a * l));
    }

    [[nodiscard]] FollowerPoint follower(double x) const {
        const MotionPoint point = motion_.at(x);
        const double lift = scene_.motion.lift;
        const double angle = scene_.motion.unit_angle();
        return {lift * point.derivative[0], lift * point.derivative[1] / angle,
                lift * point.derivative[2] / (angle * angle)};
    }

    [[nodiscard]] RollerPath path(const FollowerPoint& point) const {
        using enum DimensionIndex;
        const Complex i(0, 1);
        Complex c(dimension(offset), rest_ + point.s);
        Complex c1 = i;
        Complex c2 = 0;
        if (is_oscillating(cam_.follower)) {
            const Complex arm = std::polar(dimension(arm_length), std::numbers::pi - rest_ - point.s);
            c = dimension(center_distance) + arm;
            c1 = -i * arm;
            c2 = -arm;
        }
        const double sense = sense_of(cam_.rotation);
        const Complex tangent = c1 * point.first - i * sense * c;
        const Complex second =
            c2 * point.first * point.first + c1 * point.second - 2.0 * i * sense * c1 * point.first - c;
        const Complex across = std::conj(c1) * i * tangent;
        return {std::abs(across.imag() / across.real()),
                -sense * (std::conj(tangent) * second).imag() / std::pow(std::abs(tangent), 3)};
    }

    [[nodiscard]] double pressure(double x) const {
        const LimitSpec& limit = scene_.limits;
        const FollowerPoint point = follower(x);
        auto holds = limit.pressure_angle;
        const double still = at_rest * scene_.motion.lift / scene_.motion.unit_angle();
        if (point.first > still && limit.rise_pressure_angle) holds = limit.rise_pressure_angle;
        if (point.first < -still && limit.return_pressure_angle) holds = limit.return_pressure_angle;
        if (std::abs(point.first) <= still) {  // the least of all that are given
            for (const auto& own : {limit.rise_pressure_angle, limit.return_pressure_angle})
                if (own && (!holds || own->value < holds->value)) holds = own;
        }
        return holds ? path(point).pressure_tangent / std::tan(holds->value) - 1.0 : -1.0;
    }

    [[nodiscard]] double sharpness(double x) const {
        const double least = scene_.limits.cam_radius_min->value + dimension(DimensionIndex::roller_radius);
        return path(follower(x)).curvature * least - 1.0;
    }

    [[nodiscard]] double flat_sharpness(double x) const {
        const FollowerPoint point = follower(x);
        const double base = dimension(DimensionIndex::base_radius);
        return (scene_.limits.cam_radius_min->value - base - point.s - point.second) / base;
    }

    [[nodiscard]] double lightness(double x) const {
        const FollowerPoint point = follower(x);
        const double least = scene_.limits.contact_force_min->value;
        const double force = scene_.forces->force(*scene_.motion.speed, {point.s, point.first, point.second},
                                                  scene_.motion.unit_angle() * x);
        return (least - force) / std::max(least, scene_.forces->preload);
    }

    /// The largest over the motion.
    [[nodiscard]] double largest(const Amount& amount) const {
        constexpr int places = 64;
        const std::vector<double> breaks = motion_.breakpoints();
        double found = -HUGE_VAL;
        for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
            const double step = (breaks[k + 1] - breaks[k]) / places;
            for (int j = 0; j <= places; ++j) {
                const double x = breaks[k] + j * step;
                const double here = amount(x);
                if (std::isnan(here)) return HUGE_VAL;
                found = std::max(found, here);
                if (here > found - 0.01)
                    found = std::max(found, refined(amount, std::max(breaks[k], x - step),
                                                    std::min(breaks[k + 1], x + step)));
            }
        }
        return found;
    }

    [[nodiscard]] static double refined(const Amount& amount, double low, double high) {
        constexpr double golden = 0.6180339887498949;
        double best = -HUGE_VAL;
        for (int step = 0; step < 50; ++step) {
            const double left = high - golden * (high - low);
            const double right = low + golden * (high - low);
            const double at_left = amount(left);
            const double at_right = amount(right);
            best = std::max({best, at_left, at_right});
            (at_left > at_right ? high : low) = at_left > at_right ? right : left;
        }
        return best;
    }

    const Scene& scene_;
    const MotionChain& motion_;
    DiskCam cam_;
    double rest_ = 0.0;
};

}  // namespace

std::vector<BrokenLimit> broken_limits(const Solution& solution) {
    return CamAudit(solution).limits();
}

}  // namespace camopt::stability
