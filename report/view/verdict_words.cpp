// SPDX-License-Identifier: MIT
#include "report/view/verdict_words.hpp"

#include "core/text/list_text.hpp"
#include "report/view/number_text.hpp"
#include "report/view/peak_comparison.hpp"
#include "studies/delivered/delivered_audit.hpp"
#include "studies/search/plan.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

constexpr double least_shown_gap = 1e-9;
constexpr int figures = 9;  // of objective and bound: enough to see a gap of 1e-7

/// The search had several starts: the scene is not convex.
bool searched_from_starts(const Solution& solution) {
    return !solution.solver.convex && solution.solver.starts > 0;
}

/// No backend ran, since laws and dwells fix the motion.
bool is_fixed(const Solution& solution) {
    return solution.scene.motion.prescribed() && solution.solver.termination == Termination::not_run;
}

std::string because(const Certificate& certificate) {
    return certificate.reason == Reason::none ? std::string{}
                                              : fmt::format(" ({})", words_of(name_of(certificate.reason)));
}

/// A motion that was found, and then did not stand the audit of what is delivered.
bool was_found_wanting(const Solution& solution) {
    return solution.certificate.verdict == Verdict::failed && solution.motion != nullptr;
}

/// A motion was found that doubles do not hold: it is not delivered.
bool is_beyond_doubles(const Solution& solution) {
    return solution.certificate.verdict == Verdict::failed && solution.motion == nullptr &&
           is_no_motion(solution.certificate.reason);
}

/// Rounded up, to one digit below 1 %.
std::string percent_above(double part) {
    const double percent = 100.0 * part;
    const int decimals = std::max(0, -static_cast<int>(std::floor(std::log10(percent))));
    const double unit = std::pow(10.0, -decimals);
    return fmt::format("{:.{}f} %", unit * std::ceil(percent / unit * (1.0 - 1e-9)), decimals);
}

/// "8 starts" or "from one start"
std::string starts_text(int starts) {
    return starts == 1 ? std::string("from one start") : fmt::format("the best of {} starts", starts);
}

/// The user stopped it, and that is why it is no better.
bool was_interrupted(const Certificate& certificate) {
    return certificate.reason == Reason::interrupted;
}

/// Of a motion without a proof that it is the best one: what is proved.
std::string not_optimal_words(const Certificate& certificate) {
    const std::string gap = gap_words(certificate);
    return gap.empty() ? "optimality is not proved" : "proved to be " + gap;
}

std::string interrupted_sentence(const Solution& solution) {
    const int starts = solution.solver.starts;
    const std::string where = !searched_from_starts(solution) ? std::string()
                              : starts == 1 ? std::string(" in the search from its first start")
                                            : fmt::format(" in the search, after {} starts", starts);
    if (solution.certificate.verdict == Verdict::failed)
        return fmt::format(
            "Interrupted{}: no motion that satisfies every limit was found. Whether one exists is open.",
            where);
    return fmt::format("Interrupted{}: the best motion found so far satisfies every limit; {}.", where,
                       not_optimal_words(solution.certificate));
}

/// Of the motion of a given cam: its limits.
std::string given_words(const Solution& solution) {
    if (solution.constraints.empty()) return "the scene has no limits";
    const std::vector<std::string> violated = violated_limits(solution);
    if (violated.empty()) return "every limit is satisfied";
    return fmt::format("it violates {}",
                       listed(
                           violated, ", ", [](const std::string& key) { return key; }, " and "));
}

}  // namespace

std::string gap_words(const Certificate& certificate) {
    if (!certificate.gap) return {};
    double part = std::max(*certificate.gap, least_shown_gap);
    // The gap is relative to 1 at least; the objective may be smaller.
    if (const std::optional<double>& bound = certificate.lower_bound) {
        if (!(*bound > 0.0)) return {};
        part = std::max(part, certificate.objective / *bound - 1.0);
    }
    return part <= 1.0 ? fmt::format("at most {} from the optimum", percent_above(part)) : std::string{};
}

