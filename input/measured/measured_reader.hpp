// SPDX-License-Identifier: MIT
// [measured] of a checked scene file → MeasuredMotion: numbers of the scene itself, or of a CSV file in its
// folder. Internal to input/.
#pragma once

#include "input/document/scene_source.hpp"
#include "input/measured/measured_table.hpp"
#include "input/scene_reader.hpp"

#include <optional>

namespace camopt::input {

struct MeasuredInput {
    MeasuredMotion motion;
    std::optional<MeasuredTable> table;  ///< where it came from a file: its lines, for messages
};

/// Throws InputError for what is missing, a file that cannot be read, units that do not fit the lift.
[[nodiscard]] std::optional<MeasuredInput> read_measured(const SceneSource& source, const MotionSpec& motion,
                                                         const KnownNames& known);

/// A fault of the measured motion at the line of its file; nothing where it is of something else.
void fail_in_table(const SceneSource& source, const MeasuredInput& measured, const SceneFault& fault);

/// Puts the numbers of a table that the scene names into the scene, in its place. Nothing happens where it
/// names none.
void write_out_tables(Node& root, const std::filesystem::path& folder);

}  // namespace camopt::input
