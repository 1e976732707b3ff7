// SPDX-License-Identifier: MIT
// Parts of a validated scene file. Errors: InputError for keys that do not fit the type of the motion or the
// follower, missing dimensions, unknown laws, units that do not fit the lift. Internal to input/.
#pragma once

#include "input/document/scene_source.hpp"
#include "input/known_names.hpp"
#include "scene/cam_kind.hpp"
#include "scene/scene.hpp"

namespace camopt::input {

/// A parsed document → validated Scene: checks keys, values and their relations; throws InputError for the
/// first fault.
[[nodiscard]] Scene read_document(const SceneSource& source, const KnownNames& known);

struct AllowedLaws {
    const std::vector<std::string>& keys;
    std::string_view after = {};  ///< what else, in an error message
};
/// Throws if the text does not name a law that is known, with numbers that it has.
void check_law(const SceneSource& source, const Given& given, const std::string& key, const KnownNames& known,
               const AllowedLaws& allowed);

// The rows of a table read what they say where it lives; the rest of it follows.

void read_motion(const SceneSource& source, const KnownNames& known, Scene& scene);

/// Makes the scene's cam complete; none where the scene has no cam.
void read_cam(const SceneSource& source, const KnownNames& known, Scene& scene);

/// speed_range of a table: two speeds.
void check_speed_range(const SceneSource& source, std::string_view table);

/// Throws for units that do not fit the follower, and loads over more than a revolution.
void check_forces(const SceneSource& source, const Scene& scene);

/// Throws for a unit that does not fit the lift. `key`: as the user would write it.
void check_unit(const SceneSource& source, const Given& given, std::string_view key,
                const MotionSpec& motion);

/// Throws for units that do not fit the lift.
void check_drive(const SceneSource& source, const MotionSpec& motion);

/// In time: v = (lift·ω/β) V, a = lift (ω/β)² A, j = lift (ω/β)³ J with ω in rad/s and β = the unit angle of
/// the motion in rad. Throws for a missing speed, or a unit that does not fit the lift.
void read_limits(const SceneSource& source, Scene& scene);

// Cams: their numbers and choices, as their kind describes them. Internal to input/.

/// Throws InputError if the output swings and the lift is a length, or the reverse.
void check_lift(const SceneSource& source, const CamKind& kind, const CamVariant& variant,
                const MotionSpec& motion);

/// Without formulas.
[[nodiscard]] CamSpec read_mechanism(const SceneSource& source, const CamKind& kind,
                                     const MotionSpec& motion);

/// Throws for units that do not fit the lift, and for what is missing.
void read_dynamics(const SceneSource& source, Scene& scene);

// [measured] of a checked scene file → MeasuredMotion: numbers of the scene itself, or of a CSV file in its
// folder. Internal to input/.

/// A key of [measured] in the unit of the manual: "theta_deg".
[[nodiscard]] std::string measured_key(std::string_view name);

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
    bool by_step = false;                   ///< the rows have no angles
    char decimal = '.';
    bool points = false;       ///< (x, y) or (theta, r) too
    bool any_decimal = false;  ///< read_inspected_table's: finds the decimal comma
    int skipped = 0;           ///< lines at the beginning
    bool crank = false;        ///< angles in cam units are crank angles
    std::vector<double> scale = {},
                        offset = {};  ///< of each column: offset + scale · cell; empty: as written
};

/// Throws InputError "FILE:LINE: …" for columns that are missing or in other units, cells that are not finite
/// numbers, angles that neither ascend nor descend, and files that cannot be read.
[[nodiscard]] MeasuredTable read_measured_table(const std::filesystem::path& file,
                                                const TableForm& form = {});
[[nodiscard]] MeasuredTable measured_table_of(std::string_view text, const std::string& name,
                                              const TableForm& form = {});

// Points of a disk cam's surface → the motion of the follower that rolls or slides on it.
//
// Each point becomes one row. Its normal n comes from the cubic through its neighbours (core/numbers/
// robust_fit.hpp) in polar coordinates: outliers do not turn it. A roller of radius R that touches the point
// p there has its centre at p + R n, a face its distance p · n; the cam angle is that at which this is on the
// follower's guide. An error δ of the normal moves the row along the motion and off it by R δ²/2 (roller) or
// ϱ δ²/2 (face; ϱ radius of curvature): second order, while the noise of the points stays that of the rows.
// The follower lies on the largest displacement at which it touches the surface: points at which it would cut
// into the smoothed surface elsewhere are left out.
struct SurfaceProbe {
    FollowerGeometry follower;
    double radius = 0.0;         ///< m; points are the centres of a ball that touches the surface; 0: on it
    double roller_radius = 0.0;  ///< of the follower, m; 0: an edge or a face
    double sense = 1.0;          ///< of the cam's rotation, seen in the follower's frame
};
struct SurfaceMotion {
    std::vector<double> angle, displacement;  ///< rad in [0, 2π), ascending; m or rad
    std::vector<std::size_t> rows;            ///< of each row its point
    int untouched = 0;                        ///< points that the follower does not touch
};
/// Its dimensions: of ranges the middle. Throws SceneError for a cam that is not a disk.
[[nodiscard]] SurfaceProbe surface_probe(const CamSpec& cam, double probe_radius);
/// Points in the cam's frame, m. Throws SceneError "measured.theta[point]" where they leave a gap.
[[nodiscard]] SurfaceMotion motion_on_surface(std::span<const Eigen::Vector2d> points,
                                              const SurfaceProbe& probe);

/// What measured.register asks for.
struct RegisterRequest {
    bool angle = false, radius = false;
};
/// Moves the rows to where the motion is, by a robust fit (input/table_alignment.hpp) of the scene's motion
/// with the law of the catalogue in its spline strokes that is nearest to the rows; laws and dwells of the
/// scene stay. Throws SceneError "measured.register" where a displacement is searched, and for a table of a
/// whole revolution where the motion is a part of one.
[[nodiscard]] MeasuredPlace register_rows(const MotionSpec& motion, const KnownNames& known,
                                          RegisterRequest request, MeasuredMotion& measured);

struct MeasuredInput {
    MeasuredMotion motion;
    std::optional<MeasuredTable> table;  ///< if from a file: its lines, for messages
    std::vector<std::size_t> rows;       ///< of the motion: each one's place in the table or the arrays
};

/// Throws InputError for a missing key, a file that cannot be read, units that do not fit the lift. The
/// numbers of a table are kept in the place of its name (Scene::measured_rows).
[[nodiscard]] std::optional<MeasuredInput> read_measured(const SceneSource& source, Scene& scene,
                                                         const KnownNames& known);

/// Throws for a fault of the scene: one of the measured motion at its row as written, in its file if it has
/// one.
[[noreturn]] void fail_in_measured(const SceneSource& source, const MeasuredInput& measured,
                                   const SceneFault& fault);

/// Replaces the table that the scene names by its numbers. No effect if it names none.
void write_out_tables(Node& root, const std::filesystem::path& folder);

}  // namespace camopt::input
