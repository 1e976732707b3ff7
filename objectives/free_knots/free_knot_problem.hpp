// SPDX-License-Identifier: MIT
// A CamModel with free spline breakpoints: as an Nlp, and as a ContinuousProblem around it.
#pragma once

#include "objectives/grid/cam_problem.hpp"
#include "scene/scene.hpp"
#include "splines/free_knot_form.hpp"

#include <set>
#include <tuple>

namespace camopt {

// The Nlp of a CamModel with free spline breakpoints, on finitely many points of its segments.
//
// Variables: entries of a FreeKnotForm in units of their typical size, then the parameters of the model in
// units of their references. Rows, in this order: equalities of the form, distances of breakpoints, rows on
// the parameters, sampled rules in the order given. A sample is at a fraction of its segment and moves with
// it: its row is g(y, y', y'', y'''; q) <= 0 with y^{(r)} a polynomial of the entries (free_knot_form.hpp),
// so partials and second partials are exact. Not convex.

/// Rule `rule` enforced at a fraction of a modelled segment, or at its mirror image.
struct FreeSample {
    int rule = 0, segment = 0;
    double fraction = 0.0;
    bool mirrored = false;
};

class FreeKnotNlp final : public Nlp {
 public:
    /// Only parameters, rules, rows on parameters and scales of the model are used; no tie-break energy.
    FreeKnotNlp(std::shared_ptr<const CamModel> model, std::shared_ptr<const FreeKnotForm> form,
                std::vector<FreeSample> samples);

    [[nodiscard]] double cost(const ConstVectorRef& x) const override;
    void gradient(const ConstVectorRef& x, VectorRef out) const override;
    void constraints(const ConstVectorRef& x, VectorRef out) const override;
    void jacobian(const ConstVectorRef& x, std::span<double> out) const override;
    void hessian(const ConstVectorRef& x, double sigma, const ConstVectorRef& lambda,
                 std::span<double> out) const override;
    [[nodiscard]] std::string variable_name(int index) const override {
        return index < form_->size() ? form_->name(index) : model_->parameters[index - form_->size()].name;
    }
    [[nodiscard]] std::string row_name(int index) const override { return rows_[index].name; }

    /// x_physical = scale · x, over all variables.
    [[nodiscard]] const Eigen::VectorXd& scale() const { return scale_; }

 private:
    struct Row {
        enum class Kind { linear, functional, rule };
        Kind kind = Kind::linear;
        std::string name;
        std::vector<int> columns;
        std::vector<double> weights;  ///< linear: of the variables, in their units
        double offset = 0.0;          ///< linear, functional
        FreePlace place;
        int order = 0;      ///< functional: of the derivative
        double unit = 1.0;  ///< functional: what the row is divided by
        int sample = -1;    ///< rule
        int first = 0;      ///< lowest a_{i,m} among the columns
        int own = 0;  ///< columns of the place: a_{i,first} … a_{i,p}, t_i, t_{i+1}; the rest: `minus` or q
    };
    /// A row as a function of (y … y^{(5)}, q).
    struct Outer {
        double value = 0.0;
        Eigen::VectorXd slope;
        Eigen::MatrixXd curvature;  ///< empty: none
    };
    struct RmsTerm {
        int variable = 0, order = 0;
        double weight = 0.0, reference = 1.0;
    };

    void set_scale();
    void set_bounds();
    void add_form_rows();
    void add_parameter_rows();
    void add_sample_row(int sample);
    void add_cost_terms();
    void fix_patterns();
    void push(Row row, double lower, double upper, RowKind kind);
    /// The columns of a location whose row depends on a_{i,first} and higher.
    [[nodiscard]] Row placed_row(Row::Kind kind, const FreePlace& place, int first) const;
    /// a_{i,order} … a_{i,p}, t_i, t_{i+1} for segment_energy(); -1 for an end that is fixed.
    [[nodiscard]] std::vector<int> energy_columns(int segment, int order) const;
    [[nodiscard]] Outer outer(const Row& row, const Eigen::VectorXd& x, const FreePoint& point) const;
    [[nodiscard]] Outer rule_outer(const Row& row, const Eigen::VectorXd& x, const FreePoint& point) const;
    /// ∂(y … y^{(5)}) by the row's own columns.
    [[nodiscard]] Eigen::MatrixXd chain(const Row& row, const FreePoint& point) const;
    [[nodiscard]] Eigen::MatrixXd row_curvature(const Row& row, const Eigen::VectorXd& x) const;
    /// Whether two columns of a row may have a second partial.
    [[nodiscard]] bool may_curve(const Row& row, int a, int b) const;
    [[nodiscard]] Eigen::VectorXd physical(const ConstVectorRef& x) const { return scale_.cwiseProduct(x); }
    /// Of the mean square over the whole, in units of the reference: value and slope by all variables.
    [[nodiscard]] double mean_square(const RmsTerm& term, const Eigen::VectorXd& x,
                                     Eigen::VectorXd* slope) const;
    [[nodiscard]] double energy_factor(const RmsTerm& term) const {
        return 1.0 / (term.reference * term.reference * (form_->end() - form_->begin()));
    }

