// SPDX-License-Identifier: MIT
#include "objectives/rules/model.hpp"

namespace camopt {

double measured_displacement(double displacement) {
    const double size = std::abs(displacement);
    return size < standing_displacement ? 1.0 : size;
}

std::vector<double> CamModel::mean_square_weights(int order) const {
    std::vector<double> weights;
    for (const StretchScale& scale : stretch_scales) {
        const double factor = std::pow(scale.angle, order) / scale.displacement;
        weights.push_back(factor * factor);
    }
    return weights;
}

std::vector<double> CamVariables::dimensions_at(const Eigen::VectorXd& parameters) const {
    std::vector<double> own = cam.dimensions;
    for (const Variable& variable : variables)
        own[variable.dimension] = variable.reference * parameters[variable.parameter];
    return own;
}

std::vector<double> CamVariables::dimensions_for(const Eigen::VectorXd& q) const {
    std::vector<double> own = cam.dimensions;
    const std::size_t count = std::min(variables.size(), static_cast<std::size_t>(q.size()));
    for (std::size_t k = 0; k < count; ++k)
        own[variables[k].dimension] =
            variables[k].reference * q[static_cast<Eigen::Index>(k)] + variables[k].error;
    return own;
}

}  // namespace camopt
