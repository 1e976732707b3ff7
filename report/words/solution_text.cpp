// SPDX-License-Identifier: MIT
#include "report/words/solution_text.hpp"

#include "core/text/list_text.hpp"
#include "report/view/key_words.hpp"
#include "report/view/peak_comparison.hpp"
#include "studies/search/plan.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

constexpr int figures = 9;  // of objective and bound: enough to see a gap of 1e-7

/// No backend ran, since laws and dwells fix the motion.
bool is_fixed(const Solution& solution) {
    return solution.scene.motion.prescribed() && solution.solver.termination == Termination::not_run;
}

}  // namespace

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

std::string own_term_sentence(const OwnTermReport& term) {
    return fmt::format("{} reaches {}, {} in the objective (weight {}, reference {})", term.name,
                       short_text(term.value, figures),
                       short_text(term.weight * term.value / term.reference, figures),
                       short_text(term.weight), short_text(term.reference));
}

std::string relaxation_sentence(const Relaxation& row) {
    if (!row.needed)
        return fmt::format("{} = {}: {} alone helps", row.key, short_text(row.given),
                           row.ruled_out ? "no change of this limit" : "no value tried of it");
    return fmt::format("{} = {}: {}", row.key, short_text(row.given), change_words(row));
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
