// SPDX-License-Identifier: MIT
// Whether the unit of a number fits the lift: lengths, forces, masses where it is a length, angles, moments,
// inertias where it is an angle; units of time only with a speed.
#pragma once

#include "scene/key_row.hpp"
#include "scene/scene.hpp"

namespace camopt {

/// The keys in the units that fit the lift, as a message lists them: "mass_kg or mass_lb".
[[nodiscard]] std::string fitting_keys(std::span<const KeyNames> names, bool lift_is_angle);

/// A number of `member` in `unit` ("mm/s", "N m"; empty fits). `names`: how it may be written, with what is
/// written instead of it.
[[nodiscard]] std::optional<SceneFault> unit_fault(std::string_view member, std::string_view unit,
                                                   const MotionSpec& motion, std::span<const KeyNames> names);

}  // namespace camopt
