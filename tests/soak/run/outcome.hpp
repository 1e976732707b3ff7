// SPDX-License-Identifier: MIT
// What the library published of one solve: numbers read from the texts of result.json and certificate.json,
// which is all that a user has; for the stability table the curve in memory as well. The one place of the
// trials that calls the library is outcome.cpp.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace camopt {
struct Solution;
}

namespace camopt::soak {

struct PublishedSpline {
    int degree = 0, continuity = 0;
    std::vector<double> breakpoints, knots, coefficients;
    /// Of each piece the powers of x − its breakpoint, from memory; empty: only what was published is known.
    std::vector<std::vector<double>> pieces;
};

struct PublishedSegment {
    std::string kind, law;
    double start = 0.0, angle = 0.0;  ///< rad
    double from = 0.0, to = 0.0;      ///< lifts
    std::optional<PublishedSpline> spline;
    std::map<std::string, double> peaks;
};

struct PublishedLimit {
    std::string name, key, unit;
    double limit = 0.0, worst = 0.0;
};

struct PublishedRelaxation {
    std::string key;
    double given = 0.0;
    std::optional<double> needed;
    double solved = 0.0;  ///< what the values of `also` belong to
    struct Companion {
        std::string key;
        double given = 0.0, solved = 0.0;
    };
    std::vector<Companion> also = {};  ///< what changes with it
};

struct ProofRow {
    std::vector<int> indices;
    std::vector<double> values;
    std::optional<double> lower, upper;
    double multiplier = 0.0;
};

struct Proof {
    std::string statement;
    std::vector<double> cost;
    double constant = 0.0;
    std::vector<ProofRow> rows;
    std::vector<std::optional<double>> box_lower, box_upper;
    std::optional<double> bound;
};

struct Outcome {
    std::string refusal;  ///< what was thrown where the scene was refused or the solve broke; empty: a result
    std::string broken;   ///< what is wrong with the texts themselves; empty: nothing
    std::string verdict, reason, proof_kind, termination, solver, design;
    bool convex = false;
    std::optional<double> objective, lower, gap, any_curve_limit, worst_violation;
    std::map<std::string, double> peaks, references, dimensions;
    std::map<std::string, double> cam;  ///< "regularity", "forces.torque_nm", …: those that are there
    std::optional<PublishedSpline> spline;
    std::vector<PublishedSegment> segments;
    std::vector<PublishedLimit> limits;
    std::vector<std::string>
        limits_without_worst;  ///< keys of those whose worst value is null beside a motion
    std::vector<PublishedRelaxation> relaxation;
    std::vector<std::string> notes;
    /// Searches for what would help that the clock ended, as result.json says.
    std::vector<std::string> unsettled;
    std::optional<Proof> proof;
    bool has_box_proof =
        false;  ///< the certificate holds the steps of a proof over boxes, or those of all cases
    double processor_seconds = 0.0, wall_seconds = 0.0;
    /// Both texts without what may differ between two identical calls: seconds.
    std::string repeatable;
    std::shared_ptr<const Solution> solution;  ///< in memory; null: a refusal

    [[nodiscard]] bool has_motion() const { return spline.has_value() || !segments.empty(); }
    [[nodiscard]] bool is_proved() const { return verdict == "optimal"; }
};

/// What a user gets of a solve: the explanation of an infeasible scene, and texts. Or what the library itself
/// has: the pieces of the curve, to the last digit.
enum class Scope { published, memory };

/// Never throws.
[[nodiscard]] Outcome solve_text(const std::string& scene, Scope scope = Scope::published);

/// The solvers of this build that take these scenes.
[[nodiscard]] std::vector<std::string> available_solvers();

}  // namespace camopt::soak
