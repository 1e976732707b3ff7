// SPDX-License-Identifier: MIT
#include "studies/compare/comparison.hpp"

#include "motions/laws/law_catalogue.hpp"
#include "objectives/drive_rules.hpp"
#include "objectives/own_point_rule.hpp"
#include "objectives/rules/cam_limits.hpp"
#include "objectives/rules/maxima/rule_maxima.hpp"
#include "objectives/scene_model.hpp"
#include "scene/limit_table.hpp"
#include "scene/written_limits.hpp"
#include "studies/delivered/cam_report.hpp"
#include "studies/delivered/delivered_audit.hpp"
#include "studies/delivered/solution_parts.hpp"
#include "studies/laws/law_motion.hpp"
#include "studies/least/feasible_edge.hpp"
#include "studies/least/least_value.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

// Without a largest base radius: distances from the smallest cam, in prime radii or lifts, whichever is
// larger.
constexpr double nearest = 1e-6, farthest = 1e3;
constexpr int steps_a_decade = 10;
// Otherwise: parts of the range of base radii that the mechanism allows.
constexpr int bounded_steps = 400;
// A rule above this part of its scale is broken.
constexpr double rule_tolerance = 1e-11;
// The radius is found to this part of itself.
constexpr double accuracy = 1e-12;
// Places between two breakpoints where the displacement is looked at.
constexpr int range_samples = 32;

class Judge {
 public:
    Judge(const Scene& scene, const DrivenMechanism& cam, const Motion& motion)
        : scene_(scene), cam_(cam), motion_(motion) {
        find_range();
    }

    /// Empty: every limit is satisfied with this base radius; else what is not.
    [[nodiscard]] std::string broken_at(double base) {
        const CamVariables variables = with_base(base);
        std::string fault = cam_.formulas->fault(variables.cam.dimensions, least_, most_);
        if (!fault.empty()) return fault;
        const auto rules = cam_limits(scene_, variables);
        // The rule that spoke the last time is likely to speak again.
        if (last_ < rules.size() && is_broken(*rules[last_])) return rules[last_]->name();
        for (std::size_t i = 0; i < rules.size(); ++i) {
            if (!is_broken(*rules[i])) continue;
            last_ = i;
            return rules[i]->name();
        }
        return {};
    }
    /// By how much the limits are violated with it at most, each by its scale: > 0 where one is broken.
    [[nodiscard]] double violation_at(double base) const {
        const CamVariables variables = with_base(base);
        if (!cam_.formulas->fault(variables.cam.dimensions, least_, most_).empty()) return infinity;
        double worst = -infinity;
        for (const auto& rule : cam_limits(scene_, variables)) worst = std::max(worst, violation_of(*rule));
        return worst;
    }

 private:
    [[nodiscard]] CamVariables with_base(double base) const {
        CamVariables variables;
        variables.cam = cam_;
        variables.cam.dimensions[static_cast<std::size_t>(cam_.formulas->base_radius_index())] = base;
        variables.scale = {scene_.motion.lift, scene_.motion.unit_angle()};
        return variables;
    }
    [[nodiscard]] double violation_of(const PointRule& rule) const {
        const double largest = largest_of(rule_maxima(rule, motion_, Eigen::VectorXd())).value;
        return std::isnan(largest) ? infinity : largest / rule.scale() - rule_tolerance;
    }
    [[nodiscard]] bool is_broken(const PointRule& rule) const { return violation_of(rule) > 0.0; }
    void find_range() {
        const std::vector<double> points = motion_.breakpoints();
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            for (int k = 0; k <= range_samples; ++k) {
                const double x = points[i] + (points[i + 1] - points[i]) * k / range_samples;
                const double s = scene_.motion.lift * motion_.at(std::min(x, motion_.end())).derivative[0];
                least_ = std::min(least_, s);
                most_ = std::max(most_, s);
            }
        }
    }

    const Scene& scene_;
    const DrivenMechanism& cam_;
    const Motion& motion_;
    double least_ = 0.0, most_ = 0.0;
    std::size_t last_ = 0;
};

