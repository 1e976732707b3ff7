// SPDX-License-Identifier: MIT
#include "tests/input/cam_points.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace camopt::input {
namespace cam_points {

constexpr double pi = std::numbers::pi;

/// An array of what `of` is at each point of the cam under a knife edge, every 5 deg.
std::string points(const std::function<double(double radius, double angle)>& of) {
    std::string text;
    for (int i = 0; i < 72; ++i) {
        const double theta = i * pi / 36.0;
        const double lift = theta < 2.0   ? theta / 2.0
                            : theta < 4.5 ? 1.0
                                          : (2.0 * pi - theta) / (2.0 * pi - 4.5);
        text += fmt::format("{}{:.17g}", i == 0 ? "[" : ", ", of(0.04 + 0.02 * lift, pi / 2.0 - theta));
    }
    return text + "]\n";
}

}  // namespace cam_points

std::vector<CamPointKey> cam_point_keys() {
    using cam_points::points;
    const std::string knife =
        "objective.jerk = 1\nmotion = { type = \"DRD\", rise_rad = 2, lift_mm = 20 }\n"
        "cam = { type = \"disk\", follower = \"translating_knife\", base_radius_mm = 40, "
        "rotation = \"counterclockwise\" }\n";
    const auto x = [](double r, double at) { return r * std::cos(at); };
    const auto y = [](double r, double at) { return r * std::sin(at); };
    const std::string drum =
        "objective.jerk = 1\nmotion = { type = \"DRD\", rise_rad = 2, lift_mm = 20 }\n"
        "cam = { type = \"cylindrical\", follower = \"translating\", roller_radius_mm = 5, "
        "roller_length_mm = 15, cylinder_radius_mm = 60 }\nmeasured.of = \"center\"\nmeasured.theta_rad = " +
        points([](double, double at) { return at; });
    const auto height = [](double r, double) { return r - 0.04; };
    const std::string around = knife + "measured.theta_rad = " + points([](double, double at) { return at; });
    std::vector<CamPointKey> all;
    for (const auto& [unit, size] : {std::pair("mm", 1e-3), std::pair("in", 0.0254), std::pair("m", 1.0)}) {
        const auto add = [&](const std::string& name, const std::string& value, const std::string& rest) {
            const std::string key = fmt::format("measured.{}_{}", name, unit);
            all.push_back({key, rest + key + " = " + value + "\n"});
        };
        const auto in_unit = [size = size](const auto& of) {
            return points([=](double r, double at) { return of(r, at) / size; });
        };
        add("x", in_unit(x), knife + "measured.y_m = " + points(y));
        add("y", in_unit(y), knife + "measured.x_m = " + points(x));
        add("r", in_unit([](double r, double) { return r; }), around);
        add("z", in_unit(height), drum);
        add("radius", fmt::format("{:.17g}", 0.05 / size), drum + "measured.z_m = " + points(height));
        add("probe_radius", "0", around + "measured.r_m = " + points([](double r, double) { return r; }));
    }
    return all;
}

}  // namespace camopt::input
