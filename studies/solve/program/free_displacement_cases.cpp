// SPDX-License-Identifier: MIT
#include "studies/solve/program/free_displacement_cases.hpp"

#include "objectives/grid/cam_problem.hpp"
#include "objectives/scene_model.hpp"
#include "solvers/exchange/continuous_solve.hpp"
#include "solvers/structured/structured_solver.hpp"
#include "splines/extrema.hpp"
#include "studies/compare/peak_arithmetic.hpp"
#include "studies/delivered/solution_report.hpp"
#include "studies/solve/solve_without_explaining.hpp"
#include "studies/solve/tie_break.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace camopt {

namespace {

using Sign = DisplacementBox::Sign;

// A case is cut where its relaxation puts the displacement, but no closer to its ends than this part of it:
// slices would never end.
constexpr double least_slice = 0.1;
// Boxes narrower than this, in lifts, are not cut again: what is left to gain is rounding.
constexpr double narrowest = 1e-10;

/// A rise between two dwells whose peaks are those of any segment of the program that moves from rest to
/// rest, for its angle and displacement do not change them.
Scene single_rise(const Scene& scene) {
    Scene rise;
    rise.spline = scene.spline;
    rise.solver = scene.solver;
    rise.solver.name = "auto";
    rise.solver.options.clear();
    rise.objective.velocity = scene.objective.velocity;
    rise.objective.acceleration = scene.objective.acceleration;
    rise.objective.jerk = scene.objective.jerk;
    rise.objective.reference = scene.objective.reference;
    rise.objective.tie_break = TieBreak::none;
    const auto cap = [](const std::optional<PeakLimit>& limit) {
        return limit && !limit->in_time() ? limit : std::nullopt;
    };
    rise.limits.velocity = cap(scene.limits.velocity);
    rise.limits.acceleration = cap(scene.limits.acceleration);
    rise.limits.jerk = cap(scene.limits.jerk);
    return rise;
}

bool says_nothing(const Scene& rise) {
    const ObjectiveSpec& objective = rise.objective;
    const bool weighs = objective.velocity > 0.0 || objective.acceleration > 0.0 || objective.jerk > 0.0;
    return !weighs && !rise.limits.velocity && !rise.limits.acceleration && !rise.limits.jerk;
}

double peak_of(const Peaks& peaks, int order) {
    return order == 1 ? peaks.velocity.value : order == 2 ? peaks.acceleration.value : peaks.jerk.value;
}

}  // namespace

DisplacementCases::DisplacementCases(const Scene& scene, const Peaks& reference, const SolveControl& control)
    : scene_(scene),
      reference_(reference),
      control_(control),
      family_(scene_family(scene, DesignKind::states)),
      free_(free_displacements(scene, family_)) {}

DisplacementCase DisplacementCases::whole() const {
    return {{}, whole_range(free_, family_)};
}

const ProvedBox& DisplacementCases::shape() {
    if (shape_) return *shape_;
    shape_.emplace();
    const Scene rise = single_rise(scene_);
    if (says_nothing(rise)) return *shape_;
    Certificate certificate = solve_without_explaining(rise, control_).certificate;
    shape_->infeasible = certificate.verdict == Verdict::infeasible;
    if (!shape_->infeasible && certificate.lower_bound) shape_->bound = *certificate.lower_bound;
    const bool proved = certificate.proof && (shape_->infeasible || certificate.lower_bound);
    if (proved) shape_->proof = std::make_shared<DualityProof>(std::move(*certificate.proof));
    if (!proved) *shape_ = {};
    return *shape_;
}

bool DisplacementCases::moves_from_rest_to_rest(const DisplacementCase& part) const {
    for (std::size_t i = 0; i < part.boxes.size(); ++i) {
        const bool moves = part.boxes[i].sign == Sign::rises || part.boxes[i].sign == Sign::falls;
        if (moves && free_.rest_to_rest[i]) return true;
    }
    return false;
}

void DisplacementCases::bound(DisplacementCase& part, double seconds) {
    if (moves_from_rest_to_rest(part)) {
        const ProvedBox& own = shape();
        if (own.infeasible || own.bound > part.bound) static_cast<ProvedBox&>(part) = own;
        if (part.infeasible) return;
    }
    const CamModel model = scene_model(scene_, DesignKind::states, reference_, part.boxes);
    CamProblem problem(convex_part(model, ConvexOver::every_motion));
    ExchangeOptions exchange = exchange_options(scene_);
    exchange.backend.native.clear();  // they belong to the backend the user chose
    exchange.backend.max_seconds = seconds;
    const JudgeOptions judge{scene_.solver.tolerance, scene_.solver.wanted_gap()};
    ContinuousResult result = solve_continuous(problem, *make_structured_solver(), exchange, judge, control_);
    Certificate& certificate = result.certificate;
    if (!certificate.proof) return;
    part.infeasible = certificate.verdict == Verdict::infeasible;
    const bool better = certificate.lower_bound && *certificate.lower_bound > part.bound;
    if (better) part.bound = *certificate.lower_bound;
    if (part.infeasible || better) part.proof = std::make_shared<DualityProof>(std::move(*certificate.proof));
    if (part.infeasible || result.x.size() == 0) return;
    const Eigen::VectorXd design = problem.design_values(result.x);
    part.levels.clear();
    for (const int joint : free_.joints)
        part.levels.push_back(family_.stretches()[static_cast<std::size_t>(joint) - 1].to.value(design));
    find_worst(part, problem.model(), result.x, design);
}

