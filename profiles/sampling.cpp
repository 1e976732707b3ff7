// SPDX-License-Identifier: MIT
#include "profiles/sampling.hpp"

#include "core/errors.hpp"

#include <fmt/format.h>

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
    Sampler(const CamPointAt& at, double unit_angle, double tolerance)
        : at_(at), unit_angle_(std::abs(unit_angle)), tolerance_(tolerance) {}

    [[nodiscard]] std::vector<double> places(const std::vector<double>& breakpoints) {
        places_ = {breakpoints.front()};
        for (std::size_t i = 1; i < breakpoints.size(); ++i) append(breakpoints[i - 1], breakpoints[i]);
        return std::move(places_);
    }

 private:
    using Point = Eigen::Vector3d;

    /// Appends the places after `from` up to and including `to`, so dense that the chords satisfy the
    /// tolerance.
    void append(double from, double to) {
        const int steps = std::max(1, static_cast<int>(std::ceil(unit_angle_ * (to - from) / widest_step)));
        for (int i = 0; i < steps; ++i) {
            const double begin = from + (to - from) * i / steps;
            const double end = i + 1 < steps ? from + (to - from) * (i + 1) / steps : to;
            append_step(begin, end, at_(begin).contact, at_(end).contact);
        }
    }

    void append_step(double from, double to, const Point& start, const Point& end) {
        std::array<Point, parts_of_step - 1> inner;
        bool close = true;
        for (int i = 1; i < parts_of_step; ++i) {
            Point& point = inner[static_cast<std::size_t>(i - 1)];
            point = at_(from + (to - from) * i / parts_of_step).contact;
            close = close && distance_to_chord(point, start, end) <= seen_share * tolerance_;
        }
        if (close || unit_angle_ * (to - from) < 2.0 * narrowest_step) {
            places_.push_back(to);
            return;
        }
        const double middle = 0.5 * (from + to);
        const Point& halfway = inner[parts_of_step / 2 - 1];
        append_step(from, middle, start, halfway);
        append_step(middle, to, halfway, end);
    }

    const CamPointAt& at_;
    double unit_angle_, tolerance_;
    std::vector<double> places_;
};

}  // namespace

FollowerState state_of(const MotionPoint& point, const MotionScale& scale) {
    const double rate = scale.lift / scale.unit_angle;
    return {scale.lift * point.derivative[0], rate * point.derivative[1],
            rate / scale.unit_angle * point.derivative[2]};
}

MotionPoint motion_at(const Motion& motion, double x) {
    return motion.at(x, x < motion.end() ? Side::right : Side::left);
}

MechanismPoint mechanism_point(const DrivenMechanism& mechanism, const MotionPoint& motion,
                               const MotionScale& scale, int station) {
    const double theta = scale.unit_angle * motion.x;
    return mechanism.formulas->point(theta, {mechanism.dimensions, state_of(motion, scale), theta}, station);
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

std::vector<double> profile_places(const CamPointAt& at, const std::vector<double>& breakpoints,
                                   double unit_angle, const ProfileSampling& sampling) {
    if (sampling.count) return even_places(breakpoints, *sampling.count);
    if (!(sampling.chord_tolerance > 0.0))
        throw InputError(
            fmt::format("chord_tolerance: found {}; allowed: above 0", sampling.chord_tolerance));
    return Sampler(at, unit_angle, sampling.chord_tolerance).places(breakpoints);
}

std::vector<MechanismPoint> sampled_profile(const DrivenMechanism& cam, const Motion& motion,
                                            const MotionScale& scale, const ProfileSampling& sampling,
                                            int station) {
    const CamPointAt at = [&](double x) {
        return mechanism_point(cam, motion_at(motion, x), scale, station);
    };
    std::vector<MechanismPoint> points;
    for (const double x : profile_places(at, motion.breakpoints(), scale.unit_angle, sampling))
        points.push_back(at(x));
    return points;
}

}  // namespace camopt
