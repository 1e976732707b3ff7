// SPDX-License-Identifier: MIT
// Why a scene has no motion, and what would have to change, in the user's words.
#pragma once

#include "studies/delivered/solution.hpp"

namespace camopt {

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

/// "limits.velocity: 1.2 given, 1.31 needed if this is the only change". Units stand in the key.
[[nodiscard]] std::string relaxation_sentence(const Relaxation& row);

/// The sentences of all that, and of changes that suffice together; empty for a feasible scene.
[[nodiscard]] std::vector<std::string> infeasible_remarks(const Solution& solution);

}  // namespace camopt
