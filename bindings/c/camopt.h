// SPDX-License-Identifier: MIT
// camopt in C: a scene goes in; the best cam motion comes out, with its peaks, the cam and the proof.
//
// Errors. Functions that can fail return a camopt_error, CAMOPT_OK = 0. What went wrong is then in
// camopt_error_text(), a text of the calling thread. No C++ exception leaves the library, nothing is printed,
// nothing aborts; a NULL where something must be given is CAMOPT_ERROR_NULL. Where a call fails, what it
// would have written stays as it was (a new handle is NULL), unless its comment says otherwise. One
// exception: memory that ends while TOML is read or JSON written ends the program, for the libraries that do
// it are not prepared for that.
//
// Handles. camopt_scene and camopt_solution are made by functions with an argument `camopt_… **` and freed by
// camopt_…_free. A solution keeps nothing of its scene: either may be freed first. A `const char *` that is
// handed out belongs to its handle and lives as long, unless its comment says otherwise.
//
// Memory. Texts come as camopt_text, freed by camopt_text_free. Lists of numbers and points go into buffers
// of the caller; with buffer NULL and capacity 0 only their number comes back.
//
// Structs. Those with a member `size` are read or filled up to it: set it to sizeof before the call, and all
// else of options to 0. Later versions may add members at the end. Structs without it never change.
//
// Threads. Many threads may use one handle by const functions at once, none while another changes or frees
// it. Different handles have nothing in common. camopt_solve and camopt_sweep may run in several threads at
// once, with the same scene too, and give the numbers they give alone, bit for bit, unless a limit of time
// decides. Solves by Ipopt wait for one another. Callbacks are called by the thread that solves. They may use
// other handles, and must return: no longjmp, no end of the thread. A C++ exception that one throws ends the
// call with CAMOPT_ERROR_CALLBACK.
//
// Units. x = cam angle / rise angle, y = displacement / lift; ' is d/dx; peaks are those of y', y'', y''' and
// have no units. Everything else says its unit in its name, or has one beside it. A number that does not
// exist is NaN. Text is UTF-8, with a decimal point regardless of the locale.
#ifndef CAMOPT_H
#define CAMOPT_H

#include <stddef.h>

#if defined(__GNUC__)
#define CAMOPT_C_API __attribute__((visibility("default")))
#else
#define CAMOPT_C_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/// Counts what a program compiled with an older header would no longer understand.
#define CAMOPT_ABI_VERSION 0

/// CAMOPT_ABI_VERSION of the library that was loaded: a program stops where it is not that of its header.
CAMOPT_C_API int camopt_abi_version(void);

/// The version of camopt, "MAJOR.MINOR.PATCH". Static.
CAMOPT_C_API const char* camopt_version(void);

/// The libraries that this camopt was built with, a line each ("Ipopt: EPL-1.0 (solver)"), and in a last line
/// under what terms a binary of it may be passed on. Static.
CAMOPT_C_API const char* camopt_licenses(void);

// Errors.

typedef enum camopt_error {
    CAMOPT_OK = 0,
    CAMOPT_ERROR_NULL = 1,         ///< an argument that must be given is NULL
    CAMOPT_ERROR_ARGUMENT = 2,     ///< an argument of the call is out of its range
    CAMOPT_ERROR_INPUT = 3,        ///< the scene: a key, a value, a file; the text says what is allowed
    CAMOPT_ERROR_UNAVAILABLE = 4,  ///< this build leaves out what was asked for
    CAMOPT_ERROR_ABSENT = 5,       ///< the solution has no such thing: no motion, no cam, no drawing
    CAMOPT_ERROR_CAPACITY = 6,     ///< the buffer is too small; the number needed has come back
    CAMOPT_ERROR_CANCELLED = 7,    ///< a sweep was stopped by the caller before its last row
    CAMOPT_ERROR_CALLBACK = 8,     ///< a callback threw a C++ exception
    CAMOPT_ERROR_MEMORY = 9,       ///< no memory was left
    CAMOPT_ERROR_INTERNAL = 10     ///< a fault of camopt: please report it
} camopt_error;

