// SPDX-License-Identifier: MIT
// The rows of plc_format.hpp, a source each. Where the fields come from: docs/plc.md.
#pragma once

#include "output/plc/plc_format.hpp"

namespace camopt {

[[nodiscard]] PlcFormat codesys_format();
[[nodiscard]] PlcFormat twincat_format();
[[nodiscard]] PlcFormat siemens_format();
[[nodiscard]] PlcFormat br_format();
[[nodiscard]] PlcFormat rockwell_format();
[[nodiscard]] PlcFormat omron_format();
[[nodiscard]] PlcFormat lenze_format();
[[nodiscard]] PlcFormat coefficient_csv_format();

}  // namespace camopt
