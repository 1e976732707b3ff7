// SPDX-License-Identifier: MIT
// Everything known after a scene was solved: what report/ writes and what an embedder reads.
#pragma once

#include "solvers/certificate/certificate.hpp"
#include "splines/curve.hpp"
#include "splines/motion_chain.hpp"
#include "studies/delivered/cam_points.hpp"
#include "studies/delivered/cam_summary.hpp"
#include "studies/delivered/driven_mechanism.hpp"

namespace camopt {

/// One user limit, as written and as kept. worst, limit in `unit`; at: x.
struct ConstraintReport {
    std::string name;  ///< "velocity", "pressure_angle", …
    std::string key;   ///< "limits.velocity_mm_s"
    double limit = 0.0, worst = 0.0;
    std::string unit;
    double at = 0.0;
    bool active = false;  ///< scene_limits.hpp
    /// Its worst value was enclosed along the whole motion: none hides between points.
    bool verified = false;
    bool no_contact = false;  ///< there is no figure: the cam is undercut, the follower cannot touch it
    std::string side = {};    ///< where it is worst: "outer flank"; empty: the cam has one side
    std::string speed = {};   ///< at which it is worst: "at 0 rpm"; empty: that of the scene
    double scale = 0.0;       ///< of the quantity, in the unit; 0: known from the limit and its row
    /// With tolerances: its worst value over all cams within them; `worst` is that of the drawing.
    std::optional<double> made = {};
    double made_at = 0.0;  ///< x of it
    std::string made_cam =
        {};  ///< its errors that matter: "s+ s'- base_radius-" (objectives/rules/made_cams.hpp)

