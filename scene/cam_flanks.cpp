// SPDX-License-Identifier: MIT
#include "scene/cam_flanks.hpp"

#include "core/errors.hpp"

#include <fmt/format.h>

namespace camopt {
namespace {

// Angles closer than this part of the motion coincide.
constexpr double same_angle = 1e-9;

bool is_break(const FollowerMotion& motion, double angle) {
    const double nearness = same_angle * (motion.end() - motion.begin());
    return std::any_of(motion.breakpoints.begin() + 1, motion.breakpoints.end() - 1,
                       [&](double place) { return std::abs(place - angle) <= nearness; });
}

std::vector<double> even_heights(const CamFlanks& cam, const FlankSampling& sampling) {
    const bool whole = sampling.from_height == 0.0 && sampling.to_height == 0.0;
    const double to = whole ? cam.roller_length : sampling.to_height;
    std::vector<double> heights;
    heights.reserve(static_cast<std::size_t>(sampling.sections));
    for (int i = 0; i < sampling.sections; ++i)
        heights.push_back(sampling.from_height + (to - sampling.from_height) * i / (sampling.sections - 1));
    return heights;
}

}  // namespace

DrumSize body_around(const DrumSize& groove, const DrumBody& body, double wall) {
    DrumSize size = groove;
    if (body.diameter) size.radius = 0.5 * *body.diameter;
    const double length = groove.upper - groove.lower;
    const double beyond = body.length ? 0.5 * (*body.length - length) : body.wall.value_or(wall);
    size.lower -= beyond;
    size.upper += beyond;
    return size;
}

void FlankSampling::validate() const {
    if (sections < 2) throw InputError(fmt::format("sections: found {}; allowed: at least 2", sections));
    if (angles < 2) throw InputError(fmt::format("angles: found {}; allowed: at least 2", angles));
    const bool whole = from_height == 0.0 && to_height == 0.0;
    if (!whole && !(to_height > from_height))
        throw InputError(
            fmt::format("to_height: found {} m; allowed: above from_height, {} m", to_height, from_height));
}

std::vector<double> even_angles(const FollowerMotion& motion, int count) {
    const double begin = motion.begin(), length = motion.end() - begin;
    std::vector<double> angles = motion.breakpoints;
    for (int i = 1; i + 1 < count; ++i) {
        const double angle = begin + length * i / (count - 1);
        if (!is_break(motion, angle)) angles.push_back(angle);
    }
    std::ranges::sort(angles);
    return angles;
}

FlankGrid flank_grid(const CamFlanks& cam, const FollowerMotion& motion, const FlankSampling& sampling) {
    sampling.validate();
    return flank_grid(cam, motion, even_heights(cam, sampling), even_angles(motion, sampling.angles));
}

FlankGrid flank_grid(const CamFlanks& cam, const FollowerMotion& motion, std::vector<double> heights,
                     std::vector<double> angles) {
    FlankGrid grid;
    grid.heights = std::move(heights);
    grid.angles = std::move(angles);
    grid.roller_radius = cam.roller_radius;
    for (std::size_t side = 0; side < 2; ++side) {
        FlankSurface& flank = grid.flanks[side];
        flank.flank = side == 0 ? 1 : -1;
        flank.points.resize(grid.heights.size() * grid.angles.size());
        flank.normals.resize(flank.points.size());
    }
    for (std::size_t j = 0; j < grid.angles.size(); ++j) {
        const double theta = grid.angles[j];
        const FollowerState state = motion.state(theta);
        const RollerAxis axis = cam.axis(theta, state.s);
        grid.feet.push_back(axis.foot);
        grid.directions.push_back(axis.direction);
        if (is_break(motion, theta)) grid.breaks.push_back(static_cast<int>(j));
        for (std::size_t i = 0; i < grid.heights.size(); ++i)
            for (FlankSurface& flank : grid.flanks) {
                const FlankPoint point = cam.point(theta, state, {grid.heights[i], flank.flank});
                flank.points[grid.index(i, j)] = point.contact;
                flank.normals[grid.index(i, j)] = -point.normal;
            }
    }
    return grid;
}

}  // namespace camopt
