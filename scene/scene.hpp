// SPDX-License-Identifier: MIT
// A scene: what must move, how good, found how. SI units and radians; plain values with the defaults of a
// scene file, so that a scene can be written in a few lines of C++ without any file.
#pragma once

#include "core/errors.hpp"
#include "core/text/names.hpp"
#include "core/units.hpp"
#include "scene/cam_spec.hpp"
#include "scene/drive_spec.hpp"
#include "scene/dynamics_spec.hpp"
#include "scene/key_row.hpp"
#include "scene/own_rule.hpp"
#include "scene/tolerance_spec.hpp"
#include "scene/valve_spec.hpp"

namespace camopt {

enum class SegmentKind { dwell, law, spline };
enum class TieBreak { none, rms_jerk };
/// What V, A and J of a program are measured by (objectives/program_family.hpp, peak_scales).
enum class PeakScope { strokes, motion };

/// The units in which the numbers of a set point were written ("deg", "mm", "mm/s", "mm/rad", …; empty:
/// normalised): reports show them so, and they are what stays where the angle of a segment is searched.
struct SetPointUnits {
    std::string place = {}, displacement = {}, velocity = {}, acceleration = {};
    friend bool operator==(const SetPointUnits&, const SetPointUnits&) = default;
};

/// An exact point of the motion; with `until` a region that is run through at a constant velocity.
/// Normalised: `at` and `until` in units of the rise (of a program's segment: of its angle, from its start),
/// y in lifts, derivatives of y by that x. At least one value is given; of a region the velocity, and perhaps
/// the displacement where it begins.
struct SetPoint {
    double at = 0.0;
    std::optional<double> displacement = {}, velocity = {}, acceleration = {};
    std::optional<double> until = {};
    SetPointUnits units = {};

    [[nodiscard]] bool is_region() const { return until.has_value(); }
    friend bool operator==(const SetPoint&, const SetPoint&) = default;
};

/// Inequalities on a stretch of the cam angle, its ends included, counted from the start of the motion.
struct Corridor {
    struct Bounds {
        std::optional<double> least = {}, most = {};  ///< in lifts, by x of the whole motion
        std::string key = {};                         ///< as written: "displacement_mm"; empty: none is given
        std::string unit = {};                        ///< "mm"; empty: normalised
        friend bool operator==(const Bounds&, const Bounds&) = default;
    };
    double from = 0.0, to = 0.0;     ///< rad
    std::array<Bounds, 4> bounds{};  ///< of y, y', y'', y'''
    friend bool operator==(const Corridor&, const Corridor&) = default;
};

/// The least and the largest angle that a search may give a segment, rad.
struct AngleRange {
    double least = 0.0, most = 0.0;
    friend bool operator==(const AngleRange&, const AngleRange&) = default;
};

/// One stretch of a program. A dwell keeps the displacement it finds.
struct ProgramSegment {
    SegmentKind kind = SegmentKind::dwell;
    double angle = 0.0;              ///< cam angle it takes, rad, > 0
    std::string law = {};            ///< kind law: a key of the catalogue
    std::optional<double> to;        ///< displacement at its end, in lifts; none: free (law, spline)
    std::vector<SetPoint> via = {};  ///< kind spline
    std::optional<AngleRange> angle_range = {};  ///< searched, from `angle` on; closed programs only
    /// Its law is the polynomial with the states of its neighbours (objectives/laws/segment_law.hpp).
    [[nodiscard]] bool takes_states() const { return kind == SegmentKind::law && law == "polynomial"; }
    std::string to_unit =
        {};  ///< in which `to` was written ("mm"); it stays where the lift changes. Empty: lifts
    /// kind spline or a polynomial, followed by another: velocity, acceleration at its end, as of a set point
    /// at = 1.
    std::optional<SetPoint> end = {};
    friend bool operator==(const ProgramSegment&, const ProgramSegment&) = default;
};

/// A row of a measured table that lies apart from its neighbours.
struct MeasuredOutlier {
    int row = 0;         ///< of the table's rows of numbers, from 1
    double angle = 0.0;  ///< rad, from the start of the motion
    double off = 0.0;    ///< from its neighbours, m or rad
    friend bool operator==(const MeasuredOutlier&, const MeasuredOutlier&) = default;
};

/// What measured.register found: by the strokes of the scene, free ones as smooth curves or (law: which) as
/// the law nearest to the table.
struct MeasuredPlace {
    struct Number {
        double value = 0.0, error = 0.0;  ///< standard error; NaN: the residuals contradict the model
        friend bool operator==(const Number&, const Number&) = default;
    };
    std::string law;
    /// rad: the table's angle at the start of the motion; of points of a cam how far it is turned on the
    /// table
    std::optional<Number> angle;
    bool points = false;         ///< the angle is of points: counter-clockwise, whichever way the cam rotates
    std::optional<Number> zero;  ///< m or rad: the table's displacement where the motion has 0
    std::optional<double> base_radius;   ///< m, of points of a cam: what the zero makes it
    double residual = 0.0, noise = 0.0;  ///< m or rad: rms of the residuals, of rows from their neighbours

