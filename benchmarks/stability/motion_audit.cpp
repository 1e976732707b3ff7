// SPDX-License-Identifier: MIT
#include "benchmarks/stability/motion_audit.hpp"

#include "benchmarks/stability/cam_audit.hpp"
#include "benchmarks/stability/local_polynomial.hpp"
#include "benchmarks/stability/train_audit.hpp"
#include "core/errors.hpp"
#include "profiles/disk/disk_cam.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace camopt::stability {

namespace {

/// One spline of the motion and what its derivatives are divided by.
struct Stretch {
    const SplineCurve* curve = nullptr;
    long double angle = 1, displacement = 1;
};

/// The derivative of an order on a segment over u = (x − x_i) / width.
LocalPolynomial derivative_on(const SplineCurve& curve, int segment, int order) {
    const auto width = static_cast<long double>(curve.space().breakpoints()[segment + 1]) -
                       static_cast<long double>(curve.space().breakpoints()[segment]);
    LocalPolynomial polynomial;
    long double power = 1;
    for (int m = 0; m <= curve.degree(); ++m, power *= width)
        polynomial.push_back(power * static_cast<long double>(curve.pieces()(m, segment)));
    for (int r = 0; r < order; ++r) {
        polynomial = derivative_of(polynomial);
        for (long double& coefficient : polynomial) coefficient /= width;
    }
    return polynomial;
}

class Audit {
 public:
    explicit Audit(const Solution& solution) : solution_(solution), scene_(solution.scene) {
        if (solution.curve) {
            stretches_.push_back({&*solution.curve, 1, 1});
        } else {
            for (const SegmentReport& segment : solution.segments) add_segment(segment);
        }
        find_peaks();
    }

    MotionAudit result() {
        check_joints();
        if (solution_.curve) {
            check_ends();
            check_exact_points();
            check_symmetry();
        } else {
            check_program();
        }
        check_caps();
        if (solution_.train) check_train();
        if (solution_.cam && solution_.cam->cam.formulas->is_direct()) {
            for (const BrokenLimit& limit : broken_limits(solution_)) note(limit.amount, limit.name);
        }
        report_.objective = objective();
        return report_;
    }

 private:
    void add_segment(const SegmentReport& segment) {
        if (!segment.curve) return;
        const double rise = std::abs(segment.to - segment.from);
        stretches_.push_back({&*segment.curve, segment.end - segment.begin, rise > 0.0 ? rise : 1.0});
    }

    void note(long double amount, const std::string& what) {
        if (std::isnan(amount)) amount = HUGE_VALL;
        if (amount <= report_.violation) return;
        report_.violation = amount;
        report_.worst = what;
    }

    void find_peaks() {
        for (const Stretch& stretch : stretches_) {
            for (int segment = 0; segment < stretch.curve->segments(); ++segment) {
                long double factor = 1 / stretch.displacement;
                for (int order = 1; order <= 3; ++order) {
                    factor *= stretch.angle;
                    const long double peak = largest_magnitude(derivative_on(*stretch.curve, segment, order));
                    peaks_[order] = std::max(peaks_[order], factor * peak);
                }
            }
        }
        report_.velocity = peaks_[1];
        report_.acceleration = peaks_[2];
        report_.jerk = peaks_[3];
    }

    /// Jumps of the continuous derivatives, by the size of the derivative itself.
    void check_joints() {
        for (const Stretch& stretch : stretches_) {
            const SplineCurve& curve = *stretch.curve;
            long double factor = 1 / stretch.displacement;
            for (int order = 0; order <= std::min(curve.continuity(), 3); ++order) {
                for (int joint = 1; joint < curve.segments(); ++joint) {
                    const long double left = value_at(derivative_on(curve, joint - 1, order), 1);
                    const long double right = value_at(derivative_on(curve, joint, order), 0);
                    const long double jump = factor * std::abs(left - right) / peaks_[order];
                    if (order < 3)
                        note(jump, fmt::format("joint {}, order {}", joint, order));
                    else
                        report_.jerk_jump = std::max(report_.jerk_jump, jump);
                }
                factor *= stretch.angle;
            }
        }
    }

    [[nodiscard]] long double at(double x, int order) const {
        const SplineCurve& curve = *solution_.curve;
        const std::vector<double>& breaks = curve.space().breakpoints();
        const auto above = std::ranges::upper_bound(breaks, x);
        const int segment = std::clamp(static_cast<int>(above - breaks.begin()) - 1, 0, curve.segments() - 1);
        const auto begin = static_cast<long double>(breaks[segment]);
        return value_at(derivative_on(curve, segment, order),
                        (x - begin) / (static_cast<long double>(breaks[segment + 1]) - begin));
    }

    void demand(double x, int order, double value, const char* what) {
        note(std::abs(at(x, order) - value) / peaks_[order], fmt::format("{}, order {}", what, order));
    }

    void check_ends() {
        const bool returns = scene_.motion.type == MotionType::rr;
        const double end = scene_.motion.length();
        for (int order = 0; order <= 2; ++order) {
            demand(0.0, order, 0.0, "begin");
            demand(end, order, order == 0 && !returns ? 1.0 : 0.0, "end");
        }
        if (returns) {
            demand(1.0, 0, 1.0, "top");
            demand(1.0, 1, 0.0, "top");
        }
        if (scene_.spline.end_jerk == EndJerk::zero) {
            demand(0.0, 3, 0.0, "begin");
            demand(end, 3, 0.0, "end");
        }
    }

