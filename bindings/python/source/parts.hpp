// SPDX-License-Identifier: MIT
// The extension module _camopt: what its parts share, and the parts.
#pragma once

#include <atomic>
#include <camopt/laws.hpp>
#include <camopt/motion.hpp>
#include <camopt/own_rules.hpp>
#include <camopt/result_json.hpp>
#include <camopt/scene.hpp>
#include <camopt/solution.hpp>
#include <camopt/solver.hpp>
#include <chrono>
#include <memory>
#include <optional>
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
    pybind11::list terms, limits;  ///< `own` as given: what a copy in another process is made of

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

/// A scene of a text, settings and lists of camopt.OwnTerm, camopt.OwnLimit (ReadScene, OwnRules).
[[nodiscard]] ReadScene read_of(std::string text, std::string source, std::vector<std::string> settings,
                                const py::list& terms, const py::list& limits, bool alone);

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
/// Files and pickles of a solution, members of its class.
void add_files(pybind11::class_<struct SolvedScene>& type);
void add_pickles(pybind11::class_<struct SolvedScene>& type);
void add_solving(pybind11::module_& module);
void add_machines(pybind11::module_& module);
void add_sweeps(pybind11::module_& module);
void add_comparisons(pybind11::module_& module);

// A solution with the scene it belongs to, as Python holds it.
struct SolvedScene {
    std::shared_ptr<const Solution> solution;
    RunOrigin origin;
    pybind11::object given = pybind11::none();  ///< the ReadScene that was solved
};

// Motions as Python holds them: shared with the solution they come from, constant.
struct MotionValue {
    std::shared_ptr<const Motion> motion;
};

struct LawValue : MotionValue {
    std::shared_ptr<const Law> law;
    explicit LawValue(std::shared_ptr<const Law> made) : MotionValue{made}, law(std::move(made)) {}
};

// The interpreter during a solve: Ctrl-C and progress callbacks, while the interpreter's lock is released.

namespace py = pybind11;

/// What a callback is told: a camopt::Progress that outlives the call.
struct ProgressValue {
    std::string message;
    std::optional<int> round;
    std::optional<double> incumbent, bound, violation;
};

/// Made and destroyed with the interpreter's lock held; the solve runs in between without it. What a callback
/// or a signal handler raises stops the solve and is kept until raise_what_came().
class Watch {
 public:
    /// progress: a callable, or None.
    explicit Watch(py::object progress) : progress_(std::move(progress)) {}
    Watch(const Watch&) = delete;
    Watch& operator=(const Watch&) = delete;

    /// For a solve on the thread that made the watch. Asks for signals at most every 20 ms.
    [[nodiscard]] SolveControl control();

    /// Any thread may ask: whether something was raised.
    [[nodiscard]] bool stopped() const { return stopped_; }
    /// Takes the lock and runs the interpreter's signal handlers; whether anything was raised, now or before.
    bool look_for_signals();
    /// Takes the lock; calls the callback with these arguments, where there is one and nothing was raised.
    template <typename... Arguments>
    void tell(Arguments&&... arguments) {
        if (stopped_ || !wants_progress()) return;
        const py::gil_scoped_acquire lock;
        try {
            progress_(std::forward<Arguments>(arguments)...);
        } catch (py::error_already_set& error) {
            keep(error);
        }
    }
    [[nodiscard]] bool wants_progress() const { return !progress_.is_none(); }
    /// Keeps an exception of Python for raise_what_came(), the first one only. With the lock held.
    void keep(py::error_already_set& error);

    /// With the lock held: throws what was kept; `found`, what the solve had until then, is its attribute
    /// `name`.
    void raise_what_came(const char* name, const py::object& found);

 private:
    using Clock = std::chrono::steady_clock;

    py::object progress_;
    py::object raised_ = py::none();
    std::atomic<bool> stopped_{false};
    Clock::time_point looked_{};
};

}  // namespace camopt::python
