// SPDX-License-Identifier: MIT
#include "studies/spatial/flank_contact.hpp"

#include "core/numbers/scalar_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace camopt {

namespace {

using Eigen::Vector3d;

constexpr int section_steps = 34;    // golden sections: to 1e-7 of a distance, of whose square all depends
constexpr int most_secants = 30;     // half a dozen are needed
constexpr double first_step = 1e-5;  // of the follower, rad, or of the roller's radius
constexpr double enough = 1e-15;     // m: what is left of a distance after its subtraction

/// From the roller's axis, which goes on by a radius beyond either end but not through the cam to its far
/// side.
double distance_from(const SpatialCam& follower, const RollerAxis& axis, const Vector3d& point) {
    const double radius = follower[SpatialDimension::roller_radius];
    const Vector3d from_foot = point - axis.foot;
    const double along = std::clamp(from_foot.dot(axis.direction), -radius, follower.roller_length + radius);
    return (from_foot - along * axis.direction).norm();
}

}  // namespace

FlankContact::FlankContact(const SpatialCam& follower, std::span<const Vector3d> points,
                           std::span<const int> breaks, double s)
    : follower_(follower), curve_(points, breaks, false), s_(s) {
    for (const double node : curve_.nodes()) places_.push_back(curve_.at(node));
}

FlankContact::Nearest FlankContact::nearest(double theta, double s) {
    const RollerAxis axis = roller_axis(follower_, theta, s);
    const auto at_place = [&](std::size_t i) { return distance_from(follower_, axis, places_[i]); };
    const auto on_curve = [&](double parameter) {
        return distance_from(follower_, axis, curve_.at(parameter));
    };
    if (!placed_) {
        for (std::size_t i = 0; i < places_.size(); ++i)
            if (at_place(i) < at_place(place_)) place_ = i;
        placed_ = true;
    }
    while (place_ + 1 < places_.size() && at_place(place_ + 1) < at_place(place_)) ++place_;
    while (place_ > 0 && at_place(place_ - 1) < at_place(place_)) --place_;
    const std::vector<double>& nodes = curve_.nodes();
    const double low = nodes[place_ > 0 ? place_ - 1 : 0],
                 high = nodes[std::min(place_ + 1, nodes.size() - 1)];
    const auto nearness = [&](double parameter) { return -on_curve(parameter); };
    const double end = at_place(place_), inner = -golden_maximum(nearness, low, high, section_steps).value();
    const bool is_end = place_ == 0 || place_ + 1 == places_.size();
    return {std::min(end, inner), is_end && end <= inner};
}

FlankContact::Stand FlankContact::at(double theta) {
    const double radius = follower_[SpatialDimension::roller_radius];
    const bool slides = follower_.follower == SpatialFollower::cylindrical_translating;
    const double step = slides ? first_step * radius : first_step;
    double before = s_ + step, s = s_;
    double gap_before = nearest(theta, before).distance - radius;
    Nearest found = nearest(theta, s);
    double gap = found.distance - radius;
    for (int i = 0; i < most_secants && std::abs(gap) > enough && gap != gap_before; ++i) {
        const double next = s - gap * (s - before) / (gap - gap_before);
        if (!std::isfinite(next)) break;
        before = std::exchange(s, next);
        gap_before = gap;
        found = nearest(theta, s);
        gap = found.distance - radius;
    }
    // Rounding in the coordinates is what may be left.
    if (!(std::abs(gap) < 1e-12 * (1.0 + radius))) return {std::numeric_limits<double>::quiet_NaN(), false};
    s_ = s;
    return {s, found.at_end};
}

}  // namespace camopt