/// The base radii at which the cam can be built at rest with its other dimensions: DirectCam::reach. The cam
/// has a base radius.
Interval allowed_radii(const DrivenMechanism& cam) {
    Interval radii(0.0, infinity);
    for (const std::vector<SignedIndex>& sum : cam.formulas->direct()->reach()) {
        double sign = 0.0, others = 0.0;  // sign · base + others < 0
        for (const SignedIndex& term : sum) {
            if (term.dimension == cam.formulas->base_radius_index())
                sign = term.sign;
            else
                others += term.sign * cam.dimensions[static_cast<std::size_t>(term.dimension)];
        }
        if (sign < 0.0) radii.lower = std::max(radii.lower, others);
        if (sign > 0.0) radii.upper = std::min(radii.upper, -others);
    }
    return radii;
}

std::vector<double> tried_radii(const Scene& scene, const DrivenMechanism& cam) {
    const auto [smallest, largest] = allowed_radii(cam);
    std::vector<double> radii;
    if (largest < infinity) {
        for (int k = 1; k < bounded_steps; ++k)
            radii.push_back(smallest + (largest - smallest) * k / bounded_steps);
        return radii;
    }
    const double unit = std::max(scene.motion.lift, cam.formulas->length(cam.dimensions));
    const int last = static_cast<int>(std::lround(steps_a_decade * std::log10(farthest / nearest)));
    for (int k = 0; k <= last; ++k)
        radii.push_back(smallest + unit * nearest * std::pow(10.0, static_cast<double>(k) / steps_a_decade));
    return radii;
}

/// What every row is judged by.
struct Bench {
    const Scene& scene;
    CamModel model;
    std::vector<LawStroke> strokes;
    std::optional<DrivenMechanism> cam = {};
    bool limits_base = false;  ///< the base radius of the cam is a dimension, and the scene limits the cam
    bool limits_train = false;
    double prescribed_cost = 0.0;  ///< of the peaks of a prescribed motion
};

double dimension_of(const Bench& bench, int parameter) {
    for (const CamVariables::Variable& variable : bench.model.cam->variables) {
        if (variable.parameter == parameter)
            return bench.cam->dimensions[static_cast<std::size_t>(variable.dimension)] / variable.reference;
    }
    return 0.0;
}

double own_peak(const Scene& scene, const std::string& name, const Motion& motion) {
    const auto term = std::ranges::find(scene.own_terms, name, &OwnTerm::name);
    return largest_of_own(*term, motion).value;
}

/// In units of its reference.
double response_of(const Parameter& parameter, const Motion& motion) {
    double largest = 0.0;
    for (const auto& place : parameter.defined_by->whole()->maxima(motion, Eigen::VectorXd::Zero(1)))
        largest = std::max(largest, place.where.value);
    return largest;
}

/// A parameter of the optimizer as a given motion sets it.
double parameter_value(const Bench& bench, const Motion& motion, const Peaks& peaks, int index) {
    const Parameter& parameter = bench.model.parameters[static_cast<std::size_t>(index)];
    switch (parameter.kind) {
        case Parameter::Kind::peak:
            return derivative_peak(peaks, parameter.order).value / parameter.reference;
        case Parameter::Kind::torque:
            return peaks.torque.value / parameter.reference;
        case Parameter::Kind::rms:
            return derivative_mean(peaks, parameter.order) / parameter.reference;
        case Parameter::Kind::dimension:
            return dimension_of(bench, index);
        case Parameter::Kind::magnitude:
            return std::abs(parameter_value(bench, motion, peaks, parameter.order));
        case Parameter::Kind::own:
            return own_peak(bench.scene, parameter.name, motion) / parameter.reference;
        case Parameter::Kind::response:
        case Parameter::Kind::energy:
            return response_of(parameter, motion);
    }
    return 0.0;
}

