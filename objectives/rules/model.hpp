// SPDX-License-Identifier: MIT
// The optimization model: the cam of a problem, and the model as plain data.
#pragma once

#include "objectives/rules/point_rule.hpp"
#include "profiles/sampling.hpp"
#include "scene/drive_spec.hpp"

#include <atomic>

namespace camopt {

struct CamVariables {
    struct Variable {
        int dimension = 0;       ///< its index among the cam's dimensions
        int parameter = 0;       ///< index among the problem's parameters
        double reference = 1.0;  ///< m or rad in one unit of the parameter
        double error = 0.0;      ///< of a made cam: what is added to it, SI
    };
    DrivenMechanism cam;
    MotionScale scale;
    std::vector<Variable> variables;  ///< dimensions of the cam, then numbers of its spring
    /// By spring_numbers: one that is variable has a place after the dimensions of the cam; −1: fixed.
    std::array<int, spring_numbers.size()> spring = {-1, -1};
    /// Of a made cam (objectives/rules/made_cams.hpp): what is added to s, s', s'', SI.
    std::array<double, 3> motion_error = {};
    std::string made = {};                          ///< in its rows' remarks; empty: as on the drawing
    std::map<std::string, double> made_parts = {};  ///< the same as RowFields::made
    /// Number of evaluated points of the cam: shared by all rules of a problem; threads may count
    /// concurrently.
    std::shared_ptr<std::atomic<long>> profile_points = std::make_shared<std::atomic<long>>(0);

    /// Of the variables: those of the cam.
    [[nodiscard]] std::size_t own_variables() const {
        const auto of_spring = std::ranges::count_if(spring, [](int place) { return place >= 0; });
        return variables.size() - static_cast<std::size_t>(of_spring);
    }
    /// The dimensions for all parameters of a problem.
    [[nodiscard]] std::vector<double> dimensions_at(const Eigen::VectorXd& parameters) const;
    /// The dimensions for a rule's own parameters q, one for each of the variables, or of the first of them,
    /// with their errors.
    [[nodiscard]] std::vector<double> dimensions_for(const Eigen::VectorXd& q) const;
    /// The dimension is variable.
    [[nodiscard]] bool is_variable(int dimension) const {
        return std::ranges::find(variables, dimension, &Variable::dimension) != variables.end();
    }
};

// The optimization model as plain data: parameters, rules, rows on the parameters, and the cost
//
//   f = Σ_p weight_p q_p  +  Σ_k weight_k / 2 (m_k(x) / q_k + q_k).
//
// m_k is a mean square (rms term): at the minimum over q_k > 0 the bracket is weight_k · sqrt(m_k), jointly
// convex in (x, q_k) with a sparse Hessian. Every quantity is in units of its reference, so f is near one.

/// A root mean square of a moving motion is of order one; this bound only prevents a division by zero.
inline constexpr double least_rms = 1e-4;

/// In lifts: no cam follows a motion beyond this range, so proofs need not cover it.
inline constexpr double farthest_displacement = 1e3;

/// What a rule sees where the output's motion is prescribed (CamModel); else they are one. torque: the motion
/// whose acceleration takes the torque of a motor that moves the output through a spring.
enum class SeenMotion { output, cam, torque };

/// A variable besides the design vector: a peak, the torque peak max |y' y''|, a root mean square, a
/// dimension of the cam, the magnitude of another parameter, the peak of a user-defined term, a response of
/// an elastic follower train or of a motor (the lost area is one too), or a root mean square of that.
struct Parameter {
    enum class Kind { peak, torque, rms, dimension, magnitude, own, response, energy };
    std::string name;
    Kind kind = Kind::peak;
    int order = 0;           ///< peak, rms: of the derivative it belongs to; magnitude: of which parameter
    double reference = 1.0;  ///< the variable is in units of this
    double weight = 0.0;     ///< in the cost
    double lower = 0.0, upper = infinity;  ///< its range, in units of the reference
    /// own, response, energy: its definition, also where a relaxation omits the rule; of an energy the only
    /// place, for it has no row.
    std::shared_ptr<const PointRule> defined_by = {};
    SeenMotion seen = SeenMotion::output;  ///< response, energy: of which motion
};

/// A rule and where it holds.
struct PlacedRule {
    /// The origin of y: 0, or the displacement at an end of the stretch (linear rules only).
    enum class Datum { zero, begin, end };

    std::shared_ptr<const PointRule> rule;      ///< shared by a problem and its tie-break
    int stretch = -1;                           ///< of the family; -1: everywhere
    double from = -infinity, until = infinity;  ///< x between which it holds
    Datum datum = Datum::zero;
    bool on_copies = false;  ///< on every copy of a stretch: it depends on the cam angle
    SeenMotion seen = SeenMotion::output;

