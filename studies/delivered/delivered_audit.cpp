// SPDX-License-Identifier: MIT
#include "studies/delivered/delivered_audit.hpp"

#include "core/text/list_text.hpp"
#include "objectives/motion_bounds.hpp"
#include "scene/limit_table.hpp"
#include "studies/delivered/scene_limits.hpp"
#include "studies/delivered/solution_parts.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

// Of equal jumps, to rounding, the first is named.
constexpr double same_jump = 1e-9;

/// NaN is worse than any number.
bool is_worse(double jump, double than) {
    return !std::isnan(than) && !(jump <= than + same_jump * than);
}

struct Fault {
    Reason reason;
    std::string note;
};

std::vector<const SplineCurve*> curves_of(const Solution& solution) {
    std::vector<const SplineCurve*> curves;
    if (solution.curve) curves.push_back(&*solution.curve);
    for (const SegmentReport& segment : solution.segments)
        if (segment.curve) curves.push_back(&*segment.curve);
    return curves;
}

// Of the width of a segment: strokes are normalised by their own angle, and the objective is as wrong.
constexpr double largest_rounding_of_width = 1e-8;

/// Breakpoints of a program are rounded where they are along the cycle, however short the stroke.
std::optional<Fault> breakpoint_fault(const Solution& solution) {
    if (solution.scene.motion.type != MotionType::program) return {};
    constexpr double rounding = std::numeric_limits<double>::epsilon();
    for (const SplineCurve* curve : curves_of(solution)) {
        const SplineSpace& space = curve->space();
        for (int i = 0; i < space.segments(); ++i) {
            const double at = space.breakpoints()[i + 1];
            const double lost = rounding * std::abs(at) / space.width(i);
            if (lost <= largest_rounding_of_width) continue;
            return Fault{
                Reason::breakpoints_too_close,
                fmt::format("the segment that ends at x = {:.10g} is so narrow that double precision "
                            "gives its width to {:.2g} of it only",
                            at, lost)};
        }
    }
    return {};
}

std::optional<Fault> joint_fault(const Solution& solution) {
    JointJump worst;
    for (const SplineCurve* curve : curves_of(solution)) {
        const JointJump jump = worst_joint_jump(*curve, solution.cam_peaks);
        if (is_worse(jump.relative, worst.relative)) worst = jump;
    }
    if (worst.relative <= largest_joint_jump) return {};
    return Fault{
        Reason::breakpoints_too_close,
        fmt::format("double precision does not resolve this spline, whose breakpoints lie too close together "
                    "or whose conditions nearly contradict: derivative {} of the motion jumps by {:.2g} of "
                    "its largest value at x = {:.10g}",
                    worst.order, worst.relative, worst.at)};
}

// Control points are sums of products over a whole support, and sums of them give the curve back: each way
// rounds some hundred times where neighbours differ much in width.
constexpr double roundings_of_a_coefficient = 4096.0;
// Joints that jump by largest_joint_jump at both ends of a segment, and of its neighbours: coefficients
// cannot say so, and miss the curve by as much.
constexpr double largest_coefficient_miss = 10.0 * largest_joint_jump;

/// Σ_m size_m m! / (m − order)! width^(m − order): the most a derivative can be on a segment whose local
/// coefficients have these sizes.
double most_of_derivative(const Eigen::VectorXd& sizes, int order, double width) {
    double most = 0.0, power = 1.0;
    for (Eigen::Index m = order; m < sizes.size(); ++m) {
        double factor = power;
        for (int r = 0; r < order; ++r) factor *= static_cast<double>(m - r);
        most += factor * sizes[m];
        power *= width;
    }
    return most;
}

