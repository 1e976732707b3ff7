// SPDX-License-Identifier: MIT
// What this build is: its version, and the terms under which it may be distributed.
#pragma once

#include "core/base/standard.hpp"

namespace camopt {

/// As written into every result.
[[nodiscard]] std::string_view version();

/// A library that this camopt was built with.
struct LicensedPart {
    std::string name;     ///< "Ipopt"
    std::string license;  ///< SPDX: "EPL-1.0"
    std::string use;      ///< "solver"
};

/// camopt itself first, then what was found when it was built.
[[nodiscard]] std::vector<LicensedPart> licensed_parts();

/// One or two sentences: the terms for distributing a binary of this build. No legal advice.
[[nodiscard]] std::string terms_of_binary();

/// Both, a line a part: "Ipopt: EPL-1.0 (solver)".
[[nodiscard]] std::string license_text();

}  // namespace camopt
