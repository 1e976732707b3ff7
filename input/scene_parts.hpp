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
    [[nodiscard]] bool is_axial() const { return s_key.starts_with('z'); }
    /// Of the cam; else displacements of the follower.
    [[nodiscard]] bool is_points() const { return is_polar() || is_axial() || theta_key.starts_with('x'); }
};

/// x and y, m; of displacements, and of points (theta, z), the angle and the other number, SI.
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

// Points of a cam → the motion of the follower that rolls or slides on it.
//
// Each point becomes one row. On the surface its normal n comes from the cubic through its neighbours
// (core/numbers/robust_fit.hpp) in coordinates along the cam: outliers do not turn it. A roller of radius R
// that touches the point p there has its centre at p + R n, a face its distance p · n; the cam angle is that
// at which this is on the follower's guide. The centre of a roller needs no normal. An error δ of the normal
// moves the row along the motion and off it by R δ²/2 (roller) or ϱ δ²/2 (face; ϱ radius of curvature):
// second order, while the noise of the points stays that of the rows. The follower of a plane cam lies on the
// largest displacement at which it touches the surface: points at which it would cut into the smoothed
// surface elsewhere are left out.
//
// How a follower is mounted is what the forward check of its kind knows: FollowerGeometry (disk, linear,
// remote; with its linkage), RollerGuide (inverse), CamFlanks (barrel, cylindrical).

/// How the points lie on the cam.
struct PointForm {
    double probe_radius = 0.0;  ///< m; points are the centres of a ball that touches the surface; 0: on it
    bool centers = false;       ///< of the path of the roller's centre
    int side = 0;               ///< of a cam with two
    bool closed = true;         ///< the motion is one of the whole revolution, and so are the points
    std::optional<double> radius = {};  ///< m, of the cylinder with points (theta, z)
};
struct SurfaceMotion {
    std::vector<double> angle, displacement;  ///< rad, ascending, of a cam that turns in [0, 2π); m or rad
    std::vector<std::size_t> rows;            ///< of each row its point
    int untouched = 0;                        ///< points that the follower does not touch
    std::vector<double> breaks = {};          ///< rad: angles where pieces join
};

class CamUnderFollower;  // input/surface_points.cpp

/// A cam with its dimensions (of ranges the middle), and the follower on it, which moves by `lift`. Throws
/// SceneError where the form does not fit the cam: a side that it does not have, centres without a roller.
[[nodiscard]] std::shared_ptr<const CamUnderFollower> cam_under_follower(const CamSpec& cam,
                                                                         const PointForm& form, double lift);
/// Points in the cam's frame, (x, y) or (theta, z), SI. Throws SceneError "measured.theta[point]" where they
/// leave a gap, and "measured" for coordinates that the cam does not have.
[[nodiscard]] SurfaceMotion motion_on_points(std::span<const Eigen::Vector2d> points, bool axial,
                                             const CamUnderFollower& cam);
/// Lines and arcs of the path of the roller's centre, each as rows of its exact points. Throws SceneError
/// "cam.piece[i]" for a piece of no length, an arc with two radii, a kink, and one along which the cam angle
/// turns back.
[[nodiscard]] SurfaceMotion motion_on_pieces(const std::vector<CamPiece>& given, const CamUnderFollower& cam);
/// It turns about its axis.
[[nodiscard]] bool is_turning(const CamUnderFollower& cam);
/// It is a guide in a body that swings.
[[nodiscard]] bool is_guide(const CamUnderFollower& cam);
/// What the radius of the base circle is if the motion has its displacement 0 at `zero`; none: it has none.
[[nodiscard]] std::optional<double> base_radius_for(const CamUnderFollower& cam, double zero);

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

/// Points of a guide, turned about its pivot by an angle that is not known: turns them back, so that the
/// output rests where the motion does, before its rise and after it. Throws SceneError "measured.register"
/// where no point is there, and for another request than the angle.
[[nodiscard]] MeasuredPlace register_guide(const MotionSpec& motion, RegisterRequest request,
                                           std::vector<Eigen::Vector2d>& points, const CamUnderFollower& cam);

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
