// SPDX-License-Identifier: MIT
// What was decided of a scene and how, in words: for readers who know what a bound is, and for those who do
// not. Display units; nothing throws.
#pragma once

#include "studies/delivered/solution.hpp"

namespace camopt {

/// "Proved optimal: …" One sentence.
[[nodiscard]] std::string verdict_sentence(const Certificate& certificate);
/// The same, and what a search from several starts can say and cannot.
[[nodiscard]] std::string verdict_sentence(const Solution& solution);

/// Its headline, and what it means, for readers who do not know what a bound is.
struct VerdictWords {
    const char* tone;  ///< "good", "fair", "bad"
    const char* headline;
    std::string meaning;
};
[[nodiscard]] VerdictWords verdict_words(const Solution& solution);

/// "at most 0.0002 % from the optimum": what a bound proves of a motion that is not proved optimal, rounded
/// up. Empty without a bound, or where it allows a motion of half the objective.
[[nodiscard]] std::string gap_words(const Certificate& certificate);

/// Objective, bound, gap, limit of any curve: what exists.
struct BoundFigure {
    const char* key;
    std::string title;
    double value;
    int digits;  ///< significant
};
[[nodiscard]] std::vector<BoundFigure> bound_figures(const Solution& solution);

/// "objective 0.940489277   proved bound 0.940489270   gap 7e-9". Only what exists.
[[nodiscard]] std::string objective_line(const Solution& solution, std::string_view separator = "   ");

/// Why no backend runs for a prescribed motion, and that a named one is not used. "auto": none is named.
[[nodiscard]] std::string no_solver_words(const std::string& named);
/// The backend of the result, and the planned one where it was not used.
[[nodiscard]] std::string solver_words(const Solution& solution);
/// How it was found, for reports: solver, starts, origin of the proof.
[[nodiscard]] std::vector<std::string> solver_sentences(const Solution& solution);

}  // namespace camopt