/// "input" of CAMOPT_ERROR_INPUT, "ok" of CAMOPT_OK; "unknown" of what is none. Static.
CAMOPT_C_API const char* camopt_error_name(camopt_error code);

/// What was wrong with the last call of this thread that failed: what was found and what is allowed. ""
/// before the first. Valid until the next call of the thread that fails.
CAMOPT_C_API const char* camopt_error_text(void);

// Texts.

/// A text with a 0 behind its last byte; length without it. Freed by camopt_text_free.
typedef struct camopt_text {
    char* data;
    size_t length;
} camopt_text;

/// Frees the text and leaves data NULL, length 0. NULL is allowed, and a text that is freed already.
CAMOPT_C_API void camopt_text_free(camopt_text* text);

// Scenes.

typedef struct camopt_scene camopt_scene;

/// The defaults of a scene file: the type of motion and weights are to be set before it can be solved.
CAMOPT_C_API camopt_error camopt_scene_new(camopt_scene** scene);

/// A scene from the text of a scene file. name: stands before line and column in errors; NULL: "scene".
CAMOPT_C_API camopt_error camopt_scene_from_toml(const char* toml, const char* name, camopt_scene** scene);

CAMOPT_C_API camopt_error camopt_scene_from_file(const char* path, camopt_scene** scene);

CAMOPT_C_API camopt_error camopt_scene_copy(const camopt_scene* scene, camopt_scene** copy);

/// NULL is allowed.
CAMOPT_C_API void camopt_scene_free(camopt_scene* scene);

/// Sets one key, in the unit that stands in it: camopt_set_number(scene, "limits.velocity_mm_s", 300). Keys
/// are the dotted keys of scene files; an entry of an array that is there is "motion.segments[1].to". Other
/// spellings of the same quantity (lift_in for lift_mm) are replaced. What the reader of a scene file would
/// find wrong with this key or value is CAMOPT_ERROR_INPUT with its words, and the scene stays as it was: a
/// limit in mm/s wants motion.speed_rpm before it, a limit of the cam the cam. What is missing yet, or is
/// wrong with other keys, is told by camopt_scene_check and by everything that uses the scene. A number
/// without a fraction does for integers.
CAMOPT_C_API camopt_error camopt_set_number(camopt_scene* scene, const char* key, double value);
CAMOPT_C_API camopt_error camopt_set_text(camopt_scene* scene, const char* key, const char* value);
/// value: 0 is false, everything else true.
CAMOPT_C_API camopt_error camopt_set_bool(camopt_scene* scene, const char* key, int value);
/// values may be NULL where count is 0.
CAMOPT_C_API camopt_error camopt_set_numbers(camopt_scene* scene, const char* key, const double* values,
                                             size_t count);
/// For values of every other kind, as TOML: "{ min = 20, max = 60 }", "[{ at = 0.5, displacement = 0.5 }]".
CAMOPT_C_API camopt_error camopt_set_toml(camopt_scene* scene, const char* key, const char* value);

/// The key's default again, whatever its spelling; a table ("cam") goes with all in it. A key that is not set
/// is none the worse for it; one that no scene can have is CAMOPT_ERROR_INPUT.
CAMOPT_C_API camopt_error camopt_unset(camopt_scene* scene, const char* key);

/// Reads the whole scene as camopt_solve will: CAMOPT_ERROR_INPUT for the first thing that is wrong or
/// missing.
CAMOPT_C_API camopt_error camopt_scene_check(const camopt_scene* scene);

/// The scene as a scene file: as given, comments and all, where nothing was set.
CAMOPT_C_API camopt_error camopt_scene_to_toml(const camopt_scene* scene, camopt_text* toml);

// Solving.

typedef struct camopt_solution camopt_solution;

typedef struct camopt_progress {
    size_t size;  ///< of what the library has filled
    const char*
        message;       ///< one short line: "round 2: objective 0.93951, 97 rows". Until the callback returns
    double seconds;    ///< since the solve (the sweep) began
    int round;         ///< of the exchange of cam angles, from 1; 0: not known
    double incumbent;  ///< objective of the best motion so far
    double bound;      ///< that no motion can pass, proved so far
    double violation;  ///< of the incumbent, relative to each limit; <= 0: all are satisfied
} camopt_progress;

