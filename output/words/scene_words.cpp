// SPDX-License-Identifier: MIT
#include "output/words/scene_words.hpp"

#include "core/units.hpp"
#include "output/words/cam_words.hpp"
#include "output/words/display_scale.hpp"
#include "output/words/key_words.hpp"
#include "output/words/number_text.hpp"
#include "profiles/scene_cam.hpp"
#include "scene/cost_table.hpp"
#include "scene/limit_table.hpp"
#include "scene/written_limits.hpp"

#include <fmt/format.h>

#include <cstddef>

namespace camopt {

namespace {

using units::degree, units::millimetre;

void append(std::string& list, const std::string& part) {
    list += (list.empty() ? "" : ", ") + part;
}

std::string kind_of_motion(const MotionSpec& motion) {
    if (motion.type == MotionType::program) {
        return fmt::format("a program of {} segments over {} deg", motion.segments.size(),
                           short_text(motion.length() * motion.unit_angle() / degree));
    }
    return motion.type == MotionType::drd ? "rise between two dwells"
                                          : "rise and return without a dwell at the top";
}

std::string motion_line(const MotionSpec& motion) {
    const DisplayScale scale = display_scale(motion);
    std::string text = fmt::format("Motion: {}, lift {} {}", kind_of_motion(motion),
                                   short_text(scale.by_angle.factor[0]), scale.by_angle.unit[0]);
    if (motion.type != MotionType::program)
        text += fmt::format(", rise {} deg", short_text(motion.rise / degree));
    if (motion.type == MotionType::rr)
        text +=
            fmt::format(", return {} deg", short_text(motion.return_angle.value_or(motion.rise) / degree));
    if (motion.speed)
        text += fmt::format(", at {} rpm", short_text(*motion.speed / units::revolution_per_minute));
    if (motion.symmetric) text += ", symmetric";
    if (!motion.via.empty()) text += fmt::format(", through {} given points", motion.via.size());
    return text;
}

/// A closed program comes back: what moves last ends at 0 where it does not say so.
std::string end_text(const MotionSpec& motion, std::size_t index) {
    const ProgramSegment& segment = motion.segments[index];
    if (segment.kind == SegmentKind::dwell) return "";
    bool last = motion.closed;
    for (std::size_t i = index + 1; i < motion.segments.size(); ++i)
        last = last && motion.segments[i].kind == SegmentKind::dwell;
    if (!segment.to && !last) return " to where it is best";
    return fmt::format(" to {} of the lift", short_text(segment.to.value_or(0.0)));
}

std::string segment_line(const MotionSpec& motion) {
    std::string text;
    for (std::size_t i = 0; i < motion.segments.size(); ++i) {
        const ProgramSegment& segment = motion.segments[i];
        const std::string kind =
            segment.kind == SegmentKind::law ? words_of(segment.law) : std::string(name_of(segment.kind));
        append(text,
               fmt::format("{} {} deg{}", kind, short_text(segment.angle / degree), end_text(motion, i)));
    }
    return "Segments: " + text;
}

std::string spline_line(const Scene& scene) {
    const SplineSpec& spline = scene.spline;
    const std::size_t segments = spline.breakpoints.empty() ? static_cast<std::size_t>(spline.segments)
                                                            : spline.breakpoints.size() - 1;
    return fmt::format("Spline: degree {}, {} {}segments{}, continuous up to derivative {}{}{}",
                       spline.degree, segments, spline.breakpoints.empty() ? "uniform " : "",
                       scene.motion.type == MotionType::program ? " in each spline segment" : "",
                       spline.smoothness(),
                       spline.end_jerk == EndJerk::zero ? ", zero jerk at the dwells" : "",
                       spline.free_knots ? ", its breakpoints free" : "");
}

/// A unit and its name.
struct ShownIn {
    double unit;
    std::string name;
};

/// As the scene writes it.
ShownIn written_unit(const Dimension& dimension) {
    const KeyWords key = key_words(dimension.key);
    return {dimension.unit, key.unit.empty() ? "mm" : key.unit};
}

std::string range_text(const Dimension& dimension, const ShownIn& in) {
    const auto shown = [&](double value) { return short_text(value / in.unit); };
    if (!dimension.is_variable()) return fmt::format("{} {}", shown(dimension.low), in.name);
    return fmt::format("free from {} to {} {}", shown(dimension.low), shown(dimension.high), in.name);
}

/// Of a follower with a roller: base and roller as one range.
std::optional<Dimension> prime_radius(const Scene& scene) {
    if (!scene.cam || !has_roller(scene.cam->follower)) return {};
    Dimension prime = (*scene.cam)[DimensionIndex::base_radius];
    prime.low += (*scene.cam)[DimensionIndex::roller_radius].low;
    prime.high += (*scene.cam)[DimensionIndex::roller_radius].high;
    return prime;
}

std::string cam_line(const Scene& scene) {
    const MechanismSpec cam = cam_of(scene).value();
    std::string text = fmt::format("Cam: {}", cam_text(cam));
    for (const MechanismDimension& dimension : cam.dimensions) {
        if (dimension.value.key.empty()) continue;  // this variant has no such dimension
        // Of a disk cam as written, of others in the units of their figures.
        const ShownIn in = scene.cam            ? written_unit(dimension.value)
                           : dimension.is_angle ? ShownIn{degree, "deg"}
                                                : ShownIn{millimetre, "mm"};
        append(text, fmt::format("{} {}", words_of(dimension.name), range_text(dimension.value, in)));
    }
    if (const std::optional<Dimension> prime = prime_radius(scene))
        append(text, fmt::format("prime radius {}", range_text(*prime, written_unit(*prime))));
    if (scene.cam && scene.cam->face_half_width)
        append(text, fmt::format("half width of the face {} mm",
                                 short_text(*scene.cam->face_half_width / millimetre)));
    return text;
}

std::string force_line(const Scene& scene) {
    const ForceSpec& forces = *scene.forces;
    const bool swings = scene.motion.lift_is_angle;
    std::string text = fmt::format(
        "Forces: {} {} {}, spring {} {}, preload {} {}", swings ? "inertia" : "mass", short_text(forces.mass),
        swings ? "kg m^2" : "kg", short_text(swings ? forces.spring_rate : forces.spring_rate * millimetre),
        swings ? "N m/rad" : "N/mm", short_text(forces.preload), swings ? "N m" : "N");
    if (forces.contact_width)
        append(text, fmt::format("contact width {} mm", short_text(*forces.contact_width / millimetre)));
    return text;
}

std::string limit_text(const std::string& key, bool least, double given, const std::string& unit) {
    return fmt::format("{} {} {}{}{}", key_words(key).words, least ? ">=" : "<=", short_text(given),
                       unit.empty() ? "" : " ", unit);
}

/// Empty where nothing is limited.
std::string limit_line(const Scene& scene) {
    std::string text;
    for (const PeakLimitRow& row : peak_limit_rows())
        if (const auto& limit = row.in(scene.limits))
            append(text, limit_text(limit->key, false, limit->given, limit->unit) +
                             (limit->unit.empty() ? " (normalised)" : ""));
    for (const LimitRow& row : limit_rows())
        if (const auto& limit = row.in(scene.limits))
            append(text, limit_text(limit->key, row.is_least(), limit->given(), limit->unit));
    return text;
}

std::string reference_text(const Reference& reference) {
    if (!reference.numeric) return fmt::format("that of the law {}", words_of(reference.law));
    std::string numbers;
    for (const CostTerm& term : cost_terms())
        if (const std::optional<double>& value = reference.*term.reference)
            append(numbers, fmt::format("{} {}", words_of(term.name()), short_text(*value)));
    return fmt::format("that of the reference given as numbers{}", numbers.empty() ? "" : ": " + numbers);
}

std::string objective_line(const ObjectiveSpec& objective) {
    std::string terms;
    const auto term = [&](double weight, const std::string& name) {
        if (weight > 0.0)
            terms += fmt::format("{}{} × {}", terms.empty() ? "" : " + ", short_text(weight), name);
    };
    for (const CostTerm& row : cost_terms()) term(row.weight_in(objective), words_of(row.name()));
    const std::size_t of_motion = terms.size();
    for (int i = 0; i < dimension_count; ++i)
        term(objective.dimensions[static_cast<std::size_t>(i)],
             words_of(name_of(static_cast<DimensionIndex>(i))));
    return fmt::format("Objective: the least {}, each divided by {}{}", terms,
                       reference_text(objective.reference),
                       terms.size() > of_motion ? "; dimensions are divided by the lift" : "");
}

}  // namespace

std::vector<std::string> scene_lines(const Scene& given) {
    const Scene scene = with_written_limits(given);
    std::vector<std::string> lines = {motion_line(scene.motion)};
    if (scene.motion.type == MotionType::program) lines.push_back(segment_line(scene.motion));
    lines.push_back(spline_line(scene));
    if (has_cam(scene)) lines.push_back(cam_line(scene));
    if (scene.forces) lines.push_back(force_line(scene));
    if (const std::string limits = limit_line(scene); !limits.empty()) lines.push_back("Limits: " + limits);
    lines.push_back(objective_line(scene.objective));
    return lines;
}

}  // namespace camopt
