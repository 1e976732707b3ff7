// SPDX-License-Identifier: MIT
#include "studies/delivered/scene_limits.hpp"

#include "objectives/drive_rules.hpp"
#include "objectives/motion_bounds.hpp"
#include "objectives/rules/maxima/rule_maxima.hpp"
#include "objectives/scene_family.hpp"
#include "objectives/spring_rules.hpp"
#include "objectives/strokes.hpp"
#include "scene/limit_table.hpp"
#include "studies/delivered/solution_parts.hpp"

#include <fmt/format.h>

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
        derivative_peak(limit->physical() ? figures.motion_peaks : figures.peaks, row.order());
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

/// The states that a motion starts and ends with, where they are not rest.
void add_ends(std::vector<LimitOutcome>& all, const Scene& scene, const Motion& motion) {
    if (scene.motion.periodic()) return;
    for (const bool at_end : {false, true}) {
        const std::array<double, 2> state = end_velocities(scene.motion, at_end);
        if (state == std::array<double, 2>{}) continue;
        const double x = at_end ? motion.end() : motion.begin();
        const MotionPoint found = motion.at(x, at_end ? Side::left : Side::right);
        const std::string name = at_end ? "end" : "start";
        all.push_back(exact_point(name + "_velocity", "motion." + name, state[0], found.derivative[1], x));
        all.push_back(
            exact_point(name + "_acceleration", "motion." + name, state[1], found.derivative[2], x));
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

void add_rest(std::vector<LimitOutcome>& all, const Scene& scene, const MotionChain& motion) {
    const std::vector<RestFigure> figures = rest_figures(scene, motion);
    if (figures.empty()) return;
    // One key of the scene, one outcome: of the order that is farthest from 0 for its size.
    const RestFigure& rest = *std::ranges::max_element(
        figures, {}, [](const RestFigure& figure) { return figure.worst / figure.size; });
    const bool of_jerk = scene.rest_order() == 3;
    all.push_back({{of_jerk ? "end_jerk" : fmt::format("rest_{}", rest.order),
                    of_jerk ? "spline.end_jerk" : "spline.rest", 0.0, rest.worst, "", rest.at, true},
                   rest.worst <= just_reached * rest.size,
                   rest.worst,
                   rest.size,
                   true});
}

double finite_size(double value) {
    return std::isfinite(value) ? std::abs(value) : 0.0;
}

}  // namespace

namespace {

/// x and side of every place where spline.rest holds: the ends, of a program where a spline meets a dwell or
/// an open end.
std::vector<std::pair<double, Side>> quiet_places(const Scene& scene, const MotionChain& motion) {
    if (scene.motion.type != MotionType::program)
        return {{motion.begin(), Side::right}, {motion.end(), Side::left}};
    std::vector<std::pair<double, Side>> places;
    for (int i = 0; i < static_cast<int>(scene.motion.segments.size()); ++i) {
        if (scene.motion.segments[static_cast<std::size_t>(i)].kind != SegmentKind::spline) continue;
        const ChainPart& part = motion.parts()[static_cast<std::size_t>(i)];
        if (meets_rest(scene.motion, i, false)) places.emplace_back(part.begin, Side::right);
        if (meets_rest(scene.motion, i, true)) places.emplace_back(part.end, Side::left);
    }
    return places;
}

}  // namespace

std::vector<RestFigure> rest_figures(const Scene& scene, const MotionChain& motion) {
    std::vector<RestFigure> figures;
    for (int order = 3; order <= scene.rest_order(); ++order) {
        RestFigure figure{order, 0.0, motion.begin(), 1.0};
        for (const ChainPart& part : motion.parts())
            if (const auto* const curve = dynamic_cast<const SplineCurve*>(part.shape.get()))
                figure.size = std::max(figure.size, peak_of(*curve, order).value);
        for (const auto& [x, side] : quiet_places(scene, motion)) {
            const double found = std::abs(motion.higher_derivative(x, order, side));
            if (std::isnan(figure.worst) || found <= figure.worst) continue;
            figure.worst = found;
            figure.at = x;
        }
        figures.push_back(figure);
    }
    return figures;
}

LimitOutcome outcome_of(const Scene& scene, const CamReport* cam, const ConstraintReport& reached) {
    const double excess = limit_excess(reached), scale = limit_scale(scene, cam, reached);
    return {reached, excess <= std::max(just_reached, 10.0 * scene.solver.tolerance) * scale, excess, scale};
}

std::vector<ConstraintReport> bound_reports(const Scene& scene, const Motion& motion, const Motion& cam) {
    std::vector<ConstraintReport> all;
    double nearest = 0.0;  // of the bounds with one key: how far the motion exceeds it, by its scale
    const auto seen = [&](SeenMotion which, const WrittenBound& bound) {
        if (which == SeenMotion::output || !scene.prescribes_output()) return extreme_of(bound, motion);
        if (which == SeenMotion::cam) return extreme_of(bound, cam);
        return extreme_of(bound, combined(dynamic_cast<const MotionChain&>(motion), torque_of_output(scene)));
    };
    for (const WrittenBound& bound : motion_bounds(scene)) {
        const Extremum worst = seen(bound.seen, bound);
        const double excess = (worst.value - bound.bound) / bound.scale;
        const bool same = !all.empty() && all.back().key == bound.key;
        if (same && excess <= nearest) continue;
        nearest = excess;
        if (same) all.pop_back();
        const double shown = bound.magnitude ? std::abs(worst.value) : bound.sign * worst.value;
        all.push_back({bound.name, bound.key, bound.given, shown * bound.per_normalised, bound.unit, worst.at,
                       false, true});
        all.back().scale = bound.scale * bound.per_normalised;
    }
    if (const auto& limit = scene.limits.motor_torque_rms)
        all.push_back({limit_row(LimitedFigure::motor_torque_rms).name, limit->key, limit->given(),
                       drive_figures(scene, motion).rms_torque / limit->unit_value, limit->unit,
                       motion.begin(), false, true});
    if (const auto& limit = scene.limits.spring_harmonic) {
        const auto [first, last] = limited_harmonics(scene);
        double largest = 0.0;
        for (int order = first; order <= last; ++order)
            largest = std::max(largest, harmonic_amplitude(scene.motion, cam, order));
        all.push_back({"spring_harmonic", limit->key, limit->given(),
                       largest * scene.motion.lift / limit->unit_value, limit->unit, motion.begin(), false,
                       true});
    }
    return all;
}

std::vector<LimitOutcome> motion_limits(const Scene& scene, const MotionFigures& figures) {
    std::vector<LimitOutcome> all;
    for (const PeakLimitRow& row : peak_limit_rows())
        if (row.on_peak()) add_peak_limit(all, row, scene, figures);
    for (const ConstraintReport& reached : bound_reports(scene, figures.motion, figures.motion))
        all.push_back(outcome_of(scene, nullptr, reached));
    add_set_points(all, scene, figures.motion);
    add_ends(all, scene, figures.motion);
    add_symmetry(all, scene, figures.motion);
    add_rest(all, scene, figures.motion);
    return all;
}

double quantity_size(const Scene& scene, const CamReport* cam, const LimitRow& row) {
    using enum LimitRow::Size;
    if (row.needs_dynamics && scene.dynamics && row.size == one)  // the springs at the lift
        return scene.dynamics->preload + scene.dynamics->return_stiffness * scene.motion.lift;
    if (row.size == one) return 1.0;
    if (cam != nullptr && row.size == base_radius) return finite_size(cam->summary.base_radius);
    if (cam == nullptr || row.size != largest_force || !cam->summary.forces) return 0.0;
    const ForceSummary& forces = *cam->summary.forces;
    return std::max(finite_size(forces.largest_force.value), finite_size(forces.least_force.value));
}

double limit_scale(const Scene& scene, const CamReport* cam, const ConstraintReport& report) {
    for (const OwnLimit& limit : scene.own_limits)
        if (limit.key() == report.key) return limit.scale();
    const double size = std::max(finite_size(report.limit), report.scale);
    const LimitRow* const row = limit_named(report.name);
    const bool given = row != nullptr && row->in(scene.limits).has_value();
    const double own = given ? quantity_size(scene, cam, *row) / row->in(scene.limits)->unit_value : 0.0;
    return std::max(size, own > 0.0 ? own : finite_size(report.worst));
}

double limit_excess(const ConstraintReport& report) {
    return is_least_limit(report.name) ? report.limit - report.held() : report.held() - report.limit;
}

bool is_nowhere(const ConstraintReport& report) {
    return std::isinf(report.worst) && report.worst > 0.0 && is_least_limit(report.name);
}

void judge_activity(Solution& solution) {
    const CamReport* const cam = solution.cam ? &*solution.cam : nullptr;
    for (ConstraintReport& report : solution.constraints)
        report.active = limit_excess(report) >= -active_limit * limit_scale(solution.scene, cam, report);
}

}  // namespace camopt
