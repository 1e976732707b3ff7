// SPDX-License-Identifier: MIT
#include "objectives/rules/model.hpp"

namespace camopt {

double measured_displacement(double displacement) {
    const double size = std::abs(displacement);
    return size < standing_displacement ? 1.0 : size;
}

std::array<double, 2> CamModel::seen_range(const PlacedRule& rule, std::array<double, 2> y,
                                           const std::array<double, 2>& sup) const {
    if (!sees_other(rule)) return y;
    const auto& [by_y, by_slope, by_bend] = to_cam.weights;
    double beside = 0.0;  // 0 · ∞ is 0 here
    if (by_slope != 0.0) beside += std::abs(by_slope) * sup[0];
    if (by_bend != 0.0) beside += std::abs(by_bend) * sup[1];
    return {by_y * y[0] - beside, by_y * y[1] + beside};
}

std::array<double, 2> CamModel::expected_range(const PlacedRule& rule) const {
    return seen_range(rule, {least_displacement, most_displacement}, {entry_scale[1], entry_scale[2]});
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
