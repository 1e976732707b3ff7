// SPDX-License-Identifier: MIT
#include "objectives/rules/model.hpp"

#include <cmath>

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

}  // namespace camopt
