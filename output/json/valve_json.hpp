// SPDX-License-Identifier: MIT
// Two valve lobes on one crankshaft as data.
#pragma once

#include "studies/valve/valve_report.hpp"

namespace camopt {

/// What `camopt valves --json` prints: mm, degrees of the cam or, where the key says so, of the crankshaft.
[[nodiscard]] std::string valve_pair_json(const ValvePair& pair);

}  // namespace camopt
