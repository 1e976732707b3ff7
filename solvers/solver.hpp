// SPDX-License-Identifier: MIT
// A backend: takes an Nlp and a start, returns a point, possibly multipliers, and why it stopped. The result
// is not verified here but by the certificate (certificate.hpp).
#pragma once

#include "core/deadline.hpp"
#include "core/nlp.hpp"
#include "core/text/names.hpp"

#include <map>

namespace camopt {

// Warm start of an interior point method: a point near the central path of a problem, in the problem's own
// units, from which a neighbouring problem (rows appended, the cost slightly changed) needs few iterations.
//
// Near the path the gap of every bound times its multiplier is about `mu`. The optimum itself is unsuitable:
// there gaps and multipliers are zero, and no step is possible.
struct PathPoint {
    Eigen::VectorXd x;
    Eigen::VectorXd row_multipliers;  ///< as in BackendResult; rows appended later have none
    double mu = 0.0;   ///< in units of the cost; 0: of no path, a solution (for sequential methods)
    double gap = 0.0;  ///< sum of gaps times multipliers, relative to the cost
};

/// The last point whose gap is at least `gap`; the first if all gaps are smaller; null if there is none.
[[nodiscard]] inline const PathPoint* point_before(const std::vector<PathPoint>& path, double gap) {
    const PathPoint* found = path.empty() ? nullptr : &path.front();
    for (const PathPoint& point : path)
        if (point.gap >= gap) found = &point;
    return found;
}

/// Why a backend stopped, by its own tests.
enum class Termination {
    not_run,     ///< start value
    converged,   ///< the backend's own tests are satisfied
    acceptable,  ///< stopped close to them (Ipopt "acceptable", NLopt "roundoff limited")
    infeasible,  ///< the backend found no feasible point and reports infeasibility
    unbounded,   ///< the backend reports an unbounded objective
    iteration_limit,
    time_limit,
    interrupted,        ///< stop_requested() returned true
    numerical_failure,  ///< factorization, step or restoration failed
    evaluation_error,   ///< the problem returned a value that is not finite
    unsupported         ///< the backend does not support this kind of problem
};
[[nodiscard]] const char* name_of(Termination value);

/// Progress of a solve. Numbers are present if known.
struct Progress {
    std::string_view message;              ///< one short line, for a terminal
    std::optional<int> round = {};         ///< of the exchange of cam angles, from 1
    std::optional<double> incumbent = {};  ///< objective of the best motion so far
    std::optional<double> bound = {};      ///< proved lower bound so far
    std::optional<double> violation =
        {};  ///< of the incumbent, relative to each limit; <= 0: all are satisfied

    Progress() = default;
    Progress(std::string_view line) : message(line) {}     // NOLINT(google-explicit-constructor)
    Progress(const std::string& line) : message(line) {}   // NOLINT(google-explicit-constructor)
    operator std::string_view() const { return message; }  // NOLINT(google-explicit-constructor)
};

/// Control of a solve by its caller. Every part may be empty.
struct SolveControl {
    std::function<bool()> stop_requested;  ///< polled between iterations; true: stop soon
    /// Called by the solving thread; exceptions propagate through solve().
    std::function<void(const Progress& progress)> progress;
    Deadline deadline = {};  ///< of everything under this control, regardless of the limits of its parts
    /// Earlier: of searches that have found no feasible point. The rest is for the explanation.
    Deadline in_vain = {};
    /// Of problems with several minima: true if x is near a known minimum. A search that asks may end there
    /// (Termination::acceptable); its result claims no more. Empty: none is known.
    std::function<bool(const Eigen::VectorXd& x)> known = {};
    [[nodiscard]] bool stopped() const { return stop_requested && stop_requested(); }
    /// Why nothing more is started: Termination::interrupted or time_limit.
    [[nodiscard]] std::optional<Termination> ending() const {
        if (stopped()) return Termination::interrupted;
        return deadline.passed() ? std::optional(Termination::time_limit) : std::nullopt;
    }
    /// For a part with at most this many seconds.
    [[nodiscard]] SolveControl sooner(double seconds) const {
        return {stop_requested, progress, deadline.sooner(seconds), in_vain, known};
    }
};

/// Steps as exact as doubles hold, at several times the cost: where rows are nearly dependent.
enum class ExactSteps { never, after_failure, always };

struct BackendOptions {
    double tolerance = 1e-9;                    ///< relative optimality and feasibility, > 0
    int max_iterations = 3000;                  ///< iterations (evaluations for the derivative-free), >= 1
    double max_seconds = 60.0;                  ///< wall time, > 0; SolveControl::deadline may be earlier
    std::map<std::string, OptionValue> native;  ///< the backend's own options
    /// Warm start for a backend with a central path, in place of the start; of a problem with the same first
    /// rows.
    std::optional<PathPoint> near = {};
    bool keep_path = false;                      ///< requests BackendResult::path
    ExactSteps exact_steps = ExactSteps::never;  ///< structured only
    /// It is known that there is an optimum: structured then searches for no proof of the contrary.
    bool has_optimum = false;
    void validate() const;  ///< throws InputError
};

struct BackendResult {
    Termination termination = Termination::not_run;
    std::string native_status;  ///< the backend's own word, e.g. "Solve_Succeeded"
    Eigen::VectorXd x;          ///< size variables; finite, or empty if the backend has none
    /// Multipliers with the signs of core/nlp.hpp: ∇f + Jᵀ row_multipliers + bound_multipliers = 0, an entry
    /// > 0 at an active upper bound, < 0 at an active lower one. Absent where the backend has none.
    std::optional<Eigen::VectorXd> row_multipliers, bound_multipliers;
    int iterations = 0;
    std::vector<PathPoint> path;  ///< if requested and available: gaps descending
};

class Solver {
 public:
    virtual ~Solver() = default;
    [[nodiscard]] virtual std::string_view name() const = 0;
    /// Never throws for a numerical reason. An exception thrown by the Nlp is passed through the backend's
    /// frames and rethrown here with its type.
    [[nodiscard]] virtual BackendResult minimize(const Nlp& problem, const Eigen::VectorXd& start,
                                                 const BackendOptions& options,
                                                 const SolveControl& control) const = 0;
};

// A backend that counts its evaluations.

/// Wraps every problem in a CountingNlp; the counts of all of them are summed.
class CountingSolver final : public Solver {
 public:
    explicit CountingSolver(std::unique_ptr<Solver> solver) : solver_(std::move(solver)) {}

    [[nodiscard]] std::string_view name() const override { return solver_->name(); }
    [[nodiscard]] BackendResult minimize(const Nlp& problem, const Eigen::VectorXd& start,
                                         const BackendOptions& options,
                                         const SolveControl& control) const override;
    [[nodiscard]] const EvaluationCounts& counts() const { return counts_; }

 private:
    std::unique_ptr<Solver> solver_;
    mutable EvaluationCounts counts_;
};

}  // namespace camopt