/// Σ weight · figure / reference over the terms of peaks.
double weighted_peaks(const Scene& scene, const Peaks& peaks) {
    const Peaks reference = reference_peaks(scene);
    double sum = 0.0;
    for (const CostTerm& term : cost_terms())
        if (const double weight = term.weight_in(scene.objective); weight > 0.0)
            sum += weight * term.measured.of(peaks) / term.measured.of(reference);
    return sum;
}

double objective_of(const Bench& bench, const Motion& motion, const Peaks& peaks) {
    double objective = bench.model.cost_constant;
    // Peaks of a prescribed motion are no parameters of its model but a constant.
    if (bench.scene.motion.prescribed())
        objective += weighted_peaks(bench.scene, peaks) - bench.prescribed_cost;
    for (int i = 0; i < static_cast<int>(bench.model.parameters.size()); ++i) {
        const double weight = bench.model.parameters[static_cast<std::size_t>(i)].weight;
        if (weight > 0.0) objective += weight * parameter_value(bench, motion, peaks, i);
    }
    return objective;
}

/// A broken limit that no dimension of the cam has a say in.
std::string broken_without_cam(const ComparisonRow& row, std::size_t motion_limits) {
    for (std::size_t i = 0; i < motion_limits; ++i) {
        if (!row.limits[i].kept) return row.limits[i].reached.key;
    }
    return {};
}

void judge_limits(ComparisonRow& row, const Bench& bench, const Peaks& motion_peaks) {
    const MotionFigures figures{*row.motion, row.peaks, motion_peaks};
    row.limits = motion_limits(bench.scene, figures);
    if (bench.scene.drive) row.drive = drive_figures(bench.scene, *row.motion);
    const std::size_t of_motion = row.limits.size();
    std::optional<CamReport> cam;
    const auto add = [&](const std::vector<ConstraintReport>& all) {
        for (const ConstraintReport& reached : all)
            row.limits.push_back(outcome_of(bench.scene, cam ? &*cam : nullptr, reached));
    };
    if (bench.cam) {
        cam = cam_report(bench.scene, bench.cam->dimensions, *row.motion);
        add(cam_constraints(bench.scene, *cam));
    }
    add(own_constraints(bench.scene, *row.motion));
    if (bench.limits_train) add(response_constraints(bench.scene, train_report(bench.scene, *row.motion)));
    row.feasible = std::ranges::all_of(row.limits, &LimitOutcome::kept);
    if (!bench.limits_base) return;
    std::string broken = broken_without_cam(row, of_motion);
    row.base = broken.empty() ? needed_base(bench.scene, *bench.cam, *row.motion)
                              : NeededBase{std::nullopt, std::move(broken)};
}

ComparisonRow optimum_row(const Bench& bench, const Solution& solution) {
    ComparisonRow row;
    const bool prescribed = bench.scene.motion.prescribed();
    row.title = prescribed ? "as prescribed" : "optimum";
    row.motion = solution.motion;
    row.peaks = solution.peaks;
    row.motion_peaks = solution.motion_peaks;
    row.objective = solution.certificate.objective;
    if (solution.output) {  // whose motion and peaks are compared; limits are the cam's too
        row.motion = solution.output;
        for (const ConstraintReport& reached : solution.constraints)
            row.limits.push_back(outcome_of(bench.scene, solution.cam ? &*solution.cam : nullptr, reached));
        row.drive = solution.drive;
    } else {
        judge_limits(row, bench, solution.motion_peaks);
    }
    // The certificate knows better than a second look at limits that are just reached.
    row.feasible = solution.certificate.verdict != Verdict::infeasible &&
                   solution.certificate.verdict != Verdict::failed;
    if (!row.feasible) return row;
    for (LimitOutcome& limit : row.limits) limit.kept = true;
    if (!prescribed) row.loss_percent = 0.0;
    return row;
}

