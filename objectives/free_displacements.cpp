// SPDX-License-Identifier: MIT
#include "objectives/free_displacements.hpp"

#include <algorithm>

namespace camopt {

namespace {

using Kind = StretchRequest::Kind;

bool is_known(const AffineRow& row) {
    return known_displacement(row).has_value();
}

}  // namespace

std::array<double, 2> known_range(const MotionFamily& family) {
    std::array<double, 2> range{};
    for (const MotionFamily::Stretch& stretch : family.stretches()) {
        const std::optional<double> to = known_displacement(stretch.to);
        if (!to) continue;
        range[0] = std::min(range[0], *to);
        range[1] = std::max(range[1], *to);
    }
    return range;
}

FreeDisplacements free_displacements(const Scene& scene, const MotionFamily& family) {
    FreeDisplacements free;
    if (scene.motion.type != MotionType::program) return free;
    const std::vector<MotionFamily::Stretch>& stretches = family.stretches();
    const int count = static_cast<int>(stretches.size());
    std::vector<bool> open(stretches.size() + 1,
                           false);  // levels next to a spline whose displacement is free
    for (int i = 0; i < count; ++i) {
        const MotionFamily::Stretch& stretch = stretches[static_cast<std::size_t>(i)];
        if (stretch.kind != Kind::spline || (is_known(stretch.from) && is_known(stretch.to))) continue;
        open[static_cast<std::size_t>(i)] = open[static_cast<std::size_t>(i) + 1] = true;
    }
    for (int i = count - 1; i >= 0; --i)  // a dwell passes its level back to the segment before it
        if (stretches[static_cast<std::size_t>(i)].kind == Kind::dwell &&
            open[static_cast<std::size_t>(i) + 1])
            open[static_cast<std::size_t>(i)] = true;
    for (int i = 0; i < count; ++i) {
        const MotionFamily::Stretch& stretch = stretches[static_cast<std::size_t>(i)];
        if (stretch.kind != Kind::dwell && open[static_cast<std::size_t>(i) + 1] && !is_known(stretch.to))
            free.joints.push_back(i + 1);
    }
    const auto [least, most] = known_range(family);
    const double span = std::max(1.0, most - least);
    free.least = least - span;
    free.most = most + span;
    return free;
}

}  // namespace camopt
