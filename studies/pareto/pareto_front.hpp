// SPDX-License-Identifier: MIT
// The Pareto front of two figures of a scene, traced by limits instead of weights: also the points that no
// weight finds.
//
// Between the ends every point is   min p + ε q   subject to   q <= cap   (or the two exchanged), p and q in
// units of the scene's references, everything the scene demands kept. ε (lexicographic_weight) makes the
// point a strict one: q is the least among the least p. So the front ends where one reference unit of one
// goal would buy less than ε of the other.
//
// Other figures count by their limits alone, and by the tie-break among motions that are equal in both goals.
// With keep_weights the scene's other weights stay in force too: the first goal is then the scene's whole
// objective but for the second goal's term, and the front is one of that sum against the second.
//
// The ends are the least of either goal. Where the other goal would then be more than cut_off times its own
// least (velocity → 1 takes infinite acceleration; a spline takes as much as its breakpoints allow) the front
// ends there instead, by a cap, and says so.
//
// Points are spaced evenly along the front (front_chain.hpp): the longest pieces are halved until the shape
// is known, then points are put at equal distances and corrected. All solves are kept: those between the
// spaced points have no place. The order of the solves, hence every number, is fixed by the request alone; a
// run that goes on from known rows solves what they lack.
#pragma once

#include "studies/pareto/sweep_front.hpp"
#include "studies/sweep/sweep_plan.hpp"

namespace camopt {

/// Weight of the capped goal: small enough to leave the other its optimum, large enough to be seen by a solve
/// of tolerance 1e-9 (which then knows that goal to about 1e-5 of its reference at the ends).
inline constexpr double lexicographic_weight = 1e-4;

/// A slip of the keyboard is told before it takes a day.
inline constexpr int most_front_points = 10'000;
inline constexpr double least_front_spacing = 2.0 / most_front_points;

struct FrontRequest {
    std::array<FrontGoal, 2> goals{FrontFigure::velocity, FrontFigure::acceleration};
    int points = 21;                ///< spaced ones, both ends included, >= 2
    std::optional<double> spacing;  ///< instead: as many as keep neighbours this close, in (0, 1]
    double evenness = 0.05;         ///< a gap may differ by this part from their mean, in (0, 1)
    double cut_off = 10.0;          ///< > 1
    bool keep_weights = false;

    /// Throws InputError for a number out of its range, equal goals, or two that cannot be capped.
    void validate(const Scene& scene) const;
};

enum class FrontEnd {
    none,      ///< a point between the ends
    attained,  ///< the least of one goal, and the least of the other there
    cut_off,   ///< the front goes on beyond
    beyond     ///< the least of one goal, beyond the cut-off: no part of the front
};

struct FrontPoint {
    SweepRow row;    ///< its solve; numbers are in the order of the solves, from 0
    int place = -1;  ///< among the spaced points, from the end of least first goal; -1: none
    FrontEnd end = FrontEnd::none;
    int minimized = 0;          ///< which goal was minimized
    std::optional<double> cap;  ///< on the other one
    /// Of both goals; with keep_weights the first is that sum. 0 where there is no motion.
    std::array<double, 2> value{};
    double arc = 0.0;        ///< along the front from the end of least first goal, in the unit box
    bool dominated = false;  ///< by another point: only where the scene is not convex

    [[nodiscard]] bool is_feasible() const { return row.is_feasible(); }
};
[[nodiscard]] const char* name_of(FrontEnd value);

/// Gaps between neighbouring spaced points along the front, in the unit box.
struct FrontSpacing {
    double least = 0.0, mean = 0.0, most = 0.0;
    double length = 0.0;  ///< of the whole front
    int jumps = 0;        ///< where the front is not connected
};

struct ParetoFront {
    FrontRequest request;
    SweepColumns columns;            ///< of the rows; keys: the weights that matter, and the caps
    std::vector<FrontPoint> points;  ///< feasible ones by ascending first goal, then the others
    FrontSpacing spacing;
    bool even = false;      ///< the spacing keeps what was asked
    bool complete = false;  ///< not stopped, both ends found
};

/// Throws as solve() does; what a solve comes to is a verdict in its point. Stopped by the control it returns
/// what it has. run.row_done sees the rows in the order of the solves, before their places are known.
[[nodiscard]] ParetoFront pareto_front(const Scene& scene, const FrontRequest& request,
                                       const RowRun& run = {});

/// Its rows by number, with their places; on_front: what no other point dominates.
[[nodiscard]] SweepTable front_table(const ParetoFront& front);

}  // namespace camopt