ComparisonRow law_row(const Bench& bench, const std::shared_ptr<const Law>& law,
                      std::optional<double> optimum) {
    ComparisonRow row;
    row.key = law_name(law->info());
    row.title = law->title();
    LawMotion placed = law_motion(
        bench.strokes, bench.scene.motion.type == MotionType::program && bench.scene.motion.closed, law);
    row.misfit = std::move(placed.misfit);
    if (!placed.motion) {
        row.objective = infinity;
        return row;
    }
    row.motion = std::move(placed.motion);
    row.peaks = placed.peaks;
    row.motion_peaks = placed.motion_peaks;
    row.objective = objective_of(bench, *row.motion, row.peaks);
    judge_limits(row, bench, placed.motion_peaks);
    if (optimum && *optimum > 0.0 && std::isfinite(row.objective) && meets_conditions(row)) {
        const double loss = 100.0 * (row.objective / *optimum - 1.0);
        if (row.feasible || loss >= 0.0) row.loss_percent = loss;
    }
    return row;
}

/// Where the spline is the output of a train.
ComparisonRow not_the_output(const LawInfo& info) {
    ComparisonRow row;
    row.key = law_name(info);
    row.title = info.title;
    row.misfit = "where its jerk jumps, the cam would need an impulse; camopt dynamics compares laws as cams";
    row.objective = infinity;
    return row;
}

/// Keeps references to both.
Bench bench_of(const Scene& scene, const Solution& solution) {
    CamModel model = scene_model(scene, DesignKind::states, reference_peaks(scene));
    std::vector<LawStroke> strokes = strokes_of(scene, model, solution.motion.get());
    Bench bench{scene, std::move(model), std::move(strokes)};
    if (const std::optional<CamSpec>& cam = scene.cam)
        bench.cam = {cam->formulas(), solution.cam ? solution.cam->cam.dimensions : cam->middle()};
    const bool has_base = bench.cam && bench.cam->formulas->base_radius_index() >= 0;
    bench.limits_base = has_base && !cam_limits(scene, *bench.model.cam).empty();
    if (scene.motion.prescribed()) bench.prescribed_cost = weighted_peaks(scene, solution.peaks);
    bench.limits_train = scene.dynamics && std::ranges::any_of(limit_rows(), [&](const LimitRow& row) {
                             return row.needs_dynamics && row.in(scene.limits).has_value();
                         });
    return bench;
}

}  // namespace

NeededBase needed_base(const Scene& scene, const DrivenMechanism& cam, const Motion& motion) {
    if (cam.formulas->base_radius_index() < 0)
        throw InputError("the needed base radius of a cam whose base radius is no dimension");
    Judge judge(scene, cam, motion);
    std::string broken;
    double below = 0.0;
    for (const double radius : tried_radii(scene, cam)) {
        std::string now = judge.broken_at(radius);
        if (!now.empty()) {
            broken = std::move(now);
            below = radius;
            continue;
        }
        const ValueSearch search{[&](double value) { return judge.violation_at(value); }};
        ValueTrial outside = search.at(below);
        if (outside.feasible()) outside.violation = infinity;  // no cam at all, before the first radius
        const ValueBracket edge = closed_in(search, {search.at(radius), outside}, accuracy * radius);
        return {edge.inside.value, {}};
    }
    return {std::nullopt, broken};
}

bool meets_conditions(const ComparisonRow& row) {
    return std::ranges::all_of(row.limits,
                               [](const LimitOutcome& limit) { return limit.kept || !limit.exact; });
}

ComparisonRow compare_law(const Solution& solution, const std::string& law) {
    if (!solution.motion) throw InputError("a law is compared with a motion, and this solution has none");
    const auto found = std::ranges::find(law_catalogue(), law_key(law), &LawInfo::key);
    if (found == law_catalogue().end())
        throw InputError(fmt::format("law: found \"{}\"; allowed: those of camopt list laws", law));
    const Scene scene = with_written_limits(solution.scene);
    return law_row(bench_of(scene, solution), make_law(law), solution.certificate.objective);
}

