// SPDX-License-Identifier: MIT
// result.json → plain values: those that cannot be recomputed from the scene and the delivered motion.
// Doubles round-trip bit for bit. Whether they still belong to the motion is verified when a Solution is made
// of them (studies/restored/restored_solution.hpp). Errors: InputError "FILE: KEY: found …; allowed: …".
#pragma once

#include "core/base/standard.hpp"

#include <Eigen/Core>

#include <map>

namespace camopt::input {

/// A spline of the delivered motion: pieces (degree + 1) x segments, as SplineCurve takes them.
struct CurveRecord {
    int degree = 0, continuity = 0;
    std::vector<double> breakpoints;
    Eigen::MatrixXd pieces;
};

/// One part of the chain (splines/motion_chain.hpp): a dwell if it names neither a curve nor a law.
struct PartRecord {
    double begin = 0.0, end = 0.0;
    std::optional<int> curve;  ///< index in ResultRecord::curves
    std::string law;           ///< key of the catalogue
    double x0 = 0.0, x_scale = 1.0, y0 = 0.0, y_scale = 1.0;
};

/// Of a cam that drives both ways.
struct PlayRecord {
    double least = 0.0, largest = 0.0;  ///< in deg or mm
    double least_at_deg = 0.0, largest_at_deg = 0.0;
    std::optional<double> least_groove_width_mm;
};

struct ForwardCheckRecord {
    double deviation = 0.0;  ///< in deg or mm
    double relative = 0.0, at_deg = 0.0, seconds = 0.0;
    int points = 0;
    std::optional<PlayRecord> play = {};
};

struct CamRecord {
    std::vector<std::pair<std::string, double>> dimensions;  ///< "base_radius_m"; m or rad
    std::optional<ForwardCheckRecord> forward_check;
};

struct DesignRecord {
    std::string kind;
    std::vector<std::string> names;
    std::vector<double> values;
};

struct SolverRecord {
    std::string name, termination, native_status, choice, proof_source;
    int iterations = 0, exchange_rounds = 0, starts = 0;
    bool convex = true;
};

struct EvaluationRecord {
    long cost = 0, gradient = 0, constraints = 0, jacobian = 0, hessian = 0, profile_points = 0;
};

struct ResultRecord {
    std::string scene_file, command;
    std::string verdict;
    std::optional<double> any_curve_limit;
    std::vector<CurveRecord> curves;
    std::vector<PartRecord> parts;
    std::optional<CamRecord> cam;
    DesignRecord design;
    SolverRecord solver;
    EvaluationRecord evaluations;
    double seconds_total = 0.0, seconds_solve = 0.0;
    std::map<std::string, double> seconds;  ///< all of them, the phases too
    std::vector<std::string> notes;
    std::string machine;  ///< Solution::machine
};

/// Whether a result without a motion (infeasible, failed) is read: its record has no parts.
enum class RecordedMotion { required, optional };

/// Throws InputError for text that is not a result of this version of camopt, and for one without a required
/// motion.
[[nodiscard]] ResultRecord read_result(std::string_view json, std::string_view source_name,
                                       RecordedMotion needed = RecordedMotion::required);

}  // namespace camopt::input
