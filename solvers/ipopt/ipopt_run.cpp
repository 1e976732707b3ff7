// SPDX-License-Identifier: MIT
// The part "ipopt": a separate module, or a part of camopt_solvers.
#include "core/errors.hpp"
#include "core/platform/part_entry.hpp"
#include "solvers/ipopt/ipopt_adapter.hpp"
#include "solvers/ipopt/ipopt_part.hpp"

#include <fmt/core.h>

#include <IpIpoptApplication.hpp>

namespace camopt {

namespace {

// Options of camopt to options of Ipopt. Private to this folder (an Ipopt type appears).

class Settings {
 public:
    explicit Settings(Ipopt::IpoptApplication& application) : options_(application.Options()) {}

    // Ipopt returns false for an option that its version does not know or a value that it rejects.
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
    // The default 1e-8 would allow every limit to be exceeded by ten times the default tolerance.
    settings.require("bound_relax_factor", 0.01 * tolerance);
}

// About 1000 cubic segments.
constexpr int many_variables = 3000;

/// Sets the defaults for the shape of the problem, then the native options of `options`, which are validated
/// already. Throws InputError if this version of Ipopt refuses one of the latter.
void set_ipopt_options(Ipopt::IpoptApplication& application, const NlpShape& shape,
                       const BackendOptions& options, bool predictor_corrector) {
    Settings settings(application);
    settings.require("print_level", 0);
    settings.require("sb", true);  // no banner
    settings.require("linear_solver", "mumps");
    settings.require("max_iter", options.max_iterations);
    // Problems are scaled already; Ipopt's own scaling loosens the tolerances by an unknown factor.
    settings.require("nlp_scaling_method", "none");
    settings.require("mu_strategy", "adaptive");
    // In large problems the row permutation of MUMPS at least doubles its time; in small ones it improves the
    // last digits.
    if (shape.variables() >= many_variables) settings.require("mumps_permuting_scaling", 0);
    // Ipopt would have MUMPS allocate eleven times the memory that it expects to need. If twice that is too
    // little, Ipopt doubles it.
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

struct Outcome {
    Termination termination;
    const char* word;
};

Outcome outcome_of(Ipopt::ApplicationReturnStatus status) {
    using enum Termination;
    switch (status) {
        case Ipopt::Solve_Succeeded:
            return {converged, "Solve_Succeeded"};
        case Ipopt::Solved_To_Acceptable_Level:
            return {acceptable, "Solved_To_Acceptable_Level"};
        case Ipopt::Infeasible_Problem_Detected:
            return {infeasible, "Infeasible_Problem_Detected"};
        case Ipopt::Search_Direction_Becomes_Too_Small:
            return {acceptable, "Search_Direction_Becomes_Too_Small"};
        case Ipopt::Diverging_Iterates:
            return {unbounded, "Diverging_Iterates"};
        case Ipopt::User_Requested_Stop:
            return {interrupted, "User_Requested_Stop"};
        case Ipopt::Feasible_Point_Found:
            return {converged, "Feasible_Point_Found"};
        case Ipopt::Maximum_Iterations_Exceeded:
            return {iteration_limit, "Maximum_Iterations_Exceeded"};
        case Ipopt::Restoration_Failed:
            return {numerical_failure, "Restoration_Failed"};
        case Ipopt::Error_In_Step_Computation:
            return {numerical_failure, "Error_In_Step_Computation"};
        case Ipopt::Maximum_CpuTime_Exceeded:
            return {time_limit, "Maximum_CpuTime_Exceeded"};
        case Ipopt::Not_Enough_Degrees_Of_Freedom:
            return {unsupported, "Not_Enough_Degrees_Of_Freedom"};
        case Ipopt::Invalid_Problem_Definition:
            return {unsupported, "Invalid_Problem_Definition"};
        case Ipopt::Invalid_Option:
            return {unsupported, "Invalid_Option"};
        case Ipopt::Invalid_Number_Detected:
            return {evaluation_error, "Invalid_Number_Detected"};
        case Ipopt::Unrecoverable_Exception:
            return {numerical_failure, "Unrecoverable_Exception"};
        case Ipopt::NonIpopt_Exception_Thrown:
            return {numerical_failure, "NonIpopt_Exception_Thrown"};
        case Ipopt::Insufficient_Memory:
            return {numerical_failure, "Insufficient_Memory"};
        case Ipopt::Internal_Error:
            return {numerical_failure, "Internal_Error"};
        default:
            return {numerical_failure, "unknown to camopt"};  // a status of a later Ipopt
    }
}

BackendResult run_ipopt(const Nlp& problem, const Eigen::VectorXd& start, const BackendOptions& options,
                        SolveGuard& guard, bool predictor_corrector) {
    constexpr bool with_console = false;
    const Ipopt::SmartPtr<Ipopt::IpoptApplication> application = new Ipopt::IpoptApplication(with_console);
    set_ipopt_options(*application, problem.shape(), options, predictor_corrector);
    BackendResult result;
    Outcome outcome = outcome_of(application->Initialize(""));  // "": reads no ipopt.opt
    if (outcome.termination == Termination::converged) {
        const Ipopt::SmartPtr<IpoptAdapter> adapter = new IpoptAdapter(problem, start, guard);
        outcome = outcome_of(application->OptimizeTNLP(GetRawPtr(adapter)));
        result = adapter->result();
    }
    guard.rethrow();
    result.termination = outcome.termination;
    result.native_status = outcome.word;
    if (guard.reason() && outcome.termination != Termination::converged) result.termination = *guard.reason();
    return result;
}

std::recursive_timed_mutex& turn_of_process() {
    static std::recursive_timed_mutex mutex;
    return mutex;
}

constexpr IpoptPart ipopt_table = {turn_of_process, run_ipopt};

}  // namespace

}  // namespace camopt

extern "C" const void* camopt_part_ipopt(const char* build);
const void* camopt_part_ipopt(const char* build) {
    return camopt::part_for(build, &camopt::ipopt_table);
}