std::string verdict_sentence(const Solution& solution) {
    const Certificate& certificate = solution.certificate;
    const SolverReport& solver = solution.solver;
    if (was_found_wanting(solution))
        return fmt::format("Failed: the motion found does not match the scene{}, see the notes.",
                           because(certificate));
    if (is_beyond_doubles(solution))
        return fmt::format(
            "Failed: double precision cannot represent the motion found{}, see the notes. Other "
            "breakpoints may.",
            because(certificate));
    if (certificate.verdict == Verdict::feasible && !solution.machine.empty())
        return fmt::format("An axis of a machine, solved with all the others: {}. Every limit is satisfied.",
                           solution.machine);
    if (certificate.reason == Reason::given_cam)
        return fmt::format("The motion of a given cam, nothing to optimize; {}.", given_words(solution));
    if (was_interrupted(certificate)) return interrupted_sentence(solution);
    if (solution.scene.motion.prescribed()) {
        const bool kept = certificate.verdict == Verdict::optimal;
        const bool free = solution.plan && solution.plan->dimensions > 0;
        if (!free && (kept || certificate.verdict == Verdict::infeasible))
            return kept ? "Prescribed motion, nothing to optimize; every limit is satisfied."
                        : "Proved infeasible: the prescribed motion violates a limit.";
        if (kept) return "Prescribed motion; the dimensions of its cam are proved optimal.";
        if (certificate.verdict == Verdict::infeasible)
            return "Proved infeasible: the prescribed motion violates a limit with every cam of this scene.";
    }
    if (!searched_from_starts(solution) || certificate.verdict == Verdict::optimal ||
        certificate.verdict == Verdict::infeasible)
        return verdict_sentence(certificate);
    const std::string gap = gap_words(certificate);
    if (certificate.verdict == Verdict::local)
        return fmt::format(
            "Local optimum, {}: no small change improves it{}", starts_text(solver.starts),
            gap.empty() ? ". A better one may exist." : ", and it is proved to be " + gap + ".");
    if (certificate.verdict == Verdict::feasible)
        return fmt::format("Feasible, {}: every limit is satisfied; {}{}.", starts_text(solver.starts),
                           not_optimal_words(certificate), because(certificate));
    return fmt::format(
        "Failed: no motion that satisfies every limit was found from {} {}; infeasibility is not proved{}.",
        solver.starts, solver.starts == 1 ? "start" : "starts", because(certificate));
}

std::string verdict_sentence(const Certificate& certificate) {
    switch (certificate.verdict) {
        case Verdict::optimal:
            if (is_relaxed(certificate))
                return fmt::format(
                    "Proved optimal, with limits that lie within rounding of infeasible: no curve of this "
                    "spline "
                    "space that satisfies them to within {} of their size is better by more than the gap.",
                    short_text(certificate.proof->limits_relaxed_by, 2));
            return "Proved optimal: no curve of this spline space is better by more than the gap.";
        case Verdict::local:
            if (const std::string gap = gap_words(certificate); !gap.empty())
                return fmt::format("Feasible and stationary, and proved to be {}; solver.gap requires less.",
                                   gap);
            return "Local optimum: feasible, and no small change improves it; not proved to be the "
                   "global optimum.";
        case Verdict::feasible:
            return fmt::format("Feasible: every limit is satisfied; {}{}.", not_optimal_words(certificate),
                               because(certificate));
        case Verdict::infeasible:
            if (certificate.reason == Reason::conditions_contradict)
                return "Infeasible: no curve of this spline space meets all the conditions, see the notes.";
            return "Proved infeasible: no curve of this spline space satisfies all the limits.";
        case Verdict::failed:
            break;
    }
    return fmt::format("Failed: neither a curve nor a proof was found{}.", because(certificate));
}

