// SPDX-License-Identifier: MIT
// Adapter from an Nlp to Ipopt's TNLP. Private to this folder (Ipopt types appear).
#pragma once

#include "solvers/backend_support.hpp"

#include <IpTNLP.hpp>

namespace camopt {

/// Trial points with values that are not finite after which the solve is stopped. Ipopt shortens its step at
/// such a point, which often helps, but would repeat it for all its iterations.
inline constexpr int non_finite_limit = 100;

class IpoptAdapter final : public Ipopt::TNLP {
 public:
    using Index = Ipopt::Index;
    using Number = Ipopt::Number;

    IpoptAdapter(const Nlp& problem, const Eigen::VectorXd& start, SolveGuard& guard)
        : problem_(problem), shape_(problem.shape()), start_(start), guard_(guard) {}

    /// x and multipliers returned by Ipopt; x is empty if Ipopt returned none.
    [[nodiscard]] const BackendResult& result() const { return result_; }

    bool get_nlp_info(Index& n, Index& m, Index& jacobian_size, Index& hessian_size,
                      IndexStyleEnum& index_style) override;
    bool get_bounds_info(Index n, Number* x_lower, Number* x_upper, Index m, Number* g_lower,
                         Number* g_upper) override;
    bool get_starting_point(Index n, bool want_x, Number* x, bool want_z, Number* z_lower, Number* z_upper,
                            Index m, bool want_lambda, Number* lambda) override;
    bool get_constraints_linearity(Index m, LinearityType* types) override;
    bool eval_f(Index n, const Number* x, bool new_x, Number& value) override;
    bool eval_grad_f(Index n, const Number* x, bool new_x, Number* gradient) override;
    bool eval_g(Index n, const Number* x, bool new_x, Index m, Number* g) override;
    bool eval_jac_g(Index n, const Number* x, bool new_x, Index m, Index size, Index* rows, Index* columns,
                    Number* values) override;
    bool eval_h(Index n, const Number* x, bool new_x, Number sigma, Index m, const Number* lambda,
                bool new_lambda, Index size, Index* rows, Index* columns, Number* values) override;
    void finalize_solution(Ipopt::SolverReturn status, Index n, const Number* x, const Number* z_lower,
                           const Number* z_upper, Index m, const Number* g, const Number* lambda, Number cost,
                           const Ipopt::IpoptData* data,
                           Ipopt::IpoptCalculatedQuantities* quantities) override;
    bool intermediate_callback(Ipopt::AlgorithmMode mode, Index iteration, Number cost, Number violation,
                               Number dual_violation, Number mu, Number step_norm, Number regularization,
                               Number dual_step, Number primal_step, Index line_search_trials,
                               const Ipopt::IpoptData* data,
                               Ipopt::IpoptCalculatedQuantities* quantities) override;

 private:
    [[nodiscard]] bool finite(std::span<const double> values);
    void fill_fixed_bound_multipliers();

    const Nlp& problem_;
    const NlpShape& shape_;
    const Eigen::VectorXd& start_;
    SolveGuard& guard_;
    BackendResult result_;
    int non_finite_ = 0;
};

}  // namespace camopt
