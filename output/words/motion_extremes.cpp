// SPDX-License-Identifier: MIT
#include "output/words/motion_extremes.hpp"

#include "core/numbers/sampled_maximum.hpp"
#include "core/peak_figures.hpp"
#include "output/words/angle_words.hpp"
#include "output/words/shown_units.hpp"
#include "profiles/scene_cam.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace camopt {

namespace {

// Of the peak of a derivative: less to the other side is rounding.
constexpr double no_motion = 1e-9;
// In lifts: a stroke whose range the solver keeps to its tolerance does not leave it.
constexpr double no_excursion = 1e-6;

void add_excursions(std::vector<Excursion>& all, const Motion& motion, Excursion stroke, double begin,
                    double end) {
    std::vector<double> places = motion.breakpoints();
    std::erase_if(places, [&](double x) { return x < begin || x > end; });
    const FigureAlong displacement = [&](double x, Side side) { return motion.at(x, side).derivative[0]; };
    for (const Extremum& found : {least_along(places, displacement), largest_along(places, displacement)}) {
        stroke.farthest = {found.value, found.at, Side::right};
        stroke.beyond = std::max(stroke.low - found.value, found.value - stroke.high);
        if (stroke.beyond > no_excursion) all.push_back(stroke);
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
    const Extremum found = largest_along(motion.breakpoints(), [&](double x, Side side) {
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
    if (solution.segments.empty()) add_excursions(all, motion, {}, motion.begin(), motion.end());
    for (int i = 0; i < static_cast<int>(solution.segments.size()); ++i) {
        const SegmentReport& segment = solution.segments[static_cast<std::size_t>(i)];
        const auto [low, high] = std::minmax(segment.from, segment.to);
        if (segment.kind == SegmentKind::spline)
            add_excursions(all, motion, {low, high, i}, segment.begin, segment.end);
    }
    return all;
}

std::vector<std::string> excursion_sentences(const Solution& solution) {
    const MotionUnit unit = shown_units(solution.scene).motion[0].first;
    std::vector<std::string> sentences;
    for (const Excursion& one : excursions(solution)) {
        std::string range = one.below() ? "its start" : "its top";
        if (one.segment >= 0)
            range = fmt::format("the stroke of segment {} ({} to {})", one.segment + 1,
                                short_text(unit.per_normalised * one.low), unit.normalised_text(one.high));
        sentences.push_back(fmt::format("The {} goes {} {} {} at {} deg.",
                                        has_cam(solution.scene) ? "follower" : "output",
                                        unit.normalised_text(one.beyond), one.below() ? "below" : "above",
                                        range, degrees_at(solution, one.farthest.at)));
    }
    return sentences;
}

}  // namespace camopt
