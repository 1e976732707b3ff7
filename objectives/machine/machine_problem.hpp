// SPDX-License-Identifier: MIT
// Several CamProblems on one master angle θ, joined by clearances, as one ContinuousProblem:
//
//     min Σ_i weight_i f_i(x_i)   subject to the rules of every axis, and for every clearance k
//     g_k(θ) = (at_least − Σ_i factor_i lift_i y_i((θ − phase_i) / unit angle_i)) / scale ≤ 0
//
// at every θ of its stretch; θ − phase_i is wrapped into the cycle. An axis that advances from cycle to cycle
// counts its displacement from the cycle's start: of angles before its phase its advance is subtracted, so
// that y is continuous from θ = 0 to 2π, where it falls back. Clearances are linear in the designs. Between
// the merged breakpoints of its axes a clearance is one polynomial, whose maximum is exact; where an axis
// follows a law it is bounded by enclosures of its second derivative.
//
// The variables are those of all axes, the design entries by master angle (states; others axis by axis), then
// the parameters: rows couple variables that are near each other, so that factors fill in by the number of
// axes only. Rows: those of the axes' grids and of the clearances, in the order in which they were added.
#pragma once

#include "core/units.hpp"
#include "objectives/grid/cam_problem.hpp"
#include "objectives/rules/linear_bound.hpp"

namespace camopt {

/// An axis on its master.
struct AxisPlace {
    std::string name;
    double phase = 0.0;       ///< rad of the master
    double unit_angle = 1.0;  ///< cam angle of x = 1, rad
    double lift = 1.0;        ///< m or rad of y = 1
    double weight = 1.0;      ///< of its objective in the total
    double advance = 0.0;     ///< y that it gains in each cycle
};

/// One axis as an optimization model.
struct MachineBlock {
    AxisPlace place;
    CamModel model;
    std::vector<RuleSample> samples = {};  ///< of an earlier grid of the same rules
};

/// Σ factor · displacement >= at_least: y is the sum, in SI, sign −1 and the bound −at_least. Between two
/// angles of the master, rad; from > until passes the end of the cycle.
struct ClearanceRule : LinearBound {
    std::vector<int> axes;
    std::vector<double> factors;
    std::vector<double> samples = {};  ///< master angles of an earlier grid

    /// All round; at_least and scale in SI.
    ClearanceRule(std::string name, std::vector<int> of_axes, std::vector<double> with_factors,
                  double at_least, double violation)
        : LinearBound{std::move(name), 0, -1, -at_least, violation},
          axes(std::move(of_axes)),
          factors(std::move(with_factors)) {
        from = 0.0;
        until = units::turn;
    }
    /// The same between two angles.
    [[nodiscard]] ClearanceRule between(double begin, double end) && {
        from = begin;
        until = end;
        return std::move(*this);
    }

    /// What an axis adds to g for y = 1, `lift`: SI of it.
    [[nodiscard]] double weight(std::size_t axis, double lift) const {
        return sign * factors[axis] * lift / scale;
    }
};

/// Where a row of the machine comes from.
struct MachineOrigin {
    int axis = -1;       ///< −1: a clearance
    int clearance = -1;  ///< −1: a rule of an axis
    std::string rule;    ///< of the axis: "limits.velocity_mm_s"; empty: a clearance
    double angle = 0.0;  ///< of the master, rad, in [0, 2π)
};

class MachineProblem final : public ContinuousProblem {
 public:
    /// Throws InputError for a block without a rule's formula and for axes that do not exist.
    MachineProblem(std::vector<MachineBlock> blocks, std::vector<ClearanceRule> clearances);
    ~MachineProblem() override;

    [[nodiscard]] const Nlp& grid() const override;
    [[nodiscard]] Eigen::VectorXd start() const override;
    [[nodiscard]] Eigen::VectorXd completed(const Eigen::VectorXd& x) const override;
    [[nodiscard]] double objective(const Eigen::VectorXd& x) const override;
    [[nodiscard]] std::vector<Violation> violations(const Eigen::VectorXd& x, double slack) const override;
    [[nodiscard]] double worst_of_limits(const Eigen::VectorXd& x) const override;
    int refine(std::span<const Violation> worst) override;
    int refine_pressed(std::span<const Violation> worst, const Eigen::VectorXd& row_multipliers) override;
    [[nodiscard]] Box box(double incumbent, double relaxation) const override;
    [[nodiscard]] bool convex(double incumbent) const override;

