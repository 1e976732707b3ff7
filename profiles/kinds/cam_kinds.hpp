// SPDX-License-Identifier: MIT
// The registry of kinds of cams. A new kind needs its leaf and a row in kind_rows.hpp.
#pragma once

#include "scene/cam_kind.hpp"

namespace camopt {

/// In the order of the manual; a [cam] without a type counts as the first.
[[nodiscard]] std::span<const CamKind> cam_kinds();
/// Adds a kind of the program permanently: scene files name it by cam.type and are read with its keys,
/// solve() and reports know it by its CamMechanism. `formulas` and every variant's `spec` are needed; the
/// texts behind the string views of its rows must stay valid. Add it before the first scene is read. Throws
/// InputError for a type that is taken.
void add_cam_kind(CamKind kind);
/// Null if there is no such kind.
[[nodiscard]] const CamKind* cam_kind(std::string_view type);
/// Allowed values of cam.type.
[[nodiscard]] std::vector<std::string_view> cam_types();

}  // namespace camopt
