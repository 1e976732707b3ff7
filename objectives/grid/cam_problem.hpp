// SPDX-License-Identifier: MIT
// A CamModel on a grid of cam angles: as an Nlp, and as a ContinuousProblem around it.
#pragma once

#include "core/continuous_problem.hpp"
#include "objectives/nlp_parts.hpp"
#include "objectives/rules/model.hpp"

#include <Eigen/SparseCholesky>

namespace camopt {

// The Nlp of a CamModel on finitely many cam angles.
//
// Variables: design entries in units of their typical size, then parameters in units of their references.
// Rows, in this order: equalities of the design vector, rows on the parameters, rows on the design, sampled
// rules in the order given. A sampled rule's row is g(B x + b; q) <= 0 with the constant map B of its cam
// angle: Jacobian Bᵀ∂g, Hessian Bᵀ ∂²g B. Rows of linear rules are multiplied out once. Each other row
// remembers its rule at the last point: one thread at a time may evaluate a grid.

/// Rule `rule` enforced at x, as seen from `side`.
struct RuleSample {
    int rule = 0;
    double at = 0.0;
    Side side = Side::right;
    std::vector<double> setting = {};  ///< of rules of the whole motion
};

class GridNlp final : public Nlp {
 public:
    GridNlp(std::shared_ptr<const CamModel> model, std::vector<RuleSample> samples);

    /// Appends rows of more samples.
    void append(std::span<const RuleSample> samples);

    [[nodiscard]] double cost(const ConstVectorRef& x) const override;
    void gradient(const ConstVectorRef& x, VectorRef out) const override;
    void constraints(const ConstVectorRef& x, VectorRef out) const override;
    void jacobian(const ConstVectorRef& x, std::span<double> out) const override;
    void hessian(const ConstVectorRef& x, double sigma, const ConstVectorRef& lambda,
                 std::span<double> out) const override;
    [[nodiscard]] std::string variable_name(int index) const override;
    [[nodiscard]] std::string row_name(int index) const override { return row_origin(index).text(); }
    [[nodiscard]] RowOrigin row_origin(int index) const override;

    [[nodiscard]] int first_sample_row() const { return first_sample_row_; }

    /// Takes the weights of the model's parameters again.
    void follow_weights();
    /// Takes the right-hand sides of the model's rows on parameters again.
    void follow_uppers();

 private:
    /// One row: affine rows have their coefficients, others the map (y … y''') = offset + matrix ·
    /// x[columns].
    struct Row {
        std::vector<int> columns;     ///< of the Jacobian, ascending
        std::vector<double> weights;  ///< affine rows
        double offset = 0.0;          ///< affine rows
        int sample = -1;              ///< nonlinear rows: which sample
        Eigen::MatrixXd map = {};     ///< other nonlinear rows: 4 x design columns
        Eigen::Vector4d map_offset = Eigen::Vector4d::Zero();
        std::shared_ptr<const QuadraticForm> form = {};  ///< nonlinear rows of the whole motion
        /// Other nonlinear rows: the rule at the last (y … y''', q), for the row, its Jacobian and its
        /// Hessian.
        mutable Eigen::VectorXd last_point = {};
        mutable RuleValue last = {};
    };
    struct RmsTerm {
        int variable = 0;
        double weight = 0.0;
        QuadraticForm form;
    };

    void add_fixed_rows();
    void add_sample_rows(int first);
    void add_sample_row(int sample);
    [[nodiscard]] const RuleValue& affine_rule(const RuleSample& place);
    [[nodiscard]] AffineRow linear_rule_row(const RuleSample& place, const RuleValue& affine) const;
    [[nodiscard]] double unit_of(const RuleSample& place) const;
    void add_linear_row(int sample);
    void add_curved_row(int sample);
    void add_energy_row(int sample);
    void add_cost_terms();
    void claim_cost();
    void claim_rows(int first);
    /// Valid until the row is evaluated at another point.
    [[nodiscard]] const RuleValue& rule_value(const Row& row, const ConstVectorRef& x) const;
    [[nodiscard]] int design_size() const { return model_->design.size(); }

