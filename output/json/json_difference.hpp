// SPDX-License-Identifier: MIT
// The first difference between two JSON documents that should say the same.
#pragma once

#include "output/json/json_text.hpp"

#include <string>

namespace camopt {

/// In words: the key, what was found, what is allowed; empty where there is none. Numbers may differ by
/// `tolerance`, relative (below 1 absolute); where an extreme lies (keys at, at_deg) is not looked at: a flat
/// one may lie anywhere.
[[nodiscard]] std::string json_difference(const Json& found, const Json& allowed, double tolerance);

}  // namespace camopt
