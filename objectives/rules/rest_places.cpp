// SPDX-License-Identifier: MIT
#include "objectives/rules/rest_places.hpp"

#include "motions/laws/law_catalogue.hpp"
#include "scene/motion/set_points.hpp"

#include <algorithm>
#include <cmath>

namespace camopt {

namespace {

constexpr double at_rest = 1e-9;  // of a law's mean velocity: less is round-off

void add_program(std::vector<double>& places, const Scene& scene) {
    const MotionSpec& motion = scene.motion;
    const double unit = motion.unit_angle();
    double angle = 0.0;
    for (std::size_t i = 0; i < motion.segments.size(); ++i) {
        const ProgramSegment& segment = motion.segments[i];
        const double begin = angle / unit;
        angle += segment.angle;
        const double end = angle / unit;
        bool rests_first = segment.kind == SegmentKind::dwell, rests_last = rests_first;
        if (segment.kind == SegmentKind::law) {
            const auto law = make_law(segment.law);
            rests_first = std::abs(law->at(law->begin(), Side::right).derivative[1]) < at_rest;
            rests_last = std::abs(law->at(law->end(), Side::left).derivative[1]) < at_rest;
        }
        const bool opens = i == 0 && !motion.closed;
        const bool closes = i + 1 == motion.segments.size() && !motion.closed;
        const bool spline = segment.kind == SegmentKind::spline;
        if (rests_first || (opens && spline)) places.push_back(begin);
        if (rests_last || (closes && spline)) places.push_back(end);
    }
}

}  // namespace

std::vector<double> rest_places(const Scene& scene) {
    const MotionSpec& motion = scene.motion;
    std::vector<double> places;
    if (motion.type == MotionType::program) {
        add_program(places, scene);
    } else {
        places = {0.0, motion.length()};
        if (motion.type == MotionType::rr) places.push_back(1.0);
    }
    for (const PlacedPoint& point : placed_points(motion))
        if (point.wanted[1] && *point.wanted[1] == 0.0) places.insert(places.end(), {point.begin, point.end});
    std::ranges::sort(places);
    places.erase(std::unique(places.begin(), places.end()), places.end());
    return places;
}

}  // namespace camopt
