// SPDX-License-Identifier: MIT
// There is no fork.
#include "core/platform/child.hpp"

namespace camopt {

bool can_run_children() {
    return false;
}

std::optional<std::string> run_in_child(const Child&) {
    return std::nullopt;
}

}  // namespace camopt
