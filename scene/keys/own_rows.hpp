// SPDX-License-Identifier: MIT
// The rows of the keys that belong to no kind of cam (those of a kind: scene/cam_kind.hpp). Parts are in the
// order of the manual.
#pragma once

#include "scene/key_row.hpp"

#include <algorithm>
#include <iterator>

namespace camopt {

/// All of them, made once.
[[nodiscard]] const std::vector<KeyRow>& own_rows();

namespace key_rows {

using Rows = std::vector<KeyRow>;

/// Parts of own_rows(): in the manual before [cam], and after it.
[[nodiscard]] std::span<const KeyRow> before_cam();
[[nodiscard]] std::span<const KeyRow> after_cam();

[[nodiscard]] Rows of_motion();  ///< and of the top level
[[nodiscard]] Rows points_of_motion();
[[nodiscard]] Rows points_of_segments();  ///< and corridors
[[nodiscard]] Rows of_measured();
[[nodiscard]] Rows of_search();  ///< [spline], [objective]
[[nodiscard]] Rows other_tables();
[[nodiscard]] Rows of_loads();   ///< [forces], [dynamics], [drive]
[[nodiscard]] Rows of_limits();  ///< and of the solver
[[nodiscard]] Rows of_tolerance();
/// The row of [tolerance] for a dimension of the cam, whose own row this is; `meaning` outlives it.
[[nodiscard]] KeyRow tolerance_of(const KeyRow& dimension, std::string_view meaning);

/// One list after the other.
template <class... Part>
[[nodiscard]] Rows joined(Part... parts) {
    Rows all;
    (std::ranges::move(parts, std::back_inserter(all)), ...);
    return all;
}

}  // namespace key_rows
}  // namespace camopt
