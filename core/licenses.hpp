// SPDX-License-Identifier: MIT
// Under what terms this build may be passed on: which libraries of others are in it, and what follows.
#pragma once

#include <string>
#include <vector>

namespace camopt {

/// A library that this camopt was built with.
struct LicensedPart {
    std::string name;     ///< "Ipopt"
    std::string license;  ///< SPDX: "EPL-1.0"
    std::string use;      ///< "solver"
};

/// camopt itself first, then what was found when it was built.
[[nodiscard]] std::vector<LicensedPart> licensed_parts();

/// One or two sentences: under what terms a binary of this build may be passed on. No legal advice.
[[nodiscard]] std::string terms_of_binary();

/// Both, a line a part: "Ipopt: EPL-1.0 (solver)".
[[nodiscard]] std::string license_text();

}  // namespace camopt
