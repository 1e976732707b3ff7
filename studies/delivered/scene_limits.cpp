// SPDX-License-Identifier: MIT
#include "studies/delivered/scene_limits.hpp"

#include "scene/limit_table.hpp"
#include "studies/delivered/limit_activity.hpp"
#include "studies/delivered/set_point_reports.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace camopt {

namespace {

// A limit that is just reached is kept: figures agree to rounding only. Relative; of exact points absolute,
// in lifts.
constexpr double just_reached = 1e-7;
constexpr int symmetry_samples = 64;  // between two breakpoints

void add_peak_limit(std::vector<LimitOutcome>& all, const PeakLimitRow& row, const Scene& scene,
                    const MotionFigures& figures) {
    const std::optional<PeakLimit>& limit = row.in(scene.limits);
    if (!limit) return;
    const Extremum& found =
        derivative_peak(limit->in_time() ? figures.motion_peaks : figures.peaks, row.order());
    all.push_back(outcome_of(scene, nullptr,
                             {row.name(), limit->key, limit->given,
                              found.value * limit->unit_per_normalised(), limit->unit, found.at}));
}

/// A value that must be `wanted`, found to be `found` at x.
LimitOutcome exact_point(std::string name, std::string key, double wanted, double found, double x) {
    const double distance = std::abs(found - wanted);
    const double size = std::max(1.0, std::abs(wanted));
    return {{std::move(name), std::move(key), wanted, found, "", x, true},
            distance <= just_reached * size,
            distance,
            size,
            true};
}

void add_set_points(std::vector<LimitOutcome>& all, const Scene& scene, const Motion& motion) {
    for (SetPointReport& report : set_point_reports(scene.motion, scene.spline.degree, motion)) {
        const bool kept = report.distance <= just_reached * std::max(1.0, report.size);
        const double off = std::abs(report.found - report.wanted);  // as it was written
        all.push_back({{set_point_name(report.order), std::move(report.key), report.wanted, report.found,
                        std::move(report.unit), report.at, true},
                       kept,
                       off,
                       std::max(std::abs(report.wanted), off),
                       true});
    }
}

void add_symmetry(std::vector<LimitOutcome>& all, const Scene& scene, const Motion& motion) {
    if (!scene.motion.symmetric) return;
    const bool rise = scene.motion.type == MotionType::drd;
    double worst = 0.0, at = 0.0;
    const std::vector<double> points = motion.breakpoints();
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        for (int k = 0; k <= symmetry_samples; ++k) {
            const double x = points[i] + (points[i + 1] - points[i]) * k / symmetry_samples;
            const double here = motion.at(x).derivative[0];
            const double there = motion.at(motion.end() - x).derivative[0];
            const double off = std::abs(rise ? here + there - 1.0 : here - there);
            if (off > worst) {
                worst = off;
                at = x;
            }
        }
    }
    all.push_back(exact_point("symmetric", "motion.symmetric", 0.0, worst, at));
}

void add_end_jerk(std::vector<LimitOutcome>& all, const Scene& scene, const MotionChain& motion) {
    if (scene.spline.end_jerk != EndJerk::zero) return;
    double worst = 0.0, at = motion.begin();
    for (const auto& [x, side] : quiet_places(scene, motion)) {
        const double jerk = std::abs(motion.at(x, side).derivative[3]);
        if (jerk <= worst) continue;
        worst = jerk;
        at = x;
    }
    all.push_back(exact_point("end_jerk", "spline.end_jerk", 0.0, worst, at));
}

}  // namespace

std::vector<std::pair<double, Side>> quiet_places(const Scene& scene, const MotionChain& motion) {
    if (scene.motion.type != MotionType::program)
        return {{motion.begin(), Side::right}, {motion.end(), Side::left}};
    std::vector<std::pair<double, Side>> places;
    const std::vector<ProgramSegment>& segments = scene.motion.segments;
    const std::size_t count = segments.size();
    const auto dwells = [&](std::size_t i) { return segments[i % count].kind == SegmentKind::dwell; };
    for (std::size_t i = 0; i < count; ++i) {
        if (segments[i].kind != SegmentKind::spline) continue;
        const ChainPart& part = motion.parts()[i];
        const bool inner_begin = i > 0 || scene.motion.closed;
        const bool inner_end = i + 1 < count || scene.motion.closed;
        if (inner_begin && dwells(i + count - 1)) places.emplace_back(part.begin, Side::right);
        if (inner_end && dwells(i + 1)) places.emplace_back(part.end, Side::left);
    }
    return places;
}

LimitOutcome outcome_of(const Scene& scene, const CamReport* cam, const ConstraintReport& reached) {
    const double excess = limit_excess(reached), scale = limit_scale(scene, cam, reached);
    return {reached, excess <= std::max(just_reached, 10.0 * scene.solver.tolerance) * scale, excess, scale};
}

std::vector<LimitOutcome> motion_limits(const Scene& scene, const MotionFigures& figures) {
    std::vector<LimitOutcome> all;
    for (const PeakLimitRow& row : peak_limit_rows()) add_peak_limit(all, row, scene, figures);
    add_set_points(all, scene, figures.motion);
    add_symmetry(all, scene, figures.motion);
    add_end_jerk(all, scene, figures.motion);
    return all;
}

}  // namespace camopt