    void check_exact_points() {
        for (const SetPoint& point : scene_.motion.via) {
            if (point.displacement) demand(point.at, 0, *point.displacement, "exact point");
            if (point.velocity) demand(point.at, 1, *point.velocity, "exact point");
            if (point.acceleration) demand(point.at, 2, *point.acceleration, "exact point");
        }
    }

    void check_symmetry() {
        if (!scene_.motion.symmetric) return;
        const double length = scene_.motion.length();
        for (int k = 0; k <= 64; ++k) {
            const double x = length * k / 128.0;
            const long double left = at(x, 0);
            const long double right = at(length - x, 0);
            note(scene_.motion.type == MotionType::drd ? std::abs(left + right - 1) : std::abs(left - right),
                 "symmetry");
        }
    }

    /// Given displacements, and jumps between the segments of a program.
    void check_program() {
        for (std::size_t k = 0; k < solution_.segments.size(); ++k) {
            const SegmentReport& segment = solution_.segments[k];
            if (const auto to = scene_.motion.segments[k].to)
                note(std::abs(segment.to - *to), fmt::format("segment {}, displacement", k));
            if (k == 0) continue;
            const MotionPoint left = solution_.motion->at(segment.begin, Side::left);
            const MotionPoint right = solution_.motion->at(segment.begin, Side::right);
            for (int order = 0; order <= 2; ++order)
                note(std::abs(left.derivative[order] - right.derivative[order]) / peaks_[order],
                     fmt::format("joint of segments {}, order {}", k, order));
        }
    }

    void check_cap(const std::optional<PeakLimit>& limit, int order, const char* name) {
        // A cap in time holds for the motion itself: of a program its peaks are not those of the segments.
        if (!limit || (limit->physical() && !solution_.curve)) return;
        note(peaks_[order] / limit->normalised - 1, name);
    }

    void check_caps() {
        check_cap(scene_.limits.velocity, 1, "velocity cap");
        check_cap(scene_.limits.acceleration, 2, "acceleration cap");
        check_cap(scene_.limits.jerk, 3, "jerk cap");
    }

    void check_train() {
        train_ = train_audit(solution_);
        if (const auto& limit = scene_.limits.residual)
            note(train_.residual * scene_.motion.lift / limit->value - 1, "residual");
        if (const auto& limit = scene_.limits.dynamic_contact_force_min)
            note((limit->value - train_.least_force) / scene_.dynamics->preload, "dynamic contact force");
    }

    /// √(∫ (y^{(r)})² dx / length): Gauss with four points is exact to degree 7.
    [[nodiscard]] long double root_mean_square(int order) const {
        constexpr std::array<long double, 2> node = {0.861136311594052575224L, 0.339981043584856264803L};
        constexpr std::array<long double, 2> weight = {0.347854845137453857373L, 0.652145154862546142627L};
        long double sum = 0;
        long double length = 0;
        const SplineCurve& curve = *solution_.curve;
        for (int segment = 0; segment < curve.segments(); ++segment) {
            const LocalPolynomial polynomial = derivative_on(curve, segment, order);
            const auto width = static_cast<long double>(curve.space().width(segment));
            length += width;
            for (int k = 0; k < 2; ++k) {
                const long double below = value_at(polynomial, (1 - node[k]) / 2);
                const long double above = value_at(polynomial, (1 + node[k]) / 2);
                sum += width * weight[k] / 2 * (below * below + above * above);
            }
        }
        return std::sqrt(sum / length);
    }

    [[nodiscard]] long double objective() const {
        const ObjectiveSpec& weights = scene_.objective;
        const Peaks& reference = solution_.reference_peaks;
        long double sum = 0;
        const auto add = [&](double weight, long double figure, double by) {
            if (weight > 0.0) sum += weight * figure / by;
        };
        add(weights.velocity, peaks_[1], reference.velocity.value);
        add(weights.acceleration, peaks_[2], reference.acceleration.value);
        add(weights.jerk, peaks_[3], reference.jerk.value);
        if (weights.rms_acceleration > 0.0)
            add(weights.rms_acceleration, root_mean_square(2), reference.rms_acceleration);
        if (weights.rms_jerk > 0.0) add(weights.rms_jerk, root_mean_square(3), reference.rms_jerk);
        if (weights.residual > 0.0)
            add(weights.residual, train_.residual, scene_.objective.reference.residual.value());
        const auto disk = solution_.cam ? disk_cam(solution_.cam->cam) : std::nullopt;
        if (!disk) return sum;
        const DiskCam& cam = *disk;
        const auto dimension = [&](DimensionIndex index) {
            return cam.dimensions[static_cast<std::size_t>(index)];
        };
        const double by = is_oscillating(cam.follower)
                              ? scene_.motion.lift * dimension(DimensionIndex::center_distance)
                              : scene_.motion.lift;
        for (int k = 0; k < dimension_count; ++k)
            add(weights.dimensions[k], std::abs(static_cast<long double>(cam.dimensions[k])), by);
        return sum;
    }

    const Solution& solution_;
    const Scene& scene_;
    std::vector<Stretch> stretches_;
    std::array<long double, 4> peaks_{1, 0, 0, 0};
    TrainAudit train_;
    MotionAudit report_;
};

}  // namespace

MotionAudit audit(const Solution& solution) {
    if (!solution.motion) throw InputError("audit: found no motion; allowed: a solution with one");
    return Audit(solution).result();
}

}  // namespace camopt::stability
