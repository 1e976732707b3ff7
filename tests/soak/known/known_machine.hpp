// SPDX-License-Identifier: MIT
// Machines with a known least total objective at their speed: programs of one revolution on one master, each
// with the bounds, set points and costs of its own class, and clearances between them.
#pragma once

#include "tests/soak/known/posing.hpp"

#include <optional>

namespace camopt::soak {

/// Nullopt: these draws give no machine.
[[nodiscard]] std::optional<KnownScene> drawn_machine(Draw& draw, const Question& question, bool edges);

}  // namespace camopt::soak
