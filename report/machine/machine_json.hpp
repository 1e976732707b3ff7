// SPDX-License-Identifier: MIT
// A machine's result as JSON: machine.json, and impossible.json with the proof at the speed above that of the
// motions.
#pragma once

#include "report/json/result_json.hpp"
#include "studies/machine/machine.hpp"

namespace camopt {

/// `axes`: where each axis's scene comes from, in the order of the machine; `machine`: the machine file.
[[nodiscard]] std::string machine_json(const MachineSolution& solution, const RunOrigin& machine,
                                       const std::vector<RunOrigin>& axes);

/// As certificate.json: the proof that there are no motions at MachineSolution::impossible_above.
[[nodiscard]] std::string impossible_json(const MachineSolution& solution);

}  // namespace camopt