/// The published coefficients give the curve back, as well as doubles of displacements up to the lift can: at
/// the top they are of its size, and a motion and its mirror image are treated equally.
std::optional<Fault> coefficient_fault(const SplineCurve& curve, const Peaks& peaks) {
    const SplineSpace& space = curve.space();
    const Eigen::VectorXd coefficients = curve.coefficients();
    const std::array<double, 4> size = {1.0, peaks.velocity.value, peaks.acceleration.value,
                                        peaks.jerk.value};
    constexpr double rounding = roundings_of_a_coefficient * std::numeric_limits<double>::epsilon();
    for (int i = 0; i < space.segments(); ++i) {
        const Eigen::MatrixXd basis = monomials_of_basis(space, i);
        const auto own = coefficients.segment(space.first_basis_function(i), space.degree() + 1);
        const Eigen::VectorXd missed = (basis * own - curve.pieces().col(i)).cwiseAbs();
        for (int order = 0; order <= 3; ++order) {
            const double found = most_of_derivative(missed, order, space.width(i));
            if (found <= largest_coefficient_miss * size[static_cast<std::size_t>(order)]) continue;
            const Eigen::VectorXd met = basis.cwiseAbs() * own.cwiseAbs().cwiseMax(1.0);
            if (found <= rounding * most_of_derivative(met, order, space.width(i))) continue;
            return Fault{Reason::coefficients_too_coarse,
                         fmt::format("the coefficients do not reproduce derivative {} of the curve between "
                                     "x = {:.10g} and {:.10g}: it is off by {:.2g} of its peak",
                                     order, space.breakpoints()[i], space.breakpoints()[i + 1],
                                     found / size[static_cast<std::size_t>(order)])};
        }
    }
    return {};
}

std::optional<Fault> condition_fault(const Solution& solution) {
    const double tolerance = std::max(solution.scene.solver.tolerance, condition_rounding);
    const std::vector<ConditionMiss> missed = missed_conditions(solution, tolerance);
    if (missed.empty()) return {};
    return Fault{Reason::condition_not_met,
                 "the delivered motion violates a condition: " + missed.front().condition};
}

/// Lifts.
std::array<double, 2> range_of_motion(const Solution& solution) {
    const FigureAlong displacement = [&](double x, Side side) {
        return solution.motion->at(x, side).derivative[0];
    };
    const std::vector<double> breakpoints = solution.motion->breakpoints();
    return {least_along(breakpoints, displacement).value, largest_along(breakpoints, displacement).value};
}

/// Of a follower between two lifts.
std::string fault_of_cam(const Solution& solution, double least, double most) {
    const DrivenMechanism& cam = solution.cam->cam;
    const double lift = solution.scene.motion.lift;
    return cam.formulas->fault(cam.dimensions, lift * least, lift * most);
}

/// A cam whose figures would have no value: the follower does not reach all of its motion.
std::optional<Fault> cam_fault(const Solution& solution) {
    if (!solution.cam) return {};
    const auto [least, most] = range_of_motion(solution);
    const std::string fault = fault_of_cam(solution, least, most);
    if (fault.empty()) return {};
    return Fault{Reason::cam_cannot_be_built, "the cam of this motion cannot be built: " + fault};
}

bool is_violated(const Solution& solution, const ConstraintReport& report) {
    const CamReport* const cam = solution.cam ? &*solution.cam : nullptr;
    const double tolerance = std::max(solution.scene.solver.tolerance, figure_rounding);
    const bool has_value =
        is_least_limit(report.name) ? !std::isnan(report.worst) : std::isfinite(report.worst);
    return !has_value || !(limit_excess(report) <= tolerance * limit_scale(solution.scene, cam, report));
}

std::optional<Fault> limit_fault(const Solution& solution) {
    for (const ConstraintReport& report : solution.constraints) {
        if (!is_violated(solution, report)) continue;
        const std::string unit = report.unit.empty() ? "" : " " + report.unit;
        return Fault{Reason::limit_not_kept,
                     fmt::format("{} = {:.9g}{} is violated: {} reaches {:.9g}{} at x = {:.6g}", report.key,
                                 report.limit, unit, report.name, report.worst, unit, report.at)};
    }
    return {};
}

/// Of the cam's limits between the points that figures come from.
std::optional<Fault> limit_between_fault(const Solution& solution) {
    if (!solution.cam) return {};
    const double tolerance = std::max(solution.scene.solver.tolerance, figure_rounding);
    for (const EnclosedLimit& limit : solution.cam->limits_along)
        if (!(limit.worst <= tolerance))
            return Fault{Reason::limit_not_kept,
                         fmt::format("{} is violated by {:.2g} of its size at x = {:.6g}", limit.key,
                                     limit.worst, limit.at)};
    return {};
}

/// A mean displacement near the end of what is searched.
std::optional<Fault> unbounded_fault(const Solution& solution) {
    constexpr double nearly = 0.5;
    if (!(solution.scene.objective.area > 0.0)) return {};
    if (!(lost_area(solution.output_motion()) < 1.0 - nearly * farthest_displacement)) return {};
    return Fault{
        Reason::unbounded,
        "the objective has no least value: the more a motion leaves the lift, the less area is lost, "
        "and the other terms cost less than that gains; motion.within_lift = true, a limit or larger "
        "weights of the other terms bound it"};
}

