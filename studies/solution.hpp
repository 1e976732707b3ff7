// SPDX-License-Identifier: MIT
// Everything known after a scene was solved: what output/ writes and what an embedder reads.
#pragma once

#include "core/counting_nlp.hpp"
#include "core/peaks.hpp"
#include "core/scene.hpp"
#include "solvers/certificate.hpp"
#include "solvers/solver.hpp"
#include "splines/curve.hpp"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace camopt {

/// One user limit, as written and as kept. worst, limit in `unit`; at: x.
struct ConstraintReport {
    std::string name;  ///< "velocity", "acceleration", "jerk", …
    std::string key;   ///< "limits.velocity_mm_s"
    double limit = 0.0, worst = 0.0;
    std::string unit;
    double at = 0.0;
    bool active = false;
};

/// The least change of one limit alone, the others kept, that makes the scene feasible; none where none
/// helps.
struct Relaxation {
    std::string key;
    double given = 0.0;
    std::optional<double> needed;
};

/// The free entries of the design vector: the numbers a user would type into another tool.
struct DesignReport {
    DesignKind kind = DesignKind::automatic;
    std::vector<std::string> names;
    Eigen::VectorXd values;
};

struct SolverReport {
    std::string name;    ///< the backend that ran
    std::string choice;  ///< why "auto" took it; empty where the user named it
    Termination termination = Termination::not_run;
    std::string native_status;
    int iterations = 0;
    int exchange_rounds = 0;
    std::string proof_source;  ///< whose multipliers proved the bound
};

struct LimitCurve {  ///< the limit no curve can pass (motions/any_curve_limit.hpp)
    double objective = 0.0;
    std::optional<double> velocity, acceleration, jerk;  ///< none: not attained (infinite)
};

struct Solution {
    Scene scene;
    Certificate certificate;
    std::optional<SplineCurve> curve;  ///< the delivered curve; none where nothing feasible was found
    Peaks peaks;                       ///< of the delivered curve, exact
    Peaks reference_peaks;             ///< what the objective divides by (only the parts in use are set)
    std::optional<LimitCurve> any_curve_limit;
    std::vector<ConstraintReport> constraints;
    std::vector<Relaxation> relaxation;  ///< filled where the verdict is infeasible
    DesignReport design;
    SolverReport solver;
    EvaluationCounts evaluations;
    double seconds_total = 0.0, seconds_solve = 0.0;
    std::vector<std::string> notes;  ///< redundant conditions by name, and other things worth a line
};

}  // namespace camopt
