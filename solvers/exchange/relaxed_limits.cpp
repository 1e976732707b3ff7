// SPDX-License-Identifier: MIT
#include "solvers/exchange/relaxed_limits.hpp"

#include "solvers/certificate/duality.hpp"
#include "solvers/structured/structured_solver.hpp"

#include <cmath>

namespace camopt {

namespace {

/// The same problem with every limit moved out.
class RelaxedGrid final : public Nlp {
 public:
    RelaxedGrid(const Nlp& base, double slack) : Nlp(base.shape()), base_(base) {
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

}  // namespace

std::optional<DualityProof> relaxed_proof(const ContinuousProblem& problem, const JudgedPoint& point,
                                          const BackendOptions& options, const SolveControl& control) {
    if (!problem.grid().shape().convex || !problem.convex(point.objective)) return {};
    const RelaxedGrid grid(problem.grid(), point.slack);
    const BackendResult dual = make_structured_solver()->minimize(grid, point.x, options, control);
    if (!dual.row_multipliers || !dual.row_multipliers->allFinite()) return {};
    DualityProof proof = duality_proof(grid, point.x, *dual.row_multipliers,
                                       problem.box(point.objective, point.slack), "objective");
    if (!std::isfinite(proof.bound)) return {};
    proof.limits_relaxed_by = point.slack;
    return proof;
}

}  // namespace camopt
