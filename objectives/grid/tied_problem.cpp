// SPDX-License-Identifier: MIT
#include "objectives/grid/cam_problem.hpp"

namespace camopt {

namespace {

/// Mean square jerk over its reference², in the optimizer's units.
QuadraticForm jerk_energy(const CamModel& model) {
    QuadraticForm form = model.design.mean_square(3, model.mean_square_weights(3));
    form.scale(1.0 / (model.jerk_reference * model.jerk_reference), design_scales(model));
    return form;
}

}  // namespace

/// The rows of another grid, with the energy added to its cost.
class TiedProblem::Grid final : public Nlp {
 public:
    Grid(const Nlp& base, const QuadraticForm& energy, double weight)
        : base_(base), energy_(energy), weight_(weight) {
        shape_ = base.shape();
        shape_.linear_cost = false;
        shape_.hessian = {};
        for (int k = 0; k < base.shape().hessian.size(); ++k)
            slots_.claim(shape_.hessian, base.shape().hessian.rows[k], base.shape().hessian.columns[k]);
        each_entry([&](int row, int column, double) { slots_.claim(shape_.hessian, row, column); });
        slots_.finish();
    }
    void set_weight(double weight) { weight_ = weight; }
    double cost(const ConstVectorRef& x) const override {
        return base_.cost(x) + weight_ * energy_.value(design(x));
    }
    void gradient(const ConstVectorRef& x, VectorRef out) const override {
        base_.gradient(x, out);
        out.head(energy_.linear.size()) += 2.0 * weight_ * energy_.slope(design(x));
    }
    void constraints(const ConstVectorRef& x, VectorRef out) const override { base_.constraints(x, out); }
    void jacobian(const ConstVectorRef& x, std::span<double> out) const override { base_.jacobian(x, out); }
    void hessian(const ConstVectorRef& x, double sigma, const ConstVectorRef& lambda,
                 std::span<double> out) const override {
        std::ranges::fill(out, 0.0);
        // Entries of the base were claimed first, each once.
        const auto own = static_cast<std::size_t>(base_.shape().hessian.size());
        base_.hessian(x, sigma, lambda, out.first(own));
        auto add = slots_.into(out);
        for (std::size_t k = 0; k < own; ++k) add(0.0);
        each_entry([&](int, int, double value) { add(2.0 * sigma * weight_ * value); });
    }
    std::string variable_name(int index) const override { return base_.variable_name(index); }
    std::string row_name(int index) const override { return base_.row_name(index); }
    RowOrigin row_origin(int index) const override { return base_.row_origin(index); }

 private:
    [[nodiscard]] Eigen::VectorXd design(const ConstVectorRef& x) const {
        return x.head(energy_.linear.size());
    }
    /// Of the lower triangle.
    template <typename Visit>
    void each_entry(Visit&& visit) const {
        for (int column = 0; column < energy_.matrix.outerSize(); ++column)
            for (Eigen::SparseMatrix<double>::InnerIterator entry(energy_.matrix, column); entry; ++entry)
                if (entry.row() >= column) visit(static_cast<int>(entry.row()), column, entry.value());
    }

    const Nlp& base_;
    const QuadraticForm& energy_;
    double weight_;
    HessianSlots slots_;
};

TiedProblem::TiedProblem(CamProblem& problem, double weight)
    : problem_(problem),
      energy_(jerk_energy(problem.model())),
      weight_(weight),
      grid_(std::make_unique<Grid>(problem.grid(), energy_, weight)) {}

TiedProblem::~TiedProblem() = default;

void TiedProblem::set_weight(double weight) {
    weight_ = weight;
    grid_->set_weight(weight);
}

const Nlp& TiedProblem::grid() const {
    return *grid_;
}

double TiedProblem::objective(const Eigen::VectorXd& x) const {
    return grid_->cost(completed(x));
}

/// The rows of the problem changed.
void TiedProblem::follow(int added) {
    if (added > 0) grid_ = std::make_unique<Grid>(problem_.grid(), energy_, weight_);
}

int TiedProblem::refine(std::span<const Violation> worst) {
    const int added = problem_.refine(worst);
    follow(added);
    return added;
}

int TiedProblem::refine_pressed(std::span<const Violation> worst, const Eigen::VectorXd& row_multipliers) {
    const int added = problem_.refine_pressed(worst, row_multipliers);
    follow(added);
    return added;
}

}  // namespace camopt