    std::shared_ptr<const CamModel> model_;
    std::vector<RuleSample> samples_;
    Eigen::VectorXd scale_;  ///< of the design entries
    std::vector<Row> rows_;
    int first_sample_row_ = 0;
    /// Cached rows of linear rules that do not depend on x; the last is of one that does.
    std::vector<std::optional<RuleValue>> affine_;
    Eigen::VectorXd linear_cost_;
    std::vector<RmsTerm> rms_;
    /// The slot of each contribution to the Hessian, in the order in which hessian() visits them.
    HessianSlots hessian_slots_;
};

/// Unit of variable `index`: x_physical = scale · x.
[[nodiscard]] double variable_scale(const CamModel& model, int index);

/// Those of all design entries.
[[nodiscard]] Eigen::VectorXd design_scales(const CamModel& model);

// The nearest point that satisfies A x + a = 0: x − Aᵀ (A Aᵀ)⁻¹ (A x + a), repeated until round-off.

/// The row over x = x_physical / column_scale, divided by its largest weight.
[[nodiscard]] AffineRow unit_row(const AffineRow& row, const Eigen::VectorXd& column_scale);

class EqualityProjection {
 public:
    /// rows: independent. column_scale: x_physical = column_scale · x.
    EqualityProjection(const std::vector<Equality>& rows, const Eigen::VectorXd& column_scale);

    [[nodiscard]] Eigen::VectorXd project(Eigen::VectorXd x) const;
    [[nodiscard]] const Eigen::SparseMatrix<double>& matrix() const { return matrix_; }
    [[nodiscard]] const Eigen::VectorXd& offset() const { return offset_; }

 private:
    Eigen::SparseMatrix<double> matrix_;
    Eigen::VectorXd offset_;
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> normal_;
};

// A CamModel as a ContinuousProblem: the motion's design vector and the cam's rules on a grid of angles.
//
// x = design entries and parameters in optimizer units (GridNlp). Rules hold at every cam angle:
// their continuous maxima come from rule_maxima.hpp.

class CamProblem final : public ContinuousProblem {
 public:
    /// The first grid: every rule at the breakpoints (both sides where its derivative jumps) and, where it is
    /// curved between them, at the middles.
    explicit CamProblem(CamModel model);
    /// The same with a grid already refined for another cost over the same rules (the tie-break).
    CamProblem(CamModel model, const std::vector<RuleSample>& samples);

    [[nodiscard]] const Nlp& grid() const override { return *grid_; }
    [[nodiscard]] Eigen::VectorXd start() const override;
    [[nodiscard]] Eigen::VectorXd completed(const Eigen::VectorXd& x) const override;
    [[nodiscard]] double objective(const Eigen::VectorXd& x) const override;
    [[nodiscard]] std::vector<Violation> violations(const Eigen::VectorXd& x, double slack) const override {
        return violations_of(false, x, slack);
    }
    [[nodiscard]] double worst_of_limits(const Eigen::VectorXd& x) const override;
    int refine(std::span<const Violation> worst) override;
    int refine_pressed(std::span<const Violation> worst, const Eigen::VectorXd& row_multipliers) override;
    [[nodiscard]] Box box(double incumbent, double relaxation) const override;
    [[nodiscard]] bool convex(double incumbent) const override;
    /// What no motion of a cost of at most `incumbent` is below: 0 but for a lost area.
    [[nodiscard]] double least_cost(double incumbent) const;
    /// A smooth random motion (a beam under random loads) and random dimensions, from a seed.
    [[nodiscard]] Eigen::VectorXd random_start(unsigned seed) const;

    [[nodiscard]] const CamModel& model() const { return *model_; }
    /// The motions of the model, which lives as long as they do.
    [[nodiscard]] std::shared_ptr<const MotionFamily> family() const { return {model_, &model_->design}; }
    [[nodiscard]] const std::vector<RuleSample>& samples() const { return samples_; }
    /// Other weights of the same terms: the parameters' positive ones, one for each parameter.
    void set_weights(std::span<const double> weights);
    /// Other numbers for the same limits: the right-hand sides of the rows on parameters, one for each.
    void set_uppers(std::span<const double> uppers);
    [[nodiscard]] MotionChain motion(const Eigen::VectorXd& x) const {
        return model_->design.motion(design_values(x));
    }
    /// The same unless the output's motion is prescribed.
    [[nodiscard]] MotionChain motion(const Eigen::VectorXd& x, SeenMotion seen) const {
        return model_->family_of(seen).motion(design_values(x));
    }
    /// The spline of the first run: all of it for DRD and RR.
    [[nodiscard]] SplineCurve curve(const Eigen::VectorXd& x) const {
        return model_->design.run_curve(0, design_values(x));
    }
    /// Design entries of x in their own units.
    [[nodiscard]] Eigen::VectorXd design_values(const Eigen::VectorXd& x) const {
        return scales_.cwiseProduct(x.head(model_->design.size()));
    }

