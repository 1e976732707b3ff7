// SPDX-License-Identifier: MIT
// The plan of a solve: what is searched and by which solver, from which starts, with which relaxations,
// tie-break and proof, and how the time is shared. plan() solves nothing; planned_solve.cpp executes a plan
// and takes from it all that can be decided before the first result.
#pragma once

#include "scene/scene.hpp"
#include "solvers/certificate/certificate.hpp"

namespace camopt {

enum class ConvexOver;  // objectives/scene_model.hpp
struct PosedScene;      // studies/search/posed_scene.hpp

/// Searches where the problem is not convex, or its breakpoints are free, and the scene does not say how
/// many.
inline constexpr int default_starts = 8;

/// Where a search of a problem that is not convex starts. `relaxation`: from its optimum, or from the
/// smoothest motion if it has none.
enum class StartKind { measured, relaxation, smoothest, random };
[[nodiscard]] const char* name_of(StartKind value);
[[nodiscard]] StartKind start_kind(bool from_measured, int index);

struct PlanOptions {
    /// A picture before its proof: a problem that is not convex is searched once from the motion of a
    /// neighbour, if one is known, and has no bound.
    bool look = false;
    bool explain = false;  ///< an explanation follows if there is no motion, and time is kept for it
};

struct SolvePlan {
    // What is searched, besides the motion for given numbers.
    bool prescribed = false;    ///< laws and dwells only: not even the motion
    int angles = 0;             ///< segments of a program whose angle has a range
    int displacements = 0;      ///< free levels of a program: variables of the problem
    int breakpoints = 0;        ///< free breakpoints inside the motion
    int dimensions = 0;         ///< free dimensions of the cam: variables of the problem
    bool transmission = false;  ///< that of the motor

    // The solve for given angles and breakpoints.
    std::string solver;
    std::string reason;  ///< why "auto" took it; empty if the scene names it
    /// Tried if `solver` ends without a proof, in a search from several starts without a motion; empty: none.
    std::string next_solver;
    DesignKind design = DesignKind::states;
    bool contradiction = false;  ///< conditions contradict each other: infeasible without a search
    double cost_scale =
        1.0;  ///< the objective is divided by this while it is solved (objectives/cost_units.hpp)
    bool strokes_first_free =
        false;  ///< without the rules of strokes; with them if the motion leaves a range
    std::vector<ConvexOver> relaxations;  ///< solved first, without the rules that are not convex there
    bool convex = true;  ///< every rule is linear or convex, and neither angles nor breakpoints are searched
    int starts = 1;      ///< searches at most
    bool from_measured = false;  ///< the first start is the measured motion of the scene
    unsigned seed = 0;           ///< of random starts
    bool look = false;
    bool tie_break = false;  ///< of equal optima the smoothest
    /// Of the bound. boxes: a convex relaxation, then boxes of motions; of searched angles boxes of angles.
    ProofKind proof = ProofKind::duality;

    // Time.
    double seconds = 0.0;          ///< for everything
    double searching = 1.0;        ///< part of it after which searches without a feasible point end
    double bounding_boxes = 0.6;   ///< of searched angles: part for boxes, …
    double moving_angles = 0.9;    ///< … and moves with them; the rest is for the last solve
    double explain_seconds = 0.0;  ///< at most, if there is no motion; 0: no explanation
};

/// Throws InputError for a wrong scene.
[[nodiscard]] SolvePlan plan(const Scene& scene, const PlanOptions& options = {});

/// The plan of a scene that was validated.
[[nodiscard]] SolvePlan plan_of(const PosedScene& posed, const PlanOptions& options = {});

}  // namespace camopt
