// SPDX-License-Identifier: MIT
// TOML machine file → validated MachineSpec (scene/machine_spec.hpp), with the scenes of its axes, whose
// paths are relative to the file. Errors: InputError "FILE:LINE:COLUMN: key: found …; allowed: …", of the
// machine file, or of the scene file of an axis.
#pragma once

#include "scene/machine_spec.hpp"

#include <filesystem>

namespace camopt::input {

/// Reads one scene file with settings "KEY=VALUE": camopt::load_scene (input/loading/load_scene.hpp).
using AxisLoader =
    std::function<Scene(const std::filesystem::path& file, std::span<const std::string> settings)>;

/// `settings`: "KEY=VALUE" of the machine file, or "AXIS.KEY=VALUE" of the scene of an axis, by its name. The
/// speed of every axis is the least one of the machine.
[[nodiscard]] MachineSpec read_machine(const std::filesystem::path& file, const AxisLoader& load,
                                       std::span<const std::string> settings = {});

/// Those of the settings that are the machine file's own.
[[nodiscard]] std::vector<std::string> machine_settings(std::span<const std::string> settings,
                                                        const MachineSpec& machine);

/// The title, perhaps empty, of a TOML text that is a machine file: one with a table [machine].
[[nodiscard]] std::optional<std::string> machine_title(std::string_view toml);

/// A number of a scene as a setting, in the unit of the manual to 15 digits: "motion.phase_deg=30". `path`:
/// the table with indices, `table` in the key table.
[[nodiscard]] std::string setting_of(std::string_view path, std::string_view table, std::string_view name,
                                     double si);
/// The setting of an axis's scene for a speed of the machine, rad/s: "motion.speed_rpm=…" to 15 digits.
[[nodiscard]] std::string speed_setting(double speed);

/// For a fault found after reading: throws InputError at the file and line of its member. `settings` as read.
[[noreturn]] void fail_in_machine(const std::filesystem::path& file, std::span<const std::string> settings,
                                  const MachineSpec& machine, const SceneFault& fault);

}  // namespace camopt::input
