// SPDX-License-Identifier: MIT
// A scene before its answer: the motions that it allows, what it may cost and what may limit it.
// known_scene.hpp chooses a motion, bounds and weights for which that motion is the optimum.
#pragma once

#include "tests/soak/draw.hpp"
#include "tests/soak/known/piecewise_space.hpp"
#include "tests/soak/scenes/scene_text.hpp"

#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace camopt::soak {

inline constexpr double degree_angle = std::numbers::pi / 180.0, turn_angle = 2.0 * std::numbers::pi;

/// What turns normalised numbers (lifts, x) into those of a scene.
struct Units {
    double lift = 1e-3;   ///< m or rad
    double unit = 1.0;    ///< rad of the cam for x = 1
    double speed = 0.0;   ///< rad/s; 0: none
    bool swings = false;  ///< the lift is an angle
};

/// A spelling of a derivative of this order: the end of its key, and what a normalised value is multiplied
/// by.
struct Spelling {
    std::string ending;
    double factor = 1.0;
};
/// `normal`: the factor of the spelling without a unit.
[[nodiscard]] Spelling drawn_spelling(Draw& draw, const Units& units, int order, double normal);
inline constexpr const char* order_names[] = {"displacement", "velocity", "acceleration", "jerk"};

/// Neighbouring pieces of one spline of the scene.
struct Run {
    int first = 0, pieces = 0;
    double begin = 0.0, end = 0.0;     ///< x
    double angle = 1.0, height = 1.0;  ///< of its stroke, x and lifts: what its peaks are measured by
    double least = 0.0, most = 1.0;    ///< lifts: the range of its stroke
    bool rises = true;
    int table = -1;  ///< its place among the tables motion.segments; −1: the motion itself
};

/// A combination of each run, and constants: one of it all, also where the motion rests, and one more of each
/// run.
struct Quantity {
    std::vector<Combination> of_run;
    double constant = 0.0;
    std::vector<double> added = {};  ///< empty: nothing

    [[nodiscard]] double constant_in(std::size_t run) const {
        return added.empty() ? constant : constant + added[run];
    }
};

/// A part of the objective: weight · (largest |quantity|) / reference.
struct CostTerm : Quantity {
    std::string key;
    double reference = 1.0;
};

/// The root mean square of a quantity, x rests outside the runs.
struct RmsDraft : Quantity {
    std::string key;
    std::string limit_key;  ///< empty: there is no such limit
    double rests = 0.0;
    double reference = 0.0;  ///< 0: drawn
    double chance = 0.0;     ///< of being a cost
};

/// A stretch of constant velocity, x.
struct Region {
    std::size_t run = 0;
    double from = 0.0, to = 0.0;
};

/// A bound of a quantity, in [limits]: written as number = factor · bound.
struct LimitDraft : Quantity {
    enum class Side { both, above, below };
    std::string key;     ///< with its unit
    std::string member;  ///< "": the number itself; "min", "max"
    Side side = Side::both;
    double factor = 1.0;
    double widening =
        0.0;  ///< of a bound for all cams within tolerances: the drawing's motion keeps so far away
    double at_rest_least = 0.0, at_rest_most = 0.0;  ///< of the combination where the motion rests
    double must_exceed = -1e300;                     ///< a bound that is written has to
};

struct Draft {
    std::string kind;    ///< of the scene, for the table
    std::string change;  ///< what is extreme about it; empty: nothing
    SceneText text;
    PiecewiseSpace space{3};
    Units units;
    std::vector<Run> runs;
    std::vector<CostTerm> terms;
    std::vector<LimitDraft> limits;
    std::vector<RmsDraft> root_mean_squares;
    std::vector<Region> regions;
    double length = 1.0;        ///< x of the whole motion
    double resting_area = 0.0;  ///< ∫ y dx outside the splines
    bool may_pass_points = true;
    bool monotone = false;               ///< the motion has to be
    bool advances = false;               ///< by a lift each cycle
    double lowest = -1e300;              ///< lifts: a cam is not built of motions below
    std::string reference_law;           ///< empty: numbers
    std::array<double, 4> made_error{};  ///< of y and its derivatives, x: tolerances
    int continuity = 2;
};

/// Class by its number; that of machines has the motions of drawn_axis.
inline constexpr int known_kinds = 12, machine_kind = 11;
[[nodiscard]] const char* known_kind_name(int kind);
/// `extreme`: units 1e±9, segment widths 1 : 1e4.
[[nodiscard]] Draft drawn_draft(Draw& draw, int kind, bool extreme);
/// A program of one revolution at this speed, without laws, with a motor or a cam or neither.
[[nodiscard]] Draft drawn_axis(Draw& draw, double speed_rpm, bool extreme);

}  // namespace camopt::soak
