// SPDX-License-Identifier: MIT
#include "studies/delivered/solution_report.hpp"

#include "motions/laws/law.hpp"
#include "objectives/drive_rules.hpp"
#include "objectives/scene_family.hpp"
#include "objectives/scene_model.hpp"
#include "scene/limit_table.hpp"
#include "studies/delivered/cam_report.hpp"
#include "studies/delivered/made_limits.hpp"
#include "studies/delivered/scene_limits.hpp"
#include "studies/delivered/smallest_of_any_motion.hpp"
#include "studies/delivered/solution_parts.hpp"
#include "studies/laws/law_motion.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

// Rows of a proof that carry less than this part of its weight do not explain anything.
constexpr double telling_weight = 1e-3;
// In lifts: control points that differ by less are one displacement and its roundings.
constexpr double rounded_displacement = 1e-13;
// A derivative that jumps by less than this part of the motion's peak is continuous.
constexpr double same_derivative = 1e-7;

void report_peak_limit(Solution& solution, const char* name, const std::optional<PeakLimit>& limit,
                       const Extremum& peak) {
    if (!limit) return;
    const double unit = limit->unit_per_normalised();
    solution.constraints.push_back(
        {name, limit->key, limit->given, peak.value * unit, limit->unit, peak.at, false, true});
}

/// The highest derivative that is continuous at x, to rounding; `known`: this one is.
int continuity_at(const Motion& motion, double left_x, double right_x, int known = -1) {
    const MotionPoint left = motion.at(left_x, Side::left);
    const MotionPoint right = motion.at(right_x, Side::right);
    int order = known;
    while (order < 3) {
        const double jump = std::abs(left.derivative[order + 1] - right.derivative[order + 1]);
        const double size = std::max({1.0, std::abs(left.derivative[order + 1])});
        if (jump > same_derivative * size) break;
        ++order;
    }
    return order;
}

/// A curve whose control points differ by no more than their rounding stands, and its derivatives are 0:
/// those of its pieces would be that rounding, and not what the published control points say.
SplineCurve without_rounded_motion(const SplineCurve& curve) {
    const Eigen::VectorXd points = curve.coefficients();
    if (points.maxCoeff() - points.minCoeff() > rounded_displacement) return curve;
    Eigen::MatrixXd pieces = Eigen::MatrixXd::Zero(curve.pieces().rows(), curve.pieces().cols());
    pieces.row(0).setConstant(points[0]);
    return {curve.space(), std::move(pieces)};
}

SplineCurve curve_of(const ChainPart& part) {
    return without_rounded_motion(
        part_of_run(dynamic_cast<const SplineCurve&>(*part.shape), part.begin, part.end, -part.x0));
}

void report_segments(Solution& solution) {
    const MotionChain& motion = solution.output_motion();
    const std::vector<StretchScale> scales = peak_scales(solution.scene);
    const bool given = solution.scene.is_given();
    JoinedMeans means;
    for (std::size_t s = 0; s < motion.parts().size(); ++s) {
        const ChainPart& part = motion.parts()[s];
        const ProgramSegment& written = solution.scene.motion.segments[s];
        const bool by_law = written.kind == SegmentKind::law;
        SegmentReport report{given && by_law ? SegmentKind::spline : written.kind,
                             given ? std::string() : written.law,
                             part.begin,
                             part.end,
                             motion.at(part.begin, Side::right).derivative[0],
                             motion.at(part.end, Side::left).derivative[0],
                             {},
                             {},
                             0};
        const bool first = s == 0;
        report.continuity = first && !solution.scene.motion.periodic()
                                ? -1
                                : continuity_at(motion, first ? motion.end() : part.begin, part.begin,
                                                first && solution.scene.motion.relative ? 0 : -1);
        if (given && written.kind == SegmentKind::dwell)
            raise_peaks(solution.motion_peaks, peaks_of(curve_of(part)));
        if (report.kind == SegmentKind::spline) {
            report.curve = curve_of(solution.motion->parts()[s]);
            const Peaks own = peaks_of(solution.output ? curve_of(part) : *report.curve);
            if (solution.output) raise_peaks(solution.cam_peaks, peaks_of(*report.curve));
            report.peaks = normalised_peaks(own, scales[s]);
            raise_peaks(solution.peaks, *report.peaks);
            raise_peaks(solution.motion_peaks, own);
            means.add(*report.peaks, part.end - part.begin);
        }
        if (report.kind == SegmentKind::law) {
            const std::shared_ptr<const Law> law = segment_law(solution.scene.motion, s);
            const LawStroke stroke{written.kind, law, part.begin, part.end, report.from, report.to};
            const Peaks own = law_peaks(stroke, *law, motion, solution.scene.motion.periodic());
            const bool of_motion = solution.scene.objective.peaks == PeakScope::motion;
            report.peaks = normalised_peaks(
                own, of_motion ? scales[s]
                               : StretchScale{part.end - part.begin,
                                              measured_displacement(report.to - report.from)});
            raise_peaks(solution.motion_peaks, own);
            if (solution.scene.motion.prescribed()) {
                raise_peaks(solution.peaks, *report.peaks);
                means.add(*report.peaks, part.end - part.begin);
            }
        }
        solution.segments.push_back(std::move(report));
    }
    means.set(solution.peaks);
}

void report_peak_limits(Solution& solution) {
    for (const PeakLimitRow& row : peak_limit_rows()) {
        if (!row.on_peak()) continue;
        const std::optional<PeakLimit>& limit = row.in(solution.scene.limits);
        const bool in_time = limit && limit->physical();
        report_peak_limit(solution, row.name(), limit,
                          derivative_peak(in_time ? solution.motion_peaks : solution.peaks, row.order()));
    }
    for (ConstraintReport& reached :
         bound_reports(solution.scene, solution.output_motion(), *solution.motion))
        solution.constraints.push_back(std::move(reached));
}