    /// What the limit is held against.
    [[nodiscard]] double held() const { return made.value_or(worst); }
};

/// A term of the objective beside the peaks, mostly one that the program brought: weight · value / reference
/// of it is in the objective.
struct OwnTermReport {
    std::string name;
    double weight = 0.0, reference = 1.0;
    double value = 0.0;  ///< its largest along the motion, in its own unit; 0 where it is nowhere above
    double at = 0.0;     ///< x
    bool of_whole_motion = false;  ///< the lost area, a root mean square: of no one place
    bool of_scene = false;         ///< a term of scene files: the lost area, of the motor
};

/// A figure of the elastic follower train at the worst speed of its range.
struct ResponseReport {
    double value = 0.0;  ///< residual in lifts; acceleration in lifts by x²; least force in N or N m
    double speed = 0.0;  ///< rad/s: the worst
    double at = 0.0;     ///< x
};

/// A term over one of them: weight · value / reference is in the objective.
struct ResponseTermReport {
    std::string name;
    double weight = 0.0, reference = 1.0;
    ResponseReport worst;
};

/// What the train makes of the delivered motion, from rest over every rise and return. A program without a
/// dwell never rests: it has none of these figures.
struct TrainReport {
    std::vector<double> natural_frequencies;  ///< rad/s, ascending
    double frequency_ratio = 0.0;             ///< time of x = 1 over the longest natural period
    std::array<double, 2> speeds{};           ///< rad/s: the range
    std::optional<ResponseReport> residual;   ///< none: no mode vibrates
    std::optional<ResponseReport> acceleration;
    std::optional<ResponseReport> least_force;  ///< none: the cam guides the follower both ways
    std::vector<ResponseTermReport> terms;      ///< those with a weight
};

/// Harmonics of the lift over one revolution, and the speeds at which they meet the natural frequency of the
/// return spring (objectives/spring_rules.hpp).
struct SurgeReport {
    struct Harmonic {
        int order = 0;                ///< k >= 1
        double amplitude = 0.0;       ///< m or rad
        double resonant_speed = 0.0;  ///< rad/s of the cam
        bool near = false;            ///< at the scene's speed the nearest to the frequency, or next to it
        bool limited = false;
    };
    double frequency_ratio = 0.0;  ///< natural frequency by the speed of the cam
    std::vector<Harmonic> harmonics;
};

/// A number that changes along with another one: the dwell that a longer segment is taken from.
struct CompanionChange {
    std::string key;
    double given = 0.0, solved = 0.0;
};

/// The least change of one number, the others kept, that makes the scene feasible; none where none was found.
struct Relaxation {
    std::string key;
    double given = 0.0;
    std::optional<double> needed = {};  ///< on the edge of what is feasible
    /// `needed` as people read it: rounded to the side that does, a little farther off. A solve of the scene
    /// with this number found a motion.
    std::optional<double> solved = {};
    /// Without `needed`: it is proved that no value helps, not only that none of those tried does.
    bool ruled_out = false;
    std::vector<CompanionChange> also = {};  ///< what changed along with it in that solve
};

/// Among Explanation::unsettled: the search for what all limits together would have to give.
inline constexpr const char* together_key = "together";

/// Why a search for changes ended: everything was tried; as many useful changes as were asked for were found;
/// its time was over; the user stopped it.
enum class ExplanationEnd { complete, enough, time_limit, interrupted };
inline constexpr const char* explanation_end_names[] = {"complete", "enough", "time_limit", "interrupted"};
[[nodiscard]] constexpr const char* name_of(ExplanationEnd value) {
    return explanation_end_names[static_cast<int>(value)];
}

/// What was found out about a scene without a motion, beside the changes of one number alone.
struct Explanation {
    /// Changes that do together, where no limit alone can be relaxed far enough: all by the same part of
    /// themselves, but those that need none.
    std::vector<Relaxation> together;
    std::vector<std::string> any_motion;  ///< keys of limits that no motion can satisfy, spline or not
    std::vector<std::string> alone;       ///< keys of limits that no motion satisfies even without the others
    /// Set points ("motion.via[1]") without which, each removed alone, the scene has a motion.
    std::vector<std::string> set_points;
    int finest = 0;                       ///< segments of the finest spline tried without success; 0: none
    std::vector<std::string> unsettled;   ///< keys of changes whose search did not end, `together_key` too
    double seconds = 0.0, allowed = 0.0;  ///< taken, and what it was given
    bool own_limit = true;  ///< `allowed` is solver.explain_seconds; false: what solver.max_seconds left
    ExplanationEnd end = ExplanationEnd::complete;
};

/// One rule of a contradiction and where on the cam it is violated.
struct ConflictReport {
    std::string key;          ///< "limits.pressure_angle_deg"
    double at = 0.0;          ///< x; NaN: the proof has no rows, that over boxes or of any curve
    double weight = 0.0;      ///< its part in the proof, in (0, 1]
    std::string remark = {};  ///< which part of the rule: "face turns back"; mostly empty
};

/// One segment of a program. `peaks`, `curve`: of spline segments, normalised by angle and displacement of
/// its stroke (peak_scales).
struct SegmentReport {
    SegmentKind kind = SegmentKind::dwell;
    std::string law;
    double begin = 0.0, end = 0.0;     ///< x
    double from = 0.0, to = 0.0;       ///< displacements, in lifts
    std::optional<Peaks> peaks;        ///< as peak_scales says; none of a dwell
    std::optional<SplineCurve> curve;  ///< over x
    /// The highest derivative that is continuous at its beginning; -1 at the open beginning of a motion.
    int continuity = 0;
};

/// The smallest cam that any motion whatever would allow (motions/bounds/smallest_cam.hpp), and the stroke
/// that asks for it: of all strokes whose pressure angle is limited the one that needs most.
struct SmallestCamReport {
    double prime_radius = 0.0;    ///< m, not reached
    double given = 0.0;           ///< that of the delivered cam (or asked for), m
    double pressure_angle = 0.0;  ///< of that stroke, rad
    bool rises = true;
    double begin = 0.0, end = 0.0;  ///< of the stroke, x
    std::string key = {};           ///< of its limit
};

/// A follower was run over the exported points: how far it was from the designed motion (forward_check.hpp).
struct ForwardCheckReport {
    double deviation = 0.0;  ///< largest |s found − s designed|, m or rad
    double relative = 0.0;   ///< by the prime radius (a swing times the arm)
    double at = 0.0;         ///< x
    int points = 0;
    double seconds = 0.0;
    /// Of a cam that drives both ways (studies/check/check_cam.hpp).
    struct Play {
        double least = 0.0, largest = 0.0;         ///< how far the follower can be moved to and fro, m or rad
        double least_at = 0.0, largest_at = 0.0;   ///< x
        std::optional<double> least_groove_width;  ///< m, of the finished flanks; a groove's
    };
    std::optional<Play> play = {};
};

/// A cam that was made, of any kind: its formulas and numbers, its figures.
struct CamReport {
    DrivenMechanism cam;  ///< numbers in the order of Scene::cam
    CamSummary summary;
    std::vector<EnclosedLimit> limits_along;          ///< of every rule that keeps a limit of the scene
    std::optional<SmallestCamReport> smallest;        ///< where it is known
    std::optional<ForwardCheckReport> forward_check;  ///< where it was asked for: report/ wants it
};

/// The free entries of the design vector: the numbers a user would type into another tool.
struct DesignReport {
    DesignKind kind = DesignKind::automatic;
    std::vector<std::string> names;
    Eigen::VectorXd values;
};

struct SolverReport {
    std::string name;    ///< the backend that ran
    std::string choice;  ///< why "auto" took it; empty where the user named it
    Termination termination = Termination::not_run;
    std::string native_status;
    int iterations = 0;
    int exchange_rounds = 0;
    bool convex = true;        ///< every rule is linear or convex: the optimum is the global one
    int starts = 1;            ///< searches from different starts
    std::string proof_source;  ///< whose multipliers proved the bound
    /// The number of the solve whose motion this is, in a study that reuses what it knows: proved for these
    /// weights by multipliers fitted to its active rows (studies/search/proved_optima.hpp). None: solved.
    std::optional<int> proved_from = {};
};

/// The law of the catalogue that is nearest to the rows of one stroke, in the mean square, with its own ends.
struct LawMatch {
    std::string law;                  ///< its title
    double begin = 0.0, end = 0.0;    ///< x
    double largest = 0.0, rms = 0.0;  ///< |law − table| over the stroke, in lifts
};

/// A measured motion beside the delivered one: the spline of the scene's own space that is nearest to it in
/// the mean square, and what that one is worth.
struct MeasuredReport {
    std::string name;
    int rows = 0;
    int freedom =
        0;  ///< free numbers of the fit: of a table with fewer than twice as many rows it follows noise
    double largest_error = 0.0, rms_error = 0.0;  ///< |table − fit|, in lifts
    double at = 0.0;                              ///< x of the largest
    std::shared_ptr<const MotionChain> motion;    ///< the fit
    Peaks peaks;                                  ///< of the fit, as Solution::peaks
    std::optional<double> objective;  ///< of the fit by the scene's weights; none: not of the motion alone
    bool started = false;             ///< the search began from it too
    /// Of a given cam, in lifts: the standard deviation of one row, and the standard errors of the motion and
    /// its derivatives by x (root mean squares along it).
    struct Noise {
        double row = 0.0;
        std::array<double, 4> error{};
    };
    std::optional<Noise> noise = {};
    std::vector<LawMatch> laws;  ///< of each stroke whose displacements are given
};

struct Solution;

/// How far the number went that objective.least or objective.largest names (studies/least/least_value.hpp).
/// Values in the unit of the key.
struct LeastReport {
    std::string key;
    bool largest = false;
    double value = 0.0;                ///< of the delivered motion's scene
    std::optional<double> impossible;  ///< at it the scene is proved infeasible; none: no such value is known
    /// optimal: both are known, at most least_gap apart, and nothing lies beyond; or `value` is the end of
    /// what the key may be. feasible: nothing lies beyond `impossible`, which is farther off. local: values
    /// beyond may exist.
    Verdict verdict = Verdict::local;
    /// Keys of the proof at `impossible`, the heaviest first; of a proof over boxes, which has no rows, those
    /// that are active in the delivered motion.
    std::vector<std::string> limited_by = {};
    std::shared_ptr<const Solution> proof = {};  ///< the scene with `impossible`; null in a result read back
};

/// What tolerances cost, and which of them (studies/tolerance/tolerance_study.hpp). Keys:
/// "tolerance.profile".
struct ToleranceReport {
    struct Decides {
        std::string limit, tolerance;  ///< of this limit's loss the largest part
        friend bool operator==(const Decides&, const Decides&) = default;
    };
    struct Halved {
        std::string tolerance;
        double gain = 0.0;  ///< relative, of the objective
        friend bool operator==(const Halved&, const Halved&) = default;
    };
    std::optional<double> price;  ///< relative loss against the scene without tolerances
    std::vector<Decides> decides;
    std::vector<Halved> halved;         ///< the objective with half of one of them
    std::optional<int> segments_worth;  ///< the least number beyond which more gain less than the price
    std::vector<std::string> open;      ///< what time did not suffice for, in words
    friend bool operator==(const ToleranceReport&, const ToleranceReport&) = default;
};

struct LimitCurve {  ///< the lower bound for every curve (motions/bounds/any_curve_limit.hpp)
    double objective = 0.0;
    std::optional<double> velocity, acceleration, jerk;  ///< none: not attained (infinite)
};

/// Wall time by phase. A search over starts, breakpoints, angles or cases and an explanation take the rest of
/// Solution::seconds_total; solver, judgement and proof are then those of the start that is delivered.
struct PhaseSeconds {
    double setup = 0.0;      ///< scene to model, spline space and first grid
    double solver = 0.0;     ///< inside the backend
    double judgement = 0.0;  ///< first point, continuous maxima and new rows
    double proof = 0.0;      ///< the bound from multipliers
    double tie_break = 0.0;  ///< the backend's part included
    double report = 0.0;     ///< peaks, limits and cam properties of the delivered motion, and its audit
    double search = 0.0;     ///< other angles, breakpoints or directions of strokes than those delivered
};

struct PhaseRow {
    const char* name;
    double PhaseSeconds::*seconds;
};
inline constexpr std::array phase_rows = {
    PhaseRow{"setup", &PhaseSeconds::setup},         PhaseRow{"solver", &PhaseSeconds::solver},
    PhaseRow{"judgement", &PhaseSeconds::judgement}, PhaseRow{"proof", &PhaseSeconds::proof},
    PhaseRow{"tie_break", &PhaseSeconds::tie_break}, PhaseRow{"report", &PhaseSeconds::report},
    PhaseRow{"search", &PhaseSeconds::search}};

class MotionFamily;  // splines/motion_family.hpp
struct SolvePlan;    // studies/search/plan.hpp

struct Solution {
    // Compiled once, in the source of this header: copies of so many members take a compiler long. A move may
    // throw std::bad_alloc: sparse matrices of Eigen allocate there.
    // NOLINTBEGIN(performance-noexcept-move-constructor)
    Solution();
    Solution(const Solution& other);
    Solution(Solution&& other);
    Solution& operator=(const Solution& other);
    Solution& operator=(Solution&& other);
    // NOLINTEND(performance-noexcept-move-constructor)
    ~Solution();

