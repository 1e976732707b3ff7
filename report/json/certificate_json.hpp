// SPDX-License-Identifier: MIT
// certificate.json: the verdict with its proof, complete, so that anybody can recompute the bound from the
// file alone, with or without camopt. The recipe stands in the file itself under "how_to_check".
#pragma once

#include "solvers/certificate/certificate.hpp"

namespace camopt {

/// The recipe in words and formulas, as it stands in the file and in the report.
[[nodiscard]] std::string_view how_to_check();

[[nodiscard]] std::string certificate_json(const Certificate& certificate);

}  // namespace camopt
