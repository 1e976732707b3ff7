// SPDX-License-Identifier: MIT
#include "objectives/model.hpp"

#include <cmath>

namespace camopt {

std::vector<double> CamModel::mean_square_weights(int order) const {
    std::vector<double> weights;
    for (const StretchScale& scale : stretch_scales) {
        const double factor = std::pow(scale.angle, order) / scale.displacement;
        weights.push_back(factor * factor);
    }
    return weights;
}

}  // namespace camopt
