// SPDX-License-Identifier: MIT
// Files of controllers from templates (shop/plc/templates), and back.
//
//   // {header}                           a line of comment each; what follows // is not read back
//   Cam : ARRAY[0..{last}] OF POINT;
//   {each point}                          or {each piece}: what follows is repeated for each
//   Cam[{index}].dX := {x}; Cam[{index}].dY := {s:REAL};
//   {end}
//
// Counts: {count} as PlcFormat counts, {last} = count − 1; of an element {index} from 0, {number} from 1,
// {step} 1 and of the last 0. Numbers of the motion, in the table's units: x (master), s, v, a, j (slave and
// its derivatives by the master), c0 … c6 of the piece; alone at the element's point or at the begin of its
// piece; to.s at the end of its piece, next.s at the next point, first.s and end.s at the ends of the cycle.
// Any other name is PlcFormat::own_number. Types as in IEC 61131-3: LREAL where none is given, {x:REAL},
// {x:DINT}.
#pragma once

#include "shop/plc/plc_format.hpp"

namespace camopt {

/// A file of templates/, compiled in. Throws ModelError for any other name.
[[nodiscard]] std::string_view plc_template(std::string_view name);

/// The table as that file of the format. Throws InputError for a number that its type cannot hold.
[[nodiscard]] std::string written_file(const PlcFormat& format, const std::string& file,
                                       const PlcTable& table);

/// What the controller makes of such a file. Throws InputError where the text differs from the template in
/// more than comments and numbers, and where its numbers contradict each other.
[[nodiscard]] std::vector<PolynomialPiece> read_file(const PlcFormat& format, const std::string& file,
                                                     std::string_view text, const PlcUnits& units);

}  // namespace camopt
