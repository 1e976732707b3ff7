// SPDX-License-Identifier: MIT
#include "output/reference_motion.hpp"

#include "motions/law_catalogue.hpp"
#include "output/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace camopt {

namespace {

/// y(x) = law(x) up to x = 1, then law(t) with t = (1 + ratio − x) / ratio.
class RiseAndReturn final : public Motion {
 public:
    RiseAndReturn(std::unique_ptr<Motion> law, double ratio) : law_(std::move(law)), ratio_(ratio) {}

    [[nodiscard]] double begin() const override { return 0.0; }
    [[nodiscard]] double end() const override { return 1.0 + ratio_; }

    [[nodiscard]] MotionPoint at(double x, Side side) const override {
        if (x < 1.0 || (x == 1.0 && side == Side::left)) return law_->at(x, side);
        const double t = std::clamp((end() - x) / ratio_, 0.0, 1.0);
        MotionPoint point = law_->at(t, side == Side::left ? Side::right : Side::left);
        point.x = x;
        double factor = 1.0;
        for (double& value : point.derivative) {
            value *= factor;
            factor *= -1.0 / ratio_;
        }
        return point;
    }

    [[nodiscard]] std::vector<double> breakpoints() const override {
        std::vector<double> places = law_->breakpoints();
        const std::vector<double> rise = places;
        for (auto place = rise.rbegin() + 1; place != rise.rend(); ++place)
            places.push_back(*place == 0.0 ? end() : end() - ratio_ * *place);
        return places;
    }

 private:
    std::unique_ptr<Motion> law_;
    double ratio_;
};

/// A shorter return has the larger peaks.
Peaks with_return(Peaks peaks, double ratio) {
    const auto enlarge = [&](Extremum& peak, int order) {
        const double factor = std::pow(1.0 / ratio, order);
        if (factor <= 1.0) return;
        peak.value *= factor;
        peak.at = 1.0 + ratio - ratio * peak.at;
        peak.side = peak.side == Side::left ? Side::right : Side::left;
    };
    enlarge(peaks.velocity, 1);
    enlarge(peaks.acceleration, 2);
    enlarge(peaks.jerk, 3);
    enlarge(peaks.torque, 3);
    const auto mean = [&](double rms, int order) {
        return rms * std::sqrt((1.0 + std::pow(ratio, 1 - 2 * order)) / (1.0 + ratio));
    };
    peaks.rms_velocity = mean(peaks.rms_velocity, 1);
    peaks.rms_acceleration = mean(peaks.rms_acceleration, 2);
    peaks.rms_jerk = mean(peaks.rms_jerk, 3);
    return peaks;
}

}  // namespace

ReferenceMotion reference_motion(const Scene& scene) {
    ReferenceMotion reference;
    if (scene.objective.reference.numeric) return reference;
    std::unique_ptr<Law> law = make_law(scene.objective.reference.law);
    reference.title = words_of(law->key());
    reference.peaks = law->peaks();
    if (scene.motion.type == MotionType::program) return reference;
    reference.motion = std::move(law);
    if (scene.motion.type == MotionType::rr) {
        const double ratio = scene.motion.length() - 1.0;
        reference.peaks = with_return(reference.peaks, ratio);
        reference.motion = std::make_unique<RiseAndReturn>(std::move(reference.motion), ratio);
    }
    return reference;
}

}  // namespace camopt
