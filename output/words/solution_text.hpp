// SPDX-License-Identifier: MIT
// A solution in words: for the terminal, the picture and the report.
#pragma once

#include "studies/delivered/solution.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace camopt {

/// "Proved optimal: …" One sentence.
[[nodiscard]] std::string verdict_sentence(const Certificate& certificate);
/// The same, and what a search from several starts can say and cannot.
[[nodiscard]] std::string verdict_sentence(const Solution& solution);

/// "at most 0.0002 % from the optimum": what a bound proves of a motion that is not proved optimal, rounded
/// up. Empty without a bound, or where it allows a motion of half the objective.
[[nodiscard]] std::string gap_words(const Certificate& certificate);

/// "objective 0.940489277   proved bound 0.940489270   gap 7e-9". Only what exists.
[[nodiscard]] std::string objective_line(const Solution& solution, std::string_view separator = "   ");

/// "speed reaches 1.7, 0.4 in the objective (weight …)"
[[nodiscard]] std::string own_term_sentence(const OwnTermReport& term);

/// "limits.velocity = 1.8: velocity reaches 1.79 (not active)"
[[nodiscard]] std::string constraint_sentence(const ConstraintReport& row);

/// "limits.velocity: 1.2 given, 1.31 needed if this is the only change". Units stand in the key.
[[nodiscard]] std::string relaxation_sentence(const Relaxation& row);

/// How it was found, for reports: solver, starts, where the proof comes from and stands.
[[nodiscard]] std::vector<std::string> solver_sentences(const Solution& solution);

/// What `camopt solve` prints: a compact summary of a dozen lines, ending in a line feed.
[[nodiscard]] std::string summary_text(const Solution& solution,
                                       std::span<const std::filesystem::path> written);

}  // namespace camopt