typedef void (*camopt_progress_callback)(const camopt_progress* progress, void* user);

/// Asked often between iterations: not 0 stops the search soon.
typedef int (*camopt_cancel_callback)(void* user);

/// All may be 0: `camopt_solve_options options = {0}; options.size = sizeof options;`
typedef struct camopt_solve_options {
    size_t size;
    camopt_progress_callback progress;
    camopt_cancel_callback cancel;
    void* user;         ///< goes to both
    int forward_check;  ///< not 0: a follower is run over the finished cam's points; the report says how far
                        ///< it was off
} camopt_solve_options;

/// Finds the best motion of the scene. options: may be NULL. What came out is the solution's verdict, not an
/// error: there is a solution also where nothing feasible exists (it has suggested changes), and where the
/// search was cancelled (with the best motion so far; without a motion where nothing had been found). Errors:
/// INPUT, UNAVAILABLE (a solver that this build leaves out), CALLBACK, MEMORY.
CAMOPT_C_API camopt_error camopt_solve(const camopt_scene* scene, const camopt_solve_options* options,
                                       camopt_solution** solution);

/// NULL is allowed.
CAMOPT_C_API void camopt_solution_free(camopt_solution* solution);

// What was found.

typedef enum camopt_verdict {
    CAMOPT_OPTIMAL = 0,   ///< proved: no motion of this spline space is better by more than the gap asked for
    CAMOPT_LOCAL = 1,     ///< no better motion near it; not proved to be the global optimum
    CAMOPT_FEASIBLE = 2,  ///< satisfies every limit
    CAMOPT_INFEASIBLE = 3,  ///< no motion satisfies the limits
    CAMOPT_FAILED = 4       ///< nothing was found that satisfies the limits, and nothing is proved
} camopt_verdict;

/// "optimal" of CAMOPT_OPTIMAL; "unknown" of what is none. Static.
CAMOPT_C_API const char* camopt_verdict_name(camopt_verdict verdict);

typedef struct camopt_summary {
    size_t size;
    camopt_verdict verdict;
    const char* reason;  ///< why the verdict is not better: "no_feasible_point", "time_limit"; "" where
                         ///< nothing is to say
    int has_motion;
    int has_cam;         ///< a cam was made: parameters, profile
    int interrupted;     ///< the cancel callback ended the search
    double objective;    ///< weighted peaks over those of the reference law
    double lower_bound;  ///< proved: no motion of the spline space is below
    double gap;          ///< (objective - lower_bound) / max(1, |objective|)
    double any_curve;    ///< the limit that no curve of any kind can pass
    double violation;    ///< largest of any limit between samples too, relative; <= 0: all are satisfied
    double begin, end;   ///< x of the motion's ends
    double rise_deg;     ///< cam angle of one unit of x
    double lift;         ///< of one unit of y: mm, or deg where lift_is_angle
    int lift_is_angle;
    double speed_rpm;  ///< of the scene
    int iterations, exchange_rounds;
    double seconds_total, seconds_solve;
} camopt_summary;

CAMOPT_C_API camopt_error camopt_solution_summary(const camopt_solution* solution, camopt_summary* summary);

/// max |y'|, |y''|, |y'''|, |y' y''| with the x where they are, and root mean squares. Exact, between samples
/// too.
typedef struct camopt_peaks {
    size_t size;
    double velocity, velocity_at;
    double acceleration, acceleration_at;
    double jerk, jerk_at;
    double torque, torque_at;
    double rms_velocity, rms_acceleration, rms_jerk;
} camopt_peaks;

/// V, A, J of the objective: of a program the largest over its spline segments, each by its own angle and
/// displacement. ABSENT without a motion.
CAMOPT_C_API camopt_error camopt_solution_peaks(const camopt_solution* solution, camopt_peaks* peaks);

/// Of the whole motion, in lifts and rises: what physical peaks come from. The same but for programs. ABSENT
/// without a motion.
CAMOPT_C_API camopt_error camopt_solution_motion_peaks(const camopt_solution* solution, camopt_peaks* peaks);