    /// The residuals are far above the noise.
    [[nodiscard]] bool contradicted() const { return residual > 3.0 * noise; }
    friend bool operator==(const MeasuredPlace&, const MeasuredPlace&) = default;
};

/// A motion that was measured, or comes from elsewhere: displacement over cam angle, counted from the start.
struct MeasuredMotion {
    std::vector<double> angle;         ///< rad, ascending, over the whole motion
    std::vector<double> displacement;  ///< m; rad where the lift is an angle
    bool start = false;                ///< searches begin from it too; else it is only compared
    /// It is the motion of a cam that exists: nothing is optimized.
    bool given = false;
    /// rad, of a cam of pieces: where its contact passes from one to the next, and s'' may jump.
    std::vector<double> breaks = {};
    std::string name = {};  ///< of the table, for people
    int untouched = 0;      ///< points of the cam that its follower does not touch: left out
    std::vector<MeasuredOutlier> outliers = {};
    bool excluded = false;                    ///< the outliers are not among the rows
    std::optional<MeasuredPlace> place = {};  ///< only where it was searched
    friend bool operator==(const MeasuredMotion&, const MeasuredMotion&) = default;
};

/// What a scene file says about its measured motion; of a table its numbers. SI units and radians, as
/// written: before `zero` and `registered` are looked at.
struct MeasuredRows {
    std::string table = {};                              ///< a file whose numbers are not here yet
    std::vector<std::string> columns = {};               ///< of the table
    std::string decimal = ".";                           ///< of the table
    std::vector<double> scale = {}, offset = {};         ///< of the table, a number for each column
    int skip_lines = 0;                                  ///< of the table
    std::vector<double> theta = {}, s = {};              ///< angles and displacements
    std::vector<double> x = {}, y = {}, r = {}, z = {};  ///< points of the cam; r or z with theta
    std::string of = "surface";                          ///< or "center": what the points are on
    int side = 1;                                        ///< of a cam with two: which one they are on
    std::optional<double> radius = {};                   ///< of the cylinder that points (theta, z) are on
    double probe_radius = 0.0;
    std::optional<double> step = {};           ///< from row to row, in place of theta
    std::string zero = "start";                ///< or "nose"
    std::optional<double> zero_angle = {};     ///< in place of the word
    std::string angles = "cam";                ///< or "crank"
    std::vector<std::string> registered = {};  ///< "angle", "radius": searched
    std::string outliers = "keep", use = "compare", norm = "peak", name = {};
    friend bool operator==(const MeasuredRows&, const MeasuredRows&) = default;
};

struct MotionSpec {
    MotionType type = MotionType::drd;
    double lift = 1e-3;                    ///< m, or rad where lift_is_angle; > 0
    bool lift_is_angle = false;            ///< a swinging or indexing output
    double rise = 3.14159265358979323846;  ///< cam angle of the rise, rad, in (0, 2π]
    std::optional<double> return_angle;    ///< RR: cam angle of the return, rad; default: rise
    std::optional<double> speed;           ///< rad/s, > 0; only time-domain limits and outputs need it
    bool symmetric = false;                ///< DRD: y(x) + y(1-x) = 1; RR: y(x) = y(2-x)
    bool within_lift = true;               ///< each stroke stays between its ends (objectives/strokes.hpp)
    bool monotone = false;                 ///< a rise only rises, a return only falls
    /// Lifts that splines stay between, of the search alone: those of cams that can be built.
    std::optional<std::array<double, 2>> reach = {};
    std::vector<SetPoint> via;
    std::vector<ProgramSegment> segments;  ///< program: from s = 0 at the start
    bool closed = true;                    ///< program: the angles add up to a turn, and it ends at s = 0
    /// Program, not closed: the angles add up to a turn that goes on in the next one from the displacement
    /// it has reached, as smooth as its splines.
    bool relative = false;
    /// Program: its segments are so many copies of one part, and so is the motion. Closed programs only.
    int repeat = 1;
    /// Program that is periodic: rad, in (−2π, 2π). The master angle at which the motion begins: tables of
    /// the motion over the master count from there (Solution::master_turn). Angles of the scene are the
    /// motion's own.
    double phase = 0.0;
    /// Velocity and acceleration where a motion that is not periodic starts and ends, normalised as set
    /// points of the first and the last stretch; what is not given is 0, as at rest.
    std::optional<SetPoint> start, end;
    std::vector<Corridor> corridors;
    std::optional<ValveSpec> valve;  ///< program: its segments are those of this lobe (make_valve_lobe)

