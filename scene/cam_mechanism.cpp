// SPDX-License-Identifier: MIT
#include "scene/cam_mechanism.hpp"

#include <fmt/format.h>

#include <cmath>

namespace camopt {

MechanismValue combined(double factor_a, const MechanismValue& a, double factor_b, const MechanismValue& b) {
    return {factor_a * a.value + factor_b * b.value, factor_a * a.gradient + factor_b * b.gradient,
            factor_a * a.hessian + factor_b * b.hessian, factor_a * a.by_angle + factor_b * b.by_angle};
}

MechanismValue CamMechanism::pressure_excess(double limit, int sign, const MechanismState& state, int station,
                                             std::span<const int> active) const {
    return combined(sign * std::cos(limit),
                    quantity(MechanismQuantity::pressure_numerator, state, station, active), -std::sin(limit),
                    quantity(MechanismQuantity::pressure_denominator, state, station, active));
}

std::optional<RangeAlong> CamMechanism::pressure_along(double limit, int sign,
                                                       const MechanismStateAlong& state, int station) const {
    const auto numerator = quantity_along(MechanismQuantity::pressure_numerator, state, station);
    const auto denominator = quantity_along(MechanismQuantity::pressure_denominator, state, station);
    if (!numerator || !denominator) return {};
    return sign * std::cos(limit) * *numerator - std::sin(limit) * *denominator;
}

std::string CamMechanism::undercut_words() const {
    return "the cam crosses itself there, the part that remains does not lead the roller as designed. A "
           "smaller "
           "roller or a cam's centre farther from it helps";
}

std::string CamMechanism::check_words(int points) const {
    return fmt::format("lever and linkage run over {} points of the cam", points);
}

}  // namespace camopt
