// SPDX-License-Identifier: MIT
#include "studies/search/presolve.hpp"

#include "motions/laws/law.hpp"
#include "objectives/rules/maxima/rule_maxima.hpp"
#include "objectives/scene_model.hpp"
#include "scene/limit_table.hpp"
#include "studies/laws/law_motion.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

// In lifts: a control point of a motion lies within a few.
constexpr double farthest_control_point = 1e3;
// So many times the segments have freedom enough for whatever can be met at all; beyond a thousand there is
// no want of it.
constexpr int plenty = 16, most_conflict_segments = 1024;

int plenty_of(int segments) {
    return std::max(segments, std::min(plenty * segments, most_conflict_segments));
}

/// Weak duality for a cost of zero: the rows of a contradiction add up to 0 >= bound > 0. The box only
/// absorbs the rounding of that sum; it leaves out no curve a cam could follow.
DualityProof contradiction_proof(const ConditionConflict& conflict, int control_points) {
    DualityProof proof;
    proof.statement = "conditions";
    proof.cost = Eigen::VectorXd::Zero(control_points);
    proof.box = {Eigen::VectorXd::Constant(control_points, -farthest_control_point),
                 Eigen::VectorXd::Constant(control_points, farthest_control_point)};
    for (int j = 0; j < control_points; ++j)
        proof.variables.push_back(fmt::format("free control point {}", j));
    const auto rows = static_cast<Eigen::Index>(conflict.rows.size());
    proof.matrix.resize(rows, control_points);
    proof.lower.resize(rows);
    proof.multipliers.resize(rows);
    std::vector<Eigen::Triplet<double>> entries;
    for (Eigen::Index i = 0; i < rows; ++i) {
        const ConflictRow& row = conflict.rows[static_cast<std::size_t>(i)];
        proof.rows.push_back(row.name);
        proof.origins.push_back({row.name, {}, {}, Side::right, false});
        proof.lower[i] = -row.row.offset;
        proof.multipliers[i] = row.multiplier;
        for (std::size_t k = 0; k < row.row.columns.size(); ++k) {
            entries.emplace_back(i, row.row.columns[k], row.row.weights[k]);
        }
    }
    proof.upper = proof.lower;
    proof.matrix.setFromTriplets(entries.begin(), entries.end());
    proof.bound = recomputed_bound(proof);
    return proof;
}

/// "a; b; c": what a condition follows from or contradicts.
std::string list_of(const ConditionConflict& conflict) {
    return fmt::format("{}", fmt::join(conflict.others, "; "));
}

bool speaks_of_rest(const PlacedRule& rule) {
    return rule->limit() && rule->parameters().empty() && rule->highest_order() <= 1 && rule.stretch == -1 &&
           rule->curvature(-infinity, infinity) == Curvature::general;
}

bool holds_at(const PointRule& rule, double x) {
    return rule.places().empty() || std::ranges::binary_search(rule.places(), x);
}

/// The common violation t is at least that at the place of rest: a problem of one row.
DualityProof proof_of(const RestConflict& conflict) {
    DualityProof proof;
    proof.statement = "least_common_violation";
    proof.variables = {"common violation"};
    proof.cost = Eigen::VectorXd::Ones(1);
    proof.rows = {fmt::format("{} {}, x = {:.17g}, y = {:.17g}", conflict.key,
                              conflict.where.at_rest ? "at rest" : "of the prescribed motion",
                              conflict.where.x, conflict.where.y)};
    RowOrigin origin{conflict.key, {}, conflict.where.x, Side::right, true, {}, 0, conflict.fields};
    if (origin.fields.key.empty()) origin.fields.key = conflict.key;
    proof.origins = {origin};
    proof.matrix.resize(1, 1);
    proof.matrix.insert(0, 0) = 1.0;
    proof.lower = Eigen::VectorXd::Constant(1, conflict.violation);
    proof.upper = Eigen::VectorXd::Constant(1, infinity);
    proof.multipliers = Eigen::VectorXd::Constant(1, -1.0);
    proof.box = {Eigen::VectorXd::Zero(1), Eigen::VectorXd::Constant(1, 1.0 + conflict.violation)};
    proof.bound = recomputed_bound(proof);
    return proof;
}

