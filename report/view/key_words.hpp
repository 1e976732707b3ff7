// SPDX-License-Identifier: MIT
// Keys of a scene in words: "limits.pressure_angle_deg" is the "pressure angle" in "deg".
#pragma once

#include "studies/delivered/solution.hpp"

namespace camopt {

struct KeyWords {
    std::string words;   ///< "pressure angle", "base radius", "cam radius"
    std::string unit;    ///< "deg", "mm/s", …; empty: dimensionless
    bool limit = false;  ///< of the table [limits]: it bounds something, it is not the thing itself

    /// What is set: "base radius", "pressure angle limit", "limit on the largest contact force".
    [[nodiscard]] std::string subject() const;
};

[[nodiscard]] KeyWords key_words(std::string_view key, std::string_view remark = {});

/// What to do: "increase the base radius to 31.4 mm", "raise the pressure angle limit to 33.1 deg",
/// "lengthen the angle of segment 3 (motion.segments[2].angle_deg) from 50 to 54 deg, taken from …, which
/// becomes 36 deg". Empty where no change of it alone helps.
[[nodiscard]] std::string change_words(const Relaxation& row);

/// What changes along with it: ", with the return at 95 deg"; empty: nothing.
[[nodiscard]] std::string also_words(const Relaxation& row);

/// Whether no smaller change of the number suffices: of a limit of a convex scene. Of everything else the
/// needed value suffices, and a smaller change may.
[[nodiscard]] bool is_exact(const Solution& solution, const Relaxation& row);

/// The number of these words: the one that was solved, or the needed one rounded to the side that does.
[[nodiscard]] std::string needed_number(const Relaxation& row);

}  // namespace camopt