    /// A program whose first segment follows its last one.
    [[nodiscard]] bool periodic() const { return type == MotionType::program && (closed || relative); }
    /// The segments before they are repeated; those of a program that does not.
    [[nodiscard]] std::size_t own_segments() const {
        return segments.size() / static_cast<std::size_t>(repeat);
    }
    /// Laws and dwells only: there is one such motion.
    [[nodiscard]] bool prescribed() const;
    /// The cam angle of x = 1, rad: the rise; in a program the angle of its first spline segment, in a
    /// prescribed one of its first law.
    [[nodiscard]] double unit_angle() const;
    /// Length of the motion in x: 1 for DRD, 1 + return / rise for RR, all angles / unit angle for a program.
    [[nodiscard]] double length() const;
    /// The master's at x, rad: from the phase on, not reduced to one turn.
    [[nodiscard]] double master_angle(double x) const { return phase + unit_angle() * x; }
    /// x at a master angle (rad) of a periodic motion, in [0, length()).
    [[nodiscard]] double own_place(double master) const;
    /// The least and the largest displacement that is given, m or rad: 0 and the lift, of a program those of
    /// its segments.
    [[nodiscard]] std::pair<double, double> displacements() const;
    friend bool operator==(const MotionSpec&, const MotionSpec&) = default;
};

struct SplineSpec {
    int degree = 3;     ///< 3, 5 or 7
    int segments = 12;  ///< uniform segments over the whole motion; ignored where breakpoints are given
    /// RR: half of the segments over the rise, half over the return, in place of uniform ones over both.
    bool by_stroke = false;
    std::vector<double> breakpoints;  ///< x, ascending, from 0 to length(); empty: uniform
    /// The interior breakpoints are variables too: those above are where the search starts.
    bool free_knots = false;
    /// Highest continuous derivative, roughest() … degree − 1; default degree − 1.
    std::optional<int> continuity;
    /// Highest derivative that is 0 where the spline meets rest: the ends of DRD and RR, dwells and open ends
    /// of a program. 2 … degree − 1; 3 is also the key spline.end_jerk = "zero".
    int rest = 2;
    DesignKind design = DesignKind::automatic;

