// SPDX-License-Identifier: MIT
#include "studies/restored/restored_solution.hpp"

#include "motions/laws/law_catalogue.hpp"
#include "objectives/laws/segment_law.hpp"
#include "objectives/scene_model.hpp"
#include "scene/part_names.hpp"
#include "studies/delivered/smallest_of_any_motion.hpp"
#include "studies/delivered/solution_report.hpp"
#include "studies/measured/given_motion.hpp"
#include "studies/measured/measured_fit.hpp"
#include "studies/search/plan.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

[[noreturn]] void refuse(const std::string& what) {
    throw InputError("the result does not belong to its scene: " + what);
}

std::shared_ptr<const Motion> shape_of(const PartRecord& part, bool given, const MotionSpec& motion,
                                       std::size_t index,
                                       const std::vector<std::shared_ptr<const Motion>>& curves) {
    if (given) {
        if (!part.curve) refuse("found a part of a given motion without a spline; allowed: splines");
        return curves.at(static_cast<std::size_t>(*part.curve));
    }
    const ProgramSegment* const written =
        motion.type == MotionType::program ? &motion.segments[index] : nullptr;
    const bool law = !part.law.empty();
    const SegmentKind kind = law ? SegmentKind::law : part.curve ? SegmentKind::spline : SegmentKind::dwell;
    const SegmentKind wanted = written != nullptr ? written->kind : SegmentKind::spline;
    const std::shared_ptr<const Law> own = wanted == SegmentKind::law ? segment_law(motion, index) : nullptr;
    const std::string name = own ? law_name(own->info()) : std::string();
    if (kind != wanted || part.law != name)
        refuse(fmt::format("found a part of the motion that is a {} {}; allowed: a {} {}", name_of(kind),
                           part.law, name_of(wanted), name));
    if (law) return own;
    return part.curve ? curves.at(static_cast<std::size_t>(*part.curve)) : nullptr;
}

std::shared_ptr<const SplineCurve> curve_of(const CurveRecord& record) {
    Eigen::MatrixXd pieces(record.degree + 1, static_cast<Eigen::Index>(record.pieces.size()));
    for (std::size_t i = 0; i < record.pieces.size(); ++i)
        pieces.col(static_cast<Eigen::Index>(i)) = record.pieces[i];
    return std::make_shared<SplineCurve>(SplineSpace(record.degree, record.continuity, record.breakpoints),
                                         std::move(pieces));
}

std::shared_ptr<const MotionChain> chain_of(const Scene& scene, const MotionRecord& record) {
    std::vector<std::shared_ptr<const Motion>> curves;
    for (const CurveRecord& curve : record.curves) curves.push_back(curve_of(curve));
    const bool program = scene.motion.type == MotionType::program;
    const std::size_t wanted = program ? scene.motion.segments.size() : 1;
    if (record.parts.size() != wanted)
        refuse(fmt::format("found {} parts of the motion; allowed: {}", record.parts.size(), wanted));
    std::vector<ChainPart> parts;
    for (std::size_t i = 0; i < record.parts.size(); ++i) {
        parts.push_back(record.parts[i].part);
        parts.back().shape = shape_of(record.parts[i], scene.is_given(), scene.motion, i, curves);
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
    return {chain_of(scene, *record.motion), cam ? dimensions_of(*cam, *record.cam) : std::vector<double>{}};
}

void tell_of_run(Solution& solution, const ResultRecord& record) {
    solution.solver = record.solver;
    solution.evaluations = record.evaluations;
    solution.design = record.design;
    solution.seconds_total = record.seconds_total;
    solution.seconds_solve = record.seconds_solve;
    solution.phases = record.phases;
    solution.notes = record.notes;
    solution.machine = record.machine;
    solution.least = record.least;
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
        if (!scene.motion.segments[i].angle_range || !record.motion) continue;
        const auto& names = record.design.names;
        const std::string name = searched_angle_key(i);
        const auto found = std::ranges::find(names, name);
        if (found == names.end()) refuse(fmt::format("found no {} in its design", name));
        angles.back() = record.design.values[found - names.begin()];
    }
    return with_segment_angles(scene, angles);
}

/// The spring that was chosen is part of the design, too.
void take_chosen_spring(Scene& scene, const ResultRecord& record) {
    for (const SpringNumber& number : spring_numbers) {
        if (!scene.forces || !((*scene.forces).*number.range) || !record.motion) continue;
        const auto& names = record.design.names;
        const auto found = std::ranges::find(names, std::string_view(number.key));
        if (found == names.end()) refuse(fmt::format("found no {} in its design", number.key));
        (*scene.forces).*number.number = record.design.values[found - names.begin()];
    }
}

}  // namespace

Solution restored_solution(const Scene& scene, const ResultRecord& record) {
    Solution solution;
    solution.scene = scene;
    solution.reference_peaks = reference_peaks(scene);
    if (!scene.is_given()) solution.plan = std::make_shared<const SolvePlan>(plan(scene, {.explain = true}));
    if (searches_angles(scene)) solution.scene = with_found_angles(scene, record);
    take_chosen_spring(solution.scene, record);
    if (scene.measured)
        solution.measured =
            scene.is_given() ? given_motion(scene) : measured_report(scene, solution.reference_peaks);
    if (record.motion) report_delivered(solution, delivered_of(solution.scene, record));
    tell_of_run(solution, record);
    if (solution.measured && solution.motion) solution.measured->started = began_from_measured(solution);
    if (scene.is_given()) solution.measured->peaks = solution.peaks;
    if (solution.cam && record.cam) solution.cam->forward_check = record.cam->forward_check;
    return solution;
}

}  // namespace camopt