void report_conflict_at(Solution& solution, const RestConflict& conflict, Reason reason) {
    solution.certificate.verdict = Verdict::infeasible;
    solution.certificate.reason = reason;
    solution.certificate.proof = proof_of(conflict);
    solution.certificate.proof_kind = ProofKind::duality;
    solution.conflict = {{conflict.key, conflict.where.x, 1.0, {}}};
}

constexpr double most_violation = 1e9;  // of a figure that is infinite

/// A limit on a derivative that a law has infinite, inside or where it joins.
std::optional<RestConflict> impulse_conflict(const Scene& scene, const MotionFamily& family,
                                             const MotionChain& motion) {
    for (const PeakLimitRow& row : peak_limit_rows()) {
        const std::optional<PeakLimit>& limit = row.in(scene.limits);
        for (std::size_t s = 0; limit && s < family.stretches().size(); ++s) {
            const MotionFamily::Stretch& stretch = family.stretches()[s];
            if (stretch.kind != StretchRequest::Kind::shape) continue;
            const std::shared_ptr<const Law> law = segment_law(scene.motion, s);
            const LawStroke stroke{SegmentKind::law,
                                   law,
                                   stretch.begin,
                                   stretch.end,
                                   motion.at(stretch.begin, Side::right).derivative[0],
                                   motion.at(stretch.end, Side::left).derivative[0]};
            const Extremum peak =
                derivative_peak(law_peaks(stroke, *law, motion, scene.motion.periodic()), row.order());
            if (std::isfinite(peak.value)) continue;
            return RestConflict{
                limit->key, {peak.at, motion.at(peak.at).derivative[0], false}, most_violation};
        }
    }
    return {};
}

}  // namespace

void report_contradicted_case(Solution& solution, const std::string& key, double apart) {
    report_conflict_at(solution, {key, {}, apart}, Reason::limits_contradict);
    solution.certificate.proof->rows = {key + ": the directions of the case and the given displacements"};
}

void report_redundant(Solution& solution, const MotionFamily& family) {
    for (const ConditionConflict& conflict : family.redundant())
        solution.notes.push_back(conflict.condition + " follows from the other conditions" +
                                 (conflict.others.empty() ? "" : ": " + list_of(conflict)));
}

void report_contradictions(Solution& solution, const MotionFamily& family) {
    int run = 0;
    while (family.run(run).contradictions().empty()) ++run;
    const DesignVector& design = family.run(run);
    solution.certificate.verdict = Verdict::infeasible;
    solution.certificate.reason = Reason::conditions_contradict;
    solution.certificate.proof =
        contradiction_proof(design.contradictions().front(), design.space().dimension());
    solution.certificate.proof_kind = ProofKind::duality;
    // Conditions that no spline can meet together are not a matter of freedom.
    const bool freedom =
        scene_family(with_segments(solution.scene, plenty_of(segments_of(solution.scene.spline))),
                     DesignKind::states)
            .contradictions()
            .empty();
    for (const ConditionConflict& conflict : design.contradictions()) {
        std::string note =
            conflict.others.empty() && !freedom
                ? fmt::format(
                      "{} contradicts the conditions at the ends of the motion, at its top or where its "
                      "segments join; more segments were tried without success: change it",
                      conflict.condition)
            : conflict.others.empty()
                ? fmt::format(
                      "degree {} with {} segments leaves too little freedom to meet the conditions at both "
                      "ends: give the spline more segments",
                      design.space().degree(), design.space().segments())
                : fmt::format("{} contradicts {}; {}", conflict.condition, list_of(conflict),
                              freedom
                                  ? "the spline has too little freedom to meet all of them: change one, or "
                                    "give it more segments"
                                  : "more segments were tried and do not help: change one");
        // A region is several conditions with one name.
        if (std::ranges::find(solution.notes, note) == solution.notes.end())
            solution.notes.push_back(std::move(note));
    }
}