    [[nodiscard]] int smoothness() const { return continuity.value_or(degree - 1); }
    /// The least continuity: a state at a breakpoint holds y'', of degree 7 y''' too.
    [[nodiscard]] int roughest() const { return degree == 7 ? 3 : 2; }
    friend bool operator==(const SplineSpec&, const SplineSpec&) = default;
};

/// The figures the peaks are divided by: those of a law of the catalogue, or numbers.
struct Reference {
    std::string law = "modified_sine";  ///< used where a number below is absent
    std::optional<double> velocity, acceleration, jerk, torque, rms_acceleration, rms_jerk;
    std::optional<double> residual, dynamic_acceleration;  ///< in lifts; in lifts by x²
    std::optional<double> area;                            ///< lost area, 1 − mean displacement in lifts
    std::optional<double> motor_torque, motor_torque_rms;  ///< N m
    std::optional<double> deviation, deviation_rms;        ///< lifts; none: 0.001
    bool numeric = false;  ///< true: `law` plays no part, every number needed must be given
    friend bool operator==(const Reference&, const Reference&) = default;
};

/// A number of a scene whose least, or largest, value with a motion is sought first
/// (studies/least/least_value.hpp); the weights choose among the motions at it.
struct SoughtKey {
    std::string key;       ///< "limits.pressure_angle_deg"
    bool largest = false;  ///< better large

    /// The key of the scene file that names it.
    [[nodiscard]] const char* member() const { return largest ? "objective.largest" : "objective.least"; }
    friend bool operator==(const SoughtKey&, const SoughtKey&) = default;
};

struct ObjectiveSpec {
    double velocity = 0.0, acceleration = 0.0, jerk = 0.0;  ///< weights, >= 0
    double torque = 0.0;                                    ///< weight, >= 0, of max |y' y''|
    double rms_acceleration = 0.0, rms_jerk = 0.0;          ///< weights, >= 0
    double residual = 0.0, dynamic_acceleration = 0.0;      ///< weights, >= 0; need dynamics
    double area = 0.0;  ///< weight, >= 0, of the lost area 1 − (1/L) ∫ y dx over the whole motion
    double motor_torque = 0.0, motor_torque_rms = 0.0;  ///< weights, >= 0; need a drive
    double deviation = 0.0, deviation_rms = 0.0;        ///< weights, >= 0; need a measured motion
    /// Weights, >= 0, of the cam's variable dimensions divided by the lift (of an oscillating follower: by
    /// the lift times the centre distance); the offset counts by its magnitude.
    std::array<double, dimension_count> dimensions{};
    Reference reference;
    TieBreak tie_break = TieBreak::rms_jerk;
    PeakScope peaks = PeakScope::strokes;
    std::optional<SoughtKey> sought = {};
    double least_gap = 1e-4;  ///< relative distance of the value sought from one that is proved impossible
    friend bool operator==(const ObjectiveSpec&, const ObjectiveSpec&) = default;
};

/// A hard limit on a peak, or on one side of a derivative, as the user wrote it. From C++ a number will do,
/// which is normalised (limits.velocity = 1.6), or one in a unit (limits.velocity =
/// millimetres_per_second(300), scene/written_limits.hpp): solve() fills in the rest.
struct PeakLimit {
    double normalised = 0.0;      ///< on the normalised peak, > 0; of one side any number
    std::string key;              ///< as written, e.g. "limits.velocity_mm_s"
    double given = 0.0;           ///< in the unit of the key
    std::string unit;             ///< "", "mm/s", "deg/s^2", …
    double one_normalised = 0.0;  ///< in the unit of the key; 0: given / normalised

    PeakLimit() = default;
    PeakLimit(double normalised_peak, std::string written_key = {}, double written_number = 0.0,
              std::string written_unit = {})  // NOLINT(google-explicit-constructor)
        : normalised(normalised_peak),
          key(std::move(written_key)),
          given(written_number),
          unit(std::move(written_unit)) {}

