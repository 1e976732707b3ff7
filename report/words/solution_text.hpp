// SPDX-License-Identifier: MIT
// A solution in words: for the terminal, the picture and the report.
#pragma once

#include "studies/delivered/solution.hpp"

namespace camopt {

/// "Proved optimal: …" One sentence.
[[nodiscard]] std::string verdict_sentence(const Certificate& certificate);

/// Why no backend runs for a prescribed motion, and that a named one is not used. "auto": none is named.
[[nodiscard]] std::string no_solver_words(const std::string& named);
/// The backend of the result, and the planned one where it was not used.
[[nodiscard]] std::string solver_words(const Solution& solution);
/// The same, and what a search from several starts can say and cannot.
[[nodiscard]] std::string verdict_sentence(const Solution& solution);

/// Its headline, and what it means, for readers who do not know what a bound is.
struct VerdictWords {
    const char* tone;  ///< "good", "fair", "bad"
    const char* headline;
    std::string meaning;
};
[[nodiscard]] VerdictWords verdict_words(const Solution& solution);

/// The search had several starts: the scene is not convex.
[[nodiscard]] bool searched_from_starts(const Solution& solution);

/// "at most 0.0002 % from the optimum": what a bound proves of a motion that is not proved optimal, rounded
/// up. Empty without a bound, or where it allows a motion of half the objective.
[[nodiscard]] std::string gap_words(const Certificate& certificate);

/// "objective 0.940489277   proved bound 0.940489270   gap 7e-9". Only what exists.
[[nodiscard]] std::string objective_line(const Solution& solution, std::string_view separator = "   ");

/// Objective, bound, gap, limit of any curve: what exists.
struct BoundFigure {
    const char* key;
    std::string title;
    double value;
    int digits;  ///< significant
};
[[nodiscard]] std::vector<BoundFigure> bound_figures(const Solution& solution);

/// "speed reaches 1.7, 0.4 in the objective (weight …)"
[[nodiscard]] std::string own_term_sentence(const OwnTermReport& term);

/// "limits.velocity: 1.2 given, 1.31 needed if this is the only change". Units stand in the key.
[[nodiscard]] std::string relaxation_sentence(const Relaxation& row);

/// How it was found, for reports: solver, starts, where the proof comes from and stands.
[[nodiscard]] std::vector<std::string> solver_sentences(const Solution& solution);

// What a scene asks for, in words: motion, spline, cam, forces, limits, objective.

/// One line each, "Motion: rise between two dwells, lift 10 mm, …"; what the scene has not is left out.
[[nodiscard]] std::vector<std::string> scene_lines(const Scene& given);

// Why a scene has no motion, and what would have to change, in the user's words.

/// "The pressure angle limit at 23.4 deg conflicts with the cam radius limit at 12 deg: no spline of 12 cubic
/// segments satisfies all limits." Which limits the proof rests on, heaviest first, and where; "cannot be
/// kept" is said of those that are impossible by themselves, and of "any motion" only where that is proved of
/// every motion. Empty where nothing is known of it.
[[nodiscard]] std::string conflict_sentence(const Solution& solution);

/// "lengthen the rise to 68.2 deg, or increase the base radius to 31.4 mm, or raise the pressure angle limit
/// to 33.1 deg": each change alone would do. Empty where none helps.
[[nodiscard]] std::string sufficient_changes(const std::vector<Relaxation>& rows);

/// "concave radius, roller radius": what no change alone was found to help. Empty where everything does.
[[nodiscard]] std::string hopeless_changes(const std::vector<Relaxation>& rows);

/// "spline of 4 quintic segments": the motions that a verdict speaks of.
[[nodiscard]] std::string spline_words(const Scene& scene);

/// "Together these would do: raise the velocity limit to 1.31 and raise the acceleration limit to 4.37."
/// Empty where nothing is known of it.
[[nodiscard]] std::string joint_sentence(const Solution& solution);

/// The sentences of all that, in this order; empty for a feasible scene.
[[nodiscard]] std::vector<std::string> infeasible_remarks(const Solution& solution);

// What an engineer must know about a cam beside its figures, in sentences.

/// Undercut, what limits the cam, the smallest one, the rest of the turn, lift-off, the forward check: one
/// sentence or two each, of what there is to say about this kind. For a solution with a cam.
[[nodiscard]] std::vector<std::string> cam_remarks(const Solution& solution);

// An elastic follower train in words for people.

/// "from 300 to 1200 rpm"
[[nodiscard]] std::string speeds_words(const std::array<double, 2>& speeds);
/// Of the output at this speed of the camshaft, from lifts by x².
[[nodiscard]] double acceleration_at(const Scene& scene, double normalised, double speed);
/// A sentence a figure: of result reports.
[[nodiscard]] std::vector<std::string> train_sentences(const Solution& solution);
/// What the motion asks of the motor; empty without one.
[[nodiscard]] std::vector<std::string> drive_sentences(const Solution& solution);

}  // namespace camopt
