// SPDX-License-Identifier: MIT
#include "studies/pareto/front_chain.hpp"

namespace camopt {

namespace {

// Points closer than this in the unit box are one point: a solve knows a goal no better.
constexpr double same_front_place = 1e-6;
// Ends whose goals differ by less than this, relative, are one end.
constexpr double same_front_value = 1e-7;

bool dominates(const FrontPlace& one, const FrontPlace& other) {
    const double first = other.box[0] - one.box[0], second = other.box[1] - one.box[1];
    return std::min(first, second) > -same_front_place && std::max(first, second) > same_front_place;
}

bool same(const FrontPlace& one, const FrontPlace& other) {
    return std::abs(one.box[0] - other.box[0]) <= same_front_place &&
           std::abs(one.box[1] - other.box[1]) <= same_front_place;
}

double distance(const FrontPlace& one, const FrontPlace& other) {
    return std::hypot(one.box[0] - other.box[0], one.box[1] - other.box[1]);
}

}  // namespace

FrontChain::FrontChain(const FrontNode& first_end, const FrontNode& second_end) {
    least_ = {first_end.value[0], second_end.value[1]};
    range_ = {second_end.value[0] - least_[0], first_end.value[1] - least_[1]};
    has_extent_ = true;
    for (std::size_t goal = 0; goal < 2; ++goal) {
        const double size = std::max(std::abs(first_end.value[goal]), std::abs(second_end.value[goal]));
        if (!(range_[goal] > same_front_value * size)) has_extent_ = false;
    }
    nodes_ = {first_end};
    if (has_extent_) nodes_.push_back(second_end);
    for (const FrontNode& node : nodes_) places_.push_back(place_of(node));
}

FrontPlace FrontChain::place_of(const FrontNode& node) const {
    if (!has_extent_) return {};
    return {{(node.value[0] - least_[0]) / range_[0], (node.value[1] - least_[1]) / range_[1]}, false};
}

double FrontChain::change(int piece, int goal) const {
    const auto i = static_cast<std::size_t>(piece), g = static_cast<std::size_t>(goal);
    return std::abs(places_[i + 1].box[g] - places_[i].box[g]);
}

double FrontChain::value_within(const FrontTarget& target, int goal) const {
    const auto i = static_cast<std::size_t>(target.after), g = static_cast<std::size_t>(goal);
    return nodes_[i].value[g] + target.part * (nodes_[i + 1].value[g] - nodes_[i].value[g]);
}

bool FrontChain::insert(const FrontNode& node, int piece) {
    const FrontPlace place = place_of(node);
    for (const FrontPlace& old : places_) {
        if (!same(place, old) && !dominates(old, place)) continue;
        close(piece);
        return false;
    }
    drop_dominated(place);
    const auto before =
        std::ranges::find_if(places_, [&](const FrontPlace& other) { return other.box[0] > place.box[0]; });
    const auto index = before - places_.begin();
    nodes_.insert(nodes_.begin() + index, node);
    places_.insert(before, place);
    return true;
}

void FrontChain::drop_dominated(const FrontPlace& by) {
    for (std::size_t i = places_.size(); i-- > 0;) {
        if (!dominates(by, places_[i])) continue;
        const auto at = static_cast<std::ptrdiff_t>(i);
        nodes_.erase(nodes_.begin() + at);
        places_.erase(places_.begin() + at);
        if (i > 0) places_[i - 1].jump_follows = false;  // the piece is another one now
    }
}

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