/// By how much each box's own peaks, measured by the displacement at hand, pass those of the relaxation.
void DisplacementCases::find_worst(DisplacementCase& part, const CamModel& model, const Eigen::VectorXd& x,
                                   const Eigen::VectorXd& design) const {
    double largest = 0.0;
    part.worst = -1;
    for (std::size_t i = 0; i < part.boxes.size(); ++i) {
        const DisplacementBox& box = part.boxes[i];
        if (box.sign == Sign::stands || box.most - box.least < narrowest) continue;
        const MotionFamily::Stretch& stretch = family_.stretches()[static_cast<std::size_t>(box.stretch)];
        const double found = stretch.to.value(design) - stretch.from.value(design);
        const double measure = std::max(std::abs(found), standing_displacement);
        const SplineCurve curve =
            part_of_run(family_.run_curve(stretch.run, design), stretch.begin, stretch.end, stretch.shift);
        const Peaks own = normalised_peaks(peaks_of(curve), {stretch.end - stretch.begin, measure});
        double excess = 0.0;
        for (std::size_t p = 0; p < model.parameters.size(); ++p) {
            const Parameter& parameter = model.parameters[p];
            if (parameter.kind != Parameter::Kind::peak) continue;
            const double relaxed = x[model.design.size() + static_cast<Eigen::Index>(p)];
            const double weight = parameter.weight > 0.0 ? parameter.weight : 1.0;
            excess += weight * std::max(0.0, peak_of(own, parameter.order) / parameter.reference - relaxed);
        }
        if (excess <= largest) continue;
        largest = excess;
        part.worst = static_cast<int>(i);
        part.liked = found;
    }
}

namespace {

/// The box to cut where the relaxation does not say: one whose sign is open, else the widest for its size.
int widest(const DisplacementCase& part) {
    int chosen = -1;
    double largest = 0.0;
    for (std::size_t i = 0; i < part.boxes.size(); ++i) {
        const DisplacementBox& box = part.boxes[i];
        const double width = box.most - box.least;
        if (box.sign == Sign::stands || width < narrowest) continue;
        const double size = box.sign == Sign::any ? infinity : width / box.largest_measure();
        if (size <= largest) continue;
        largest = size;
        chosen = static_cast<int>(i);
    }
    return chosen;
}

std::vector<DisplacementBox> parts_of(const DisplacementBox& box, double liked) {
    std::vector<DisplacementBox> parts;
    const auto add = [&](double least, double most, Sign sign) {
        DisplacementBox part = box;
        part.least = least;
        part.most = most;
        part.sign = sign;
        parts.push_back(part);
    };
    if (box.sign == Sign::any) {
        if (box.least < 0.0) add(box.least, 0.0, Sign::falls);
        add(0.0, 0.0, Sign::stands);
        if (box.most > 0.0) add(0.0, box.most, Sign::rises);
        return parts;
    }
    const double slice = least_slice * (box.most - box.least);
    const double cut = std::clamp(liked, box.least + slice, box.most - slice);
    add(box.least, cut, box.sign);
    add(cut, box.most, box.sign);
    return parts;
}

}  // namespace

std::vector<DisplacementCase> DisplacementCases::split(const DisplacementCase& whole) const {
    const bool known = whole.worst >= 0;
    const int chosen = known ? whole.worst : widest(whole);
    if (chosen < 0) return {};
    const DisplacementBox& box = whole.boxes[static_cast<std::size_t>(chosen)];
    const double liked = known ? whole.liked : 0.5 * (box.least + box.most);
    std::vector<DisplacementCase> parts;
    for (const DisplacementBox& piece : parts_of(box, liked)) {
        DisplacementCase part;
        part.bound = whole.bound;
        part.proof = whole.proof;
        part.boxes = whole.boxes;
        part.levels = whole.levels;
        part.boxes[static_cast<std::size_t>(chosen)] = piece;
        if (narrow(part.boxes, free_, family_)) parts.push_back(std::move(part));
    }
    return parts;
}

}  // namespace camopt
