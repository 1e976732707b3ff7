// SPDX-License-Identifier: MIT
// A backend: takes an Nlp and a start, hands back a point, perhaps multipliers, and why it stopped.
// What was found is not judged here: that is the certificate's word (certificate.hpp).
#pragma once

#include "core/deadline.hpp"
#include "core/nlp.hpp"
#include "core/text/choices.hpp"

#include <Eigen/Core>

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace camopt {

// Where an interior point came by: a point near the central path of a problem, in the problem's own terms,
// from which a neighbouring problem (rows appended, the cost a little changed) is a few iterations away.
//
// Near the path the gap of every bound times its multiplier is about `mu`. The optimum itself is no such
// place: there gaps and multipliers are zero, and nothing can move.
struct PathPoint {
    Eigen::VectorXd x;
    Eigen::VectorXd row_multipliers;  ///< as in BackendResult; rows appended later have none
    double mu = 0.0;                  ///< in units of the cost
    double gap = 0.0;                 ///< sum of gaps times multipliers, relative to the cost
};

/// The last point whose gap is at least `gap`; the first where none is that far off; null where there is
/// none.
[[nodiscard]] inline const PathPoint* point_before(const std::vector<PathPoint>& path, double gap) {
    const PathPoint* found = path.empty() ? nullptr : &path.front();
    for (const PathPoint& point : path)
        if (point.gap >= gap) found = &point;
    return found;
}

/// Why a backend stopped, in its own opinion.
enum class Termination {
    not_run,     ///< start value
    converged,   ///< the backend's own tests are met
    acceptable,  ///< stopped close to them (Ipopt "acceptable", NLopt "roundoff limited")
    infeasible,  ///< the backend believes that no feasible point exists
    unbounded,   ///< the backend believes that the objective has no lower bound
    iteration_limit,
    time_limit,
    interrupted,        ///< stop_requested() said so
    numerical_failure,  ///< factorization, step or restoration failed
    evaluation_error,   ///< the problem gave a value that is not finite
    unsupported         ///< the backend cannot take this kind of problem at all
};
[[nodiscard]] const char* name_of(Termination value);

/// How far a solve is, told from time to time. Numbers are there where they are known.
struct Progress {
    std::string_view message;              ///< one short line, for a terminal
    std::optional<int> round = {};         ///< of the exchange of cam angles, from 1
    std::optional<double> incumbent = {};  ///< objective of the best motion so far
    std::optional<double> bound = {};      ///< that no motion can pass, proved so far
    std::optional<double> violation = {};  ///< of the incumbent, relative to each limit; <= 0: all are kept

    Progress() = default;
    Progress(std::string_view line) : message(line) {}     // NOLINT(google-explicit-constructor)
    Progress(const std::string& line) : message(line) {}   // NOLINT(google-explicit-constructor)
    operator std::string_view() const { return message; }  // NOLINT(google-explicit-constructor)
};

/// The outside world during a solve. Every part may be empty.
struct SolveControl {
    std::function<bool()> stop_requested;  ///< polled between iterations; true: stop soon
    /// Called by the solving thread; what it throws comes through solve().
    std::function<void(const Progress& progress)> progress;
    Deadline deadline = {};  ///< of all that is done under this control, whatever its parts may take each
    /// Earlier: of searches that have found nothing within the limits. What is left then is for saying why.
    Deadline in_vain = {};
    /// Of problems with several minima: true where x lies near a known minimum already. A search
    /// that asks may end there (Termination::acceptable); its result says no more than that. Empty: none is
    /// known.
    std::function<bool(const Eigen::VectorXd& x)> known = {};
    [[nodiscard]] bool stopped() const { return stop_requested && stop_requested(); }
    /// Why nothing more is to be begun: Termination::interrupted or time_limit.
    [[nodiscard]] std::optional<Termination> ending() const {
        if (stopped()) return Termination::interrupted;
        return deadline.passed() ? std::optional(Termination::time_limit) : std::nullopt;
    }
    /// For a part that gets so many seconds at most.
    [[nodiscard]] SolveControl sooner(double seconds) const {
        return {stop_requested, progress, deadline.sooner(seconds), in_vain, known};
    }
};

struct BackendOptions {
    double tolerance = 1e-9;                    ///< relative optimality and feasibility, > 0
    int max_iterations = 3000;                  ///< iterations (evaluations for the derivative-free), >= 1
    double max_seconds = 60.0;                  ///< wall time, > 0; SolveControl::deadline may be earlier
    std::map<std::string, OptionValue> native;  ///< the backend's own options
    /// Where a backend with a central path may begin instead of the start; of a problem whose first rows are
    /// the same.
    std::optional<PathPoint> near = {};
    bool keep_path = false;  ///< asks for BackendResult::path
    void validate() const;   ///< throws InputError
};

struct BackendResult {
    Termination termination = Termination::not_run;
    std::string native_status;  ///< the backend's own word, e.g. "Solve_Succeeded"
    Eigen::VectorXd x;          ///< size variables; finite, or empty where the backend has nothing to give
    /// Multipliers with the signs of core/nlp.hpp: ∇f + Jᵀ row_multipliers + bound_multipliers = 0, an entry
    /// > 0 at an active upper bound, < 0 at an active lower one. Absent where the backend has none.
    std::optional<Eigen::VectorXd> row_multipliers, bound_multipliers;
    int iterations = 0;
    std::vector<PathPoint> path;  ///< where it was asked for and there is one: gaps descending
};

class Solver {
 public:
    virtual ~Solver() = default;
    [[nodiscard]] virtual std::string_view name() const = 0;
    /// Never throws for a numerical reason. An exception thrown by the Nlp is carried across the backend's
    /// own frames and rethrown here with its type.
    [[nodiscard]] virtual BackendResult minimize(const Nlp& problem, const Eigen::VectorXd& start,
                                                 const BackendOptions& options,
                                                 const SolveControl& control) const = 0;
};

}  // namespace camopt
