// SPDX-License-Identifier: MIT
// A scene as the text of a scene file, and the keys of one, for a complete report.
#pragma once

#include "scene/scene.hpp"

namespace camopt::input {

/// TOML with every key that differs from its default, in the units in which the scene was read; of a scene
/// made by a program, or a key whose unit is not known, in that of the manual or in SI, whichever needs fewer
/// digits. read_scene of it is the same scene, bit for bit. Only a number that is normalised by others (a set
/// point in mm/s) and was not read from a file may differ in the last bit, where no written number gives it.
/// Measured rows of a table are written as numbers. Throws InputError for what no scene file says: own terms
/// and limits, limits of both and of one side of the same derivative, an unknown cam.
[[nodiscard]] std::string scene_text(const Scene& scene);

struct WrittenKey {
    std::string key;      ///< "motion.lift_mm", "motion.via[0].at"
    std::string value;    ///< in TOML: 30.0, "DRD", {min = 20, max = 60}
    std::string unit;     ///< "mm"; empty: dimensionless
    std::string meaning;  ///< of the key table; empty: an option of a solver
};

/// Every key with a value, in the order of the text, without the tables and arrays of tables that contain
/// others. Keys without a table row are listed too. Throws InputError for text that is not TOML.
[[nodiscard]] std::vector<WrittenKey> keys_written_in(std::string_view toml, std::string_view source_name);

/// Those that scene_text(scene) writes, also of a scene that it refuses: without what no scene file says.
[[nodiscard]] std::vector<WrittenKey> keys_of(const Scene& scene);

}  // namespace camopt::input