    /// given / normalised: what one unit of the normalised peak is in the unit of the key.
    [[nodiscard]] double unit_per_normalised() const {
        return one_normalised > 0.0 ? one_normalised : given / normalised;
    }
    /// In a unit, in time or by the cam angle: it holds for the motion itself. A normalised one holds for
    /// each spline segment of a program as its peaks are measured (objective.peaks).
    [[nodiscard]] bool physical() const { return !unit.empty(); }
    [[nodiscard]] bool in_time() const { return is_unit_of_time(unit); }
    friend bool operator==(const PeakLimit&, const PeakLimit&) = default;
};

/// A number that went through a change of unit and back, to the 15 digits that survive: 30,
/// not 29.999999999999996.
[[nodiscard]] double as_written(double value);

/// Any other hard limit, as the user wrote it. From C++ its number will do
/// (limits.pressure_angle = 30 * units::degree): solve() fills in the rest.
struct WrittenLimit {
    double value = 0.0;       ///< SI, rad
    std::string key;          ///< as written, e.g. "limits.pressure_angle_deg"
    double unit_value = 1.0;  ///< SI value of one unit of the key
    std::string unit;         ///< "deg", "mm", "N", …; empty: dimensionless

    WrittenLimit() = default;
    WrittenLimit(double number, std::string written_key = {}, double one_unit = 1.0,
                 std::string written_unit = {})  // NOLINT(google-explicit-constructor)
        : value(number), key(std::move(written_key)), unit_value(one_unit), unit(std::move(written_unit)) {}

    [[nodiscard]] double given() const { return as_written(value / unit_value); }
    friend bool operator==(const WrittenLimit&, const WrittenLimit&) = default;
};

/// What a limit of the cam holds on to: a figure that a cam is judged by.
enum class LimitedFigure {
    pressure_angle,         ///< |φ| at every cam angle
    rise_pressure_angle,    ///< while the follower rises, in place of the one above
    return_pressure_angle,  ///< while it returns
    convex_radius,          ///< of the cam's surface, where it is convex
    concave_radius,         ///< where it is concave
    regularity,          ///< 1 − roller radius / pitch radius, or cam radius / base radius of a flat face
    contact_force,       ///< F or M of ForceSpec, the least
    contact_force_most,  ///< the largest, in a groove to either side
    torque,              ///< |camshaft torque|
    hertz_pressure,
    residual,               ///< amplitude of the output's free vibration after a rise or a return
    dynamic_contact_force,  ///< of the elastic train on the cam
    motor_torque,           ///< |τ| of the drive
    motor_torque_min,       ///< τ, of one side
    motor_torque_max,
    motor_torque_rms,  ///< over the cycle
    motor_speed,       ///< |n|
    spring_harmonic    ///< largest amplitude of the harmonics of the lift near the spring's frequency
};
inline constexpr int limited_figure_count = 18;

/// The highest harmonic of the lift that a limit may name, or a spring be near to.
inline constexpr int most_harmonic = 1000;

struct LimitSpec {
    std::optional<PeakLimit> velocity, acceleration, jerk;
    /// Of one side: y^{(r)} >= min, y^{(r)} <= max.
    std::optional<PeakLimit> velocity_min, velocity_max, acceleration_min, acceleration_max, jerk_min,
        jerk_max;
    /// The same of the cam's own motion s, in lifts over x; only where dynamics prescribes the output's.
    std::optional<PeakLimit> cam_velocity, cam_acceleration, cam_jerk, cam_velocity_min, cam_velocity_max,
        cam_acceleration_min, cam_acceleration_max, cam_jerk_min, cam_jerk_max;
    // The rest needs a cam.
    std::optional<WrittenLimit> pressure_angle;                              ///< |φ| <=, in (0, π/2)
    std::optional<WrittenLimit> rise_pressure_angle, return_pressure_angle;  ///< replace it there
    std::optional<WrittenLimit> cam_radius_min;      ///< least convex radius of the cam surface, >= 0
    std::optional<WrittenLimit> concave_radius_min;  ///< least concave radius of the cam surface, >= 0
    /// Least regularity, in [0, 1): 1 − roller radius / pitch radius for a roller, cam radius / base radius
    /// for a flat face. 0: just no undercut.
    std::optional<WrittenLimit> undercut_margin;
    // These need forces and a speed too.
    std::optional<WrittenLimit> contact_force_min;   ///< of F (N) or M (N m) of ForceSpec
    std::optional<WrittenLimit> contact_force_max;   ///< of F or M; where both sides carry, of its magnitude
    std::optional<WrittenLimit> torque_max;          ///< |camshaft torque|, N m
    std::optional<WrittenLimit> hertz_pressure_max;  ///< Pa; needs a contact width
    // These need dynamics, and no cam.
    std::optional<WrittenLimit> residual;                   ///< amplitude of the output in dwells, m or rad
    std::optional<WrittenLimit> dynamic_contact_force_min;  ///< on the cam, N or N m
    // These need a drive.
    std::optional<WrittenLimit> motor_torque, motor_torque_min, motor_torque_max;  ///< |τ|, or one side, N m
    std::optional<WrittenLimit> motor_torque_rms;                                  ///< over the cycle, N m
    std::optional<WrittenLimit> motor_speed;                                       ///< rad/s
    /// Amplitude of the harmonics of the lift, m or rad; needs forces.spring_frequency.
    std::optional<WrittenLimit> spring_harmonic;
    /// The first and the last of them; {0, 0}: the nearest to the spring's frequency, and one to either side.
    std::array<int, 2> spring_harmonics{};
    MotorCurve motor_curve;  ///< |τ| at |n|, from n = 0 to the largest speed; empty: none
    friend bool operator==(const LimitSpec&, const LimitSpec&) = default;
};

struct SolverSpec {
    std::string name = "auto";
    double tolerance = 1e-9;  ///< feasibility and optimality of the solve, relative
    /// Proved relative gap below which the verdict is optimal; default: wanted_gap().
    std::optional<double> gap;
    double max_seconds = 60.0;  ///< wall time of the whole solve; then the best feasible point is kept
    /// Of max_seconds: for the search for changes that make an infeasible scene feasible, which ends as soon
    /// as it has found so many useful ones.
    double explain_seconds = 5.0;
    int explain_changes = 3;
    std::optional<int> starts;  ///< starting points; default: 1 where convex, 8 otherwise
    unsigned seed = 0;
    std::map<std::string, OptionValue> options;  ///< the backend's own, checked against its registry

