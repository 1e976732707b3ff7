// SPDX-License-Identifier: MIT
#include "studies/delivered/mechanism_summary.hpp"

#include "core/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace camopt {

namespace {

constexpr double same_place = 1e-9;  // of the motion: two places are one

class MechanismTurn {
 public:
    MechanismTurn(const DrivenMechanism& mechanism, const Motion& motion, const MotionScale& scale)
        : mechanism_(mechanism), motion_(motion), scale_(scale), points_(motion.breakpoints()) {}

    /// Over all stations.
    template <class Figure>
    [[nodiscard]] CamExtreme largest(const Figure& figure) const {
        std::optional<CamExtreme> best;
        for (int station = 0; station < mechanism_.formulas->stations(); ++station) {
            const CamExtreme one = largest_along(points_, [&](double x, Side side) {
                return figure(mechanism_point(mechanism_, motion_.at(x, side), scale_, station));
            });
            if (!best || one.value > best->value) best = one;
        }
        return *best;
    }
    template <class Figure>
    [[nodiscard]] CamExtreme least(const Figure& figure) const {
        CamExtreme found = largest([&](const MechanismPoint& point) { return -figure(point); });
        found.value = -found.value;
        return found;
    }

 private:
    const DrivenMechanism& mechanism_;
    const Motion& motion_;
    MotionScale scale_;
    std::vector<double> points_;
};

}  // namespace

MechanismPoint mechanism_point(const DrivenMechanism& mechanism, const MotionPoint& motion,
                               const MotionScale& scale, int station) {
    return mechanism.formulas->point(scale.unit_angle * motion.x,
                                     {mechanism.dimensions, state_of(motion, scale)}, station);
}

MechanismSummary mechanism_summary(const DrivenMechanism& mechanism, const Motion& motion,
                                   const MotionScale& scale) {
    const MechanismTurn turn(mechanism, motion, scale);
    MechanismSummary summary;
    summary.pressure_angle =
        turn.largest([](const MechanismPoint& point) { return std::abs(point.pressure_angle); });
    summary.regularity = turn.least([](const MechanismPoint& point) { return point.regularity; });
    if (!mechanism.formulas->planar()) return summary;
    // Radii of the cam follow from the pitch curve's: the curvature is smooth where a radius is not.
    const double roller = mechanism.dimensions[static_cast<std::size_t>(mechanism.formulas->roller_radius())];
    const auto curvature = [](const MechanismPoint& point) { return point.pitch_curvature; };
    const CamExtreme sharpest = turn.largest(curvature), hollow = turn.least(curvature);
    if (sharpest.value > 0.0) summary.convex_radius = CamExtreme{1.0 / sharpest.value - roller, sharpest.at};
    if (hollow.value < 0.0) summary.concave_radius = CamExtreme{roller - 1.0 / hollow.value, hollow.at};
    summary.base_radius = turn.least([](const MechanismPoint& point) { return point.contact.norm(); }).value;
    return summary;
}

MechanismProfile mechanism_profile(const DrivenMechanism& mechanism, const Motion& motion,
                                   const MotionScale& scale, int count, int station) {
    if (count < 2) throw InputError(fmt::format("count: found {}; allowed: at least 2", count));
    const std::vector<double> breakpoints = motion.breakpoints();
    const double length = motion.end() - motion.begin();
    std::vector<double> places = breakpoints;
    for (int i = 1; i + 1 < count; ++i) {
        const double place = motion.begin() + length * i / (count - 1);
        const auto next = std::ranges::lower_bound(breakpoints, place);
        if (std::min(*next - place, place - *std::prev(next)) > same_place * length) places.push_back(place);
    }
    std::ranges::sort(places);
    MechanismProfile profile;
    for (const double x : places) {
        const MotionPoint point = motion.at(x, x < motion.end() ? Side::right : Side::left);
        if (std::ranges::binary_search(breakpoints, x))
            profile.breaks.push_back(static_cast<int>(profile.points.size()));
        profile.points.push_back(mechanism_point(mechanism, point, scale, station));
        profile.outputs.push_back(scale.lift * point.derivative[0]);
    }
    return profile;
}

}  // namespace camopt
