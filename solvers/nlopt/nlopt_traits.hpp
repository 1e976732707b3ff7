// SPDX-License-Identifier: MIT
// Properties of the algorithms of NLopt, without a header of NLopt: the registry describes them in builds
// without it too. Private to this folder.
#pragma once

#include "solvers/nlopt/nlopt_method.hpp"

namespace camopt {

struct NloptTraits {
    const char* name = nullptr;
    const char* text = nullptr;
    bool needs_derivatives = true;
    bool takes_equalities = true;
    /// Runs from where the run before ended.
    int restarts = 20;
    bool is_global = false;     ///< needs a finite box, takes random numbers
    bool is_augmented = false;  ///< an outer loop on multipliers around an unconstrained method
};

[[nodiscard]] const NloptTraits& traits_of(NloptMethod method);

/// Relative steps that end a run, in tolerances: a short step of SLSQP on a linear program says little about
/// the distance to the optimum.
inline constexpr double step_tolerance = 1e-3;

/// Defaults of options that differ between the algorithms of NLopt.
inline constexpr double default_search_radius = 10.0;
inline constexpr int default_dual_evaluations = 2000;
inline constexpr int default_inner_evaluations = 2000;

}  // namespace camopt