void report_cam(Solution& solution, std::vector<double> dimensions) {
    if (!solution.scene.cam.has_value()) return;
    solution.cam = cam_report(solution.scene, std::move(dimensions), *solution.motion);
    solution.cam->limits_along = enclosed_limits(solution.scene, solution.cam->cam, *solution.motion);
    for (ConstraintReport& limit : cam_constraints(solution.scene, *solution.cam)) {
        limit.verified = is_verified(solution.cam->limits_along, limit.key);
        solution.constraints.push_back(std::move(limit));
    }
    if (solution.scene.tolerance) hold_for_made_cams(solution);
}

}  // namespace

SplineCurve part_of_run(const SplineCurve& run, double begin, double end, double shift) {
    const SplineSpace& space = run.space();
    // The nearest ones: there and back by the shift rounds.
    const int first = space.breakpoint_at(begin + shift), last = space.breakpoint_at(end + shift);
    std::vector<double> breakpoints;
    for (int i = first; i <= last; ++i) breakpoints.push_back(space.breakpoints()[i] - shift);
    breakpoints.front() = begin;
    breakpoints.back() = end;
    return {SplineSpace(run.degree(), run.continuity(), std::move(breakpoints)),
            run.pieces().middleCols(first, last - first)};
}

void report_delivered(Solution& solution, MotionAndCam delivered) {
    solution.motion = std::move(delivered.motion);
    if (solution.scene.prescribes_output())
        solution.output =
            std::make_shared<const MotionChain>(solved(*solution.motion, cam_of_output(solution.scene)));
    if (solution.scene.motion.type == MotionType::program) {
        report_segments(solution);
    } else {
        const auto curve_of_all = [](const MotionChain& motion) -> const SplineCurve& {
            return dynamic_cast<const SplineCurve&>(*motion.parts().front().shape);
        };
        solution.curve = curve_of_all(*solution.motion);
        solution.peaks = solution.motion_peaks = peaks_of(curve_of_all(solution.output_motion()));
        if (solution.output) solution.cam_peaks = peaks_of(*solution.curve);
    }
    if (!solution.output) solution.cam_peaks = solution.motion_peaks;
    report_peak_limits(solution);
    report_cam(solution, std::move(delivered.dimensions));
    solution.own_terms = own_term_reports(solution.scene, solution.output_motion());
    const std::vector<ConstraintReport> own = own_constraints(solution.scene, solution.output_motion());
    solution.constraints.insert(solution.constraints.end(), own.begin(), own.end());
    report_responses(solution);
    if (solution.scene.drive) solution.drive = drive_figures(solution.scene, solution.output_motion());
    if (solution.scene.forces && solution.scene.forces->spring_frequency)
        solution.surge = surge_report(solution.scene, *solution.motion);
    judge_activity(solution);
}

void add_to_design(Solution& solution, std::vector<std::string> names, std::span<const double> values) {
    DesignReport& design = solution.design;
    Eigen::VectorXd all(static_cast<Eigen::Index>(values.size()) + design.values.size());
    all << Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size())),
        design.values;
    names.insert(names.end(), design.names.begin(), design.names.end());
    design.names = std::move(names);
    design.values = std::move(all);
}

void set_scene(Solution& solution, Scene scene) {
    if (scene.forces && solution.scene.forces)
        for (const SpringNumber& spring : spring_numbers)
            if ((*scene.forces).*spring.range)
                (*scene.forces).*spring.number = (*solution.scene.forces).*spring.number;
    solution.scene = std::move(scene);
}

void report_motion(Solution& solution, const CamProblem& problem, const Eigen::VectorXd& x) {
    const CamModel& model = problem.model();
    const Eigen::VectorXd parameters = x.tail(static_cast<Eigen::Index>(model.parameters.size()));
    MotionAndCam delivered{std::make_shared<const MotionChain>(problem.motion(x, SeenMotion::cam)), {}};
    std::vector<std::string> spring;
    std::vector<double> chosen;
    if (model.cam) {
        delivered.dimensions = model.cam->dimensions_at(parameters);
        for (std::size_t k = 0; k < spring_numbers.size(); ++k) {
            if (model.cam->spring[k] < 0) continue;
            spring.emplace_back(spring_numbers[k].key);
            chosen.push_back(delivered.dimensions[static_cast<std::size_t>(model.cam->spring[k])]);
            solution.scene.forces.value().*spring_numbers[k].number = chosen.back();
        }
        delivered.dimensions.resize(delivered.dimensions.size() - chosen.size());
    }
    report_delivered(solution, std::move(delivered));
    const MotionFamily& design = model.design;
    const Eigen::VectorXd values = problem.design_values(x);
    const std::vector<int> reported = design.reported_entries();
    solution.design.values = values(reported);
    for (const int entry : reported) solution.design.names.push_back(design.name(entry));
    if (!chosen.empty()) add_to_design(solution, std::move(spring), chosen);
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

void note_phase(Solution& solution) {
    const double phase = solution.scene.motion.phase;
    if (phase == 0.0 || !solution.motion) return;
    solution.notes.push_back(
        fmt::format("angles of reports, motion tables and controller tables are the master's: the motion "
                    "begins at {:.9g} deg "
                    "(the cam's own angle there is 0)",
                    phase / units::degree));
}

}  // namespace camopt
