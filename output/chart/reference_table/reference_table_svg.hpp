// SPDX-License-Identifier: MIT
// The reference table as one picture: objective against the number of segments with the paper's figures and
// the limit of all curves; acceleration and jerk of the best 12 segments over the modified sine; peaks of the
// classical laws relative to the modified sine.
//
// Normalised quantities. Colours can be told apart by colour-blind readers; marks differ in shape as well.
// Rows that are not proved optimal are named in red. Nothing throws; a part without values is left out.
#pragma once

#include "studies/compare/reference_table.hpp"

#include <string>

namespace camopt {

[[nodiscard]] std::string reference_table_svg(const ReferenceTable& table);

}  // namespace camopt
