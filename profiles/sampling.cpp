// SPDX-License-Identifier: MIT
#include "profiles/sampling.hpp"

#include "core/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace camopt {
namespace {

// A step is tested at its eighths, which detect both S-shaped and symmetric deviations.
constexpr int parts_of_step = 8;
// Between those points an arc is at most 1.6 %, an S at most 2.6 % further from the chord.
constexpr double seen_share = 0.97;
// A motion may reverse more than once between two breakpoints: no step is wider, so the eighths are 1.25
// degrees.
constexpr double widest_step = std::numbers::pi / 18.0;
// Least step: at a cusp or a discontinuity no step is narrow enough. 1e-6 rad leaves 1e-13 m on a radius of 1
// m.
constexpr double narrowest_step = 1e-6;
// Angles closer than this part of the motion coincide.
constexpr double same_place = 1e-9;

double distance_to_chord(const Eigen::Vector3d& point, const Eigen::Vector3d& from,
                         const Eigen::Vector3d& to) {
    const Eigen::Vector3d chord = to - from;
    const double squared = chord.squaredNorm();
    const double along = squared > 0.0 ? std::clamp((point - from).dot(chord) / squared, 0.0, 1.0) : 0.0;
    return (point - from - along * chord).norm();
}

class Sampler {
 public:
    Sampler(const DrivenMechanism& cam, const Motion& motion, const MotionScale& scale, int station)
        : cam_(cam), motion_(motion), scale_(scale), station_(station) {}

    [[nodiscard]] std::vector<MechanismPoint> points(const ProfileSampling& sampling) const {
        const std::vector<double> breakpoints = motion_.breakpoints();
        std::vector<MechanismPoint> points;
        if (sampling.count) {
            for (const double place : even_places(breakpoints, *sampling.count)) points.push_back(at(place));
            return points;
        }
        points.push_back(at(breakpoints.front()));
        for (std::size_t i = 1; i < breakpoints.size(); ++i)
            append(breakpoints[i - 1], breakpoints[i], sampling.chord_tolerance, points);
        return points;
    }

 private:
    struct Step {
        double from = 0.0, to = 0.0;
        Eigen::Vector3d start;
    };

    [[nodiscard]] MechanismPoint at(double x) const {
        const Side side = x < motion_.end() ? Side::right : Side::left;
        const double theta = scale_.unit_angle * x;
        const FollowerState state = state_of(motion_.at(x, side), scale_);
        return cam_.formulas->point(theta, {cam_.dimensions, state, theta}, station_);
    }

    /// Appends the points after `from` up to and including `to`, so dense that the chords satisfy the
    /// tolerance.
    void append(double from, double to, double tolerance, std::vector<MechanismPoint>& points) const {
        const double width = std::abs(scale_.unit_angle) * (to - from);
        const int steps = std::max(1, static_cast<int>(std::ceil(width / widest_step)));
        for (int i = 0; i < steps; ++i) {
            const double begin = from + (to - from) * i / steps;
            const double end = i + 1 < steps ? from + (to - from) * (i + 1) / steps : to;
            append_step({begin, end, points.back().contact}, at(end), tolerance, points);
        }
    }

    void append_step(const Step& step, const MechanismPoint& end, double tolerance,
                     std::vector<MechanismPoint>& points) const {
        std::array<MechanismPoint, parts_of_step - 1> inner;
        bool close = true;
        for (int i = 1; i < parts_of_step; ++i) {
            MechanismPoint& point = inner[static_cast<std::size_t>(i - 1)];
            point = at(step.from + (step.to - step.from) * i / parts_of_step);
            close =
                close && distance_to_chord(point.contact, step.start, end.contact) <= seen_share * tolerance;
        }
        const bool narrow = std::abs(scale_.unit_angle) * (step.to - step.from) < 2.0 * narrowest_step;
        if (narrow || close) {
            points.push_back(end);
            return;
        }
        const double middle = 0.5 * (step.from + step.to);
        const MechanismPoint& halfway = inner[parts_of_step / 2 - 1];
        append_step({step.from, middle, step.start}, halfway, tolerance, points);
        append_step({middle, step.to, halfway.contact}, end, tolerance, points);
    }

    const DrivenMechanism& cam_;
    const Motion& motion_;
    MotionScale scale_;
    int station_;
};

}  // namespace

FollowerState state_of(const MotionPoint& point, const MotionScale& scale) {
    const double rate = scale.lift / scale.unit_angle;
    return {scale.lift * point.derivative[0], rate * point.derivative[1],
            rate / scale.unit_angle * point.derivative[2]};
}

std::vector<double> even_places(const std::vector<double>& breakpoints, int count) {
    if (count < 2) throw InputError(fmt::format("count: found {}; allowed: at least 2", count));
    const double begin = breakpoints.front(), length = breakpoints.back() - begin;
    std::vector<double> places = breakpoints;
    for (int i = 1; i + 1 < count; ++i) {
        const double place = begin + length * i / (count - 1);
        const auto next = std::ranges::lower_bound(breakpoints, place);
        const double gap = std::min(*next - place, place - *std::prev(next));
        if (gap > same_place * length) places.push_back(place);
    }
    std::ranges::sort(places);
    return places;
}

std::vector<MechanismPoint> sampled_profile(const DrivenMechanism& cam, const Motion& motion,
                                            const MotionScale& scale, const ProfileSampling& sampling,
                                            int station) {
    if (!sampling.count && !(sampling.chord_tolerance > 0.0))
        throw InputError(
            fmt::format("chord_tolerance: found {}; allowed: above 0", sampling.chord_tolerance));
    return Sampler(cam, motion, scale, station).points(sampling);
}

}  // namespace camopt
