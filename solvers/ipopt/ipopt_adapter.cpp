// SPDX-License-Identifier: MIT
#include "solvers/ipopt/ipopt_adapter.hpp"

namespace camopt {

namespace {

using ConstMap = Eigen::Map<const Eigen::VectorXd>;
using Map = Eigen::Map<Eigen::VectorXd>;

std::span<double> span_of(double* values, int size) {
    return {values, static_cast<std::size_t>(size)};
}

void copy_pattern(const SparsityPattern& pattern, int* rows, int* columns) {
    std::copy(pattern.rows.begin(), pattern.rows.end(), rows);
    std::copy(pattern.columns.begin(), pattern.columns.end(), columns);
}

}  // namespace

bool IpoptAdapter::finite(std::span<const double> values) {
    if (std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); }))
        return true;
    if (++non_finite_ >= non_finite_limit) guard_.stop(Termination::evaluation_error);
    return false;
}

bool IpoptAdapter::get_nlp_info(Index& n, Index& m, Index& jacobian_size, Index& hessian_size,
                                IndexStyleEnum& index_style) {
    n = shape_.variables();
    m = shape_.constraints();
    jacobian_size = shape_.jacobian.size();
    hessian_size = shape_.hessian.size();
    index_style = C_STYLE;
    return true;
}

bool IpoptAdapter::get_bounds_info(Index n, Number* x_lower, Number* x_upper, Index m, Number* g_lower,
                                   Number* g_upper) {
    // Ipopt treats anything beyond ±1e19 as infinite.
    Map(x_lower, n) = shape_.x_lower;
    Map(x_upper, n) = shape_.x_upper;
    Map(g_lower, m) = shape_.g_lower;
    Map(g_upper, m) = shape_.g_upper;
    return true;
}

bool IpoptAdapter::get_starting_point(Index n, bool want_x, Number* x, bool want_z, Number*, Number*, Index,
                                      bool want_lambda, Number*) {
    if (want_z || want_lambda) return false;
    if (want_x) Map(x, n) = start_;
    return true;
}

bool IpoptAdapter::get_constraints_linearity(Index m, LinearityType* types) {
    for (Index row = 0; row < m; ++row) types[row] = shape_.rows[row].linear ? LINEAR : NON_LINEAR;
    return true;
}

bool IpoptAdapter::eval_f(Index n, const Number* x, bool, Number& value) {
    return guard_.call([&] { value = problem_.cost(ConstMap(x, n)); }) && finite({&value, 1});
}

bool IpoptAdapter::eval_grad_f(Index n, const Number* x, bool, Number* gradient) {
    Map out(gradient, n);
    return guard_.call([&] { problem_.gradient(ConstMap(x, n), out); }) && finite(span_of(gradient, n));
}

bool IpoptAdapter::eval_g(Index n, const Number* x, bool, Index m, Number* g) {
    Map out(g, m);
    return guard_.call([&] { problem_.constraints(ConstMap(x, n), out); }) && finite(span_of(g, m));
}

bool IpoptAdapter::eval_jac_g(Index n, const Number* x, bool, Index, Index size, Index* rows, Index* columns,
                              Number* values) {
    if (!values) {
        copy_pattern(shape_.jacobian, rows, columns);
        return true;
    }
    const std::span<double> out = span_of(values, size);
    return guard_.call([&] { problem_.jacobian(ConstMap(x, n), out); }) && finite(out);
}

bool IpoptAdapter::eval_h(Index n, const Number* x, bool, Number sigma, Index m, const Number* lambda, bool,
                          Index size, Index* rows, Index* columns, Number* values) {
    if (!values) {
        copy_pattern(shape_.hessian, rows, columns);
        return true;
    }
    const std::span<double> out = span_of(values, size);
    return guard_.call([&] { problem_.hessian(ConstMap(x, n), sigma, ConstMap(lambda, m), out); }) &&
           finite(out);
}

void IpoptAdapter::finalize_solution(Ipopt::SolverReturn, Index n, const Number* x, const Number* z_lower,
                                     const Number* z_upper, Index m, const Number*, const Number* lambda,
                                     Number, const Ipopt::IpoptData*, Ipopt::IpoptCalculatedQuantities*) {
    const ConstMap point(x, n);
    if (!point.allFinite()) return;
    result_.x = point;
    const ConstMap rows(lambda, m), lower(z_lower, n), upper(z_upper, n);
    if (!rows.allFinite() || !lower.allFinite() || !upper.allFinite()) return;
    result_.row_multipliers = rows;
    result_.bound_multipliers = upper - lower;
    fill_fixed_bound_multipliers();
}

// Ipopt 3.11 removes fixed variables from the problem and leaves their multipliers at zero.
void IpoptAdapter::fill_fixed_bound_multipliers() {
    if (!(shape_.x_lower.array() == shape_.x_upper.array()).any()) return;
    Eigen::VectorXd slope(shape_.variables());
    std::vector<double> values(shape_.jacobian.rows.size());
    const bool known = guard_.call([&] {
        problem_.gradient(result_.x, slope);
        problem_.jacobian(result_.x, values);
    });
    if (!known) return;
    for (int k = 0; k < shape_.jacobian.size(); ++k)
        slope[shape_.jacobian.columns[k]] += values[k] * (*result_.row_multipliers)[shape_.jacobian.rows[k]];
    for (int j = 0; j < shape_.variables(); ++j)
        if (shape_.x_lower[j] == shape_.x_upper[j] && std::isfinite(slope[j]))
            (*result_.bound_multipliers)[j] = -slope[j];
}

bool IpoptAdapter::intermediate_callback(Ipopt::AlgorithmMode, Index iteration, Number cost, Number violation,
                                         Number, Number, Number, Number, Number, Number, Index,
                                         const Ipopt::IpoptData*, Ipopt::IpoptCalculatedQuantities*) {
    result_.iterations = iteration;
    guard_.report(iteration, cost, violation);
    return !guard_.must_stop();
}

}  // namespace camopt