std::optional<Fault> objective_fault(double believed, double found) {
    if (std::abs(believed - found) <= objective_rounding * std::max(1.0, std::abs(found))) return {};
    return Fault{
        Reason::objective_not_of_the_curve,
        fmt::format("the solver's objective {:.9g} differs from that of the curve, {:.9g}", believed, found)};
}

/// A gap that the curve's own objective widens beyond solver.gap is no proof that it is optimal.
void judge_gap(Certificate& certificate, double allowed) {
    if (certificate.verdict != Verdict::optimal || !certificate.gap || *certificate.gap <= allowed) return;
    certificate.verdict = Verdict::local;
    certificate.reason = Reason::stationary;
}

/// The last word on bounds: one that passes the objective is none of this motion.
void drop_passed_bound(Certificate& certificate, double tolerance) {
    if (!certificate.lower_bound || !bound_passes(certificate.objective, *certificate.lower_bound,
                                                  std::max(tolerance, objective_rounding)))
        return;
    forget_proof(certificate);
    if (certificate.verdict != Verdict::optimal) return;
    certificate.verdict = Verdict::feasible;
    certificate.reason = Reason::limits_within_rounding;
}

std::string active_limits(const Solution& solution) {
    std::string text;
    for (const ConstraintReport& report : solution.constraints)
        if (report.active) append_item(text, fmt::format("{} = {:.9g}", report.key, report.limit));
    return text.empty() ? "the limits" : text;
}

/// Says what a proof with relaxed limits is a proof of, and why there is none where there is none.
void tell_of_rounding(Solution& solution) {
    const Certificate& certificate = solution.certificate;
    const bool relaxed = is_relaxed(certificate);
    if (!relaxed && certificate.reason != Reason::limits_within_rounding) return;
    std::string note =
        fmt::format("{}: infeasible to within rounding. Only the tolerance makes it feasible, and ",
                    active_limits(solution));
    if (relaxed)
        note += fmt::format(
            "the bound holds for every motion that satisfies the limits to within {:.2g} of their size",
            certificate.proof->limits_relaxed_by);
    else
        note += "a bound for the limits as written exceeds the objective, so none is reported";
    solution.notes.push_back(std::move(note));
}

void fail(Certificate& certificate, Reason reason) {
    certificate.verdict = Verdict::failed;
    certificate.reason = reason;
    forget_proof(certificate);
    certificate.stationarity.reset();
}

/// What the certificate says of limits between places.
void tell_of_enclosures(Solution& solution) {
    Certificate& certificate = solution.certificate;
    certificate.verified.clear();
    certificate.unverified.clear();
    for (const ConstraintReport& limit : solution.constraints)
        (limit.verified ? certificate.verified : certificate.unverified).push_back(limit.key);
}

// Of the motion's peaks: a curve that moves less than this is measured by the motion, not by its own
// rounding.
constexpr double standstill = 1e-3;

double size_of(const SplineCurve& curve, int order) {
    return order == 0 ? curve.pieces().row(0).cwiseAbs().maxCoeff() : peak_of(curve, order).value;
}

}  // namespace

std::vector<std::string> violated_limits(const Solution& solution) {
    std::vector<std::string> keys;
    for (const ConstraintReport& report : solution.constraints)
        if (is_violated(solution, report) && std::ranges::find(keys, report.key) == keys.end())
            keys.push_back(report.key);
    return keys;
}

void audit_given(Solution& solution) {
    Certificate& certificate = solution.certificate;
    certificate.verdict = Verdict::feasible;
    certificate.reason = Reason::given_cam;
    certificate.worst_violation = 0.0;
    certificate.objective = defined_objective(solution);
    const CamReport* const cam = solution.cam ? &*solution.cam : nullptr;
    for (const ConstraintReport& report : solution.constraints)
        if (is_violated(solution, report))
            certificate.worst_violation = std::max(
                certificate.worst_violation, limit_excess(report) / limit_scale(solution.scene, cam, report));
    std::optional<Fault> fault = joint_fault(solution);
    for (const SplineCurve* curve : curves_of(solution))
        if (!fault) fault = coefficient_fault(*curve, solution.cam_peaks);
    if (!fault) fault = cam_fault(solution);
    if (!fault) return tell_of_enclosures(solution);
    fail(certificate, fault->reason);
    if (is_no_motion(fault->reason)) withdraw_motion(solution);
    solution.notes.push_back(std::move(fault->note));
}