/// A number of the cam: "base_radius", 30, "mm"; after these of its spring what was a range: "preload", 120,
/// "N".
typedef struct camopt_parameter {
    size_t size;
    const char* name;
    const char* unit;  ///< "mm" or "deg"; "N", "N/m", of a swinging follower "N m", "N m/rad"
    double value;
    int is_variable;  ///< the optimizer chose it
} camopt_parameter;

/// 0 where there is no cam.
CAMOPT_C_API camopt_error camopt_parameter_count(const camopt_solution* solution, size_t* count);
/// index from 0; ARGUMENT beyond the count.
CAMOPT_C_API camopt_error camopt_parameter_at(const camopt_solution* solution, size_t index,
                                              camopt_parameter* parameter);

/// A limit of the scene, as written, and the value reached.
typedef struct camopt_constraint {
    size_t size;
    const char* name;  ///< "pressure_angle"
    const char* key;   ///< "limits.pressure_angle_deg"
    const char* unit;  ///< of limit and worst; "" without one
    double limit, worst;
    double at;  ///< x of the worst
    int active;
    int no_contact;  ///< there is no figure: the cam is undercut
} camopt_constraint;

/// 0 where there is no motion.
CAMOPT_C_API camopt_error camopt_constraint_count(const camopt_solution* solution, size_t* count);
/// index from 0; ARGUMENT beyond the count.
CAMOPT_C_API camopt_error camopt_constraint_at(const camopt_solution* solution, size_t index,
                                               camopt_constraint* constraint);

/// Suggested changes where the verdict is infeasible: the least change of one number, the most useful first.
typedef struct camopt_relaxation {
    size_t size;
    const char* key;  ///< given, needed and solved are in its unit
    double given;
    double needed;  ///< on the edge of what is feasible; NaN: none was found
    double solved;  ///< needed, rounded to the side that does: a motion was found with it
    int ruled_out;  ///< without needed: it is proved that no value helps
    size_t also;    ///< how many numbers change along with it
} camopt_relaxation;

/// A number that changes along with another one: the dwell that a longer segment is taken from.
typedef struct camopt_companion_change {
    size_t size;
    const char* key;  ///< given and solved are in its unit
    double given, solved;
} camopt_companion_change;

CAMOPT_C_API camopt_error camopt_relaxation_count(const camopt_solution* solution, size_t* count);
/// index from 0; ARGUMENT beyond the count.
CAMOPT_C_API camopt_error camopt_relaxation_at(const camopt_solution* solution, size_t index,
                                               camopt_relaxation* relaxation);
/// What changes along with the relaxation `index`; which: from 0, below its `also`, else ARGUMENT.
CAMOPT_C_API camopt_error camopt_relaxation_also(const camopt_solution* solution, size_t index, size_t which,
                                                 camopt_companion_change* change);

// The motion.

/// y, y', y'', y''' at any x of [begin, end]; where one jumps, as seen from the right (at the end: left).
/// ARGUMENT outside, ABSENT without a motion. Where dynamics.prescribe = "output" it is the cam's.
CAMOPT_C_API camopt_error camopt_motion_at(const camopt_solution* solution, double x, double derivatives[4]);

/// The same of the motion of the output of an elastic train, which camopt_solution_peaks is of; without such
/// a train the motion itself.
CAMOPT_C_API camopt_error camopt_output_at(const camopt_solution* solution, double x, double derivatives[4]);

/// camopt_motion_at at `count` places; any of the buffers of `count` numbers may be NULL. Nothing is written
/// where one x is outside.
CAMOPT_C_API camopt_error camopt_motion_at_all(const camopt_solution* solution, const double* x, size_t count,
                                               double* y, double* dy, double* d2y, double* d3y);

/// At `count` >= 2 places evenly over [begin, end], both included; any of the buffers may be NULL.
CAMOPT_C_API camopt_error camopt_motion_samples(const camopt_solution* solution, size_t count, double* x,
                                                double* y, double* dy, double* d2y, double* d3y);

/// A spline y(x): DRD and RR motions are one, programs have one a spline segment.
typedef struct camopt_spline {
    size_t size;
    int degree;
    int continuity;     ///< highest continuous derivative
    double begin, end;  ///< x
    size_t breakpoint_count;
    size_t knot_count;  ///< clamped: the end knots degree + 1 fold, the others degree - continuity fold
    size_t coefficient_count;  ///< knot_count - degree - 1
} camopt_spline;

