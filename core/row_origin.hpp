// SPDX-License-Identifier: MIT
// Where a constraint row comes from: what reports and explanations look up. Names of rows are for people.
#pragma once

#include "core/extremum.hpp"

#include <optional>
#include <string>

namespace camopt {

struct RowOrigin {
    std::string rule;          ///< of a limit of the scene: its key, "limits.velocity_mm_s"
    std::string remark;        ///< which part of the rule: "face turns back"; mostly empty
    std::optional<double> at;  ///< x; none: it belongs to no place of the motion
    Side side = Side::right;   ///< of x, where something may jump
    bool limit = false;        ///< a hard limit of the user's scene
    std::optional<int> order =
        {};        ///< the highest derivative that the rule reads; none: no rule of the motion
    int sign = 0;  ///< ±1 where a rule has two sides, one for each sign; else 0

    /// "limits.velocity_mm_s (face turns back) at x = 0.25-"; the minus: the side below x.
    [[nodiscard]] std::string text() const;
    friend bool operator==(const RowOrigin&, const RowOrigin&) = default;
};

}  // namespace camopt
