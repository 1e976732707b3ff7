// SPDX-License-Identifier: MIT
#include "objectives/free_displacements.hpp"

#include "core/nlp.hpp"
#include "objectives/model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace camopt {

namespace {

using Kind = StretchRequest::Kind;
using Sign = DisplacementBox::Sign;

// Levels pass along a chain in one sweep forth and one back; the third sees what the boxes gained.
constexpr int sweeps = 3;

struct Interval {
    double least = -infinity, most = infinity;

    void meet(double low, double high) {
        least = std::max(least, low);
        most = std::min(most, high);
    }
    /// Rounding of sums of displacements must not make a box empty.
    [[nodiscard]] bool empty() const { return least > most + standing_displacement; }
};

bool is_known(const AffineRow& row) {
    return known_displacement(row).has_value();
}

/// Whether the motion rests where stretch `index` ends (or begins): beside a dwell or an open end.
bool rests_beside(const Scene& scene, const MotionFamily& family, int index, int step) {
    const int count = static_cast<int>(family.stretches().size());
    int other = index + step;
    if (other < 0 || other >= count) {
        if (!scene.motion.closed) return true;
        other = (other + count) % count;
    }
    return family.stretches()[static_cast<std::size_t>(other)].kind == Kind::dwell;
}

std::vector<Interval> known_levels(const FreeDisplacements& free, const MotionFamily& family) {
    const std::vector<MotionFamily::Stretch>& stretches = family.stretches();
    std::vector<Interval> levels(stretches.size() + 1);
    const auto set = [](Interval& level, const AffineRow& row) {
        if (const std::optional<double> known = known_displacement(row)) level = {*known, *known};
    };
    for (std::size_t i = 0; i < stretches.size(); ++i) {
        set(levels[i], stretches[i].from);
        set(levels[i + 1], stretches[i].to);
    }
    for (const int joint : free.joints) levels[static_cast<std::size_t>(joint)].meet(free.least, free.most);
    return levels;
}

/// Where stretch i moves: its box, or anything.
std::vector<Interval> steps_of(std::span<const DisplacementBox> boxes, const MotionFamily& family) {
    std::vector<Interval> steps(family.stretches().size());
    for (std::size_t i = 0; i < steps.size(); ++i)
        if (family.stretches()[i].kind == Kind::dwell) steps[i] = {0.0, 0.0};
    for (const DisplacementBox& box : boxes)
        steps[static_cast<std::size_t>(box.stretch)] = {box.least, box.most};
    return steps;
}

}  // namespace

double DisplacementBox::largest_measure() const {
    const double largest = std::max(std::abs(least), std::abs(most));
    if (sign == Sign::stands) return 1.0;
    return sign == Sign::any ? std::max(1.0, largest) : largest;
}

std::string DisplacementBox::words() const {
    if (sign == Sign::stands) return fmt::format("displacement of motion.segments[{}] = 0", stretch);
    const bool open_below = sign == Sign::rises && least == 0.0;
    const bool open_above = sign == Sign::falls && most == 0.0;
    return fmt::format("{:.9g} {} displacement of motion.segments[{}] {} {:.9g}", least,
                       open_below ? "<" : "<=", stretch, open_above ? "<" : "<=", most);
}

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
    std::vector<bool> open(stretches.size() + 1, false);  // levels beside a spline whose displacement is open
    for (int i = 0; i < count; ++i) {
        const MotionFamily::Stretch& stretch = stretches[static_cast<std::size_t>(i)];
        if (stretch.kind != Kind::spline || (is_known(stretch.from) && is_known(stretch.to))) continue;
        free.stretches.push_back(i);
        free.rest_to_rest.push_back(rests_beside(scene, family, i, -1) && rests_beside(scene, family, i, 1));
        open[static_cast<std::size_t>(i)] = open[static_cast<std::size_t>(i) + 1] = true;
    }
    for (int i = count - 1; i >= 0; --i)  // a dwell hands its level back to what moved there
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

std::vector<DisplacementBox> whole_range(const FreeDisplacements& free, const MotionFamily& family) {
    std::vector<DisplacementBox> boxes;
    const double widest = free.most - free.least;
    for (const int stretch : free.stretches) boxes.push_back({stretch, -widest, widest, Sign::any});
    (void)narrow(boxes, free, family);
    return boxes;
}

bool narrow(std::vector<DisplacementBox>& boxes, const FreeDisplacements& free, const MotionFamily& family) {
    std::vector<Interval> levels = known_levels(free, family);
    std::vector<Interval> steps = steps_of(boxes, family);
    const int count = static_cast<int>(steps.size());
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        for (int i = 0; i < count; ++i)
            levels[i + 1].meet(levels[i].least + steps[i].least, levels[i].most + steps[i].most);
        for (int i = count - 1; i >= 0; --i)
            levels[i].meet(levels[i + 1].least - steps[i].most, levels[i + 1].most - steps[i].least);
        for (int i = 0; i < count; ++i)
            steps[i].meet(levels[i + 1].least - levels[i].most, levels[i + 1].most - levels[i].least);
    }
    for (const Interval& level : levels)
        if (level.empty()) return false;
    for (DisplacementBox& box : boxes) {
        const Interval& step = steps[static_cast<std::size_t>(box.stretch)];
        if (step.empty()) return false;
        if (box.sign == Sign::stands) continue;
        box.least = std::min(step.least, step.most);
        box.most = std::max(step.least, step.most);
        if (box.sign == Sign::any && box.least > standing_displacement) box.sign = Sign::rises;
        if (box.sign == Sign::any && box.most < -standing_displacement) box.sign = Sign::falls;
        // What has to stand cannot move.
        const bool stays = std::max(std::abs(box.least), std::abs(box.most)) < standing_displacement;
        if (box.sign != Sign::any && stays) return false;
    }
    return true;
}

}  // namespace camopt
