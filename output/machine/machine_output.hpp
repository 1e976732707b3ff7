// SPDX-License-Identifier: MIT
// A machine's result as text for the terminal, as JSON, and as files: machine.json, certificate.json of the
// motions, impossible.json with the proof at the speed above them.
#pragma once

#include "output/json/result_json.hpp"
#include "studies/machine/machine.hpp"

namespace camopt {

/// `axes`: where each axis's scene comes from, in the order of the machine; `machine`: the machine file.
[[nodiscard]] std::string machine_json(const MachineSolution& solution, const RunOrigin& machine,
                                       const std::vector<RunOrigin>& axes);

[[nodiscard]] std::string machine_text(const MachineSolution& solution);

/// As certificate.json: the proof that there are no motions at MachineSolution::impossible_above.
[[nodiscard]] std::string impossible_json(const MachineSolution& solution);

}  // namespace camopt
