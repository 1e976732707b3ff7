// SPDX-License-Identifier: MIT
#include "report/view/peak_comparison.hpp"

#include "motions/laws/law_catalogue.hpp"
#include "objectives/scene_model.hpp"
#include "report/view/cam_words.hpp"
#include "scene/limit_table.hpp"
#include "scene/motion/set_points.hpp"
#include "scene/part_names.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

/// The law's own peak where there is a law, else the number the objective divides by (0: not in use).
std::optional<double> reference_value(const ReferenceMotion& reference, double of_law, double divisor) {
    if (!reference.title.empty()) return of_law;
    if (divisor > 0.0) return divisor;
    return std::nullopt;
}

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

std::vector<PeakRow> peak_comparison(const Solution& solution, const ReferenceMotion& reference) {
    const Peaks& peaks = solution.peaks;
    const Peaks& motion = solution.motion_peaks;
    const Peaks& law = reference.peaks;
    const Peaks& divisor = solution.reference_peaks;
    const LimitCurve limit = solution.any_curve_limit.value_or(LimitCurve{});
    const ShownUnits shown = shown_units(solution.scene);
    return {
        {"velocity", "V", peaks.velocity, motion.velocity,
         reference_value(reference, law.velocity.value, divisor.velocity.value), limit.velocity,
         shown.motion[1], signed_peaks(solution, 1)},
        {"acceleration", "A", peaks.acceleration, motion.acceleration,
         reference_value(reference, law.acceleration.value, divisor.acceleration.value), limit.acceleration,
         shown.motion[2], signed_peaks(solution, 2)},
        {"jerk", "J", peaks.jerk, motion.jerk, reference_value(reference, law.jerk.value, divisor.jerk.value),
         limit.jerk, shown.motion[3], signed_peaks(solution, 3)},
        {"inertia torque", "Q", peaks.torque, motion.torque,
         reference_value(reference, law.torque.value, divisor.torque.value), std::nullopt, std::nullopt},
    };
}

std::string left_out_of_any_curve(const Scene& scene) {
    const bool cam = limits_cam(scene.limits) || (scene.cam && scene.cam->face_half_width);
    std::string text = cam ? "limits of the cam" : "";
    if (!placed_points(scene.motion).empty()) text += text.empty() ? "via points" : " and via points";
    return text.empty() ? text : fmt::format(" ({} left out)", text);
}

std::string reference_title(const ReferenceMotion& reference) {
    return reference.title.empty() ? "reference" : reference.title;
}

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
    // The motion of a given cam is what it is: there is no optimizer that could keep it within its strokes.
    if (!solution.motion || solution.scene.is_given()) return all;
    const Motion& motion = *solution.motion;
    if (solution.segments.empty()) add_excursions(all, motion, {}, motion.begin(), motion.end());
    for (int i = 0; i < static_cast<int>(solution.segments.size()); ++i) {
        const SegmentReport& segment = solution.segments[i];
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
            range = fmt::format("the stroke of {} ({} to {})",
                                segment_words(static_cast<std::size_t>(one.segment)),
                                short_text(unit.per_normalised * one.low), unit.normalised_text(one.high));
        sentences.push_back(fmt::format("The {} goes {} {} {} at {} deg.",
                                        solution.scene.cam.has_value() ? "follower" : "output",
                                        unit.normalised_text(one.beyond), one.below() ? "below" : "above",
                                        range, degrees_at(solution, one.farthest.at)));
    }
    return sentences;
}

ReferenceMotion reference_motion(const Scene& scene) {
    ReferenceMotion reference;
    if (scene.objective.reference.numeric) return reference;
    std::unique_ptr<Law> law = make_law(scene.objective.reference.law);
    reference.title = words_of(law->key());
    reference.peaks = law->peaks();
    if (scene.motion.type == MotionType::rr) {
        const LawMotion placed = law_motion(strokes_of(scene.motion), false, std::move(law));
        reference.motion = std::make_unique<MotionChain>(*placed.motion);
        reference.peaks = placed.peaks;
    } else if (scene.motion.type == MotionType::drd) {
        reference.motion = std::move(law);
    }
    return reference;
}

}  // namespace camopt
