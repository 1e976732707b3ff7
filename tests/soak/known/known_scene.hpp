// SPDX-License-Identifier: MIT
// Random scenes whose answer is known before they are solved.
//
// A motion y₀ of the scene's space is drawn. Its peaks, and rows at angles of our choice (limits, corridors,
// set points), are written so that y₀ satisfies them, many with equality. Multipliers λ >= 0 of these rows
// (free in sign at set points) with
//     Σ λ_i a_i = 0 on all changes of the motion          (a_i: gradients of peaks and active rows)
// are found by non-negative least squares (nonnegative.hpp), and the sums of those of the peaks become the
// weights of the objective. Then weak duality says that no motion is better than y₀: for every motion y that
// satisfies the scene f(y) >= f(y₀) + Σ λ_i a_i (y − y₀) = f(y₀). Where the combination contains no peak, the
// rows are Farkas multipliers: one bound moved by ε makes the scene infeasible by λ ε.
//
// A machine is several motions at once, and clearances are rows that have a gradient in two or more of them.
#pragma once

#include "tests/soak/draw.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace camopt::soak {

struct KnownAnswer {
    bool feasible = true;
    double objective = 0.0;  ///< of the optimum, where there is one
    double error = 0.0;      ///< of this number: rounding of all that the scene says, and of the multipliers
    /// Of a scene that was moved: how far the optimum may lie below and above `objective`. Infinity above:
    /// there may be none.
    double below = 0.0, above = 0.0;
    /// Σ |multiplier| · size of its row / objective: the relative change of the answer by one of the scene's
    /// numbers.
    double condition = 1.0;
    /// How far a relative change by 1 of every number may raise the optimum; below 0: not known.
    double growth = -1.0;
    double room = 0.0;  ///< the same of the active rows alone, in their sizes
    /// Infeasible scenes: least violation, in sizes of the rows, that any motion has. Feasible ones: how far
    /// the limits may be off a scene without a motion, where that is known.
    double margin = 0.0;
};

/// The scene of one axis of a machine.
struct AxisFile {
    std::string name;  ///< "first.toml", as the machine names it
    std::string text;
};

struct KnownScene {
    std::string kind;                 ///< class of the table: "rise", …
    std::string change;               ///< what was moved (edges); empty: nothing
    std::string text;                 ///< TOML; of a machine the file [machine]
    std::vector<AxisFile> axes = {};  ///< of a machine
    KnownAnswer answer = {};
};

struct KnownSettings {
    std::uint64_t seed = 1;
    int kind = -1;       ///< one class; −1: all
    bool edges = false;  ///< scenes moved by round-off, near impossible, in extreme units
};

/// The same number makes the same scene.
[[nodiscard]] KnownScene drawn_known_scene(const KnownSettings& settings, long number);

}  // namespace camopt::soak
