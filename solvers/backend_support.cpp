// SPDX-License-Identifier: MIT
#include "solvers/backend_support.hpp"

#include "core/errors.hpp"

#include <fmt/ranges.h>

namespace camopt {

namespace {

std::string range_in_words(const NumberRange& range) {
    if (std::isfinite(range.maximum))
        return fmt::format("{}{}, {}]", range.minimum_excluded ? "(" : "[", range.minimum, range.maximum);
    if (std::isfinite(range.minimum))
        return fmt::format("{} {}", range.minimum_excluded ? ">" : ">=", range.minimum);
    return "any";
}

NativeOption with_range(NativeOption option, const NumberRange& range) {
    option.range = range_in_words(range);
    option.minimum = range.minimum;
    option.maximum = range.maximum;
    option.minimum_excluded = range.minimum_excluded;
    return option;
}

std::string in_words(const OptionValue& value) {
    struct Words {
        std::string operator()(bool v) const { return v ? "true" : "false"; }
        std::string operator()(long long v) const { return fmt::format("{}", v); }
        std::string operator()(double v) const { return fmt::format("{}", v); }
        std::string operator()(const std::string& v) const { return fmt::format("'{}'", v); }
    };
    return std::visit(Words{}, value);
}

bool in_range(const NativeOption& option, double value) {
    const bool above = option.minimum_excluded ? value > option.minimum : value >= option.minimum;
    return std::isfinite(value) && above && value <= option.maximum;
}

bool takes(const NativeOption& option, const OptionValue& value) {
    if (option.kind == "bool") return std::holds_alternative<bool>(value);
    if (option.kind == "text") {
        const auto* text = std::get_if<std::string>(&value);
        return text != nullptr &&
               std::find(option.choices.begin(), option.choices.end(), *text) != option.choices.end();
    }
    if (const auto* integer = std::get_if<long long>(&value))
        return in_range(option, static_cast<double>(*integer));
    const auto* number = std::get_if<double>(&value);
    return option.kind == "number" && number != nullptr && in_range(option, *number);
}

void check_sizes(const NlpShape& shape) {
    const auto check = [](const char* what, std::ptrdiff_t found, std::ptrdiff_t expected) {
        if (found != expected)
            throw ModelError(
                fmt::format("shape of the problem: {} has {} entries, expected {}", what, found, expected));
    };
    check("x_upper", shape.x_upper.size(), shape.x_lower.size());
    check("g_upper", shape.g_upper.size(), shape.g_lower.size());
    check("rows", std::ssize(shape.rows), shape.g_lower.size());
    check("jacobian.columns", std::ssize(shape.jacobian.columns), std::ssize(shape.jacobian.rows));
    check("hessian.columns", std::ssize(shape.hessian.columns), std::ssize(shape.hessian.rows));
    if (shape.x_lower.hasNaN() || shape.x_upper.hasNaN() || shape.g_lower.hasNaN() || shape.g_upper.hasNaN())
        throw ModelError("shape of the problem: a bound is NaN");
}

void check_pattern(const char* name, const SparsityPattern& pattern, int rows, int columns) {
    for (int k = 0; k < pattern.size(); ++k) {
        const int row = pattern.rows[k], column = pattern.columns[k];
        if (row < 0 || row >= rows || column < 0 || column >= columns)
            throw ModelError(fmt::format("pattern of the {}: entry {} is at ({}, {}), outside {} x {}", name,
                                         k, row, column, rows, columns));
    }
}

/// A choice that this build does not have is refused before the solve; nothing is substituted.
void refuse_absent(const SolverEntry& entry, const NativeOption& option, const OptionValue& value) {
    const auto* word = std::get_if<std::string>(&value);
    if (word == nullptr || std::ranges::find(option.absent, *word) == option.absent.end()) return;
    std::vector<std::string> there;
    for (const std::string& choice : option.choices)
        if (std::ranges::find(option.absent, choice) == option.absent.end()) there.push_back(choice);
    throw UnavailableError(
        fmt::format("option '{}' of {}: '{}' is not built into this camopt; available: {}; {}", option.name,
                    entry.name, *word, fmt::join(there, ", "), option.remedy));
}

}  // namespace

NativeOption flag_option(std::string name, std::string default_value, std::string meaning) {
    NativeOption option{std::move(name), "bool", std::move(default_value), "true or false",
                        std::move(meaning)};
    return option;
}

NativeOption integer_option(std::string name, std::string default_value, NumberRange range,
                            std::string meaning) {
    return with_range({std::move(name), "integer", std::move(default_value), {}, std::move(meaning)}, range);
}

NativeOption number_option(std::string name, std::string default_value, NumberRange range,
                           std::string meaning) {
    return with_range({std::move(name), "number", std::move(default_value), {}, std::move(meaning)}, range);
}

NativeOption text_option(std::string name, std::string default_value,
                         std::initializer_list<const char*> choices, std::string meaning) {
    NativeOption option{std::move(name), "text", std::move(default_value), {}, std::move(meaning)};
    option.choices.assign(choices.begin(), choices.end());
    option.range = fmt::format("'{}'", fmt::join(option.choices, "' or '"));
    return option;
}

void check_native_options(const SolverEntry& entry, const std::map<std::string, OptionValue>& options) {
    for (const auto& [name, value] : options) {
        const auto found =
            std::find_if(entry.options.begin(), entry.options.end(),
                         [&name = name](const NativeOption& option) { return option.name == name; });
        if (found == entry.options.end()) {
            std::vector<std::string> names;
            for (const NativeOption& option : entry.options) names.push_back(option.name);
            throw InputError(fmt::format("unknown option '{}' of {}; allowed: {}{}", name, entry.name,
                                         names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", ")),
                                         spelling_hint(name, names)));
        }
        if (!takes(*found, value))
            throw InputError(fmt::format("option '{}' of {}: found {}, allowed is a {}: {}", name, entry.name,
                                         in_words(value), found->kind, found->range));
        refuse_absent(entry, *found, value);
    }
}

