// SPDX-License-Identifier: MIT
// The report of a paper as JSON, for programs.
#pragma once

#include "studies/papers/paper_report.hpp"

namespace camopt {

// Tables as columns and rows of objects by column key, figures as series. Numbers read back as the same
// double; null where there is none.
[[nodiscard]] std::string paper_report_json(const PaperReport& report);

}  // namespace camopt
