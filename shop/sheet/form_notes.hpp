// SPDX-License-Identifier: MIT
// Notes of a workshop drawing that say of any plane cam what it runs under and how well it must be made.
#pragma once

#include "report/drawing/profile_shape.hpp"

namespace camopt {

/// "Follower: translating roller, roller radius 10 mm, offset 8 mm."
[[nodiscard]] std::string follower_note(const ProfileShape& shape, LengthUnit lengths);

/// The scene's limits of form and the least radii of curvature (of both disks), where there are any.
void add_form_notes(std::vector<std::string>& notes, const Solution& solution, bool both_disks = false);

/// "Profile: the follower's displacement within ±0.02 mm, its slope within ±0.005 mm/deg." and "Limits hold
/// for base radius ±0.05 mm.", where the scene has tolerances.
void add_tolerance_notes(std::vector<std::string>& notes, const Scene& scene);

/// "±0.02 mm of the follower", for the title block; empty: no profile tolerance is given.
[[nodiscard]] std::string profile_band(const Scene& scene);

}  // namespace camopt