VerdictWords verdict_words(const Solution& solution) {
    const Certificate& certificate = solution.certificate;
    const std::string gap = gap_words(certificate);
    const std::string proved = gap.empty() ? gap : "Proved: it is " + gap + ".";
    switch (certificate.verdict) {
        case Verdict::optimal:
            if (solution.scene.motion.prescribed())
                return {"good", "The prescribed motion satisfies every limit", verdict_sentence(solution)};
            return {"good", "The best motion, and proved optimal",
                    "It satisfies every limit, and no motion of this spline is better for the weights of the "
                    "scene."};
        case Verdict::local:
            return {"good", "A good motion: no small change makes it better",
                    "It satisfies every limit. " +
                        (gap.empty() ? "A quite different motion may still be better." : proved)};
        case Verdict::feasible:
            if (certificate.reason == Reason::given_cam)
                return {violated_limits(solution).empty() ? "good" : "bad", "The motion of a given cam",
                        verdict_sentence(solution)};
            if (!solution.machine.empty())
                return {"good", "An axis of a machine",
                        "It satisfies every limit. All axes were solved together: " + solution.machine +
                            ". What is proved is in the report of the machine."};
            return {"fair", "A motion that satisfies every limit",
                    gap.empty() ? "Whether it is the best one is not known: the search ended early."
                                : proved + " The search for a better one ended early."};
        case Verdict::infeasible:
            if (solution.scene.motion.prescribed())
                return {"bad", "The prescribed motion violates a limit",
                        "This is proved: something in the scene has to change."};
            return {"bad", "No motion satisfies all of these limits",
                    "This is proved: something in the scene has to change."};
        case Verdict::failed:
            break;
    }
    return {"bad", "No motion was found",
            "Infeasibility is not proved either; see the notes and the appendix."};
}

std::vector<BoundFigure> bound_figures(const Solution& solution) {
    const Certificate& certificate = solution.certificate;
    std::vector<BoundFigure> all;
    const auto add = [&](const char* key, std::string title, const std::optional<double>& value, int digits) {
        if (value && std::isfinite(*value)) all.push_back({key, std::move(title), *value, digits});
    };
    add("objective", "objective", certificate.objective, figures);
    add("bound",
        certificate.proof_kind == ProofKind::any_curve_limit ? "bound for all curves"
        : searched_from_starts(solution) && certificate.proof_kind != ProofKind::boxes
            ? "bound of the convex relaxation"
            : "proved bound",
        certificate.lower_bound, figures);
    add("gap", "gap", certificate.gap, 2);
    if (solution.any_curve_limit)
        add("any_curve", "limit of any curve" + left_out_of_any_curve(solution.scene),
            solution.any_curve_limit->objective, figures);
    return all;
}

std::string objective_line(const Solution& solution, std::string_view separator) {
    return listed(
        bound_figures(solution), separator,
        [](const BoundFigure& one) { return one.title + " " + short_text(one.value, one.digits); },
        separator);
}

std::string no_solver_words(const std::string& named) {
    return "the motion is prescribed" + (named == "auto" ? "" : "; " + named + " is not used");
}

std::string solver_words(const Solution& solution) {
    const std::string& used = solution.solver.name;
    if (is_fixed(solution)) return "none, " + no_solver_words(solution.scene.solver.name);
    if (!solution.plan || solution.plan->solver == used || solution.plan->next_solver == used) return used;
    return fmt::format("{}; {} was not needed, the problem without the limits that are not convex decides it",
                       used, solution.plan->solver);
}

std::vector<std::string> solver_sentences(const Solution& solution) {
    const SolverReport& solver = solution.solver;
    std::vector<std::string> all;
    if (!solver.name.empty())
        all.push_back(
            fmt::format("Solver: {}{}; {} s in all.", solver_words(solution),
                        is_fixed(solution) ? ""
                        : solver.termination == Termination::not_run
                            ? "; not run: the search for a first point decided the scene"
                            : fmt::format("; it stopped as \"{}\" (iterations: {}, exchange rounds: {})",
                                          words_of(name_of(solver.termination)), solver.iterations,
                                          solver.exchange_rounds),
                        short_text(solution.seconds_total, 3)));
    if (!solver.choice.empty() && !is_fixed(solution))
        all.push_back(fmt::format("Reason: {}.", solver.choice));
    if (searched_from_starts(solution))
        all.push_back(
            fmt::format("The scene is not convex; searches from different starts: {}.", solver.starts));
    if (!solver.proof_source.empty())
        all.push_back(fmt::format("The proof's multipliers: {}.", solver.proof_source));
    if (solution.certificate.proof)
        all.emplace_back(
            "To check the proof without camopt: certificate.json holds the rows, the multipliers, the box "
            "and the bound; its entry how_to_check describes the check, one sum.");
    return all;
}

}  // namespace camopt
