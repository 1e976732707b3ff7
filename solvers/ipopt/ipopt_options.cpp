// SPDX-License-Identifier: MIT
#include "solvers/ipopt/ipopt_options.hpp"

#include "core/errors.hpp"
#include "solvers/chained_columns.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace camopt {

namespace {

/// Variables from which on chained columns are faster, measured on the states form (three variables a knot):
/// as fast with 256 to 2048 knots, faster by a tenth with 4096 and a fifth with 8192.
constexpr int chaining_pays = 6000;

class Settings {
 public:
    explicit Settings(Ipopt::IpoptApplication& application) : options_(application.Options()) {}

    // Ipopt answers false for an option that its version does not know or a value it does not take.
    bool set(const char* name, const char* text) { return options_->SetStringValue(name, text); }
    bool set(const char* name, bool flag) { return options_->SetStringValue(name, flag ? "yes" : "no"); }
    bool set(const char* name, double number) { return options_->SetNumericValue(name, number); }
    bool set(const char* name, int number) { return options_->SetIntegerValue(name, number); }

    template <class Value>
    void require(const char* name, Value value) {
        if (!set(name, value))
            throw InputError(fmt::format("this version of Ipopt refuses its option '{}'", name));
    }

    void require_native(const std::string& name, const OptionValue& value, bool is_integer) {
        if (const auto* flag = std::get_if<bool>(&value)) return require(name.c_str(), *flag);
        if (const auto* text = std::get_if<std::string>(&value)) return require(name.c_str(), text->c_str());
        if (const auto* number = std::get_if<double>(&value)) return require(name.c_str(), *number);
        const long long integer = std::get<long long>(value);
        if (is_integer) return require(name.c_str(), static_cast<int>(integer));
        require(name.c_str(), static_cast<double>(integer));
    }

 private:
    Ipopt::SmartPtr<Ipopt::OptionsList> options_;
};

struct Linearity {
    bool equalities = true, inequalities = true;
};

Linearity linearity_of(const NlpShape& shape) {
    Linearity linear;
    for (int row = 0; row < shape.constraints(); ++row) {
        if (shape.rows[row].linear) continue;
        (shape.g_lower[row] == shape.g_upper[row] ? linear.equalities : linear.inequalities) = false;
    }
    return linear;
}

void set_tolerances(Settings& settings, const BackendOptions& options) {
    const double tolerance = options.tolerance;
    // The barrier leaves about one complementarity product for each active row in the cost, and Ipopt divides
    // its error by the mean multiplier: a hundredth keeps the sum over some hundred rows below `tolerance`.
    settings.require("tol", 0.01 * tolerance);
    settings.require("compl_inf_tol", 0.01 * tolerance);
    settings.require("constr_viol_tol", tolerance);
    settings.require("dual_inf_tol", tolerance);
    settings.require("acceptable_tol", std::min(1e-4, 100.0 * tolerance));
    settings.require("acceptable_constr_viol_tol", std::min(1e-4, 100.0 * tolerance));
    settings.require("acceptable_dual_inf_tol", std::min(1e-4, 100.0 * tolerance));
    settings.require("acceptable_compl_inf_tol", std::min(1e-4, 100.0 * tolerance));
    // The default 1e-8 would let every limit be exceeded by ten times the default tolerance.
    settings.require("bound_relax_factor", 0.01 * tolerance);
}

}  // namespace

bool wants_predictor_corrector(const NlpShape& shape, const BackendOptions& options) {
    const auto native = options.native.find("mehrotra_algorithm");
    if (native != options.native.end()) return std::get<bool>(native->second);
    // Ipopt refuses predictor-corrector steps with any other rule for its barrier parameter.
    const auto rule = options.native.find("mu_strategy");
    if (rule != options.native.end() && std::get<std::string>(rule->second) != "adaptive") return false;
    const Linearity linear = linearity_of(shape);
    return linear.equalities && linear.inequalities && shape.convex && shape.quadratic_cost;
}

std::vector<int> columns_to_chain(const NlpShape& shape, const BackendOptions& options) {
    const auto native = options.native.find("chain_dense_columns");
    const std::string wish = native == options.native.end() ? "auto" : std::get<std::string>(native->second);
    if (wish == "no" || (wish == "auto" && shape.variables() < chaining_pays)) return {};
    return dense_columns(shape);
}

// About 1000 cubic segments.
constexpr int many_variables = 3000;

void set_ipopt_options(Ipopt::IpoptApplication& application, const NlpShape& shape,
                       const BackendOptions& options, bool predictor_corrector) {
    Settings settings(application);
    settings.require("print_level", 0);
    settings.require("sb", true);  // no banner
    settings.require("linear_solver", "mumps");
    settings.require("max_iter", options.max_iterations);
    // Problems arrive scaled; Ipopt's own scaling loosens the tolerances by a factor it does not tell.
    settings.require("nlp_scaling_method", "none");
    settings.require("mu_strategy", "adaptive");
    // In large problems MUMPS pairs the rows in a way that at least doubles its time; in small ones the pairs
    // are worth the last digits.
    if (shape.variables() >= many_variables) settings.require("mumps_permuting_scaling", 0);
    // Ipopt would have MUMPS set aside eleven times the memory that it expects to need. Where twice that is
    // too little, Ipopt doubles it itself.
    settings.require("mumps_mem_percent", 100);
    set_tolerances(settings, options);

    const Linearity linear = linearity_of(shape);
    const bool all_linear = linear.equalities && linear.inequalities;
    settings.require("jac_c_constant", linear.equalities);
    settings.require("jac_d_constant", linear.inequalities);
    settings.require("hessian_constant", all_linear && shape.quadratic_cost);
    (void)settings.set("grad_f_constant", shape.linear_cost);  // unknown to 3.11
    settings.require("mehrotra_algorithm", predictor_corrector);

    for (const auto& [name, value] : options.native)
        if (name != "mehrotra_algorithm" && name != "chain_dense_columns")
            settings.require_native(name, value,
                                    name == "acceptable_iter" || name == "mumps_mem_percent" ||
                                        name == "mumps_permuting_scaling" || name == "max_soc");
}

}  // namespace camopt
