// SPDX-License-Identifier: MIT
#include "studies/restored/restored_solution.hpp"

#include "motions/laws/law_catalogue.hpp"
#include "objectives/scene_model.hpp"
#include "scene/part_names.hpp"
#include "studies/delivered/smallest_of_any_motion.hpp"
#include "studies/delivered/solution_report.hpp"
#include "studies/measured/measured_fit.hpp"
#include "studies/search/plan.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

using input::CamRecord, input::CurveRecord, input::PartRecord, input::ResultRecord;

[[noreturn]] void refuse(const std::string& what) {
    throw InputError("the result does not belong to its scene: " + what);
}

std::shared_ptr<const Motion> shape_of(const PartRecord& part, const ProgramSegment* written,
                                       const std::vector<std::shared_ptr<const Motion>>& curves) {
    const bool law = !part.law.empty();
    const SegmentKind kind = law ? SegmentKind::law : part.curve ? SegmentKind::spline : SegmentKind::dwell;
    const SegmentKind wanted = written != nullptr ? written->kind : SegmentKind::spline;
    if (kind != wanted || (law && part.law != written->law))
        refuse(fmt::format("found a part of the motion that is a {} {}; allowed: a {} {}", name_of(kind),
                           part.law, name_of(wanted), written != nullptr ? written->law : ""));
    if (law) return make_law(part.law);
    return part.curve ? curves.at(static_cast<std::size_t>(*part.curve)) : nullptr;
}

std::shared_ptr<const MotionChain> chain_of(const Scene& scene, const ResultRecord& record) {
    std::vector<std::shared_ptr<const Motion>> curves;
    for (const CurveRecord& curve : record.curves)
        curves.push_back(std::make_shared<SplineCurve>(
            SplineSpace(curve.degree, curve.continuity, curve.breakpoints), curve.pieces));
    const bool program = scene.motion.type == MotionType::program;
    const std::size_t wanted = program ? scene.motion.segments.size() : 1;
    if (record.parts.size() != wanted)
        refuse(fmt::format("found {} parts of the motion; allowed: {}", record.parts.size(), wanted));
    std::vector<ChainPart> parts;
    for (std::size_t i = 0; i < record.parts.size(); ++i) {
        const PartRecord& part = record.parts[i];
        parts.push_back({part.begin, part.end,
                         shape_of(part, program ? &scene.motion.segments[i] : nullptr, curves), part.x0,
                         part.x_scale, part.y0, part.y_scale});
    }
    return std::make_shared<const MotionChain>(std::move(parts));
}

/// The recorded number of a dimension that the scene fixes or leaves free.
double dimension_of(const CamRecord& cam, const std::string& name, const Dimension& written) {
    const auto found = std::ranges::find(cam.dimensions, name, &std::pair<std::string, double>::first);
    if (found == cam.dimensions.end()) refuse(fmt::format("found no cam.dimensions.{}", name));
    if (written.is_variable() ? !std::isfinite(found->second) : found->second != written.low)
        refuse(fmt::format("cam.dimensions.{}: found {}; allowed: {}", name, found->second, written.low));
    return found->second;
}

std::vector<double> dimensions_of(const CamSpec& spec, const CamRecord& record) {
    std::vector<double> numbers;
    for (const CamDimension& dimension : spec.dimensions)
        numbers.push_back(dimension_of(record, dimension.si_key(), dimension.value));
    return numbers;
}

MotionAndCam delivered_of(const Scene& scene, const ResultRecord& record) {
    const std::optional<CamSpec>& cam = scene.cam;
    if (cam.has_value() != record.cam.has_value())
        refuse(fmt::format("found {} cam; allowed: {}", record.cam ? "a" : "no", cam ? "one" : "none"));
    return {chain_of(scene, record), cam ? dimensions_of(*cam, *record.cam) : std::vector<double>{}};
}

/// x of which shown(x) is the number that was written: division and multiplication do not always undo each
/// other.
template <class Shown>
double written_from(double written, double guess, const Shown& shown) {
    for (const double x : {guess, std::nextafter(guess, -infinity), std::nextafter(guess, infinity)})
        if (shown(x) == written) return x;
    return guess;
}

