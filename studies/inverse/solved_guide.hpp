// SPDX-License-Identifier: MIT
// The guide of a solved scene with an inverse cam, pushed by its roller.
#pragma once

#include "studies/delivered/solution.hpp"

#include <optional>

namespace camopt {

/// The roller touches either wall of the slot, of `points` (2000) points each (slot_check of
/// inverse_forward.hpp), at as many places of its stroke. The deviation is that of the feeder, m: the body's
/// by dY/dpsi at that place; relative: by the lift. Throws InputError for a solution without such a cam or
/// whose wall cannot be used.
[[nodiscard]] ForwardCheckReport check_inverse_cam(const Solution& solution, std::optional<int> points = {});

}  // namespace camopt
