// SPDX-License-Identifier: MIT
// What is said of electronic cams: the header of a file, the console, plc.json (plc_export.hpp).
#pragma once

#include "output/plc/plc_export.hpp"

#include <string>
#include <vector>

namespace camopt {

/// Lines without a comment sign.
[[nodiscard]] std::vector<std::string> plc_header(const Solution& solution, const MasterCurve& curve,
                                                  const PlcResult& result);

[[nodiscard]] std::string plc_text(const Solution& solution, const MasterCurve& curve,
                                   const std::vector<PlcResult>& results);

[[nodiscard]] std::string plc_json(const Solution& solution, const MasterCurve& curve,
                                   const std::vector<PlcResult>& results);

}  // namespace camopt
