// SPDX-License-Identifier: MIT
#include "objectives/scene_model.hpp"

#include "core/errors.hpp"
#include "motions/law_catalogue.hpp"
#include "objectives/peak_rule.hpp"

#include <fmt/format.h>

#include <cmath>

namespace camopt {

namespace {

constexpr std::array<const char*, 4> derivative_names = {"displacement", "velocity", "acceleration", "jerk"};
// Units for peaks that are capped but have no finite reference of their own: those of the modified sine.
constexpr const char* fallback_law = "modified_sine";

struct WeightedPeak {
    Parameter::Kind kind;
    int order;
    double weight;
    const std::optional<PeakLimit>* limit;
    double reference;
};

double finite_or(double value, double fallback) {
    return std::isfinite(value) && value > 0.0 ? value : fallback;
}

std::vector<WeightedPeak> weighted_peaks(const Scene& scene, const Peaks& reference) {
    static const std::optional<PeakLimit> none;
    const ObjectiveSpec& objective = scene.objective;
    const LimitSpec& limits = scene.limits;
    const Peaks fallback = make_law(fallback_law)->peaks();
    using Kind = Parameter::Kind;
    return {
        {Kind::peak, 1, objective.velocity, &limits.velocity,
         finite_or(reference.velocity.value, fallback.velocity.value)},
        {Kind::peak, 2, objective.acceleration, &limits.acceleration,
         finite_or(reference.acceleration.value, fallback.acceleration.value)},
        {Kind::peak, 3, objective.jerk, &limits.jerk, finite_or(reference.jerk.value, fallback.jerk.value)},
        {Kind::rms, 2, objective.rms_acceleration, &none,
         finite_or(reference.rms_acceleration, fallback.rms_acceleration)},
        {Kind::rms, 3, objective.rms_jerk, &none, finite_or(reference.rms_jerk, fallback.rms_jerk)},
    };
}

void require_finite(const char* name, double weight, double value, const std::string& law) {
    if (weight > 0.0 && !(std::isfinite(value) && value > 0.0)) {
        throw InputError(
            fmt::format("objective.reference: \"{}\" has no finite {}, which has the weight {}; allowed: a "
                        "law whose {} is finite, numbers, or the weight 0",
                        law, name, weight, name));
    }
}

std::vector<PointCondition> scene_conditions(const Scene& scene) {
    std::vector<PointCondition> conditions;
    const MotionSpec& motion = scene.motion;
    const double length = motion.length();
    if (motion.type == MotionType::rr) {
        conditions.push_back({1.0, 0, Side::right, 1.0, "top of the rise: y(1) = 1", false});
        conditions.push_back({1.0, 1, Side::right, 0.0, "top of the rise: y'(1) = 0", false});
    }
    if (scene.spline.end_jerk == EndJerk::zero) {
        conditions.push_back({0.0, 3, Side::right, 0.0, "spline.end_jerk at x = 0", false});
        conditions.push_back(
            {length, 3, Side::left, 0.0, fmt::format("spline.end_jerk at x = {:.6g}", length), false});
    }
    for (std::size_t i = 0; i < motion.via.size(); ++i) {
        const SetPoint& point = motion.via[i];
        const std::array<const std::optional<double>*, 3> values = {&point.displacement, &point.velocity,
                                                                    &point.acceleration};
        for (int order = 0; order < 3; ++order) {
            if (!*values[order]) continue;
            conditions.push_back({point.at, order, point.at < length ? Side::right : Side::left,
                                  **values[order],
                                  fmt::format("motion.via[{}].{} = {:.6g} at x = {:.6g}", i,
                                              derivative_names[order], **values[order], point.at)});
        }
    }
    return conditions;
}

}  // namespace

Peaks reference_peaks(const Scene& scene) {
    const Reference& reference = scene.objective.reference;
    Peaks peaks;
    if (!reference.numeric) peaks = make_law(reference.law)->peaks();
    const auto set = [](double& target, const std::optional<double>& number) {
        if (number) target = *number;
    };
    set(peaks.velocity.value, reference.velocity);
    set(peaks.acceleration.value, reference.acceleration);
    set(peaks.jerk.value, reference.jerk);
    set(peaks.rms_acceleration, reference.rms_acceleration);
    set(peaks.rms_jerk, reference.rms_jerk);
    const ObjectiveSpec& objective = scene.objective;
    const std::string law = reference.numeric ? "numbers" : reference.law;
    require_finite("velocity", objective.velocity, peaks.velocity.value, law);
    require_finite("acceleration", objective.acceleration, peaks.acceleration.value, law);
    require_finite("jerk", objective.jerk, peaks.jerk.value, law);
    require_finite("rms_acceleration", objective.rms_acceleration, peaks.rms_acceleration, law);
    require_finite("rms_jerk", objective.rms_jerk, peaks.rms_jerk, law);
    return peaks;
}

DesignVector scene_design(const Scene& scene, DesignKind kind) {
    const MotionSpec& motion = scene.motion;
    const SplineSpec& spline = scene.spline;
    const bool rise = motion.type == MotionType::drd;
    SplineSpace space =
        spline.breakpoints.empty()
            ? SplineSpace::uniform(spline.degree, spline.smoothness(), spline.segments, motion.length())
            : SplineSpace(spline.degree, spline.smoothness(), spline.breakpoints);
    const Symmetry symmetry = !motion.symmetric ? Symmetry::none : rise ? Symmetry::odd : Symmetry::even;
    return DesignVector::make({std::move(space),
                               kind,
                               {0.0, 0.0, 0.0},
                               {rise ? 1.0 : 0.0, 0.0, 0.0},
                               scene_conditions(scene),
                               symmetry});
}

CamModel scene_model(const Scene& scene, DesignKind kind, const Peaks& reference) {
    CamModel model{scene_design(scene, kind), {}, {}, {}, 0.0, 1.0, {}};
    for (const WeightedPeak& source : weighted_peaks(scene, reference)) {
        if (source.kind == Parameter::Kind::peak) {
            if (source.order < 3) model.entry_scale[source.order] = source.reference;
            if (source.order == 3) model.jerk_reference = source.reference;
        }
        const std::optional<PeakLimit>& limit = *source.limit;
        if (source.weight == 0.0 && !limit) continue;
        const int index = static_cast<int>(model.parameters.size());
        const bool peak = source.kind == Parameter::Kind::peak;
        model.parameters.push_back(
            {fmt::format("{} {}", peak ? "peak" : "rms", derivative_names[source.order]), source.kind,
             source.order, source.reference, source.weight});
        if (!peak) continue;
        for (const int sign : {1, -1}) {
            model.rules.push_back(std::make_shared<PeakRule>(source.order, sign, index, source.reference));
        }
        if (limit) {
            const double upper = limit->normalised / source.reference;
            model.parameter_rows.push_back({limit->key, {index}, {1.0}, upper, true, upper});
        }
    }
    model.entry_scale[0] = 1.0;
    return model;
}

CamModel tie_break_model(const CamModel& model, double energy_weight) {
    CamModel tied = model;
    tied.energy_weight = energy_weight;
    return tied;
}

}  // namespace camopt
