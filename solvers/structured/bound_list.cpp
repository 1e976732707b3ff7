// SPDX-License-Identifier: MIT
#include "solvers/structured/bound_list.hpp"

#include <cmath>

namespace camopt::structured {

BoundList::BoundList(const ConvexModel& model) {
    std::vector<double> signs, values;
    const auto add = [&](Eigen::Index index, double lower, double upper) {
        if (std::isfinite(lower)) {
            of.push_back(static_cast<int>(index));
            signs.push_back(1.0);
            values.push_back(lower);
        }
        if (std::isfinite(upper)) {
            of.push_back(static_cast<int>(index));
            signs.push_back(-1.0);
            values.push_back(upper);
        }
    };
    for (Eigen::Index j = 0; j < model.variables(); ++j) add(j, model.x_lower[j], model.x_upper[j]);
    of_variables = static_cast<Eigen::Index>(of.size());
    for (Eigen::Index i = 0; i < model.constraints(); ++i) {
        if (model.is_equality(i))
            equalities.push_back(static_cast<int>(i));
        else
            add(i, model.row_lower[i], model.row_upper[i]);
    }
    const auto count = static_cast<Eigen::Index>(of.size());
    sign = Eigen::Map<const Eigen::VectorXd>(signs.data(), count);
    value = Eigen::Map<const Eigen::VectorXd>(values.data(), count);
}

}  // namespace camopt::structured