/// 0 where there is no motion.
CAMOPT_C_API camopt_error camopt_spline_count(const camopt_solution* solution, size_t* count);
/// index from 0; ARGUMENT beyond the count.
CAMOPT_C_API camopt_error camopt_spline_at(const camopt_solution* solution, size_t index,
                                           camopt_spline* spline);

/// Into a buffer of `capacity` numbers; *count: how many there are. CAPACITY where these are more (unless
/// buffer is NULL and capacity 0). Coefficients are the B-spline control points over the knots.
CAMOPT_C_API camopt_error camopt_spline_breakpoints(const camopt_solution* solution, size_t index,
                                                    double* buffer, size_t capacity, size_t* count);
CAMOPT_C_API camopt_error camopt_spline_knots(const camopt_solution* solution, size_t index, double* buffer,
                                              size_t capacity, size_t* count);
CAMOPT_C_API camopt_error camopt_spline_coefficients(const camopt_solution* solution, size_t index,
                                                     double* buffer, size_t capacity, size_t* count);

// The cam.

/// One point of the cam in the frame that turns with it, the cam's centre at the origin. z: 0 of plane cams.
typedef struct camopt_profile_point {
    double theta_deg;           ///< cam angle, from the start of the motion
    double pitch_mm[3];         ///< roller centre; without a roller the contact
    double cam_mm[3];           ///< contact: a point of the cam's surface
    double normal[3];           ///< of the surface there, outward, length 1
    double pressure_angle_deg;  ///< signed
    double pitch_radius_mm;     ///< signed radius of curvature, > 0 convex; infinite where straight
    double cam_radius_mm;       ///< the same of the cam's surface; NaN where it has none
    double regularity;          ///< <= 0: undercut
} camopt_profile_point;

/// Places along the contact, each with its own profile: 1 of plane cams, heights and flanks of spatial
/// ones. ABSENT without a cam.
CAMOPT_C_API camopt_error camopt_station_count(const camopt_solution* solution, size_t* count);
/// "left wall", "100 % of the roller, flank -"; "" of plane cams. station: from 0; ARGUMENT beyond them.
CAMOPT_C_API camopt_error camopt_station_name(const camopt_solution* solution, size_t station,
                                              const char** name);

/// The whole cam (an RR motion is followed by its dwell, a DRD motion stays a sector) as about `points` >= 2
/// points evenly by cam angle, breakpoints of the motion besides; 0: as many as are good for a drawing.
/// station: from 0. Buffer as of camopt_spline_knots. ABSENT without a cam, ARGUMENT beyond the stations.
CAMOPT_C_API camopt_error camopt_profile(const camopt_solution* solution, size_t points, size_t station,
                                         camopt_profile_point* buffer, size_t capacity, size_t* count);

// Files into memory.

typedef enum camopt_document {
    CAMOPT_SUMMARY_TEXT = 0,      ///< what `camopt solve` prints
    CAMOPT_REPORT_MARKDOWN = 1,   ///< report.md
    CAMOPT_RESULT_JSON = 2,       ///< result.json
    CAMOPT_CERTIFICATE_JSON = 3,  ///< certificate.json: the proof
    CAMOPT_MOTION_CSV = 4,        ///< motion.csv; ABSENT without a motion, as the rest is
    CAMOPT_MOTION_SVG = 5,        ///< motion.svg
    CAMOPT_PROFILE_CSV = 6,       ///< profile.csv, of an inverse cam guide.csv; plane cams, as the rest
    CAMOPT_PROFILE_DXF = 7,       ///< profile.dxf: arcs within 1 µm, mm
    CAMOPT_PROFILE_SVG = 8        ///< the cam to scale
} camopt_document;

/// The text of a file that `camopt solve --out` writes (docs/results.md has columns, keys, units).
CAMOPT_C_API camopt_error camopt_solution_text(const camopt_solution* solution, camopt_document document,
                                               camopt_text* text);

// Files of the workshop: drawings, solids, NC programs, electronic cams, reports.

