// SPDX-License-Identifier: MIT
#include "output/words/tables/peak_comparison.hpp"

#include "scene/limit_table.hpp"
#include "scene/motion/set_points.hpp"

#include <fmt/format.h>

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
    const ShownUnits shown = shown_units(solution.scene);
    return {
        {"velocity", "V", peaks.velocity, motion.velocity,
         reference_value(reference, law.velocity.value, divisor.velocity.value), limit.velocity,
         shown.motion[1], signed_peaks(solution, 1)},
        {"acceleration", "A", peaks.acceleration, motion.acceleration,
         reference_value(reference, law.acceleration.value, divisor.acceleration.value), limit.acceleration,
         shown.motion[2], signed_peaks(solution, 2)},
        {"jerk", "J", peaks.jerk, motion.jerk, reference_value(reference, law.jerk.value, divisor.jerk.value),
         limit.jerk, shown.motion[3], signed_peaks(solution, 3)},
        {"inertia torque", "Q", peaks.torque, motion.torque,
         reference_value(reference, law.torque.value, divisor.torque.value), std::nullopt, std::nullopt},
    };
}

std::string PeakRow::first_text(int digits) const {
    return shown ? shown->first.normalised_text(sides.largest.value, digits) : std::string{};
}

std::string PeakRow::beside_text(int digits) const {
    return shown && shown->beside ? shown->beside->normalised_text(sides.largest.value, digits)
                                  : std::string{};
}

std::string PeakRow::change() const {
    return reference ? change_text(optimum.value, *reference) : "–";
}

std::string PeakRow::opposite_text(int digits) const {
    return shown && sides.opposite ? shown->first.normalised_text(sides.opposite->value, digits)
                                   : std::string{};
}

std::string left_out_of_any_curve(const Scene& scene) {
    const bool cam = limits_cam(scene.limits) || (scene.cam && scene.cam->face_half_width);
    std::string text = cam ? "limits of the cam" : "";
    if (!placed_points(scene.motion).empty()) text += text.empty() ? "via points" : " and via points";
    return text;
}

std::string any_curve_title(const Scene& scene) {
    const std::string left_out = left_out_of_any_curve(scene);
    return left_out.empty() ? "limit of any curve"
                            : fmt::format("limit of any curve ({} left out)", left_out);
}

std::string reference_title(const ReferenceMotion& reference) {
    return reference.title.empty() ? "reference" : reference.title;
}

}  // namespace camopt
