// SPDX-License-Identifier: MIT
#include "studies/pareto/front_spacing.hpp"

#include <algorithm>
#include <cmath>

namespace camopt {

namespace {

double distance(const FrontPlace& one, const FrontPlace& other) {
    return std::hypot(one.box[0] - other.box[0], one.box[1] - other.box[1]);
}

}  // namespace

std::vector<double> arc_lengths(std::span<const FrontPlace> places) {
    std::vector<double> arc(places.size(), 0.0);
    for (std::size_t i = 1; i < places.size(); ++i) {
        const double step = places[i - 1].jump_follows ? 0.0 : distance(places[i - 1], places[i]);
        arc[i] = arc[i - 1] + step;
    }
    return arc;
}

FrontTarget target_at(std::span<const double> arc, double length) {
    const auto above = std::ranges::upper_bound(arc, length);
    const auto last = static_cast<std::ptrdiff_t>(arc.size()) - 2;
    const auto after = std::clamp<std::ptrdiff_t>(above - arc.begin() - 1, 0, last);
    const auto i = static_cast<std::size_t>(after);
    const double piece = arc[i + 1] - arc[i];
    return {static_cast<int>(after), piece > 0.0 ? std::clamp((length - arc[i]) / piece, 0.0, 1.0) : 0.0};
}

int longest_piece(std::span<const FrontPlace> places) {
    int longest = -1;
    double most = 0.0;
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
        if (places[i].jump_follows || distance(places[i], places[i + 1]) <= most) continue;
        most = distance(places[i], places[i + 1]);
        longest = static_cast<int>(i);
    }
    return longest;
}

int nearest_place(std::span<const double> arc, double length) {
    const auto nearest = std::ranges::min_element(
        arc, [&](double one, double other) { return std::abs(one - length) < std::abs(other - length); });
    return static_cast<int>(nearest - arc.begin());
}

}  // namespace camopt
