// SPDX-License-Identifier: MIT
// The papers that camopt computes again.
#pragma once

#include "studies/delivered/solution.hpp"
#include "studies/papers/paper_report.hpp"

#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace camopt {

/// Hears in words of each part that is done, for progress; may be empty.
using PaperProgress = std::function<void(const std::string&)>;

struct PaperInfo {
    std::string_view id;     ///< "004"
    std::string_view title;  ///< one line for people
    PaperReport (*report)(const SolveControl& control, const PaperProgress& finished);
};

/// In the order of their ids.
[[nodiscard]] std::span<const PaperInfo> paper_catalogue();

/// Throws InputError naming the known ids.
[[nodiscard]] const PaperInfo& find_paper(std::string_view id);

}  // namespace camopt