bool cam_can_be_built(const Solution& solution) {
    return !cam_fault(solution);
}

std::optional<std::array<double, 2>> buildable_reach(const Solution& solution) {
    constexpr int bisections = 60;
    constexpr double inside = 1.0 - 1e-6;  // at the very end it is a point
    if (!solution.cam || !fault_of_cam(solution, 0.0, 0.0).empty()) return {};
    const auto [least, most] = range_of_motion(solution);
    std::array<double, 2> reach = {-infinity, infinity};
    const auto falls_to = [&](double y) { return fault_of_cam(solution, y, 0.0).empty(); };
    if (!falls_to(least)) reach[0] = inside * bisected(falls_to, {0.0, least}, bisections).with;
    const auto rises_to = [&](double y) { return fault_of_cam(solution, 0.0, y).empty(); };
    if (!rises_to(most)) reach[1] = inside * bisected(rises_to, {0.0, most}, bisections).with;
    return reach;
}

void withdraw_motion(Solution& solution) {
    solution.motion.reset();
    solution.output.reset();
    solution.curve.reset();
    solution.segments.clear();
    solution.cam.reset();
    solution.peaks = solution.motion_peaks = solution.cam_peaks = {};
    solution.own_terms.clear();
    solution.drive.reset();
    solution.surge.reset();
    solution.constraints.clear();
    solution.certificate.objective = infinity;
}

JointJump worst_joint_jump(const SplineCurve& curve, const Peaks& motion) {
    const std::vector<double>& breakpoints = curve.space().breakpoints();
    const std::array<double, 4> whole = {1.0, motion.velocity.value, motion.acceleration.value,
                                         motion.jerk.value};
    JointJump worst;
    for (int order = 0; order <= std::min(curve.continuity(), 3); ++order) {
        double largest = 0.0;
        JointJump jump{0.0, 0.0, order};
        for (const double joint : breakpoints) {
            const double left = curve.derivative(joint, order, Side::left);
            const double right = curve.derivative(joint, order, Side::right);
            largest = std::max({largest, std::abs(left), std::abs(right)});
            if (is_worse(std::abs(left - right), jump.relative))
                jump = {std::abs(left - right), joint, order};
        }
        // Where the derivative vanishes at every joint (two segments that mirror each other) its size lies
        // between.
        if (jump.relative > largest_joint_jump * largest) largest = std::max(largest, size_of(curve, order));
        largest = std::max(largest, standstill * whole[static_cast<std::size_t>(order)]);
        jump.relative /= largest > 0.0 ? largest : 1.0;
        if (is_worse(jump.relative, worst.relative)) worst = jump;
    }
    return worst;
}

void drop_idle_bound(Certificate& certificate, const ObjectiveSpec& objective) {
    if (certificate.verdict == Verdict::optimal) return;
    if (!certificate.lower_bound || *certificate.lower_bound >= least_objective(objective)) return;
    forget_proof(certificate);
}

void audit_delivered(Solution& solution) {
    Certificate& certificate = solution.certificate;
    if (!solution.motion) {
        certificate.objective = infinity;
        return;
    }
    const double believed = certificate.objective;
    certificate.objective = defined_objective(solution);
    if (certificate.lower_bound && certificate.gap)
        certificate.gap =
            std::max(*certificate.gap, relative_gap(certificate.objective, *certificate.lower_bound));
    std::optional<Fault> fault = unbounded_fault(solution);
    if (!fault) fault = joint_fault(solution);
    if (!fault) fault = breakpoint_fault(solution);
    for (const SplineCurve* curve : curves_of(solution))
        if (!fault) fault = coefficient_fault(*curve, solution.cam_peaks);
    if (!fault) fault = condition_fault(solution);
    if (!fault) fault = cam_fault(solution);
    if (!fault) fault = limit_fault(solution);
    if (!fault) fault = limit_between_fault(solution);
    if (!fault) fault = objective_fault(believed, certificate.objective);
    if (!fault) {
        tell_of_enclosures(solution);
        judge_gap(certificate, solution.scene.solver.wanted_gap(solution.solver.convex));
        drop_passed_bound(certificate, solution.scene.solver.tolerance);
        drop_idle_bound(certificate, solution.scene.objective);
        return tell_of_rounding(solution);
    }
    fail(certificate, fault->reason);
    if (is_no_motion(fault->reason)) withdraw_motion(solution);
    solution.notes.push_back(std::move(fault->note));
}

}  // namespace camopt
