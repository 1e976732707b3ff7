// SPDX-License-Identifier: MIT
#include "studies/delivered/solution_report.hpp"

#include "core/units.hpp"
#include "motions/laws/law_catalogue.hpp"
#include "objectives/rules/cam_limits.hpp"
#include "scene/limit_table.hpp"
#include "splines/extrema.hpp"
#include "studies/compare/peak_arithmetic.hpp"
#include "studies/delivered/mechanism_report.hpp"
#include "studies/delivered/own_report.hpp"
#include "studies/explain/smallest_of_any_motion.hpp"

#include <algorithm>
#include <cmath>

namespace camopt {

namespace {

// Rows of a proof that carry less than this part of its weight do not explain anything.
constexpr double telling_weight = 1e-3;
// A derivative that jumps by less than this part of the motion's peak is continuous.
constexpr double same_derivative = 1e-7;

void report_peak_limit(Solution& solution, const char* name, const std::optional<PeakLimit>& limit,
                       const Extremum& peak) {
    if (!limit) return;
    const double unit = limit->unit_per_normalised();
    solution.constraints.push_back({name, limit->key, limit->given, peak.value * unit, limit->unit, peak.at,
                                    peak.value >= limit->normalised * (1.0 - active_limit)});
}

/// The highest derivative that is continuous at x, to rounding.
int continuity_at(const Motion& motion, double left_x, double right_x) {
    const MotionPoint left = motion.at(left_x, Side::left);
    const MotionPoint right = motion.at(right_x, Side::right);
    int order = -1;
    while (order < 3) {
        const double jump = std::abs(left.derivative[order + 1] - right.derivative[order + 1]);
        const double size = std::max({1.0, std::abs(left.derivative[order + 1])});
        if (jump > same_derivative * size) break;
        ++order;
    }
    return order;
}

/// Peaks of a law that takes `width` of x and `rise` lifts, in units of the whole motion.
Peaks peaks_of_law(const std::string& key, double begin, double width, double rise) {
    Peaks peaks = scaled_peaks(make_law(key)->peaks(), std::abs(rise), width);
    for (const auto peak : {&Peaks::velocity, &Peaks::acceleration, &Peaks::jerk, &Peaks::torque}) {
        (peaks.*peak).at = begin + width * (peaks.*peak).at;
    }
    return peaks;
}

SplineCurve curve_of(const ChainPart& part) {
    return part_of_run(dynamic_cast<const SplineCurve&>(*part.shape), part.begin, part.end, -part.x0);
}

void report_segments(Solution& solution) {
    const MotionChain& motion = *solution.motion;
    JoinedMeans means;
    for (std::size_t s = 0; s < motion.parts().size(); ++s) {
        const ChainPart& part = motion.parts()[s];
        const ProgramSegment& written = solution.scene.motion.segments[s];
        SegmentReport report{written.kind,
                             written.law,
                             part.begin,
                             part.end,
                             motion.at(part.begin, Side::right).derivative[0],
                             motion.at(part.end, Side::left).derivative[0],
                             {},
                             {},
                             0};
        const bool first = s == 0;
        report.continuity = first && !solution.scene.motion.closed
                                ? -1
                                : continuity_at(motion, first ? motion.end() : part.begin, part.begin);
        if (written.kind == SegmentKind::spline) {
            report.curve = curve_of(part);
            const Peaks own = peaks_of(*report.curve);
            report.peaks = normalised_peaks(
                own, {part.end - part.begin, measured_displacement(report.to - report.from)});
            raise_peaks(solution.peaks, *report.peaks);
            raise_peaks(solution.motion_peaks, own);
            means.add(*report.peaks, part.end - part.begin);
        }
        if (written.kind == SegmentKind::law) {
            raise_peaks(
                solution.motion_peaks,
                peaks_of_law(written.law, report.begin, report.end - report.begin, report.to - report.from));
        }
        solution.segments.push_back(std::move(report));
    }
    means.set(solution.peaks);
}

void report_peak_limits(Solution& solution) {
    for (const PeakLimitRow& row : peak_limit_rows()) {
        const std::optional<PeakLimit>& limit = row.in(solution.scene.limits);
        const bool in_time = limit && limit->in_time();
        report_peak_limit(solution, row.name(), limit,
                          derivative_peak(in_time ? solution.motion_peaks : solution.peaks, row.order()));
    }
}

void report_cam(Solution& solution, Delivered&& delivered) {
    if (delivered.mechanism) {
        solution.mechanism =
            mechanism_report(solution.scene, std::move(*delivered.mechanism), *solution.motion);
        const auto limits = mechanism_constraints(solution.scene, *solution.mechanism);
        solution.constraints.insert(solution.constraints.end(), limits.begin(), limits.end());
    }
    if (!delivered.cam) return;
    solution.cam = cam_report(solution.scene, *delivered.cam, *solution.motion);
    const std::vector<ConstraintReport> constraints = cam_constraints(solution.scene, *solution.cam);
    solution.constraints.insert(solution.constraints.end(), constraints.begin(), constraints.end());
}

/// The key without its unit: "limits.pressure_angle_deg" → "pressure_angle".
std::string plain_name(const std::string& key) {
    const char* const name = limit_name_in(key);
    return name != nullptr ? name : key;
}

const CamExtreme& larger(const CamExtreme& one, const CamExtreme& other) {
    return one.value >= other.value ? one : other;
}

/// What the general limit on the pressure angle speaks of: all, or the stroke that has none of its own, and
/// always where the follower rests.
CamExtreme general_pressure_angle(const LimitSpec& limits, const CamSummary& summary) {
    const bool rise = limit_on(limits, LimitedFigure::rise_pressure_angle).has_value();
    const bool back = limit_on(limits, LimitedFigure::return_pressure_angle).has_value();
    if (!rise && !back) return summary.pressure_angle;
    if (rise && back) return summary.rest_pressure_angle;
    return larger(rise ? summary.return_pressure_angle : summary.rise_pressure_angle,
                  summary.rest_pressure_angle);
}

/// None where the scene has nothing it could be computed from.
std::optional<CamExtreme> figure_of(LimitedFigure figure, const LimitSpec& limits,
                                    const CamSummary& summary) {
    const std::optional<ForceSummary>& forces = summary.forces;
    if (limit_row(figure).needs_forces && !forces) return std::nullopt;
    switch (figure) {
        case LimitedFigure::pressure_angle:
            return general_pressure_angle(limits, summary);
        case LimitedFigure::rise_pressure_angle:
            return larger(summary.rise_pressure_angle, summary.rest_pressure_angle);
        case LimitedFigure::return_pressure_angle:
            return larger(summary.return_pressure_angle, summary.rest_pressure_angle);
        case LimitedFigure::convex_radius:
            return summary.convex_radius;
        case LimitedFigure::concave_radius:
            return summary.concave_radius.value_or(CamExtreme{infinity, 0.0});
        case LimitedFigure::regularity:
            return summary.regularity;
        case LimitedFigure::contact_force:
            return forces->least_force;
        case LimitedFigure::torque:
            return forces->torque;
        case LimitedFigure::hertz_pressure:
            return forces->hertz_pressure;
    }
    return std::nullopt;
}

/// The limits that need forces, or those that do not.
void add_constraints(std::vector<ConstraintReport>& all, const Scene& scene, const CamSummary& summary,
                     bool of_forces) {
    for (const LimitRow& row : limit_rows()) {
        const auto& limit = row.in(scene.limits);
        if (!limit || row.needs_forces != of_forces) continue;
        const std::optional<CamExtreme> worst = figure_of(row.figure, scene.limits, summary);
        if (!worst) continue;
        all.push_back(limit_report(*limit, *worst, row.is_least() ? -1 : 1));
        if (row.needs_contact && summary.no_contact) all.back().worst = infinity;
        all.back().no_contact = summary.no_contact && std::isinf(all.back().worst) && !row.may_be_infinite;
    }
}

}  // namespace

SplineCurve part_of_run(const SplineCurve& run, double begin, double end, double shift) {
    const SplineSpace& space = run.space();
    const int first = space.segment_of(begin + shift, Side::right);
    const int last = space.segment_of(end + shift, Side::left);
    std::vector<double> breakpoints;
    for (int i = first; i <= last + 1; ++i) breakpoints.push_back(space.breakpoints()[i] - shift);
    breakpoints.front() = begin;  // there and back by the shift is not exact
    breakpoints.back() = end;
    return {SplineSpace(run.degree(), run.continuity(), std::move(breakpoints)),
            run.pieces().middleCols(first, last - first + 1)};
}

ConstraintReport limit_report(const WrittenLimit& limit, const CamExtreme& worst, int sign) {
    const double slack = sign * (limit.value - worst.value);
    const double size = std::max(std::abs(limit.value), std::abs(worst.value));
    return {plain_name(limit.key),          limit.key,  limit.given(),
            worst.value / limit.unit_value, limit.unit, worst.at,
            slack <= active_limit * size};
}

CamReport cam_report(const Scene& scene, const DiskCam& cam, const Motion& motion) {
    return {cam, cam_summary(cam, motion, scene), smallest_of_any_motion(scene, cam), {}};
}

std::vector<ConstraintReport> cam_constraints(const Scene& scene, const CamReport& report) {
    const CamSummary& summary = report.summary;
    std::vector<ConstraintReport> all;
    add_constraints(all, scene, summary, false);
    if (scene.cam->face_half_width) {
        const WrittenLimit width{*scene.cam->face_half_width, "cam.face_half_width_mm", units::millimetre,
                                 "mm"};
        all.push_back(limit_report(width, summary.contact_offset, 1));
        all.back().name = "face_half_width";
        all.back().no_contact = summary.no_contact && std::isinf(all.back().worst);
    }
    add_constraints(all, scene, summary, true);
    return all;
}

void report_delivered(Solution& solution, Delivered delivered) {
    solution.motion = std::move(delivered.motion);
    if (solution.scene.motion.type == MotionType::program) {
        report_segments(solution);
    } else {
        solution.curve = dynamic_cast<const SplineCurve&>(*solution.motion->parts().front().shape);
        solution.peaks = solution.motion_peaks = peaks_of(*solution.curve);
    }
    report_peak_limits(solution);
    report_cam(solution, std::move(delivered));
    solution.own_terms = own_term_reports(solution.scene, *solution.motion);
    const std::vector<ConstraintReport> own = own_constraints(solution.scene, *solution.motion);
    solution.constraints.insert(solution.constraints.end(), own.begin(), own.end());
}

void report_motion(Solution& solution, const CamProblem& problem, const Eigen::VectorXd& x) {
    const CamModel& model = problem.model();
    const Eigen::VectorXd parameters = x.tail(static_cast<Eigen::Index>(model.parameters.size()));
    Delivered delivered{std::make_shared<const MotionChain>(problem.motion(x)), {}, {}};
    if (model.cam) delivered.cam = model.cam->cam_at(parameters);
    if (model.mechanism) delivered.mechanism = model.mechanism->dimensions_at(parameters);
    report_delivered(solution, std::move(delivered));
    const MotionFamily& design = model.design;
    const Eigen::VectorXd values = problem.design_values(x);
    const std::vector<int> reported = design.reported_entries();
    solution.design.values = values(reported);
    for (const int entry : reported) solution.design.names.push_back(design.name(entry));
}

void report_conflict(Solution& solution) {
    if (!solution.certificate.proof) return;
    const DualityProof& proof = *solution.certificate.proof;
    double whole = 0.0;
    std::vector<ConflictReport> found;
    for (std::size_t i = 0; i < proof.origins.size(); ++i) {
        const RowOrigin& origin = proof.origins[i];
        const double weight = std::abs(proof.multipliers[static_cast<Eigen::Index>(i)]);
        if (!origin.limit || weight == 0.0) continue;
        whole += weight;
        found.push_back({origin.rule, origin.at.value_or(0.0), weight, origin.remark});
    }
    for (ConflictReport& conflict : found) conflict.weight /= whole;
    std::erase_if(found, [](const ConflictReport& conflict) { return conflict.weight < telling_weight; });
    std::ranges::stable_sort(found, std::greater{}, &ConflictReport::weight);
    solution.conflict = std::move(found);
}

}  // namespace camopt
