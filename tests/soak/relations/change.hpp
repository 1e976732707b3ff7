// SPDX-License-Identifier: MIT
// Changes of a scene that comparisons share.
#pragma once

#include "tests/soak/scenes/scene_numbers.hpp"
#include "tests/soak/scenes/scene_text.hpp"

#include <functional>
#include <string>
#include <vector>

namespace camopt::soak {

/// A quantity, in whatever unit it is written, times a factor; of a range both ends. Nothing where it is
/// absent.
void scale_quantity(SceneTable& table, std::string_view quantity, double factor);

/// All lengths, and with them forces and caps in time: the same normalised motion. A lift that is an angle
/// stays.
void scale_lengths(SceneText& scene, double factor);
[[nodiscard]] const std::vector<std::string>& cam_lengths();

/// Writes a quantity in another unit. `keep`: which units fit it.
void respell(SceneTable& table, std::string_view quantity, std::string_view unit);

/// The reference as numbers: a law's own figures, or what is written.
[[nodiscard]] SceneTable numeric_reference(const SceneNumbers& scene);

/// A limit that may be loosened by itself, and by which factor it is looser: > 1 for a most, < 1 for a least.
struct LooseEnd {
    std::string key;
    bool is_most = true;
};
[[nodiscard]] std::vector<LooseEnd> loose_ends(const SceneText& scene);
/// `factor` > 1 loosens, < 1 tightens.
void loosen(SceneText& scene, const LooseEnd& limit, double factor);

}  // namespace camopt::soak
