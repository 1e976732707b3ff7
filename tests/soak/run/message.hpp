// SPDX-License-Identifier: MIT
// What a worker process tells, one line a message, a JSON list of texts:
//   at RELATION SCENE               before each solve: what is blamed where the worker dies
//   held RELATION                   a relation held
//   broken RELATION WHAT SCENE OTHER   it did not; OTHER: the changed scene, or empty
//   solved VERDICT SECONDS          a solve ended
#pragma once

#include <string>
#include <vector>

namespace camopt::soak {

[[nodiscard]] std::string message_line(const std::vector<std::string>& fields);
[[nodiscard]] std::vector<std::string> message_fields(const std::string& line);

}  // namespace camopt::soak
