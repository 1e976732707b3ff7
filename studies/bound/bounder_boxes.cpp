// SPDX-License-Identifier: MIT
#include "studies/bound/bounder.hpp"

namespace camopt::box_bound {

namespace {

// Boxes are shrunk where that takes away this part of their width.
constexpr double worth_a_bound = 1e-3;

}  // namespace

SeenStates::SeenStates(const std::vector<Place>& places)
    : seen_(3 * places.size(), Interval(infinity, -infinity)) {
    if (places.empty()) return;
    const auto rows = static_cast<Eigen::Index>(seen_.size());
    weights_.resize(rows, places.front().state.front().weights.size());
    offsets_.resize(rows);
    for (Eigen::Index row = 0; row < rows; ++row) {
        const StateRow& state =
            places[static_cast<std::size_t>(row / 3)].state[static_cast<std::size_t>(row % 3)];
        weights_.row(row) = state.weights.transpose();
        offsets_[row] = state.offset;
    }
}

void SeenStates::add(const Eigen::VectorXd& x) {
    if (x.size() == 0 || seen_.empty()) return;
    const Eigen::VectorXd states = weights_ * x + offsets_;
    for (std::size_t i = 0; i < seen_.size(); ++i) {
        const double state = states[static_cast<Eigen::Index>(i)];
        seen_[i] = {std::min(seen_[i].lower, state), std::max(seen_[i].upper, state)};
    }
}

std::vector<Interval> Bounder::rule_box(const Node& node, std::size_t place, int rule) const {
    const PlaceBox& box = node.boxes[place];
    std::vector<Interval> all(box.state.begin(), box.state.end());
    for (const int parameter : whole_.model().rules[static_cast<std::size_t>(rule)]->parameters()) {
        const int variable = design_size() + parameter;
        all.emplace_back(node.program.lower(variable), node.program.upper(variable));
    }
    return all;
}

void Bounder::rebuild(Node& node, std::size_t place) {
    PlaceBox& box = node.boxes[place];
    box.bent.clear();
    box.bites = false;
    for (const int rule : places_[place].rules) {
        Bent bent{rule, RuleOverBox::make(*whole_.model().rules[static_cast<std::size_t>(rule)],
                                          rule_box(node, place, rule), places_[place].at)};
        if (!bent.over || bent.over->most() > 0.0) box.bites = true;
        box.bent.push_back(std::move(bent));
    }
}

/// The least or the greatest value of a number, which may shrink its interval. False: nothing is in the node.
bool Bounder::tighten_end(Node& node, const StateRow& number, Interval& box, std::array<int, 2>& ends,
                          bool upper) {
    const Eigen::VectorXd weights = upper ? number.weights : Eigen::VectorXd(-number.weights);
    const VertexBound found = solve(node, -weights);
    if (found.status == VertexBound::Status::infeasible) {
        node.empty = true;
        keep_bound(node, found);
        return false;
    }
    if (!std::isfinite(found.bound)) return true;
    // weights · x <= side
    const double side = -found.bound;
    const Interval end =
        upper ? Interval(side) + Interval(number.offset) : Interval(number.offset) - Interval(side);
    const double gain = upper ? box.upper - end.upper : end.lower - box.lower;
    if (!(gain >= worth_a_bound * box.width()) && std::isfinite(box.width())) return true;
    if (upper ? end.upper < box.lower : end.lower > box.upper) return true;  // nothing but rounding is left
    (upper ? box.upper : box.lower) = upper ? end.upper : end.lower;
    BoxStep step;
    step.kind = BoxStep::Kind::derived;
    step.weights = weights;
    step.side = side;
    step.multipliers = named(node, found);
    step.bounds = bounds_of(node);
    ends[upper ? 1 : 0] = log(std::move(step));
    return true;
}

bool Bounder::tighten_variable(Node& node, int variable) {
    const StateRow number{Eigen::VectorXd::Unit(node.program.variables(), variable), 0.0};
    const double lower = node.program.lower(variable), upper = node.program.upper(variable);
    Interval box(lower, upper);
    std::array<int, 2>& ends = node.bound_steps[static_cast<std::size_t>(variable)];
    std::array<int, 2> found = ends;
    for (const bool end : {false, true})
        if (!tighten_end(node, number, box, found, end)) return false;
    // The step itself, without the outward rounding of an interval.
    const auto side_of = [&](int step) { return proof_.steps[static_cast<std::size_t>(step)].side; };
    const double low = found[0] != ends[0] ? -side_of(found[0]) : lower;
    const double high = found[1] != ends[1] ? side_of(found[1]) : upper;
    if (low != lower || high != upper) node.program.set_bounds(variable, low, high);
    ends = found;
    return true;
}

bool Bounder::tighten_place(Node& node, std::size_t place, int order, bool upper, SeenStates& seen) {
    PlaceBox& box = node.boxes[place];
    if (!box.bites || !is_read(box, order)) return true;
    const auto at = static_cast<std::size_t>(order);
    Interval& numbers = box.state[at];
    const Interval& known = seen.at(place, order);
    const double most = upper ? numbers.upper - known.upper : known.lower - numbers.lower;
    if (std::isfinite(numbers.width()) && most < worth_a_bound * numbers.width()) return true;
    const bool left = tighten_end(node, places_[place].state[at], numbers, box.steps[at], upper);
    seen.add(corner_);
    return left;
}

bool Bounder::tighten(Node& node) {
    ++result_.passes;
    for (int j = design_size(); j < node.program.variables(); ++j) {
        if (moves_rule_[static_cast<std::size_t>(j)] && !tighten_variable(node, j)) return false;
    }
    SeenStates seen(places_);
    seen.add(node.x);
    // One end of one order along all places before the next: neighbours lie at nearly the same corner.
    for (int order = 0; order < 3; ++order) {
        for (const bool upper : {false, true}) {
            for (std::size_t place = 0; place < places_.size(); ++place) {
                if (control_.ending()) return true;
                if (!tighten_place(node, place, order, upper, seen)) return false;
            }
        }
    }
    return true;
}

/// Some rule of the place is curved in the derivative of this order, or not yet known not to be.
bool Bounder::is_read(const PlaceBox& box, int order) const {
    return std::ranges::any_of(box.bent, [&](const Bent& bent) {
        if (bent.over) return bent.over->is_curved(order);
        return order <= whole_.model().rules[static_cast<std::size_t>(bent.rule)]->highest_order();
    });
}

}  // namespace camopt::box_bound