double number_or(const BackendOptions& options, const std::string& name, double otherwise) {
    const auto found = options.native.find(name);
    if (found == options.native.end()) return otherwise;
    if (const auto* integer = std::get_if<long long>(&found->second)) return static_cast<double>(*integer);
    const auto* number = std::get_if<double>(&found->second);
    return number ? *number : otherwise;
}

void check_backend_input(const SolverEntry& entry, const Nlp& problem, const Eigen::VectorXd& start,
                         const BackendOptions& options) {
    options.validate();
    check_native_options(entry, options.native);
    const NlpShape& shape = problem.shape();
    check_sizes(shape);
    check_pattern("Jacobian", shape.jacobian, shape.constraints(), shape.variables());
    check_pattern("Hessian", shape.hessian, shape.variables(), shape.variables());
    if (start.size() != shape.variables())
        throw InputError(fmt::format("start of the solve: found {} entries, the problem has {} variables",
                                     start.size(), shape.variables()));
    if (!start.allFinite()) throw InputError("start of the solve: an entry is not finite");
}

std::optional<BackendResult> result_of_crossed_bounds(const Nlp& problem) {
    const NlpShape& shape = problem.shape();
    if ((shape.x_lower.array() <= shape.x_upper.array()).all() &&
        (shape.g_lower.array() <= shape.g_upper.array()).all())
        return std::nullopt;
    BackendResult result;
    result.termination = Termination::infeasible;
    result.native_status = "not started: a lower bound is above its upper bound";
    return result;
}

void throw_unavailable(const SolverEntry& entry) {
    throw UnavailableError(
        fmt::format("solver '{}' is not built into this camopt; {}", entry.name, entry.remedy));
}

SolveGuard::SolveGuard(const BackendOptions& options, const SolveControl& control)
    : control_(control), deadline_(control.deadline.sooner(options.max_seconds)) {}

bool SolveGuard::must_stop() noexcept {
    if (reason_) return true;
    bool requested = false, late = false;
    if (!call([&] {
            requested = control_.stopped();
            late = deadline_.passed();
        }))
        return true;
    if (requested)
        stop(Termination::interrupted);
    else if (late)
        stop(Termination::time_limit);
    return reason_.has_value();
}

void SolveGuard::report(int iteration, double cost, double violation) noexcept {
    constexpr double interval = 0.5;
    if (!control_.progress || since_report_.seconds() < interval) return;
    since_report_ = {};
    (void)call([&] {
        const std::string line =
            fmt::format("iteration {}: cost {:.9g}, largest violation {:.2g}", iteration, cost, violation);
        control_.progress(line);
    });
}

void SolveGuard::keep_exception(std::exception_ptr exception) noexcept {
    exception_ = std::move(exception);
    stop(Termination::evaluation_error);
}

}  // namespace camopt
