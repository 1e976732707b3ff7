// SPDX-License-Identifier: MIT
// The Nlp of a CamModel on finitely many cam angles.
//
// Variables: design entries in units of their typical size, then parameters in units of their references.
// Rows, in this order: equalities of the design vector, rows on the parameters, rows on the design, sampled
// rules in the order given. A sampled rule's row is g(B x + b; q) <= 0 with the constant map B of its cam
// angle: Jacobian Bᵀ∂g, Hessian Bᵀ ∂²g B. Rows of linear rules are multiplied out once.
#pragma once

#include "core/nlp.hpp"
#include "objectives/hessian_slots.hpp"
#include "objectives/rules/model.hpp"
#include "splines/gram.hpp"

#include <Eigen/SparseCore>

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace camopt {

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

 private:
    /// One row: affine rows have their coefficients, others the map (y … y''') = offset + matrix ·
    /// x[columns].
    struct Row {
        std::vector<int> columns;     ///< of the Jacobian, ascending
        std::vector<double> weights;  ///< affine rows
        double offset = 0.0;          ///< affine rows
        int sample = -1;              ///< nonlinear rows: which sample
        Eigen::MatrixXd map;          ///< nonlinear rows: 4 x design columns
        Eigen::Vector4d map_offset = Eigen::Vector4d::Zero();
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
    void add_linear_row(int sample);
    void add_curved_row(int sample);
    void add_cost_terms();
    void claim_cost();
    void claim_rows(int first);
    [[nodiscard]] RuleValue rule_value(const Row& row, const ConstVectorRef& x) const;
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

}  // namespace camopt
