// SPDX-License-Identifier: MIT
// Keys of a scene in words: "limits.pressure_angle_deg" is the "pressure angle" in "deg".
#pragma once

#include "studies/delivered/solution.hpp"

#include <string>
#include <string_view>

namespace camopt {

struct KeyWords {
    std::string words;   ///< "pressure angle", "base radius", "cam radius"
    std::string unit;    ///< "deg", "mm/s", …; empty: dimensionless
    bool limit = false;  ///< of the table [limits]: it bounds something, it is not the thing itself
};

[[nodiscard]] KeyWords key_words(std::string_view key, std::string_view remark = {});

/// "base radius >= 31.4 mm", "pressure angle <= 33.1 deg": a dimension on the needed side of its value, a
/// limit as it would have to be written. Empty where no change of it alone helps.
[[nodiscard]] std::string needed_words(const Relaxation& row);

/// The number of these words: the one that was solved, or the needed one rounded to the side that does.
[[nodiscard]] std::string needed_number(const Relaxation& row);

}  // namespace camopt