    Scene scene;
    std::shared_ptr<const SolvePlan>
        plan;  ///< what was executed; of a result that was read: what this build would execute
    Certificate certificate;
    /// The delivered motion; none where nothing feasible was found. A prescribed one may violate limits.
    std::shared_ptr<const MotionChain> motion;
    std::optional<SplineCurve> curve;     ///< the same as one spline: DRD and RR
    std::vector<SegmentReport> segments;  ///< of a program
    std::optional<CamReport> cam;         ///< where the scene has a cam and there is a motion
    Peaks peaks;                          ///< of the delivered motion, exact, normalised
    /// Of the motion in lifts and units of x: what physical peaks come from. The same but for a program.
    Peaks motion_peaks;
    Peaks reference_peaks;  ///< what the objective divides by (only the parts in use are set)
    std::optional<LimitCurve> any_curve_limit;
    std::optional<MeasuredReport> measured;
    std::optional<LeastReport> least;          ///< where the scene seeks a number
    std::optional<ToleranceReport> tolerance;  ///< where the scene has tolerances and there is a motion
    std::vector<OwnTermReport> own_terms;
    std::optional<TrainReport> train;   ///< where the scene has dynamics and there is a motion
    std::optional<DriveFigures> drive;  ///< where the scene has a motor and there is a motion
    std::optional<SurgeReport> surge;   ///< where the spring's frequency is given and there is a motion
    std::vector<ConstraintReport> constraints;
    std::vector<Relaxation> relaxation;  ///< filled where the verdict is infeasible
    std::optional<Explanation> explanation;
    std::vector<ConflictReport> conflict;  ///< limits that leave no motion: alone, two, or of the proof
    DesignReport design;
    SolverReport solver;
    EvaluationCounts evaluations;
    double seconds_total = 0.0, seconds_solve = 0.0;
    PhaseSeconds phases;
    /// The motions of the scene, until the solution is audited (family_of()).
    std::shared_ptr<const MotionFamily> family;
    std::vector<std::string> notes;  ///< redundant conditions by name, and other things worth a line
    /// Of an axis of a machine: its phase and the clearances that shape it, in words; empty: a motion alone.
    std::string machine = {};

    /// The delivered motion over the whole turn, x from 0 to 2π / unit angle: what it leaves of the turn
    /// rests where it ends; of a motion whose ends move the motion itself. Throws InputError where there is
    /// no motion.
    [[nodiscard]] MotionChain whole_turn() const;
    /// whole_turn() from master angle 0 on: the motion begins at motion.phase. What a motion that advances
    /// has before its beginning counts from the same displacement, so that the turn is continuous.
    [[nodiscard]] MotionChain master_turn() const;
};

/// Of the delivered cam, m or rad; none: there is no cam, or it has no such dimension.
[[nodiscard]] std::optional<double> delivered_dimension(const Solution& solution, DimensionIndex which);

/// Of the motion (normalised) at one angle; the points are those of the cam along it.
using LoadsAt = std::function<FollowerLoads(const MotionPoint& motion, const CamPoints& cam)>;

/// Along a delivered cam: what does not exist, where the cam cannot touch its follower, is not finite. None
/// where the scene has no forces, or the cam is not direct. The solution must live as long.
[[nodiscard]] LoadsAt delivered_loads(const Solution& solution);

}  // namespace camopt
