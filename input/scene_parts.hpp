// SPDX-License-Identifier: MIT
// Parts of a validated scene file. Errors: InputError for keys that do not fit the type of the motion or the
// follower, missing dimensions, unknown laws, units that do not fit the lift. Internal to input/.
#pragma once

#include "input/document/scene_source.hpp"
#include "input/scene_reader.hpp"
#include "scene/cam_kind.hpp"
#include "scene/key_row.hpp"
#include "scene/scene.hpp"

#include <filesystem>

namespace camopt::input {

/// A parsed document → validated Scene: checks keys, values and their relations; throws InputError for the
/// first fault.
[[nodiscard]] Scene read_document(const SceneSource& source, const KnownNames& known);

/// [motion]
[[nodiscard]] MotionSpec read_motion(const SceneSource& source, const KnownNames& known);

/// Complete; none if the scene has no cam.
[[nodiscard]] std::optional<CamSpec> read_cam(const SceneSource& source, const MotionSpec& motion,
                                              const KnownNames& known);

[[nodiscard]] std::optional<ForceSpec> read_forces(const SceneSource& source, const Scene& scene);

/// Of inertias, moments and rates of an output that swings; others are those of one that is pushed straight.
[[nodiscard]] constexpr bool is_turning_unit(std::string_view unit) {
    return unit.starts_with("N m") || unit == "kg m^2" || unit == "lbf in";
}

[[nodiscard]] std::optional<DriveSpec> read_drive(const SceneSource& source, const MotionSpec& motion);

/// Adds to the limits on the peaks.
void read_cam_limits(const SceneSource& source, const Scene& scene, LimitSpec& limits);

// Cams: their numbers and choices, as their kind describes them. Internal to input/.

/// Throws InputError if the output swings and the lift is a length, or the reverse.
void check_lift(const SceneSource& source, const CamKind& kind, const CamVariant& variant,
                const MotionSpec& motion);

/// Without formulas.
[[nodiscard]] CamSpec read_mechanism(const SceneSource& source, const CamKind& kind,
                                     const MotionSpec& motion);

// Caps of [limits] on normalised peaks. In time: v = (lift·ω/β) V, a = lift (ω/β)² A, j = lift (ω/β)³ J with
// ω in rad/s and β = the unit angle of the motion in rad. Errors: InputError for a missing speed or a unit
// that does not fit the lift. Internal to input/.
[[nodiscard]] LimitSpec read_peak_limits(const SceneSource& source, const MotionSpec& motion);

// The [dynamics] table. Internal to input/.
[[nodiscard]] std::optional<DynamicsSpec> read_dynamics(const SceneSource& source, const MotionSpec& motion);

// [measured] of a checked scene file → MeasuredMotion: numbers of the scene itself, or of a CSV file in its
// folder. Internal to input/.

// A CSV file of a measured motion: a line that names the columns, then rows of numbers.
//
// Columns are found by their names, in any order; others are ignored, and of two for one quantity the first
// counts. They are separated by commas, semicolons or tabs, as in the first line. Empty lines, lines that
// begin with #, and rows that repeat the one before (both sides of a joint) are skipped. Internal to input/.
struct MeasuredTable {
    std::string file;              ///< its name in messages
    std::string theta_key, s_key;  ///< "theta_deg", "s_mm"; of rows at a given step the first is empty
    Spelling theta_unit, s_unit;
    std::vector<double> theta, s;  ///< as written
    std::vector<int> lines;        ///< of each row, from 1
};

/// What the scene says about the table.
struct TableForm {
    std::vector<std::string> columns = {};  ///< their names; empty: in the first line
    bool by_step = false;                   ///< the rows have no angles
    char decimal = '.';
    bool points = false;  ///< read_inspected_table's: (x, y) or (theta, r) too; finds the decimal comma
};

/// Throws InputError "FILE:LINE: …" for columns that are missing or in other units, cells that are not finite
/// numbers, angles that neither ascend nor descend, and files that cannot be read.
[[nodiscard]] MeasuredTable read_measured_table(const std::filesystem::path& file,
                                                const TableForm& form = {});
[[nodiscard]] MeasuredTable measured_table_of(std::string_view text, const std::string& name,
                                              const TableForm& form = {});

struct MeasuredInput {
    MeasuredMotion motion;
    std::optional<MeasuredTable> table;  ///< if from a file: its lines, for messages
    std::vector<std::size_t> rows;       ///< of the motion: each one's place in the table or the arrays
};

/// Throws InputError for a missing key, a file that cannot be read, units that do not fit the lift.
[[nodiscard]] std::optional<MeasuredInput> read_measured(const SceneSource& source, const MotionSpec& motion,
                                                         const KnownNames& known);

/// Throws for a fault of the scene: one of the measured motion at its row as written, in its file if it has
/// one.
[[noreturn]] void fail_in_measured(const SceneSource& source, const MeasuredInput& measured,
                                   const SceneFault& fault);

/// Replaces the table that the scene names by its numbers. No effect if it names none.
void write_out_tables(Node& root, const std::filesystem::path& folder);

}  // namespace camopt::input
