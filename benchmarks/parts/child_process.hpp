// SPDX-License-Identifier: MIT
// Work done in a process of its own, for backends that may never come back: NLopt's COBYLA can run for ever
// between two evaluations, where no time limit reaches it.
#pragma once

#include <functional>
#include <optional>
#include <string>

namespace camopt::benchmarks {

/// What the work returns. None where it took longer than `most_seconds` (the child is killed), crashed or
/// threw.
[[nodiscard]] std::optional<std::string> text_of_child(const std::function<std::string()>& work,
                                                       double most_seconds);

}  // namespace camopt::benchmarks