 private:
    void start_grid();
    void start_rule(int index);
    bool add_sample(int rule, double at, Side side);
    bool add_whole_sample(const RuleSample& sample);
    void refine_whole(const Violation& violation);
    void complete_responses(Eigen::VectorXd& x) const;
    void add_samples(std::span<const Violation> worst);
    void add_around(const Violation& violation);
    int append_rows();
    struct Pressed;
    [[nodiscard]] std::optional<Pressed> pressed_around(const Violation& violation,
                                                        const Eigen::VectorXd& row_multipliers) const;
    void add_pressed(const Violation& violation, const Pressed& pressed);
    [[nodiscard]] std::vector<Violation> violations_of(bool limits_only, const Eigen::VectorXd& x,
                                                       double slack) const;
    [[nodiscard]] Eigen::VectorXd own_parameters(int rule, const Eigen::VectorXd& x) const {
        return x.tail(static_cast<Eigen::Index>(model_->parameters.size()))(
            model_->rules[rule]->parameters());
    }
    void complete_parameters(Eigen::VectorXd& x) const;
    void complete_peaks(const SplineCurve& curve, Eigen::VectorXd& x) const;
    void complete_own_peaks(const MotionChain& chain, Eigen::VectorXd& x) const;
    void complete_program_peaks(const MotionChain& chain, Eigen::VectorXd& x) const;
    [[nodiscard]] Eigen::VectorXd smoothest(const Eigen::VectorXd& load) const;
    [[nodiscard]] std::array<double, 2> displacement_range(double incumbent) const;
    struct SupportedBounds;
    struct Considered;
    [[nodiscard]] double farthest(const Considered& motions) const;
    static void bound_by_motor(const CamModel& model, SupportedBounds& known, double relaxation);
    [[nodiscard]] SupportedBounds supported_bounds(const Considered& motions) const;
    [[nodiscard]] SupportedBounds bounds_within(double farthest, const Considered& motions) const;

    std::shared_ptr<CamModel> model_;  ///< its grid reads it too
    std::vector<RuleSample> samples_;
    /// Samples of each rule by (piece, x), to find neighbours and duplicates.
    std::vector<std::map<std::pair<int, double>, int>> places_;
    std::unique_ptr<GridNlp> grid_;
    std::unique_ptr<EqualityProjection> projection_;
    Eigen::VectorXd scales_;   ///< of the design entries
    std::size_t on_grid_ = 0;  ///< samples that already have rows
};

// Tie-break: a CamProblem with a small energy added to its cost,
//
//   f + weight · e,   e = mean square of y''' over its reference²,
//
// on the problem's own grid, which both refine. For a weight small enough the optimum is, among the optima of
// the problem, the one of least ∫ y'''².

class TiedProblem final : public ContinuousProblem {
 public:
    /// The problem must outlive this one. weight > 0.
    TiedProblem(CamProblem& problem, double weight);
    ~TiedProblem() override;

    /// Changes the weight of the energy; > 0.
    void set_weight(double weight);
    /// e of the motion of x.
    [[nodiscard]] double energy(const Eigen::VectorXd& x) const {
        return energy_.value(x.head(energy_.linear.size()));
    }

    [[nodiscard]] const Nlp& grid() const override;
    [[nodiscard]] Eigen::VectorXd start() const override { return problem_.start(); }
    [[nodiscard]] Eigen::VectorXd completed(const Eigen::VectorXd& x) const override {
        return problem_.completed(x);
    }
    [[nodiscard]] double objective(const Eigen::VectorXd& x) const override;
    [[nodiscard]] std::vector<Violation> violations(const Eigen::VectorXd& x, double slack) const override {
        return problem_.violations(x, slack);
    }
    [[nodiscard]] double worst_of_limits(const Eigen::VectorXd& x) const override {
        return problem_.worst_of_limits(x);
    }
    int refine(std::span<const Violation> worst) override;
    int refine_pressed(std::span<const Violation> worst, const Eigen::VectorXd& row_multipliers) override;
    /// The problem's own: a motion of at most this cost with the energy has at most this cost without it.
    [[nodiscard]] Box box(double incumbent, double relaxation) const override {
        return problem_.box(incumbent, relaxation);
    }
    [[nodiscard]] bool convex(double incumbent) const override { return problem_.convex(incumbent); }

 private:
    class Grid;
    void follow(int added);

    CamProblem& problem_;
    QuadraticForm energy_;  ///< of design entries in the optimizer's units
    double weight_;
    std::unique_ptr<Grid> grid_;
};

}  // namespace camopt
