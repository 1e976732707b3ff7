// SPDX-License-Identifier: MIT
#include "benchmarks/papers/wished_guide.hpp"

#include "core/errors.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

constexpr int peak_places = 2000;  // places between two joints where peaks are searched

double rise_begin(const FeederWish& wish) {
    return time_at(wish.stroke, wish.from);
}

PolarNode node_at(const FeederWish& wish, const Motion& motion, double x) {
    const double time = rise_begin(wish) + x * wish.rise_time();
    const GuideNode node =
        wanted_guide(wish.linkage, state_of(wish.stroke, time), wished_feeder(wish, motion, time));
    if (node.fault != InverseFault::none)
        throw InputError(fmt::format("the machine cannot produce the required feeder motion at {:.6g} s: {}",
                                     time, name_of(node.fault)));
    return node.node;
}

/// x of the nodes: the motion's breakpoints, and between them evenly by L.
std::vector<double> node_places(const FeederWish& wish, const Motion& motion, int nodes) {
    const double begin = rise_begin(wish), duration = wish.rise_time();
    const auto distance_at = [&](double x) { return state_of(wish.stroke, begin + x * duration).distance; };
    std::vector<double> places = {0.0};
    const std::vector<double> breaks = motion.breakpoints();
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
        const double from = distance_at(breaks[i]), to = distance_at(breaks[i + 1]);
        const int steps = std::max(
            1, static_cast<int>(std::lround(nodes * std::abs(to - from) / std::abs(wish.to - wish.from))));
        for (int k = 1; k < steps; ++k)
            places.push_back((time_at(wish.stroke, from + (to - from) * k / steps) - begin) / duration);
        places.push_back(breaks[i + 1]);
    }
    return places;
}

Eigen::Vector2d on_guide(double distance, double angle) {
    return {distance * std::cos(angle), distance * std::sin(angle)};
}

InverseState reached(const Guide& guide, const FeederLinkage& linkage, const RollerState& roller, Side side) {
    InverseState state = inverse_state(guide, linkage, roller, side);
    if (state.fault != InverseFault::none)
        throw InputError(fmt::format("the machine does not reach L = {:.6g} m: {}", roller.distance,
                                     name_of(state.fault)));
    return state;
}

/// Over the part of the guide from joint to joint, in one stroke.
void take_peaks(const Guide& guide, const FeederLinkage& linkage, const RollerStroke& stroke,
                StrokePeaks& peaks) {
    const double reached_end =
        std::max(state_of(stroke, stroke.begin).distance, state_of(stroke, stroke.end).distance);
    const double reached_begin =
        std::min(state_of(stroke, stroke.begin).distance, state_of(stroke, stroke.end).distance);
    double last_end = std::nan("");
    for (std::size_t i = 0; i + 1 < guide.joints().size(); ++i) {
        const double from = std::max(guide.joints()[i], reached_begin),
                     to = std::min(guide.joints()[i + 1], reached_end);
        if (!(from < to)) continue;
        double before = 0.0, time_before = 0.0;
        for (int k = 0; k <= peak_places; ++k) {
            const double distance = k == peak_places ? to : from + (to - from) * k / peak_places;
            const double time = time_at(stroke, distance);
            RollerState roller = state_of(stroke, time);
            roller.distance = distance;  // to the bit, so that the side of the joint is the one meant
            const FollowerState feeder =
                reached(guide, linkage, roller, k == 0 ? Side::right : Side::left).feeder.feeder;
            peaks.velocity = std::max(peaks.velocity, std::abs(feeder.velocity));
            peaks.acceleration = std::max(peaks.acceleration, std::abs(feeder.acceleration));
            if (k == 0 && !std::isnan(last_end))
                peaks.acceleration_step =
                    std::max(peaks.acceleration_step, std::abs(feeder.acceleration - last_end));
            if (k > 0 && time != time_before)
                peaks.jerk =
                    std::max(peaks.jerk, std::abs((feeder.acceleration - before) / (time - time_before)));
            before = feeder.acceleration;
            time_before = time;
            last_end = feeder.acceleration;
        }
    }
}

