// SPDX-License-Identifier: MIT
#include "solvers/exchange/exchange.hpp"

namespace camopt {

class RelaxedProblem::Grid final : public Nlp {
 public:
    Grid(const Nlp& base, double slack) : Nlp(base.shape()), base_(base) {
        for (int i = 0; i < shape_.constraints(); ++i) {
            if (!shape_.rows[static_cast<std::size_t>(i)].limit) continue;
            const double out = slack * shape_.rows[static_cast<std::size_t>(i)].scale;
            shape_.g_upper[i] += out;
            shape_.g_lower[i] -= out;
        }
    }
    double cost(const ConstVectorRef& x) const override { return base_.cost(x); }
    void gradient(const ConstVectorRef& x, VectorRef out) const override { base_.gradient(x, out); }
    void constraints(const ConstVectorRef& x, VectorRef out) const override { base_.constraints(x, out); }
    void jacobian(const ConstVectorRef& x, std::span<double> out) const override { base_.jacobian(x, out); }
    void hessian(const ConstVectorRef& x, double sigma, const ConstVectorRef& lambda,
                 std::span<double> out) const override {
        base_.hessian(x, sigma, lambda, out);
    }
    std::string variable_name(int index) const override { return base_.variable_name(index); }
    std::string row_name(int index) const override { return base_.row_name(index); }
    RowOrigin row_origin(int index) const override { return base_.row_origin(index); }

 private:
    const Nlp& base_;
};

RelaxedProblem::RelaxedProblem(ContinuousProblem& base, double slack)
    : base_(base), slack_(slack), grid_(std::make_unique<Grid>(base.grid(), slack)) {}

RelaxedProblem::~RelaxedProblem() = default;

const Nlp& RelaxedProblem::grid() const {
    return *grid_;
}

std::vector<Violation> RelaxedProblem::violations(const Eigen::VectorXd& x, double slack) const {
    return violations_beyond(base_, x, slack, slack_);
}

double RelaxedProblem::worst_of_limits(const Eigen::VectorXd& x) const {
    return std::max(-1.0, base_.worst_of_limits(x) - slack_);
}

int RelaxedProblem::refine(std::span<const Violation> worst) {
    return regridded(base_.refine(worst));
}

int RelaxedProblem::refine_pressed(std::span<const Violation> worst, const Eigen::VectorXd& row_multipliers) {
    return regridded(base_.refine_pressed(worst, row_multipliers));
}

int RelaxedProblem::regridded(int added) {
    if (added > 0) grid_ = std::make_unique<Grid>(base_.grid(), slack_);
    return added;
}

std::vector<Violation> violations_beyond(const ContinuousProblem& problem, const Eigen::VectorXd& x,
                                         double slack, double relaxation) {
    std::vector<Violation> found = problem.violations(x, slack + std::max(0.0, -relaxation));
    for (Violation& violation : found)
        if (violation.limit) violation.amount -= relaxation;
    std::erase_if(found, [slack](const Violation& violation) { return violation.amount <= -slack; });
    std::ranges::stable_sort(found, std::greater{}, &Violation::amount);
    return found;
}

}  // namespace camopt