std::optional<RestConflict> rest_conflict(const CamModel& model, double tolerance) {
    std::optional<RestConflict> worst;
    for (const PlacedRule& rule : model.rules) {
        if (!speaks_of_rest(rule) || model.sees_other(rule)) continue;
        for (const KnownPoint& known : model.known_points) {
            if (!known.at_rest || !holds_at(*rule, known.x)) continue;
            const double value = rule->evaluate({known.x, {known.y, 0.0, 0.0, 0.0}}, {}).value;
            const double violation = value / rule->scale();
            if (violation > tolerance && (!worst || violation > worst->violation))
                worst = RestConflict{rule->name(), known, violation, rule->origin().fields};
        }
    }
    return worst;
}

bool settle_prescribed(Solution& solution, CamModel& model) {
    const MotionChain motion = model.design.motion(Eigen::VectorXd());
    const double tolerance = solution.scene.solver.tolerance;
    std::optional<RestConflict> worst;
    const auto look = [&](const PlacedRule& rule, const Extremum& maximum) {
        const double scale = rule->scale_at(maximum.at);
        if (scale == 0.0) return;
        const double violation = std::isfinite(maximum.value) ? maximum.value / scale : most_violation;
        if (!(violation > tolerance) || (worst && violation <= worst->violation)) return;
        const double y = motion.at(maximum.at, maximum.side).derivative[0];
        worst = RestConflict{rule->name(), {maximum.at, y, false}, violation, rule->origin().fields};
    };
    for (const PlacedRule& rule : model.rules) {
        if (!rule->parameters().empty()) continue;
        if (const WholeMotionRule* const whole = rule->whole())
            for (const WholeMotionRule::Place& place : whole->maxima(motion, {})) look(rule, place.where);
        else
            for (const Extremum& maximum : rule_maxima(rule, model.design, motion, {})) look(rule, maximum);
    }
    std::erase_if(model.rules, [](const PlacedRule& rule) { return rule->parameters().empty(); });
    if (const auto impulse = impulse_conflict(solution.scene, model.design, motion)) worst = impulse;
    if (!worst) return false;
    report_conflict_at(solution, *worst, Reason::limits_contradict);
    solution.notes.push_back(
        fmt::format("the motion is prescribed, and {} is violated at {:.6g} deg", worst->key,
                    worst->where.x * solution.scene.motion.unit_angle() / units::degree));
    return true;
}

Certificate certificate_of_constant(const CamModel& model) {
    DualityProof proof;
    proof.statement = "objective";
    proof.variables = {"prescribed motion"};
    proof.cost = Eigen::VectorXd::Zero(1);
    proof.constant = model.cost_constant;
    proof.matrix.resize(0, 1);
    proof.box = {Eigen::VectorXd::Zero(1), Eigen::VectorXd::Zero(1)};
    proof.bound = recomputed_bound(proof);
    Certificate certificate;
    certificate.verdict = Verdict::optimal;
    certificate.objective = model.cost_constant;
    certificate.lower_bound = proof.bound;
    certificate.gap = relative_gap(certificate.objective, proof.bound);
    certificate.worst_violation = 0.0;
    certificate.proof_kind = ProofKind::duality;
    certificate.proof = std::move(proof);
    return certificate;
}

bool report_rest_conflict(Solution& solution, const CamModel& model) {
    const auto worst = rest_conflict(model, solution.scene.solver.tolerance);
    if (!worst) return false;
    report_conflict_at(solution, *worst, Reason::limit_broken_at_rest);
    solution.notes.push_back(fmt::format(
        "every motion of this scene rests at {:.6g} deg at displacement {:.6g} (in lifts), and {} is "
        "violated there for every motion",
        worst->where.x * solution.scene.motion.unit_angle() / units::degree, worst->where.y, worst->key));
    return true;
}

}  // namespace camopt