void take_shape(const Guide& guide, GuideFigures& figures) {
    double sharpest = 0.0;
    for (std::size_t i = 0; i + 1 < guide.joints().size(); ++i) {
        const double from = guide.joints()[i], to = guide.joints()[i + 1];
        for (int k = 0; k <= peak_places; ++k) {
            const GuidePoint point = guide.at(k == peak_places ? to : from + (to - from) * k / peak_places,
                                              k == 0 ? Side::right : Side::left);
            if (std::abs(point.pressure_angle) > figures.pressure_angle) {
                figures.pressure_angle = std::abs(point.pressure_angle);
                figures.pressure_angle_at = point.distance;
            }
            if (std::abs(point.curvature) > sharpest) {
                sharpest = std::abs(point.curvature);
                figures.least_radius_at = point.distance;
            }
        }
    }
    figures.least_radius = 1.0 / sharpest;
}

}  // namespace

void FeederWish::validate() const {
    linkage.validate();
    const auto refuse = [](const std::string& words) {
        throw InputError("the required feeder motion: " + words);
    };
    if (!(from < to) || !(guide_begin > 0.0 && guide_begin <= from) || !(guide_end >= to))
        refuse(
            fmt::format("guide from {} to {} m, rise from {} to {} m; must be 0 < begin <= from < to <= end",
                        guide_begin, guide_end, from, to));
    if (!std::isfinite(time_at(stroke, from)) || !std::isfinite(time_at(stroke, to)))
        refuse(fmt::format("the roller's stroke does not pass both {} and {} m", from, to));
    if (!(std::abs(upper - lower) > 0.0)) refuse("lower and upper position of the feeder are the same");
}

double FeederWish::rise_time() const {
    return time_at(stroke, to) - time_at(stroke, from);
}

FollowerState wished_feeder(const FeederWish& wish, const Motion& motion, double time) {
    const double duration = wish.rise_time(), lift = wish.upper - wish.lower;
    const double x = (time - rise_begin(wish)) / duration;
    if (x <= 0.0) return {wish.lower, 0.0, 0.0};
    if (x >= 1.0) return {wish.upper, 0.0, 0.0};
    const MotionPoint point = motion.at(x);
    return {wish.lower + lift * point.derivative[0], lift * point.derivative[1] / duration,
            lift * point.derivative[2] / (duration * duration)};
}

Guide wished_guide(const FeederWish& wish, const Motion& motion, int nodes) {
    wish.validate();
    if (nodes < 2)
        throw InputError(fmt::format("{} nodes of the guide were requested; it needs at least 2", nodes));
    if (motion.begin() != 0.0 || motion.end() != 1.0)
        throw InputError("the feeder's motion must be a rise between two dwells, x from 0 to 1");
    GuidePolarSpline spline;
    for (const double x : node_places(wish, motion, nodes)) spline.nodes.push_back(node_at(wish, motion, x));
    if (wish.rise_time() < 0.0) std::ranges::reverse(spline.nodes);
    const PolarNode &first = spline.nodes.front(), &last = spline.nodes.back();
    std::vector<GuidePiece> pieces;
    if (wish.guide_begin < wish.from)
        pieces.emplace_back(
            GuideLine{on_guide(wish.guide_begin, first.angle), on_guide(first.distance, first.angle)});
    pieces.emplace_back(spline);
    if (wish.guide_end > wish.to)
        pieces.emplace_back(
            GuideLine{on_guide(last.distance, last.angle), on_guide(wish.guide_end, last.angle)});
    return Guide(std::move(pieces));
}

GuideFigures guide_figures(const Guide& guide, const FeederLinkage& linkage, const RollerLaw& roller) {
    GuideFigures figures;
    for (const RollerStroke& stroke : roller.strokes()) {
        const bool forward = state_of(stroke, stroke.end).distance > state_of(stroke, stroke.begin).distance;
        take_peaks(guide, linkage, stroke, forward ? figures.forward : figures.back);
    }
    take_shape(guide, figures);
    return figures;
}

double feeder_deviation(const Guide& guide, const FeederWish& wish, const Motion& motion) {
    double largest = 0.0;
    const double begin = rise_begin(wish), duration = wish.rise_time();
    for (int i = 0; i <= peak_places; ++i) {
        const double time = begin + duration * i / peak_places;
        RollerState roller = state_of(wish.stroke, time);
        roller.distance = std::clamp(roller.distance, guide.begin(), guide.end());
        const double found = reached(guide, wish.linkage, roller, Side::right).feeder.feeder.s;
        largest = std::max(largest, std::abs(found - wished_feeder(wish, motion, time).s));
    }
    return largest;
}

}  // namespace camopt
