// SPDX-License-Identifier: MIT
#include "output/words/motion_extremes.hpp"

#include "core/peak_figures.hpp"
#include "output/words/angle_words.hpp"
#include "output/words/shown_units.hpp"
#include "profiles/scene_cam.hpp"
#include "studies/delivered/extremes_along.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace camopt {

namespace {

// Of the peak of a derivative: less to the other side is rounding.
constexpr double no_motion = 1e-9;
// In lifts: a stroke whose range the solver keeps to its tolerance does not leave it.
constexpr double no_excursion = 1e-6;

/// The breakpoints from begin to end, both included.
std::vector<double> breakpoints_between(const Motion& motion, double begin, double end) {
    std::vector<double> points = {begin};
    for (const double point : motion.breakpoints())
        if (point > begin && point < end) points.push_back(point);
    points.push_back(end);
    return points;
}

void add_excursions(std::vector<Excursion>& all, const Motion& motion, const Excursion& stroke, double begin,
                    double end) {
    const std::vector<double> places = breakpoints_between(motion, begin, end);
    const FigureAlong displacement = [&](double x, Side side) { return motion.at(x, side).derivative[0]; };
    for (const bool below : {true, false}) {
        const CamExtreme found =
            below ? least_along(places, displacement) : largest_along(places, displacement);
        Excursion one = stroke;
        one.beyond = below ? stroke.low - found.value : found.value - stroke.high;
        if (!(one.beyond > no_excursion)) continue;
        one.below = below;
        one.farthest = {found.value, found.at, Side::right};
        all.push_back(one);
    }
}

}  // namespace

SignedPeaks signed_peaks(const Solution& solution, int order) {
    const Motion& motion = *solution.motion;
    const auto index = static_cast<std::size_t>(order);
    SignedPeaks peaks{derivative_peak(solution.motion_peaks, order), {}};
    Extremum& largest = peaks.largest;
    const double there = motion.at(largest.at, largest.side).derivative[index];
    if (!std::isfinite(largest.value)) return peaks;
    largest.value = std::copysign(largest.value, there);
    const double sign = there < 0.0 ? 1.0 : -1.0;
    const CamExtreme found = largest_along(motion.breakpoints(), [&](double x, Side side) {
        return sign * motion.at(x, side).derivative[index];
    });
    if (found.value > no_motion * std::abs(largest.value))
        peaks.opposite = Extremum{sign * found.value, found.at, Side::right};
    return peaks;
}

std::vector<Excursion> excursions(const Solution& solution) {
    std::vector<Excursion> all;
    if (!solution.motion) return all;
    const Motion& motion = *solution.motion;
    if (solution.scene.motion.type != MotionType::program) {
        add_excursions(all, motion, {{}, 0.0, false, -1, 0.0, 1.0}, motion.begin(), motion.end());
        return all;
    }
    for (std::size_t i = 0; i < solution.segments.size(); ++i) {
        const SegmentReport& segment = solution.segments[i];
        if (segment.kind != SegmentKind::spline) continue;
        const auto [low, high] = std::minmax(segment.from, segment.to);
        add_excursions(all, motion, {{}, 0.0, false, static_cast<int>(i), low, high}, segment.begin,
                       segment.end);
    }
    return all;
}

std::string excursion_text(const Solution& solution, const Excursion& excursion) {
    return shown_units(solution.scene).motion[0].first.normalised_text(excursion.farthest.value);
}

std::vector<std::string> excursion_sentences(const Solution& solution) {
    const MotionUnit unit = shown_units(solution.scene).motion[0].first;
    const char* const mover = has_cam(solution.scene) ? "follower" : "output";
    std::vector<std::string> sentences;
    for (const Excursion& one : excursions(solution)) {
        const std::string beyond = fmt::format("The {} goes {} {}", mover, unit.normalised_text(one.beyond),
                                               one.below ? "below" : "above");
        const std::string range =
            one.segment < 0
                ? std::string(one.below ? "its start" : "its top")
                : fmt::format("the stroke of segment {} ({} to {})", one.segment + 1,
                              short_text(unit.per_normalised * one.low), unit.normalised_text(one.high));
        sentences.push_back(
            fmt::format("{} {} at {} deg.", beyond, range, degrees_at(solution, one.farthest.at)));
    }
    return sentences;
}

}  // namespace camopt