namespace {

bool weighs_anything(const Scene& scene) {
    const ObjectiveSpec& objective = scene.objective;
    const auto weighs = [&](const auto& term) { return term.weight_in(objective) > 0.0; };
    return !scene.own_terms.empty() || std::ranges::any_of(cost_terms(), weighs) ||
           std::ranges::any_of(response_terms(), weighs);
}

/// The task of a given cam: what an optimum for the same machine would do.
Scene task_of(Scene scene) {
    scene.measured->given = false;
    const auto needs = [&](const ResponseTerm& term) {
        return term.needs_measured() && term.weight_in(scene.objective) > 0.0;
    };
    if (std::ranges::none_of(response_terms(), needs)) scene.measured.reset();
    if (scene.cam) scene.cam->pieces.clear();
    return scene;
}

ComparisonRow given_row(const Bench& bench, const Solution& given, std::optional<double> optimum) {
    ComparisonRow row;
    row.key = given_row_key;
    row.title = "given cam";
    row.motion = given.motion;
    row.peaks = given.peaks;
    row.motion_peaks = given.motion_peaks;
    row.objective = given.certificate.objective;
    judge_limits(row, bench, given.motion_peaks);
    row.feasible = violated_limits(given).empty() && given.certificate.verdict != Verdict::failed;
    if (optimum && *optimum > 0.0 && std::isfinite(row.objective))
        row.loss_percent = 100.0 * (row.objective / *optimum - 1.0);
    return row;
}

}  // namespace

Comparison compare(const Scene& scene, const SolveControl& control) {
    Scene complete = with_written_limits(scene);
    Comparison comparison;
    std::optional<Solution> given;
    if (complete.is_given()) {
        given = solve_asked(complete, control);
        if (!weighs_anything(complete))
            throw InputError(
                "compare: found a given cam without [objective]; allowed: weights, by which it, laws and the "
                "optimum of its task are compared");
        complete = task_of(std::move(complete));
    }
    comparison.optimum = solve_asked(complete, control);
    const Solution& solution = comparison.optimum;
    // The laws get the optimum's angles, spring and transmission, and the number that was found for it.
    const bool chosen = complete.forces && complete.forces->is_chosen();
    const bool geared = complete.drive && complete.drive->transmission_range;
    if (searches_angles(complete) || solution.least || chosen || geared) complete = solution.scene;
    if (chosen) complete.forces->fix();
    if (geared) complete.drive->transmission_range.reset();
    const Bench bench = bench_of(complete, solution);
    comparison.cam = bench.cam;
    std::optional<double> optimum;
    if (solution.motion) {
        comparison.rows.push_back(optimum_row(bench, solution));
        if (comparison.rows.back().feasible && !complete.motion.prescribed())
            optimum = comparison.rows.back().objective;
    }
    if (given && given->motion) comparison.rows.push_back(given_row(bench, *given, optimum));
    for (const LawInfo& info : law_catalogue()) {
        const bool takes_states = info.key == "polynomial" && any_moves_on(bench.strokes);
        if (!info.rests && !takes_states) continue;  // no rise by itself
        if (control.progress) {
            const std::string line = "compares with " + info.title;
            control.progress(line);
        }
        comparison.rows.push_back(complete.prescribes_output() ? not_the_output(info)
                                                               : law_row(bench, make_law(info.key), optimum));
    }
    std::ranges::stable_sort(comparison.rows, [](const ComparisonRow& one, const ComparisonRow& other) {
        const auto rank = [](const ComparisonRow& row) {
            return !row.misfit.empty() ? 2 : row.feasible ? 0 : 1;
        };
        // Where the objective is the same for all, without one, the smaller cam is the better.
        const auto base = [](const ComparisonRow& row) {
            return row.base ? row.base->radius.value_or(infinity) : infinity;
        };
        return std::tuple(rank(one), one.objective, base(one)) <
               std::tuple(rank(other), other.objective, base(other));
    });
    return comparison;
}

}  // namespace camopt