    /// The gap, 1e-7 by default; of scenes that are not convex, which are bounded over boxes, 1e-4.
    [[nodiscard]] double wanted_gap(bool convex = true) const { return gap.value_or(convex ? 1e-7 : 1e-4); }
    friend bool operator==(const SolverSpec&, const SolverSpec&) = default;
};

struct Scene {
    // Compiled once, in the source of this header: copies of so many members take a compiler long.
    Scene();
    Scene(const Scene& other);
    Scene(Scene&& other) noexcept;
    Scene& operator=(const Scene& other);
    Scene& operator=(Scene&& other) noexcept;
    ~Scene();

    std::string title;
    /// In which its lengths are shown to people. Of a scene file: as its lift is written; where that is an
    /// angle, as the first length of its cam.
    LengthUnit length_unit = LengthUnit::millimetre;
    /// Of a scene file: how the units of its numbers are written, by the key without its unit
    /// ("motion.lift", "motion.segments[2].angle").
    std::map<std::string, Spelling> written = {};
    MotionSpec motion;
    SplineSpec spline;
    ObjectiveSpec objective;
    std::optional<CamSpec> cam;       ///< of any kind; none: no profile exists, no profile code runs
    std::optional<ForceSpec> forces;  ///< needs a cam and a speed
    LimitSpec limits;
    std::optional<DynamicsSpec> dynamics;       ///< an elastic follower train; needs a speed
    std::optional<DriveSpec> drive;             ///< a motor in place of a cam; needs a speed
    std::optional<ToleranceSpec> tolerance;     ///< of the made cam: every limit holds for all within it
    std::optional<MeasuredMotion> measured;     ///< beside the optimum, or where its search begins
    std::optional<MeasuredRows> measured_rows;  ///< of a scene file: what `measured` was made from
    std::optional<DrawingSpec> drawing;  ///< of a disk cam: what drawings and solids need beside the profile
    std::vector<OwnTerm> own_terms;      ///< beside those of `objective`
    std::vector<OwnLimit> own_limits;    ///< beside `limits`
    SolverSpec solver;