    /// Where searches begin: x of a neighbouring problem. Empty: the smoothest motions.
    void set_start(Eigen::VectorXd x) { start_ = std::move(x); }
    /// Only rules of this name (RowOrigin::rule) count as limits that the elastic problem relaxes; all others
    /// hold as written. Empty: every limit.
    void relax_only(std::string rule);

    [[nodiscard]] int axes() const { return static_cast<int>(blocks_.size()); }
    [[nodiscard]] const CamProblem& axis(int index) const { return *blocks_[index].problem; }
    /// The variables of one axis.
    [[nodiscard]] Eigen::VectorXd axis_x(int index, const Eigen::VectorXd& x) const;
    /// The displacement of an axis, SI, at a master angle.
    [[nodiscard]] double displacement(int index, const MotionChain& motion, double angle) const;
    /// Of a clearance, ascending from its `from`, may exceed 2π.
    [[nodiscard]] std::vector<double> samples(int clearance) const;
    /// The exact maximum of g_k over its stretch, at a master angle.
    [[nodiscard]] Extremum worst_of_clearance(int clearance, const Eigen::VectorXd& x) const;
    /// SI value of 100 % of a clearance.
    [[nodiscard]] double clearance_scale(int clearance) const {
        return clearances_[static_cast<std::size_t>(clearance)].rule.scale;
    }
    /// Of a row's origin as grid() and proofs give it.
    [[nodiscard]] MachineOrigin place(const RowOrigin& origin) const;

 private:
    class Grid;
    struct Block {
        AxisPlace spec;
        std::unique_ptr<CamProblem> problem;
        std::vector<int> columns;  ///< of the machine, for each variable
        int first_rule = 0;
    };
    /// Of a clearance's stretch from `from` to `from + length`, unwrapped.
    struct Clear {
        ClearanceRule rule;
        double length = 0.0;
        std::vector<double> breaks = {};    ///< the merged breakpoints, ends included
        std::map<double, int> places = {};  ///< master angle → row of `angles`
        std::vector<double> angles = {};    ///< of its rows
    };
    struct RowPlace {
        int part = 0;  ///< block, or blocks + clearance
        int row = 0;   ///< of it
    };
    // Where advancing axes fall back a clearance has rows on both sides: at 2π, and this far above it, rad.
    static constexpr double same_angle = 1e-9, after_fall = 4.0 * same_angle;

    /// An axis at a master angle: its x, and what it has advanced before, in lifts.
    struct OwnPlace {
        double x = 0.0, advanced = 0.0;
    };
    [[nodiscard]] OwnPlace axis_place(int index, double angle) const;
    /// Whether one of its axes advances from cycle to cycle.
    [[nodiscard]] bool falls_back(const Clear& clear) const;
    void number_columns();
    void merge_breaks(Clear& clear) const;
    bool add_angle(Clear& clear, double angle);
    void add_around(Clear& clear, double angle);
    void add_pressed(Clear& clear, int part, double angle, const Eigen::VectorXd& row_multipliers);
    [[nodiscard]] std::vector<Extremum> maxima_of(const Clear& clear, const std::vector<MotionChain>& motions,
                                                  double floor) const;
    int refined(std::span<const Violation> worst, const Eigen::VectorXd* row_multipliers);
    int follow();
    [[nodiscard]] bool is_limit(const std::string& rule) const {
        return relaxed_.empty() || rule == relaxed_;
    }
    [[nodiscard]] std::string rule_name(int block, int rule) const;
    [[nodiscard]] std::vector<MotionChain> motions(const Eigen::VectorXd& x) const;

    std::vector<Block> blocks_;
    std::vector<Clear> clearances_;
    std::vector<RowPlace> rows_;
    std::vector<int> part_rows_;  ///< rows of each part that are in rows_
    int variables_ = 0, first_clearance_ = 0;
    Eigen::VectorXd start_;
    std::string relaxed_;
    std::unique_ptr<Grid> grid_;
};

}  // namespace camopt
