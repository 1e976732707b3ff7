// SPDX-License-Identifier: MIT
// What a design vector (splines/design_vector.hpp) shall be: its form, the ends, exact points, symmetry; and
// how points can conflict.
#pragma once

#include "core/text/names.hpp"
#include "splines/affine_row.hpp"
#include "splines/curve.hpp"

namespace camopt {

/// y^{(order)}(x) = value, as seen from `side`.
struct PointCondition {
    double at = 0.0;
    int order = 0;
    Side side = Side::right;
    double value = 0.0;
    std::string name;
    bool asked = true;  ///< by the user: reported when it is redundant
    /// One of several that state one condition together: not reported when it follows from the others.
    bool in_group = false;
};

/// y^{(r)} = 0 at x for r = 3 … rest: what rest of that order adds to a state at rest.
[[nodiscard]] std::vector<PointCondition> rest_conditions(double x, Side side, int rest);

/// odd: y(x) + y(mirror of x) = y_begin + y_end (a rise);  even: y(x) = y(mirror of x) (a rise and return).
enum class Symmetry { none, odd, even };

struct DesignRequest {
    SplineSpace space;
    DesignKind kind = DesignKind::states;    ///< not automatic
    std::array<double, 3> begin_state{};     ///< y, y', y'' at the first breakpoint
    std::array<double, 3> end_state{};       ///< and at the last
    std::vector<PointCondition> conditions;  ///< further exact points
    Symmetry symmetry = Symmetry::none;
};

/// One row of a contradiction, over the free control points c: weights · c + offset = 0.
struct ConflictRow {
    std::string name;
    AffineRow row;
    double multiplier = 0.0;
};

/// A redundant or contradictory condition.
struct ConditionConflict {
    std::string condition;
    std::vector<std::string> others;
    /// Of a contradiction: rows and multipliers with Σ multiplier · weights = 0 and Σ multiplier · offset > 0
    /// (Farkas), so that they cannot all hold. Empty for a redundant condition.
    std::vector<ConflictRow> rows;
};

}  // namespace camopt
