// SPDX-License-Identifier: MIT
#include "profiles/inverse/g1_guide.hpp"

#include "core/errors.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace camopt {

using Eigen::Vector2d;

G1GuideShape g1_guide_shape(const G1GuideDimensions& d) {
    const double sum = d.first_radius + d.second_radius;
    const double sine = std::sin(d.end_angle), cosine = std::cos(d.end_angle);
    const double alpha =
        d.end_angle + std::acos((d.second_radius - d.line_end * sine + d.first_radius * cosine) / sum);
    return {alpha, Vector2d(d.line_end + sum * std::sin(alpha), d.first_radius - sum * std::cos(alpha))};
}

Guide make_g1_guide(const G1GuideDimensions& d) {
    const auto positive = [](const char* name, double value) {
        if (!(value > 0.0))
            throw InputError(fmt::format("{} of the guide is {}; it must be > 0", name, value));
    };
    positive("the end of the first line", d.line_end);
    positive("the first radius", d.first_radius);
    positive("the second radius", d.second_radius);
    positive("the begin", d.begin);
    if (!(d.end_angle > 0.0 && d.end_angle < 0.5 * std::numbers::pi))
        throw InputError(
            fmt::format("the end angle of the guide is {} rad; it must be > 0 and < pi / 2", d.end_angle));
    const G1GuideShape shape = g1_guide_shape(d);
    if (!std::isfinite(shape.middle_angle))
        throw InputError(
            fmt::format("no arcs of radius {} and {} m join the line that ends at {} m to one at {} rad "
                        "through the pivot",
                        d.first_radius, d.second_radius, d.line_end, d.end_angle));
    const Vector2d outwards(std::cos(d.end_angle), std::sin(d.end_angle));
    const Vector2d corner(d.line_end, 0.0), first_center(d.line_end, d.first_radius);
    const Vector2d joint =
        first_center + d.first_radius * Vector2d(std::sin(shape.middle_angle), -std::cos(shape.middle_angle));
    const Vector2d last = shape.second_center + d.second_radius * Vector2d(-outwards.y(), outwards.x());
    return Guide({GuideLine{Vector2d(d.begin, 0.0), corner}, GuideArc{corner, joint, first_center},
                  GuideArc{joint, last, shape.second_center}, GuideLine{last, d.end * outwards}});
}

}  // namespace camopt