ForwardCheckReport forward_check_of(const Scene& scene, const input::ForwardCheckRecord& record) {
    const double unit = scene.motion.lift_is_angle ? units::degree : units::millimetre;
    const double angle = scene.motion.unit_angle();
    ForwardCheckReport check;
    check.deviation =
        written_from(record.deviation, record.deviation * unit, [&](double value) { return value / unit; });
    check.relative = record.relative;
    check.at = written_from(record.at_deg, record.at_deg * units::degree / angle,
                            [&](double x) { return angle / units::degree * x; });
    check.points = record.points;
    check.seconds = record.seconds;
    if (!record.play) return check;
    const auto length = [&](double written) {
        return written_from(written, written * unit, [&](double value) { return value / unit; });
    };
    const auto place = [&](double written) {
        return written_from(written, written * units::degree / angle,
                            [&](double x) { return angle / units::degree * x; });
    };
    check.play = ForwardCheckReport::Play{length(record.play->least), length(record.play->largest),
                                          place(record.play->least_at_deg),
                                          place(record.play->largest_at_deg), std::nullopt};
    if (const auto& width = record.play->least_groove_width_mm)
        check.play->least_groove_width = written_from(*width, *width * units::millimetre,
                                                      [](double value) { return value / units::millimetre; });
    return check;
}

template <class Choice>
Choice choice_of(const std::string& name, std::initializer_list<Choice> choices) {
    if (const auto choice = choice_named(name, choices)) return *choice;
    throw InputError(fmt::format("found \"{}\" in a result; allowed: a name that camopt gives", name));
}

void tell_of_run(Solution& solution, const ResultRecord& record) {
    using enum Termination;
    const input::SolverRecord& solver = record.solver;
    solution.solver = {solver.name,
                       solver.choice,
                       choice_of(solver.termination,
                                 {not_run, converged, acceptable, infeasible, unbounded, iteration_limit,
                                  time_limit, interrupted, numerical_failure, evaluation_error, unsupported}),
                       solver.native_status,
                       solver.iterations,
                       solver.exchange_rounds,
                       solver.convex,
                       solver.starts,
                       solver.proof_source};
    const input::EvaluationRecord& count = record.evaluations;
    solution.evaluations = {count.cost,     count.gradient, count.constraints,
                            count.jacobian, count.hessian,  count.profile_points};
    const std::vector<double>& values = record.design.values;
    if (!record.parts.empty())
        solution.design = {
            choice_of(record.design.kind, {DesignKind::automatic, DesignKind::ordinates,
                                           DesignKind::coefficients, DesignKind::states}),
            record.design.names,
            Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()))};
    solution.seconds_total = record.seconds_total;
    solution.seconds_solve = record.seconds_solve;
    for (const PhaseRow& phase : phase_rows)
        if (const auto known = record.seconds.find(phase.name); known != record.seconds.end())
            solution.phases.*phase.seconds = known->second;
    solution.notes = record.notes;
    solution.machine = record.machine;
    if (record.any_curve_limit) {
        // The file has its objective; its peaks are what the scene gives.
        solution.any_curve_limit =
            limit_curve(solution.scene, solution.reference_peaks).value_or(LimitCurve{});
        solution.any_curve_limit->objective = *record.any_curve_limit;
    }
}

/// The angles that the search found are entries of the design.
Scene with_found_angles(const Scene& scene, const ResultRecord& record) {
    std::vector<double> angles;
    for (std::size_t i = 0; i < scene.motion.segments.size(); ++i) {
        angles.push_back(scene.motion.segments[i].angle);
        if (!scene.motion.segments[i].angle_range || record.parts.empty()) continue;
        const auto& names = record.design.names;
        const std::string name = searched_angle_key(i);
        const auto found = std::ranges::find(names, name);
        if (found == names.end()) refuse(fmt::format("found no {} in its design", name));
        angles.back() = record.design.values[static_cast<std::size_t>(found - names.begin())];
    }
    return with_segment_angles(scene, angles);
}

}  // namespace

Solution restored_solution(const Scene& scene, const ResultRecord& record) {
    Solution solution;
    solution.scene = scene;
    solution.reference_peaks = reference_peaks(scene);
    solution.plan = std::make_shared<const SolvePlan>(plan(scene, {.explain = true}));
    if (searches_angles(scene)) solution.scene = with_found_angles(scene, record);
    if (scene.measured) solution.measured = measured_report(scene, solution.reference_peaks);
    if (!record.parts.empty()) report_delivered(solution, delivered_of(solution.scene, record));
    tell_of_run(solution, record);
    if (solution.measured && solution.motion) solution.measured->started = began_from_measured(solution);
    if (solution.cam && record.cam && record.cam->forward_check)
        solution.cam->forward_check = forward_check_of(scene, *record.cam->forward_check);
    return solution;
}

}  // namespace camopt
