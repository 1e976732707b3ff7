// SPDX-License-Identifier: MIT
// A paper's report for programs: tables as columns and rows of objects by column key, figures as series.
// Numbers read back as the same double; null where there is none.
#pragma once

#include "studies/papers/paper_report.hpp"

#include <string>

namespace camopt {

[[nodiscard]] std::string paper_report_json(const PaperReport& report);

}  // namespace camopt
