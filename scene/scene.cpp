// SPDX-License-Identifier: MIT
#include "scene/scene.hpp"

#include "core/text/parsing.hpp"
#include "core/units.hpp"
#include "core/word_of.hpp"

#include <fmt/format.h>

namespace camopt {

Scene::Scene() = default;
Scene::Scene(const Scene& other) = default;
Scene::Scene(Scene&& other) noexcept = default;
Scene& Scene::operator=(const Scene& other) = default;
Scene& Scene::operator=(Scene&& other) noexcept = default;
Scene::~Scene() = default;

const char* name_of(SegmentKind value) {
    return word_of<SegmentKind::spline>(value, {"dwell", "law", "spline"});
}

double as_written(double value) {
    return number_in(fmt::format("{:.15g}", value)).value_or(value);
}

double MotionSpec::unit_angle() const {
    if (type != MotionType::program) return rise;
    for (const ProgramSegment& segment : segments) {
        if (segment.kind == SegmentKind::spline) return segment.angle;
    }
    for (const ProgramSegment& segment : segments) {
        if (segment.kind == SegmentKind::law) return segment.angle;
    }
    return segments.empty() ? rise : segments.front().angle;
}

double MotionSpec::own_place(double master) const {
    constexpr double rounding = 1e-12;  // of a turn: an angle that close to the beginning is there
    const double angle = master - phase, own = angle - units::turn * std::floor(angle / units::turn);
    return own < rounding || own > units::turn * (1.0 - rounding) ? 0.0 : own / unit_angle();
}

bool MotionSpec::prescribed() const {
    return type == MotionType::program && std::ranges::none_of(segments, [](const ProgramSegment& segment) {
               return segment.kind == SegmentKind::spline;
           });
}

std::pair<double, double> MotionSpec::displacements() const {
    if (type != MotionType::program) return {0.0, lift};
    double least = 0.0, most = 0.0;
    for (const ProgramSegment& segment : segments) {
        least = std::min(least, segment.to.value_or(0.0));
        most = std::max(most, segment.to.value_or(0.0));
    }
    return {lift * least, lift * most};
}

double MotionSpec::length() const {
    if (type == MotionType::drd) return 1.0;
    if (type == MotionType::rr) return 1.0 + return_angle.value_or(rise) / rise;
    double total = 0.0;
    for (const ProgramSegment& segment : segments) total += segment.angle;
    return total / unit_angle();
}

std::vector<LoadSpeed> Scene::load_speeds() const {
    const ForceSpec& load = forces.value();
    const double speed = motion.speed.value(), rpm = units::revolution_per_minute;
    std::vector<LoadSpeed> all = {{speed * speed, speed}};
    if (load.mass == 0.0 && load.damping == 0.0) return all;
    const bool presses = std::ranges::any_of(spring_numbers, [&](const SpringNumber& number) {
        const auto& range = load.*number.range;
        return (range ? (*range)[1] : load.*number.number) > 0.0;
    });
    const auto [low, high] =
        load.speed_range.value_or(std::array{presses && limits.hertz_pressure_max ? 0.0 : speed, speed});
    for (const double end : {low, high})
        if (end != speed) all.push_back({end * end, end, fmt::format("at {:.6g} rpm", end / rpm)});
    if (load.damping > 0.0 && low < high)
        all.push_back({low * high, 0.5 * (low + high),
                       fmt::format("between {:.6g} and {:.6g} rpm", low / rpm, high / rpm), false});
    return all;
}

double Scene::motion_error(int order) const {
    if (!tolerance) return 0.0;
    return tolerance->of_motion(static_cast<std::size_t>(order)) * std::pow(motion.unit_angle(), order) /
           motion.lift;
}

int Scene::nearest_harmonic() const {
    const double ratio = forces.value().spring_frequency.value() / motion.speed.value();
    constexpr double beyond = 2.0 * most_harmonic;  // find_fault() refuses it
    return static_cast<int>(std::round(std::clamp(ratio, 1.0, beyond)));
}

int segments_of(const SplineSpec& spline) {
    return spline.breakpoints.empty() ? spline.segments : static_cast<int>(spline.breakpoints.size()) - 1;
}

Scene with_segments(const Scene& scene, int segments) {
    Scene finer = scene;
    finer.spline.segments = segments;
    finer.spline.by_stroke = false;  // a number that is written is uniform
    std::vector<double>& points = finer.spline.breakpoints;
    while (!points.empty() && static_cast<int>(points.size()) - 1 < segments) {
        std::vector<double> halved = {points.front()};
        for (std::size_t i = 1; i < points.size(); ++i) {
            halved.push_back(0.5 * (points[i - 1] + points[i]));
            halved.push_back(points[i]);
        }
        points = std::move(halved);
    }
    return finer;
}

bool searches_angles(const Scene& scene) {
    return std::ranges::any_of(scene.motion.segments,
                               [](const ProgramSegment& segment) { return segment.angle_range.has_value(); });
}

}  // namespace camopt
