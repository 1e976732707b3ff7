// SPDX-License-Identifier: MIT
#include "studies/search/angle_bounds.hpp"

#include "motions/laws/law.hpp"
#include "objectives/segment_law.hpp"
#include "scene/cost_table.hpp"

namespace camopt {

namespace {

bool rests_at_joint(const MotionSpec& motion, std::size_t index, bool at_its_end) {
    const ProgramSegment& neighbour = motion.segments[index];
    if (neighbour.kind == SegmentKind::dwell) return true;
    if (neighbour.kind == SegmentKind::spline) return false;
    const auto law = segment_law(motion, index);
    const MotionPoint point = at_its_end ? law->at(1.0, Side::left) : law->at(0.0, Side::right);
    constexpr double at_rest = 1e-9;  // of the mean velocity 1: less is rounding
    return std::abs(point.derivative[1]) < at_rest && std::abs(point.derivative[2]) < at_rest;
}

bool is_normalised(const SetPoint& point) {
    return point.units.place.empty() && point.units.velocity.empty() && point.units.acceleration.empty();
}

}  // namespace

bool bounds_by_angles(const Scene& scene) {
    if (scene.cam || scene.drive || scene.dynamics || !scene.own_terms.empty() || !scene.own_limits.empty())
        return false;
    // Corridors and tables stand where they are while segments move past them; an area or a mean over the
    // turn weighs segments by their angles.
    const bool weighs_turn = std::ranges::any_of(
        response_terms(), [&](const ResponseTerm& term) { return term.weight_in(scene.objective) > 0.0; });
    if (!scene.motion.corridors.empty() || weighs_turn || weighs_any(scene.objective, CostTerm::Kind::rms))
        return false;
    const std::vector<ProgramSegment>& segments = scene.motion.segments;
    // A polynomial changes its shape with its angle.
    if (std::ranges::any_of(segments, &ProgramSegment::takes_states)) return false;
    const std::size_t count = segments.size();
    for (std::size_t i = 0; i < count; ++i) {
        if (segments[i].kind != SegmentKind::spline) continue;
        if (!std::ranges::all_of(segments[i].via, is_normalised)) return false;
        if (!rests_at_joint(scene.motion, (i + count - 1) % count, true) ||
            !rests_at_joint(scene.motion, (i + 1) % count, false))
            return false;
    }
    return true;
}

}  // namespace camopt
