// SPDX-License-Identifier: MIT
#include "scene/cam_capabilities.hpp"

namespace camopt {

std::optional<RangeOver> MechanismEnclosures::pressure_over(double limit, int sign,
                                                            const MechanismStateOver& state,
                                                            int station) const {
    const auto numerator = quantity_over(MechanismQuantity::pressure_numerator, state, station);
    const auto denominator = quantity_over(MechanismQuantity::pressure_denominator, state, station);
    if (!numerator || !denominator) return {};
    return sign * std::cos(limit) * *numerator - std::sin(limit) * *denominator;
}

std::optional<RangeOver> MechanismEnclosures::regularity_over(double margin, const MechanismStateOver& state,
                                                              int station) const {
    const auto regularity = quantity_over(MechanismQuantity::regularity, state, station);
    if (!regularity) return {};
    return RangeOver(margin) - *regularity;
}

std::optional<RangeOver> MechanismEnclosures::radius_over(const RangeOver& radius,
                                                          const MechanismStateOver& state,
                                                          int station) const {
    const auto curvature = quantity_over(MechanismQuantity::pitch_curvature, state, station);
    if (!curvature) return {};
    return radius * *curvature - RangeOver(1.0);
}

std::optional<RangeAlong> MechanismEnclosures::pressure_along(double limit, int sign,
                                                              const MechanismStateAlong& state,
                                                              int station) const {
    const auto numerator = quantity_along(MechanismQuantity::pressure_numerator, state, station);
    const auto denominator = quantity_along(MechanismQuantity::pressure_denominator, state, station);
    if (!numerator || !denominator) return {};
    return sign * std::cos(limit) * *numerator - std::sin(limit) * *denominator;
}

}  // namespace camopt
