// SPDX-License-Identifier: MIT
#include "output/peak_comparison.hpp"

#include "output/display_scale.hpp"

namespace camopt {

namespace {

/// The law's own peak where there is a law, else the number the objective divides by (0: not in use).
std::optional<double> reference_value(const ReferenceMotion& reference, double of_law, double divisor) {
    if (!reference.title.empty()) return of_law;
    if (divisor > 0.0) return divisor;
    return std::nullopt;
}

}  // namespace

std::vector<PeakRow> peak_comparison(const Solution& solution, const ReferenceMotion& reference) {
    const Peaks& peaks = solution.peaks;
    const Peaks& motion = solution.motion_peaks;
    const Peaks& law = reference.peaks;
    const Peaks& divisor = solution.reference_peaks;
    const LimitCurve limit = solution.any_curve_limit.value_or(LimitCurve{});
    const DerivativeScale scale = display_scale(solution.scene.motion).by_angle;
    return {
        {"velocity", "V", peaks.velocity, motion.velocity,
         reference_value(reference, law.velocity.value, divisor.velocity.value), limit.velocity,
         scale.factor[1], scale.unit[1]},
        {"acceleration", "A", peaks.acceleration, motion.acceleration,
         reference_value(reference, law.acceleration.value, divisor.acceleration.value), limit.acceleration,
         scale.factor[2], scale.unit[2]},
        {"jerk", "J", peaks.jerk, motion.jerk, reference_value(reference, law.jerk.value, divisor.jerk.value),
         limit.jerk, scale.factor[3], scale.unit[3]},
        {"torque", "Q", peaks.torque, motion.torque,
         reference_value(reference, law.torque.value, divisor.torque.value), std::nullopt, 0.0, ""},
    };
}

std::string reference_title(const ReferenceMotion& reference) {
    return reference.title.empty() ? "reference" : reference.title;
}

}  // namespace camopt
