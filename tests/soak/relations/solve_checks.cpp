// SPDX-License-Identifier: MIT
// Checks of a solve as a whole: texts, time, bounds and proofs.
#include "input/loading/load_scene.hpp"
#include "input/scene_text.hpp"
#include "tests/soak/relations/relation.hpp"
#include "tests/support/same_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace camopt::soak {

namespace {

/// The recipe that stands in certificate.json as how_to_check. None: it leans on an open side.
std::optional<long double> recomputed(const Proof& proof) {
    std::vector<long double> reduced(proof.cost.begin(), proof.cost.end());
    long double bound = proof.constant;
    for (const ProofRow& row : proof.rows) {
        if (row.multiplier == 0) continue;
        const std::optional<double>& side = row.multiplier > 0 ? row.upper : row.lower;
        if (!side) return std::nullopt;
        bound -= static_cast<long double>(row.multiplier) * *side;
        for (std::size_t k = 0; k < row.indices.size(); ++k)
            reduced.at(static_cast<std::size_t>(row.indices[k])) +=
                static_cast<long double>(row.multiplier) * row.values[k];
    }
    for (std::size_t j = 0; j < reduced.size(); ++j) {
        if (reduced[j] == 0) continue;
        const std::optional<double>& side = reduced[j] > 0 ? proof.box_lower.at(j) : proof.box_upper.at(j);
        if (!side) return std::nullopt;
        bound += reduced[j] * *side;
    }
    return bound;
}

/// A word of JSON that is no number of it; digits, letters and quotes around are parts of another word.
bool holds_word(const std::string& text, const std::string& word) {
    for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
        if (at > 0 &&
            (text[at - 1] == ':' || text[at - 1] == ',' || text[at - 1] == '[' || text[at - 1] == '-'))
            return true;
    return false;
}

}  // namespace

Finding check_accepted(const Solved& solved) {
    const std::string& refusal = solved.outcome.refusal;
    return refusal.empty() ? holds : Finding("refused: " + refusal);
}

Finding check_written(const Solved& solved) {
    const Scene scene = scene_of_toml(solved.text.text(), {}, "soak");
    const std::string text = input::scene_text(scene);
    const std::string parts = testing_support::differing_parts(scene, scene_of_toml(text, {}, "written"));
    return parts.empty() ? holds : Finding("differs in " + parts);
}

Finding check_json(const Solved& solved) {
    const Outcome& outcome = solved.outcome;
    if (!outcome.refusal.empty()) return no_case;
    if (!outcome.broken.empty()) return outcome.broken;
    for (const char* word : {"nan", "inf", "NaN", "Infinity"})
        if (holds_word(outcome.repeatable, word)) return fmt::format("{} in the JSON", word);
    const bool delivers =
        outcome.verdict == "optimal" || outcome.verdict == "local" || outcome.verdict == "feasible";
    if (delivers && !outcome.objective) return fmt::format("{} without an objective", outcome.verdict);
    if (delivers && !outcome.has_motion()) return fmt::format("{} without a motion", outcome.verdict);
    if (outcome.is_proved() && (!outcome.lower || !outcome.gap))
        return std::string("optimal without a bound");
    if (delivers && !solved.numbers.follower.empty() && outcome.cam.empty())
        return fmt::format("{} without a cam", outcome.verdict);
    return holds;
}

Finding check_time(const Solved& solved) {
    // Processor time: a loaded machine must not fail it. Reading, JSON and the first point are no search.
    constexpr double beside = 0.3;
    const double allowed = 1.1 * solved.numbers.max_seconds + beside;
    if (solved.outcome.processor_seconds <= allowed) return holds;
    return fmt::format("{:.2f} s of processor time of {:.2f} ({})", solved.outcome.processor_seconds,
                       solved.numbers.max_seconds, solved.outcome.verdict);
}

Finding check_bound(const Solved& solved) {
    const Outcome& outcome = solved.outcome;
    if (!outcome.objective || !outcome.has_motion()) return no_case;
    const double objective = *outcome.objective;
    // What the bound may pass the objective by: the tolerance of limits, which the motion may use.
    const double slack = std::max(1e-7, solved.numbers.tolerance) * scale_of(objective);
    if (outcome.any_curve_limit && !solved.numbers.is_program() &&
        *outcome.any_curve_limit > objective + slack)
        return fmt::format("the limit of any curve {:.12g} above the objective {:.12g} ({})",
                           *outcome.any_curve_limit, objective, outcome.verdict);
    if (!outcome.lower) return holds;
    if (*outcome.lower > objective + slack)
        return fmt::format("bound {:.12g} above the objective {:.12g} ({}, {})", *outcome.lower, objective,
                           outcome.verdict, outcome.reason);
    const double gap = (objective - *outcome.lower) / scale_of(objective);
    const double allowed = solved.numbers.gap.value_or(outcome.convex ? 1e-7 : 1e-4);
    if (outcome.is_proved() && gap > 1.0001 * allowed)
        return fmt::format("optimal with a gap of {:.3g}, allowed {:.3g}", gap, allowed);
    if (outcome.gap && *outcome.gap < gap - 1e-9)
        return fmt::format("gap {:.3g} reported, {:.3g} between objective and bound", *outcome.gap, gap);
    return holds;
}

Finding check_proof(const Solved& solved) {
    const Outcome& outcome = solved.outcome;
    if (!outcome.proof || outcome.proof->statement != "objective" || !outcome.proof->bound) return no_case;
    const auto bound = recomputed(*outcome.proof);
    if (!bound) return std::string("the proof leans on an open side");
    const double stored = *outcome.proof->bound;
    if (*bound < stored - 1e-13 * std::abs(stored))
        return fmt::format("bound {:.15g}, recomputed {:.15g}", stored, static_cast<double>(*bound));
    if (outcome.lower && outcome.proof_kind == "duality" &&
        *outcome.lower > stored + 1e-12 * scale_of(stored))
        return fmt::format("bound {:.15g} published, {:.15g} in the certificate", *outcome.lower, stored);
    return holds;
}

Finding check_infeasibility(const Solved& solved) {
    const Outcome& outcome = solved.outcome;
    if (outcome.verdict != "infeasible") return no_case;
    if (outcome.has_motion()) return std::string("infeasible with a motion");
    // Proofs over boxes are the certificate checker's to follow.
    if (outcome.proof_kind == "boxes" && outcome.has_box_proof) return holds;
    if (outcome.proof_kind == "any_curve_limit") return holds;  // of all curves: there are no rows
    if (!outcome.proof) return std::string("infeasible without a proof");
    if (outcome.proof->statement == "objective") return std::string("infeasible by a bound of the objective");
    const auto bound = recomputed(*outcome.proof);
    if (!bound) return std::string("the proof leans on an open side");
    if (*bound > 0) return holds;
    return fmt::format("the proof gives {:.3g}, not above 0 ({})", static_cast<double>(*bound),
                       outcome.proof->statement);
}

}  // namespace camopt::soak