/// How they are made; all may be 0: `camopt_file_options options = {0}; options.size = sizeof options;`
typedef struct camopt_file_options {
    size_t size;
    double bore_mm, thickness_mm;  ///< of a disk cam; 0: the scene's [drawing]
    double cutter_mm;              ///< diameter; 0: the roller's, of a plane cam 16
    double feed_mm_min;            ///< of the cutter; 0: 300
    double spindle_rpm;            ///< 0: the program has no word for it
    const char* post;              ///< file of a post-processor (docs/nc.md); NULL: the generic one
    size_t plc_points;             ///< of an electronic cam, evenly; 0: the joints of the motion
    /// Further options and other units, "KEY=VALUE" one a line: those of `camopt export` with _ for -
    /// ("direction=conventional\ncutter_in=0.5"; `camopt list keys`). NULL: none.
    const char* settings;
} camopt_file_options;

/// The names of the files that the solution has, one a line, each with a line feed: report.html, codesys.st
/// and so on of each controller; of a disk cam drawing.pdf, drawing.svg, drawing.dxf, cam.step, cam.stl,
/// cam.nc, cam_nc_check.txt; of a three-dimensional cam flanks.step, cam.nc (docs/embedding_c.md has all).
CAMOPT_C_API camopt_error camopt_file_names(const camopt_solution* solution, camopt_text* names);

/// The bytes of one of them, what `camopt export` writes: drawing.pdf, cam.stl hold zeros, length counts.
/// options: may be NULL. Errors: ABSENT for a name that this solution does not have, INPUT for an NC program
/// that its check refuses, a cam that is open or undercut, options that are not valid, UNAVAILABLE for STEP
/// or PDF in a build without the library.
CAMOPT_C_API camopt_error camopt_file(const camopt_solution* solution, const char* name,
                                      const camopt_file_options* options, camopt_text* bytes);

/// Writes `count` of them into the folder, which is created: all or none. Errors as camopt_file, and INPUT
/// where a file cannot be written.
CAMOPT_C_API camopt_error camopt_write_files(const camopt_solution* solution, const char* folder,
                                             const char* const* names, size_t count,
                                             const camopt_file_options* options);

// Sweeps.

/// Keys that vary together, and the points they take: values[point * key_count + key], in the unit of each
/// key.
typedef struct camopt_sweep_axis {
    const char* const* keys;
    size_t key_count;
    const double* values;
    size_t point_count;
} camopt_sweep_axis;

/// One solved row. Lives until the callback returns.
typedef struct camopt_sweep_row {
    size_t size;             ///< of what the library has filled
    size_t number, rows;     ///< from 0, and how many there will be
    const double* settings;  ///< value of each key, axis after axis
    size_t setting_count;
    camopt_verdict verdict;
    const char* reason;  ///< as in camopt_summary; of a row that could not be solved at all "error: …"
    double objective, lower_bound, gap, any_curve;
    double velocity, acceleration, jerk, torque, rms_acceleration, rms_jerk;  ///< peaks; NaN: no motion
    const camopt_parameter* parameters;  ///< dimensions that the optimizer chose
    size_t parameter_count;
    const char* const* active_limits;  ///< keys
    size_t active_limit_count;
    int iterations, exchange_rounds;
    double seconds;
    int proved_from;  ///< the row whose motion it has too, proved without a solve; -1: solved
} camopt_sweep_row;

/// Not 0: the sweep ends here.
typedef int (*camopt_sweep_callback)(const camopt_sweep_row* row, void* user);

/// Solves the full grid of the axes, rows in an order of neighbours (the first axis moves slowest), each from
/// what the row before found, in the chunks of `camopt sweep`: the same numbers, bit for bit. All rows are
/// checked before the first is solved. options: may be NULL; its `cancel` ends the sweep within a row, which
/// is then not told; forward_check is not looked at. Errors: INPUT ("row 3 (limits.velocity=-1): …"),
/// UNAVAILABLE, CANCELLED where the callback or cancel said so, CALLBACK.
CAMOPT_C_API camopt_error camopt_sweep(const camopt_scene* scene, const camopt_sweep_axis* axes,
                                       size_t axis_count, const camopt_solve_options* options,
                                       camopt_sweep_callback row, void* row_user);

#ifdef __cplusplus
}
#endif

#endif
