// SPDX-License-Identifier: MIT
#include "studies/search/program/program_search.hpp"

#include "solvers/certificate/certificate.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace camopt {

namespace {

// Part of the gap that a box may keep when it is closed.
constexpr double closing_part_of_gap = 0.5;
constexpr double step_growth = 2.0, step_shrink = 0.25;

}  // namespace

ProgramSearch::ProgramSearch(const Scene& scene, const SolveGiven& solve_given, const SolveControl& control,
                             Kind kind)
    : scene_(scene),
      solve_given_(solve_given),
      control_(control),
      kind_(std::move(kind)),
      allowed_(std::min(scene.solver.max_seconds, control.deadline.seconds_left())) {}

bool ProgramSearch::out_of_time(double part) {
    if (control_.stopped()) return true;
    const bool in_vain = !found() && control_.in_vain.passed();
    if (!in_vain && left(part) > 0.0) return false;
    timed_out_ = true;
    return true;
}

bool ProgramSearch::is_closed(const ProvedBox& box) const {
    return box.infeasible || box.bound >= objective() - closing_part_of_gap * scene_.solver.wanted_gap() *
                                                            std::max(1.0, objective());
}

Scene ProgramSearch::quick(const Values& values, double seconds) const {
    Scene scene = given(values);
    scene.objective.tie_break = TieBreak::none;
    scene.solver.name = "auto";
    scene.solver.options.clear();
    scene.spline.design = DesignKind::automatic;
    scene.solver.max_seconds = seconds;
    return scene;
}

bool ProgramSearch::try_values(const Values& values, double part_of_time) {
    if (std::ranges::find(tried_, values) != tried_.end()) return false;
    tried_.push_back(values);
    const double seconds = left(part_of_time);
    if (seconds <= 0.0) return false;
    Solution solution = solve_given_(quick(values, seconds));
    const bool better = solution.motion && solution.certificate.objective < objective();
    if (!better || !counts(solution)) return false;
    best_ = std::move(solution);
    best_values_ = values;
    return true;
}

double ProgramSearch::next_step(double step, bool helped) {
    return step * (helped ? step_growth : step_shrink);
}

Solution ProgramSearch::best_solved() const {
    Scene scene = given(best_values_);
    scene.solver.max_seconds = std::max(left(1.0), allowed_ * (1.0 - time_for_moves));
    Solution last = solve_given_(scene);
    const double allowance = scene_.solver.wanted_gap() * std::max(1.0, objective());
    const bool no_worse = last.motion && last.certificate.objective <= objective() + allowance;
    return no_worse ? last : best_;
}

void ProgramSearch::judge(Solution& solution, std::vector<CaseProof> boxes, bool time_ended) const {
    Certificate& certificate = solution.certificate;
    const Verdict for_given = certificate.verdict;
    forget_proof(certificate);
    certificate.cases.clear();
    solution.solver.proof_source.clear();
    const bool complete = !boxes.empty() && std::ranges::all_of(boxes, [](const CaseProof& box) {
        return box.proof != nullptr;
    });
    const bool nothing = complete && std::ranges::all_of(boxes, &CaseProof::infeasible);
    double bound = infinity;
    for (const CaseProof& box : boxes)
        if (!box.infeasible) bound = std::min(bound, box.bound);
    if (complete) {
        solution.solver.proof_source = kind_.proof_source;
        const bool one = boxes.size() == 1;  // it settles the whole
        certificate.proof_kind = one ? ProofKind::duality : ProofKind::boxes;
        if (one || (nothing && !solution.motion)) certificate.proof = *boxes.front().proof;
        if (!one) certificate.cases = std::move(boxes);
    }
    if (!solution.motion) {
        certificate.verdict = nothing ? Verdict::infeasible : Verdict::failed;
        certificate.reason = nothing              ? Reason::limits_contradict
                             : control_.stopped() ? Reason::interrupted
                             : time_ended         ? Reason::time_limit
                                                  : Reason::no_feasible_point;
        return;
    }
    if (complete) {
        certificate.lower_bound = bound;
        certificate.gap = relative_gap(certificate.objective, bound);
    }
    if (for_given == Verdict::failed || for_given == Verdict::infeasible) return;
    const bool optimal = certificate.gap && *certificate.gap <= scene_.solver.wanted_gap();
    const bool local = settled_ && best_values_.size() == kind_.one_freedom && for_given <= Verdict::local;
    certificate.verdict = optimal ? Verdict::optimal : local ? Verdict::local : Verdict::feasible;
    certificate.reason = optimal ? Reason::none : local ? Reason::stationary : kind_.open;
    if (!optimal && control_.stopped()) certificate.reason = Reason::interrupted;
    if (!optimal && timed_out_) certificate.reason = Reason::time_limit;
}

void ProgramSearch::add_to_design(Solution& solution, std::vector<std::string> names) const {
    const auto count = static_cast<Eigen::Index>(best_values_.size());
    names.insert(names.end(), solution.design.names.begin(), solution.design.names.end());
    Eigen::VectorXd values(count + solution.design.values.size());
    values << Eigen::Map<const Eigen::VectorXd>(best_values_.data(), count), solution.design.values;
    solution.design.names = std::move(names);
    solution.design.values = std::move(values);
}

void ProgramSearch::note_time(Solution& solution) const {
    if (!timed_out_) return;
    solution.notes.push_back(fmt::format(
        "the search for {} reached its time limit: the result depends on the machine", kind_.name));
}

}  // namespace camopt
