// SPDX-License-Identifier: MIT
// What the soak trials demand. A check looks at one solve, and every solve is looked at. A comparison changes
// a scene in a way whose effect is known without knowing the answer, solves again, and looks at both.
#pragma once

#include "tests/soak/draw.hpp"
#include "tests/soak/figures/motion_figures.hpp"
#include "tests/soak/run/outcome.hpp"
#include "tests/soak/scenes/scene_numbers.hpp"
#include "tests/soak/scenes/scene_text.hpp"

#include <cmath>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace camopt::soak {

/// A scene with its result, and with the motion as the trials themselves read it.
struct Solved {
    SceneText text;
    SceneNumbers numbers;
    Outcome outcome;
    std::optional<Motion> motion;
    MotionFigures figures;
    std::map<std::string, double> dimensions;  ///< delivered, m
};

/// Solves it and reads what was published, or what is in memory.
[[nodiscard]] Solved solved_from(const SceneText& text, Scope scope = Scope::published);

/// The motion and its figures, from what was published.
void read_motion(Solved& solved);

/// By how much a delivered motion misses what its scene demands, relative to the scale of each demand: the
/// worst of many.
struct Miss {
    long double amount = 0;
    std::string what;
    void note(long double by, std::string of) {
        if (by <= amount) return;  // not a number is no less
        amount = std::isnan(by) ? HUGE_VALL : by;
        what = std::move(of);
    }
    void note(const Miss& other) { note(other.amount, other.what); }
};

/// Ends, top, exact points, symmetry, given displacements.
[[nodiscard]] Miss missed_conditions(const Solved& solved);
/// Jumps of the continuous derivatives of these orders, by their peaks beside the joint.
[[nodiscard]] Miss largest_jump(const Solved& solved, int first_order, int last_order);
[[nodiscard]] Miss passed_caps(const Solved& solved);
/// Of the cam and of an elastic follower.
[[nodiscard]] Miss passed_follower_limits(const Solved& solved);

/// Nothing: the relation says nothing about this scene. Empty: it holds. Else what is wrong.
using Finding = std::optional<std::string>;
inline const Finding no_case = std::nullopt;
inline const Finding holds = std::string();

/// A trial as a comparison sees it.
class Trial {
 public:
    virtual ~Trial() = default;
    [[nodiscard]] virtual const Solved& base() const = 0;
    virtual Draw& draw() = 0;
    /// Solves a changed scene; every check looks at the result.
    virtual Solved solve(const SceneText& scene) = 0;

    [[nodiscard]] const SceneText& text() const { return base().text; }
    [[nodiscard]] const SceneNumbers& numbers() const { return base().numbers; }
    [[nodiscard]] bool has_cam() const { return !base().numbers.follower.empty(); }
};

struct Check {
    const char* name;
    const char* says;
    Finding (*of)(const Solved& solved);
};

struct Comparison {
    const char* name;
    const char* says;
    Finding (*of)(Trial& trial);
};

[[nodiscard]] std::span<const Check> checks();
[[nodiscard]] std::span<const Comparison> comparisons();

/// The larger one of |value| and 1: what errors of objectives are measured by.
[[nodiscard]] double scale_of(double value);

/// Every motion of `tight` is one of `loose` as well, and `factor` times its objective is what it has there.
[[nodiscard]] Finding never_worse(const Outcome& loose, const Outcome& tight, double factor = 1.0);
/// Both scenes say the same.
[[nodiscard]] Finding same_answer(const Outcome& left, const Outcome& right, double factor = 1.0);
/// Why an outcome that ran out of time is no witness.
[[nodiscard]] bool ended_early(const Outcome& outcome);

// The checks.
[[nodiscard]] Finding check_accepted(const Solved& solved);
[[nodiscard]] Finding check_written(const Solved& solved);
[[nodiscard]] Finding check_json(const Solved& solved);
[[nodiscard]] Finding check_time(const Solved& solved);
[[nodiscard]] Finding check_peaks(const Solved& solved);
[[nodiscard]] Finding check_objective(const Solved& solved);
[[nodiscard]] Finding check_conditions(const Solved& solved);
[[nodiscard]] Finding check_joints(const Solved& solved);
[[nodiscard]] Finding check_caps(const Solved& solved);
[[nodiscard]] Finding check_bound(const Solved& solved);
[[nodiscard]] Finding check_proof(const Solved& solved);
[[nodiscard]] Finding check_infeasibility(const Solved& solved);
[[nodiscard]] Finding check_cam_figures(const Solved& solved);
[[nodiscard]] Finding check_cam_limits(const Solved& solved);
[[nodiscard]] Finding check_reported_limits(const Solved& solved);
[[nodiscard]] Finding check_dimensions(const Solved& solved);

// The comparisons.
[[nodiscard]] Finding compare_refined(Trial& trial);
[[nodiscard]] Finding compare_smoothness(Trial& trial);
[[nodiscard]] Finding compare_freed(Trial& trial);
[[nodiscard]] Finding compare_hurried(Trial& trial);
[[nodiscard]] Finding compare_dropped_condition(Trial& trial);
[[nodiscard]] Finding compare_loosened(Trial& trial);
[[nodiscard]] Finding compare_tightened(Trial& trial);
[[nodiscard]] Finding compare_own_figures_as_caps(Trial& trial);
[[nodiscard]] Finding compare_least_caps(Trial& trial);
[[nodiscard]] Finding compare_lift(Trial& trial);
[[nodiscard]] Finding compare_angle(Trial& trial);
[[nodiscard]] Finding compare_units(Trial& trial);
[[nodiscard]] Finding compare_weights(Trial& trial);
[[nodiscard]] Finding compare_references(Trial& trial);
[[nodiscard]] Finding compare_speed(Trial& trial);
[[nodiscard]] Finding compare_reversed(Trial& trial);
[[nodiscard]] Finding compare_mirrored(Trial& trial);
[[nodiscard]] Finding compare_solvers(Trial& trial);
[[nodiscard]] Finding compare_designs(Trial& trial);
[[nodiscard]] Finding compare_repeated(Trial& trial);
[[nodiscard]] Finding compare_relaxed(Trial& trial);
[[nodiscard]] Finding compare_dimension_ranges(Trial& trial);

}  // namespace camopt::soak
