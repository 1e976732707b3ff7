// SPDX-License-Identifier: MIT
// What result.json keeps of a solve that cannot be recomputed from the scene: the delivered motion and
// dimensions, bit for bit, and what tells of the run. studies/restored/ makes a Solution of it.
#pragma once

#include "studies/delivered/solution.hpp"

namespace camopt {

/// A spline of the delivered motion, as SplineCurve takes it.
struct CurveRecord {
    int degree = 0, continuity = 0;
    std::vector<double> breakpoints;
    std::vector<Eigen::VectorXd> pieces;  ///< one a segment, degree + 1 numbers
};

/// One part of the chain: a dwell if it names neither a curve nor a law.
struct PartRecord {
    ChainPart part;            ///< without its shape
    std::optional<int> curve;  ///< index in MotionRecord::curves
    std::string law;           ///< key of the catalogue
};

struct MotionRecord {
    std::vector<CurveRecord> curves;
    std::vector<PartRecord> parts;
};

struct CamRecord {
    std::vector<std::pair<std::string, double>> dimensions;  ///< "base_radius_m"; m or rad
    std::optional<ForwardCheckReport> forward_check;
};

/// Members are those of RunOrigin and Solution.
struct ResultRecord {
    std::string scene_file, command;
    Verdict verdict = Verdict::failed;
    std::optional<double> any_curve_limit;  ///< its objective
    std::optional<MotionRecord> motion;
    std::optional<CamRecord> cam;
    DesignReport design;
    SolverReport solver;
    EvaluationCounts evaluations;
    double seconds_total = 0.0, seconds_solve = 0.0;
    PhaseSeconds phases;
    std::vector<std::string> notes;
    std::string machine;
    std::optional<LeastReport> least;
    std::optional<ToleranceReport> tolerance;
};

}  // namespace camopt