    std::shared_ptr<const CamModel> model_;
    std::shared_ptr<const FreeKnotForm> form_;
    std::vector<FreeSample> samples_;
    std::vector<Row> rows_;
    Eigen::VectorXd scale_, linear_cost_;
    std::vector<RmsTerm> rms_;
    /// The slot of each contribution to the Hessian, in the order in which hessian() visits them.
    HessianSlots hessian_slots_;
};

// A DRD or RR scene with free interior breakpoints, as a ContinuousProblem.
//
// x as in FreeKnotNlp. Completion, peaks and maxima of violation are computed by the CamProblem
// with the breakpoints of x fixed. A violation's `where.at` counts segments: i + fraction for the point at
// that part of segment i of the whole motion, so that it stays with the segment. Not convex; box() has no
// bounds.

/// The scene with these breakpoints, stored.
[[nodiscard]] Scene with_breakpoints(Scene scene, std::vector<double> breakpoints);

/// The scene's own breakpoints: the start of the search for free ones.
[[nodiscard]] std::vector<double> start_breakpoints(const Scene& scene);

class FreeKnotProblem final : public ContinuousProblem {
 public:
    /// `scene`: DRD or RR; its breakpoints are the start of the search, and assign exact points to segments.
    FreeKnotProblem(Scene scene, const Peaks& reference);

    [[nodiscard]] const Nlp& grid() const override { return *grid_; }
    [[nodiscard]] Eigen::VectorXd start() const override;
    [[nodiscard]] Eigen::VectorXd completed(const Eigen::VectorXd& x) const override;
    [[nodiscard]] double objective(const Eigen::VectorXd& x) const override {
        return grid_->cost(completed(x));
    }
    [[nodiscard]] std::vector<Violation> violations(const Eigen::VectorXd& x, double slack) const override;
    int refine(std::span<const Violation> worst) override;
    [[nodiscard]] Box box(double incumbent, double relaxation) const override;

    [[nodiscard]] const FreeKnotForm& form() const { return *form_; }
    [[nodiscard]] std::vector<double> breakpoints(const Eigen::VectorXd& x) const {
        return form_->breakpoints(physical_form(x));
    }
    /// The problem with the breakpoints of x fixed, and x converted for it.
    [[nodiscard]] CamProblem fixed_problem(const Eigen::VectorXd& x) const;
    [[nodiscard]] Eigen::VectorXd fixed_point(const CamProblem& fixed, const Eigen::VectorXd& x) const;
    /// A point of a problem with fixed breakpoints, converted for this one.
    [[nodiscard]] Eigen::VectorXd free_point(const CamProblem& fixed, const Eigen::VectorXd& x) const;

 private:
    void start_grid();
    bool add_sample(int rule, int segment, double fraction, bool mirrored);
    void rebuild() { grid_ = std::make_unique<FreeKnotNlp>(model_, form_, samples_); }
    [[nodiscard]] Eigen::VectorXd physical_form(const Eigen::VectorXd& x) const {
        return grid_->scale().cwiseProduct(x).head(form_->size());
    }

    Scene scene_;
    Peaks reference_;
    std::shared_ptr<const CamModel> model_;  ///< of the start: rules and parameters
    std::shared_ptr<const FreeKnotForm> form_;
    std::vector<FreeSample> samples_;
    std::set<std::tuple<int, int, bool, double>> places_;  ///< rule, segment, mirrored, fraction
    std::unique_ptr<FreeKnotNlp> grid_;
};

}  // namespace camopt
