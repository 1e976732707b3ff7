// SPDX-License-Identifier: MIT
// Parts of a validated scene file. Errors: InputError for keys that do not fit the type of the motion or the
// follower, missing dimensions, unknown laws, units that do not fit the lift. Internal to input/.
#pragma once

#include "input/document/scene_source.hpp"
#include "input/scene_reader.hpp"
#include "scene/cam_kind.hpp"

namespace camopt::input {

/// A parsed document → validated Scene: checks keys, values and their relations; throws InputError for the
/// first fault.
[[nodiscard]] Scene read_document(const SceneSource& source, const KnownNames& known);

/// [motion]
[[nodiscard]] MotionSpec read_motion(const SceneSource& source, const KnownNames& known);

/// Complete; none if the scene has no cam.
[[nodiscard]] std::optional<CamSpec> read_cam(const SceneSource& source, const MotionSpec& motion,
                                              const KnownNames& known);

/// speed_range of a table: two speeds, rad/s.
[[nodiscard]] std::optional<std::array<double, 2>> speed_range(const SceneSource& source,
                                                               std::string_view table);

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
// counts. They are separated by commas, semicolons, tabs or blanks. Skipped are empty lines, lines that begin
// with #, !, % or //, text above the names (with measured.columns above the first row), a line of units below
// them, text below the last row, and rows that repeat the one before (both sides of a joint). Angles may pass
// the end of the revolution once. Internal to input/.
struct MeasuredTable {
    std::string file;              ///< its name in messages
    std::string theta_key, s_key;  ///< "theta_deg", "s_mm"; of rows at a given step the first is empty; of
                                   ///< points "x_mm", "y_mm" or "theta_deg", "r_mm"
    Spelling theta_unit, s_unit;
    std::vector<double> theta, s;  ///< as written
    std::vector<int> lines;        ///< of each row, from 1

    [[nodiscard]] bool is_polar() const { return s_key.starts_with('r'); }
    /// Of the cam; else displacements of the follower.
    [[nodiscard]] bool is_points() const { return is_polar() || theta_key.starts_with('x'); }
};

/// x and y, m; of displacements the angle and the displacement, SI.
[[nodiscard]] std::vector<Eigen::Vector2d> points_of(const MeasuredTable& table);

/// What the scene says about the table.
struct TableForm {
    std::vector<std::string> columns = {};  ///< their names; empty: in the first line
