// SPDX-License-Identifier: MIT
#include "studies/bound/bounder.hpp"

namespace camopt::box_bound {

namespace {

// Angles nearer than this part of a piece to one at hand say nothing new.
constexpr double same_place = 1e-3;

/// Without the rules that look at the motion as a whole: a relaxation whose rules all belong to places.
CamModel part_of_places(const CamModel& model) {
    CamModel part = model;
    std::erase_if(part.rules, [](const PlacedRule& rule) {
        return rule->whole() != nullptr && !rule->whole()->is_one_row();
    });
    return part;
}

CamModel linear_part(const CamModel& model) {
    CamModel part = part_of_places(model);
    std::erase_if(part.rules, [](const PlacedRule& rule) { return !rule->linear(); });
    return part;
}

}  // namespace

Eigen::VectorXd Place::point(const Eigen::VectorXd& x) const {
    Eigen::VectorXd point(4);
    for (int order = 0; order < 4; ++order) {
        const StateRow& row = state[static_cast<std::size_t>(order)];
        point[order] = row.weights.dot(x) + row.offset;
    }
    return point;
}

/// Not linear, of one place, and with an enclosure over boxes.
bool can_be_bounded(const PointRule& rule) {
    if (rule.linear() || rule.whole()) return false;
    const std::vector<Interval> box(4 + rule.parameters().size(), Interval(1.0));
    return rule.range_over(box, 0.0).has_value();
}

Bounder::Bounder(const CamModel& model, double incumbent, const BoxBoundOptions& options,
                 const SolveControl& control)
    : whole_(part_of_places(model)),
      linear_(linear_part(model)),
      incumbent_(incumbent),
      options_(options),
      control_(control) {}

void Bounder::add_place(double at, Side side) {
    add_place(at, side, false);
    if (whole_.model().cam_motion) add_place(at, side, true);
}

/// With the rules that see the same motion.
void Bounder::add_place(double at, Side side, bool of_cam) {
    const CamModel& model = whole_.model();
    const MotionFamily& family = model.family_of(of_cam ? SeenMotion::cam : SeenMotion::output);
    const int variables = whole_.grid().shape().variables();
    const MotionFamily::Piece& piece = family.pieces()[static_cast<std::size_t>(family.piece_of(at, side))];
    for (const Place& place : places_)
        if (place.of_cam == of_cam && place.side == side &&
            std::abs(place.at - at) <= same_place * (piece.end - piece.begin))
            return;
    Place place;
    place.at = at;
    place.side = side;
    place.of_cam = of_cam;
    for (int r = 0; r < static_cast<int>(model.rules.size()); ++r) {
        const PlacedRule& rule = model.rules[static_cast<std::size_t>(r)];
        if (model.sees_other(rule) != of_cam) continue;
        if (!can_be_bounded(*rule) || !rule.holds_on(piece) || !rule.holds_at(at)) continue;
        const std::vector<double>& only = rule->places();
        if (!only.empty() && std::ranges::find(only, at) == only.end()) continue;
        place.rules.push_back(r);
    }
    if (place.rules.empty()) return;
    for (int order = 0; order < 4; ++order) {
        const AffineRow row = family.functional(at, order, side);
        StateRow& state = place.state[static_cast<std::size_t>(order)];
        state.weights = Eigen::VectorXd::Zero(variables);
        state.offset = row.offset;
        for (std::size_t k = 0; k < row.columns.size(); ++k)
            state.weights[row.columns[k]] = row.weights[k] * variable_scale(model, row.columns[k]);
    }
    places_.push_back(std::move(place));
}

void Bounder::add_places() {
    const CamModel& model = whole_.model();
    const MotionFamily& family = model.design;
    for (const MotionFamily::Piece& piece : family.pieces()) {
        const int count = piece.segment >= 0 ? options_.places_a_piece : 1;
        for (int k = 0; k < count; ++k) {
            const double share = piece.segment >= 0 ? static_cast<double>(k) / count : 0.5;
            add_place(piece.begin + share * (piece.end - piece.begin), Side::right);
        }
    }
    add_place(family.end(), Side::left);
    for (const PlacedRule& rule : model.rules) {
        if (!can_be_bounded(*rule)) continue;
        for (const double at : rule->places()) add_place(at, at < family.end() ? Side::right : Side::left);
    }
}

void Bounder::sync_places(Node& node) {
    while (node.boxes.size() < places_.size()) {
        PlaceBox box;
        const Place& place = places_[node.boxes.size()];
        // What the bounds of x say, to begin with.
        for (std::size_t order = 0; order < 4; ++order) {
            const StateRow& row = place.state[order];
            Interval range(row.offset);
            for (Eigen::Index j = 0; j < row.weights.size(); ++j) {
                if (row.weights[j] == 0.0) continue;
                const int variable = static_cast<int>(j);
                range = range + Interval(row.weights[j]) *
                                    Interval(node.program.lower(variable), node.program.upper(variable));
            }
            box.state[order] = range;
        }
        node.boxes.push_back(std::move(box));
        rebuild(node, node.boxes.size() - 1);
    }
}

/// Angles at which the bound's own motion breaks a rule most. False: it breaks none between those at hand.
bool Bounder::exchange_places(Node& node) {
    const std::size_t before = places_.size();
    for (const Violation& violation : whole_.violations(node.x, 0.0)) {
        if (violation.rule >= static_cast<int>(whole_.model().rules.size())) continue;
        if (whole_.model().rules[static_cast<std::size_t>(violation.rule)]->linear()) continue;
        if (violation.amount <= 1e-7 || !std::isfinite(violation.amount)) continue;
        add_place(violation.where.at, violation.where.side);
    }
    if (places_.size() == before) return false;
    sync_places(node);
    return true;
}

}  // namespace camopt::box_bound
