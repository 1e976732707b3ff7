// SPDX-License-Identifier: MIT
#include "studies/measured/given_motion.hpp"

#include "objectives/scene_model.hpp"
#include "splines/fitted_curve.hpp"
#include "studies/delivered/delivered_audit.hpp"
#include "studies/delivered/solution_parts.hpp"
#include "studies/delivered/solution_report.hpp"
#include "studies/measured/measured_fit.hpp"

namespace camopt {

namespace {

constexpr double same_joint = 1e-9;  // of the motion: a joint of pieces there is one of segments

/// x where segments meet, begin and end included.
std::vector<double> joints_of(const MotionSpec& motion) {
    std::vector<double> joints = {0.0};
    double angle = 0.0;
    if (motion.type == MotionType::program)
        for (const ProgramSegment& segment : motion.segments)
            joints.push_back((angle += segment.angle) / motion.unit_angle());
    else
        joints.push_back(motion.length());
    return joints;
}

CurveRows rows_of(const Scene& scene) {
    const MotionSpec& motion = scene.motion;
    CurveRows rows;
    rows.joints = joints_of(motion);
    const double length = rows.joints.back();
    const bool whole = motion.type == MotionType::rr && is_whole_turn(length * motion.unit_angle());
    rows.periodic = motion.periodic() || whole;
    if (motion.relative) rows.advance = motion.segments.back().to.value_or(0.0);
    for (const MeasuredRow& row : measured_rows(scene, 0.0, length)) {
        rows.x.push_back(row.x);
        rows.y.push_back(row.y);
    }
    for (const double angle : scene.measured->breaks) {
        const double x = angle / motion.unit_angle();
        if (x > same_joint * length && x < (1.0 - same_joint) * length &&
            (rows.breaks.empty() || x - rows.breaks.back() > same_joint * length))
            rows.breaks.push_back(x);
    }
    return rows;
}

std::shared_ptr<const MotionChain> chain_of(const SplineCurve& curve, const std::vector<double>& joints) {
    const auto shape = std::make_shared<const SplineCurve>(curve);
    std::vector<ChainPart> parts;
    for (std::size_t i = 0; i + 1 < joints.size(); ++i) {
        ChainPart part;
        part.begin = joints[i];
        part.end = joints[i + 1];
        part.shape = shape;
        parts.push_back(part);
    }
    return std::make_shared<const MotionChain>(std::move(parts));
}

FittedCurve fit_of(const CurveRows& rows) {
    try {
        return fitted_curve(rows);
    } catch (const InputError& error) {
        throw SceneError({"measured", error.what(), "more rows"});
    }
}

}  // namespace

MeasuredReport given_motion(const Scene& scene) {
    const CurveRows rows = rows_of(scene);
    const FittedCurve fit = fit_of(rows);
    MeasuredReport report;
    report.name = scene.measured->name;
    report.motion = chain_of(fit.curve, rows.joints);
    report.rows = fit.rows;
    report.freedom = fit.freedom;
    report.noise = {fit.noise, fit.error};
    const std::vector<MeasuredRow> own = measured_rows(scene, 0.0, rows.joints.back());
    report.laws =
        nearest_laws(scene_family(scene, DesignKind::states), scene.motion.type == MotionType::rr, own);
    const Deviation deviation = deviation_of(own, *report.motion);
    report.largest_error = deviation.largest.value;
    report.at = deviation.largest.at;
    report.rms_error = deviation.rms;
    return report;
}

Solution given_solution(const Scene& scene) {
    const Stopwatch watch;
    Solution solution;
    solution.scene = scene;
    solution.reference_peaks = reference_peaks(scene);
    solution.design.kind = DesignKind::coefficients;
    MeasuredReport report = given_motion(scene);
    report_delivered(solution, {report.motion, scene.cam ? scene.cam->middle() : std::vector<double>{}});
    audit_given(solution);
    report.peaks = solution.peaks;
    solution.measured = std::move(report);
    solution.phases.report = solution.seconds_total = watch.seconds();
    return solution;
}

}  // namespace camopt
