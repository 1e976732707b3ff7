// SPDX-License-Identifier: MIT
// The extension module _camopt: what its parts share, and the parts.
#pragma once

#include <camopt/laws.hpp>
#include <camopt/motion.hpp>
#include <camopt/own_rules.hpp>
#include <camopt/result_json.hpp>
#include <camopt/scene.hpp>
#include <camopt/solution.hpp>
#include <memory>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace camopt::python {

// A scene as Python hands it over: the text of a scene file and settings on top of it, read and checked.

/// What a scene has beside its text.
struct OwnRules {
    std::vector<OwnTerm> terms;
    std::vector<OwnLimit> limits;
    /// The text weighs nothing, which its reader refuses: the terms are the whole objective.
    bool alone = false;
};

/// A constant: changes make another one. `settings`: "KEY=VALUE" as the command line's --set takes them.
struct ReadScene {
    std::string text;
    std::string source;  ///< stands in the place of FILE in messages
    std::vector<std::string> settings;
    OwnRules own;
    Scene scene;

    /// Throws InputError "FILE:LINE:COLUMN: key: found …; allowed: …"; about a setting "KEY=VALUE: …".
    ReadScene(std::string toml, std::string source_name, std::vector<std::string> all_settings,
              OwnRules own_rules);

    /// The scene of these settings after its own.
    [[nodiscard]] Scene with(std::span<const std::string> more) const;
    /// One TOML text that reads back as this scene.
    [[nodiscard]] std::string toml() const;
    /// Without a text where there are rules that no text can say.
    [[nodiscard]] RunOrigin origin() const;
};

// Functions of Python as cost terms and limits of a scene.
//
// A function is called as f(x, y, v, a, j) with y and its three derivatives by x. Its partials come in one of
// two ways: it is called with numbers that carry first and second partials (Number), or functions for its
// gradient and Hessian stand beside it, and all three are called with plain numbers.

namespace py = pybind11;

/// x, y, y', y'', y''': what a Number has partials by, in this order.
inline constexpr int number_variables = 5;
using Number = SecondOrder<number_variables>;

/// The formula of a rule (attributes f, gradient, hessian; the latter two may be None). It takes the
/// interpreter's lock for every call and may be copied and destroyed without it. Exceptions of the function
/// come out as py::error_already_set; ModelError for a value of the wrong kind or shape, or not finite.
[[nodiscard]] MotionFormula formula_of(const py::object& rule);

/// From the attributes of camopt.OwnTerm, camopt.OwnLimit.
[[nodiscard]] OwnTerm own_term(const py::object& rule);
[[nodiscard]] OwnLimit own_limit(const py::object& rule);

// Tables of the library as columns of NumPy.

/// A CSV text of the library (a line of names, then numbers) as {name: array}, in the order of the text. The
/// numbers are those of the file to the last bit; an empty cell is `empty`.
[[nodiscard]] pybind11::dict columns_of_csv(std::string_view csv, double empty);

// The parts of the extension module _camopt; each adds its classes and functions. In the order of module.cpp.

void add_errors(pybind11::module_& module);
void add_own_rules(pybind11::module_& module);
void add_motions(pybind11::module_& module);
void add_scenes(pybind11::module_& module);
void add_solutions(pybind11::module_& module);
void add_solving(pybind11::module_& module);
void add_sweeps(pybind11::module_& module);
void add_comparisons(pybind11::module_& module);

// A solution with the scene it belongs to, as Python holds it.
struct SolvedScene {
    std::shared_ptr<const Solution> solution;
    RunOrigin origin;
};

// Motions as Python holds them: shared with the solution they come from, constant.
struct MotionValue {
    std::shared_ptr<const Motion> motion;
};

struct LawValue : MotionValue {
    std::shared_ptr<const Law> law;
    explicit LawValue(std::shared_ptr<const Law> made) : MotionValue{made}, law(std::move(made)) {}
};

}  // namespace camopt::python