    template <typename Rule>
    PlacedRule(std::shared_ptr<Rule> what, int where = -1)  // NOLINT(google-explicit-constructor)
        : rule(std::move(what)), stretch(where) {
        from = rule->holds_between()[0];
        until = rule->holds_between()[1];
        on_copies = !holds_everywhere() && stretch < 0;
    }
    [[nodiscard]] bool holds_on(const MotionFamily::Piece& piece) const {
        if (piece.copy && !on_copies) return false;
        return (stretch < 0 || stretch == piece.stretch) && piece.begin < until && piece.end > from;
    }
    [[nodiscard]] bool holds_at(double x) const { return x >= from && x <= until; }
    [[nodiscard]] bool holds_everywhere() const {
        return stretch < 0 && from == -infinity && until == infinity;
    }
    const PointRule* operator->() const { return rule.get(); }
    const PointRule& operator*() const { return *rule; }
};

/// In lifts: a segment whose ends are closer than this is stationary, and normalised by the lift. Far above
/// the rounding of a displacement, far below manufacturing accuracy.
inline constexpr double standing_displacement = 1e-9;

/// What a displacement is normalised by: |h|; the lift for a stationary segment. In lifts.
[[nodiscard]] double measured_displacement(double displacement);

/// Normalisation of a stretch: y^{(r)} of the family is |displacement| / angle^r times the normalised one. If
/// the design moves the displacement: its largest value, so that peaks are underestimated, never
/// overestimated.
struct StretchScale {
    double angle = 1.0;         ///< its length in x
    double displacement = 1.0;  ///< in lifts, > 0
};

/// Σ_p weights_p q_p <= upper.
struct ParameterRow {
    std::string name;
    std::vector<int> parameters;
    std::vector<double> weights;
    double upper = 0.0;
    bool limit = false;
    double scale = 1.0;
};

/// A displacement common to every motion of the model; at_rest: with y' = 0.
struct KnownPoint {
    double x = 0.0, y = 0.0;
    bool at_rest = false;
};

/// What the scene says of the torque and the speed of its motor: with it proofs bound the motion.
struct MotorBounds {
    DriveTorque torque;
    bool from_rest = false;  ///< the motion begins at rest, or goes on from its own end and rests somewhere
    double cycle = 1.0;      ///< x that rms is taken over
    double rms = infinity, peak = infinity, speed = infinity;  ///< limits, N m, rad/s
    int rms_parameter = -1, peak_parameter = -1;               ///< of the terms
};

struct CamModel {
    explicit CamModel(MotionFamily motions) : design(std::move(motions)) {}

    MotionFamily design;
    /// Where the output's motion is prescribed: those of the cam and of the torque, by the same entries.
    /// Rules see them by SeenMotion; `design` is what the objective and the conditions are about.
    std::optional<MotionFamily> cam_motion, torque_motion;
    DerivativeCombination to_cam;  ///< of `design`: what makes it the cam's
    std::vector<Parameter> parameters;
    std::vector<PlacedRule> rules;
    std::vector<ParameterRow> parameter_rows;
    std::optional<MotorBounds> motor;
    /// The constant cost of fixed dimensions.
    double cost_constant = 0.0;
    /// Set where the scene has a disk cam; where it has another mechanism.
    std::shared_ptr<const CamVariables> cam;
    double jerk_reference = 1.0;  ///< of the energy that breaks ties (cam_problem.hpp)
    /// Entries of a motion that is the first start of a search; empty: none.
    Eigen::VectorXd start_design;
    /// Typical sizes of y … y''': design entries are optimized in these units.
    std::array<double, 4> entry_scale{1.0, 1.0, 1.0, 1.0};
    /// Of each design entry: these sizes times its factor, which a short stroke makes large; none: 1.
    std::vector<double> entry_factors;
    std::vector<StretchScale> stretch_scales;  ///< one a stretch; none: DRD and RR, all 1
    /// Expected range of displacements: where rules are expected to be convex. Proofs use their own bounds.
    double least_displacement = -0.25, most_displacement = 1.25;
    /// |y| of every motion whose strokes keep to their ranges, and the widest of these; infinite: some may
    /// not.
    double held_displacement = infinity, held_width = 0.0;
    std::vector<KnownPoint> known_points;  ///< ascending, both ends among them; fewer than 2: unknown

    /// What the displacements that a rule sees range over, where those of `design` do over `y` and its first
    /// two derivatives are at most `sup`.
    [[nodiscard]] std::array<double, 2> seen_range(const PlacedRule& rule, std::array<double, 2> y,
                                                   const std::array<double, 2>& sup) const;
    /// The same as far as it is expected: where rules are expected to be convex.
    [[nodiscard]] std::array<double, 2> expected_range(const PlacedRule& rule) const;
    /// Whether a rule sees another motion than `design`.
    [[nodiscard]] bool sees_other(const PlacedRule& rule) const {
        return cam_motion && rule.seen != SeenMotion::output;
    }
    [[nodiscard]] const MotionFamily& family_of(SeenMotion seen) const {
        if (!cam_motion || seen == SeenMotion::output) return design;
        return seen == SeenMotion::torque && torque_motion ? *torque_motion : *cam_motion;
    }
    [[nodiscard]] const MotionFamily& family_of(const PlacedRule& rule) const { return family_of(rule.seen); }
    /// The cam's motions: those of `design` unless the output's are prescribed.
    [[nodiscard]] const MotionFamily& cam_family() const { return family_of(SeenMotion::cam); }

    [[nodiscard]] StretchScale stretch_scale(int stretch) const {
        return stretch_scales.empty() ? StretchScale{} : stretch_scales[static_cast<std::size_t>(stretch)];
    }
    /// Weights that make mean_square() of the family the normalised one.
    [[nodiscard]] std::vector<double> mean_square_weights(int order) const;
};

}  // namespace camopt