    /// The spline is the motion of the output of an elastic train, and the cam gives what that needs.
    [[nodiscard]] bool prescribes_output() const { return dynamics && dynamics->prescribes_output(); }
    /// The highest derivative that is 0 where a spline meets rest. Of a prescribed output at least 4: the
    /// cam's acceleration has the fourth in it.
    [[nodiscard]] int rest_order() const {
        return prescribes_output() ? std::max(spline.rest, 4) : spline.rest;
    }
    /// As the scene is written; of a number that it leaves out, or without a file: `otherwise`.
    [[nodiscard]] Spelling spelling_of(const std::string& key, const Spelling& otherwise) const {
        const auto known = written.find(key);
        return known == written.end() ? otherwise : known->second;
    }
    /// The same of a length.
    [[nodiscard]] Spelling length_spelling_of(const std::string& key) const {
        return spelling_of(key, spellings::length[length_unit == LengthUnit::inch ? 1 : 0]);
    }

    /// The motion is that of a cam that exists: nothing is optimized.
    [[nodiscard]] bool is_given() const { return measured && measured->given; }
    /// Speeds whose loads enclose those of every speed that limits on loads hold at: that of the scene first,
    /// then the ends of forces.speed_range; default from 0 where a spring loads the cam and the Hertz
    /// pressure is limited. There are forces and a speed.
    [[nodiscard]] std::vector<LoadSpeed> load_speeds() const;
    /// The largest error of the r-th derivative of the motion of a made cam, in lifts by x^r; 0 without a
    /// tolerance of it.
    [[nodiscard]] double motion_error(int order) const;
    /// k >= 1 of the harmonic of the cam's speed that is nearest to the natural frequency of the spring. The
    /// scene has both.
    [[nodiscard]] int nearest_harmonic() const;
};

/// The first thing wrong with a scene: the member ("spline.breakpoints[3]"), what was found, what is allowed.
struct SceneFault {
    std::string member, found, allowed;
};

/// SI units and radians. Names of laws and solvers are not looked at: those who know the catalogues check
/// them.
[[nodiscard]] std::optional<SceneFault> find_fault(const Scene& scene);

/// Throws InputError naming the first member that is out of its range, what was found and what is allowed.
/// The scene reader names file, line and column first; this is the gate for scenes built in C++.
void validate(const Scene& scene);

[[nodiscard]] const char* name_of(SegmentKind value);
[[nodiscard]] const char* name_of(PrescribedMotion value);
[[nodiscard]] const char* name_of(TieBreak value);
[[nodiscard]] const char* name_of(PeakScope value);

[[nodiscard]] int segments_of(const SplineSpec& spline);

/// Uniform breakpoints: any number of segments. Given breakpoints are kept and their intervals halved until
/// there are at least so many.
[[nodiscard]] Scene with_segments(const Scene& scene, int segments);

/// A segment has a range for its angle.
[[nodiscard]] bool searches_angles(const Scene& scene);

// A fault of a scene as an exception: code that knows the scene's file adds file and line
// (input::fail_in_scene).

/// "member: found …; allowed: …"
class SceneError : public InputError {
 public:
    explicit SceneError(SceneFault fault);
    [[nodiscard]] const SceneFault& fault() const { return fault_; }

 private:
    SceneFault fault_;
};

/// "found …; allowed: …"
[[nodiscard]] std::string words_of(const SceneFault& fault);

}  // namespace camopt
