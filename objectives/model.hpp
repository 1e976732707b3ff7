// SPDX-License-Identifier: MIT
// What is to be minimized and kept, as plain data: parameters, rules, rows on the parameters, and the cost
//
//   f = Σ_p weight_p q_p  +  Σ_k weight_k / 2 (m_k(x) / q_k + q_k)  +  energy weight · e(x).
//
// m_k is a mean square (rms term): at its least over q_k > 0 the bracket is weight_k · sqrt(m_k), jointly
// convex in (x, q_k) with a sparse Hessian. Every quantity is in units of its reference, so f is near one.
#pragma once

#include "core/nlp.hpp"
#include "objectives/point_rule.hpp"
#include "splines/design_vector.hpp"

#include <Eigen/Core>

#include <memory>
#include <string>
#include <vector>

namespace camopt {

/// A variable beside the design vector: a peak, or a root mean square.
struct Parameter {
    enum class Kind { peak, rms };
    std::string name;
    Kind kind = Kind::peak;
    int order = 0;           ///< of the derivative it belongs to
    double reference = 1.0;  ///< the variable is in units of this
    double weight = 0.0;     ///< in the cost
};

/// Σ_p weights_p q_p <= upper.
struct ParameterRow {
    std::string name;
    std::vector<int> parameters;
    std::vector<double> weights;
    double upper = 0.0;
    bool limit = false;
    double scale = 1.0;
};

struct CamModel {
    DesignVector design;
    std::vector<Parameter> parameters;
    std::vector<std::shared_ptr<const PointRule>>
        rules;  ///< immutable, shared by a problem and its tie-break
    std::vector<ParameterRow> parameter_rows;
    /// Weight of the mean square jerk over reference² in the cost: what breaks ties.
    double energy_weight = 0.0;
    double jerk_reference = 1.0;
    /// Typical sizes of y, y', y'': design entries are optimized in these units.
    std::array<double, 3> entry_scale{1.0, 1.0, 1.0};
};

}  // namespace camopt
