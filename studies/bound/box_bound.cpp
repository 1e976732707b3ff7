// SPDX-License-Identifier: MIT
#include "studies/bound/box_bound.hpp"

#include "studies/bound/bounder.hpp"

namespace camopt::box_bound {

namespace {

// Rounds of planes at the newest corner.
constexpr int most_cut_rounds = 30;
// Passes in a row that close less than this part of what is left, until the node is halved. Boxes that shrink
// slowly at first may close in at once later.
constexpr double worth_a_pass = 5e-3;
constexpr int most_in_vain = 2;
// Halves in a row that do not lift the least bound by this part of what is left, until it is given up.
constexpr double worth_a_half = 1e-2;
constexpr int most_halves_in_vain = 8;
constexpr double outward = 1e-12;

}  // namespace

VertexBound Bounder::solve(Node& node, const Eigen::VectorXd& cost) {
    ++result_.programs;
    VertexBound found = node.program.minimize(cost, control_);
    corner_ = found.status == VertexBound::Status::optimal ? found.x : Eigen::VectorXd();
    return found;
}

bool Bounder::settle(Node& node) {
    for (int round = 0; round < most_cut_rounds; ++round) {
        const VertexBound found = solve(node, cost_);
        if (found.status == VertexBound::Status::infeasible) {
            node.empty = true;
            keep_bound(node, found);
            return false;
        }
        const double before = node.bound;
        const double bound = (Interval(found.bound) + Interval(constant_)).lower;
        if (found.bound > -infinity && bound > node.bound) {
            node.bound = bound;
            keep_bound(node, found);
        }
        if (found.status != VertexBound::Status::optimal) return true;
        node.x = found.x;
        if (is_done(node)) return true;
        int added = add_planes_at(node, node.x);
        std::vector<Violation> worst;
        for (Violation& violation : linear_.violations(node.x, 0.0))
            if (violation.amount > 1e-8) worst.push_back(violation);
        if (!worst.empty() && linear_.refine(worst) > 0) {
            sync_linear(node);
            ++added;
        }
        if (added == 0) return true;
        if (round > 8 && node.bound - before < 1e-3 * options_.gap * std::max(1.0, std::abs(node.bound)))
            return true;
    }
    return true;
}

void Bounder::close(Node& node) {
    sync_linear(node);
    sync_places(node);
    if (!settle(node)) return;
    int passes = 0, in_vain = 0;
    while (!is_done(node) && !control_.ending() && passes < options_.most_passes) {
        const double before = node.bound;
        if (!tighten(node)) return;
        rebuild_all(node);
        if (!settle(node)) return;
        ++passes;
        if (is_done(node)) return;
        const double left = bounded() ? incumbent_ - node.bound : infinity;
        const double whole = bounded() ? left : std::max(1.0, std::abs(before));
        const bool idle = node.bound - before < worth_a_pass * whole;
        in_vain = idle ? in_vain + 1 : 0;
        const bool more = passes >= 2 && exchange_places(node);
        if (in_vain >= (more ? most_in_vain + 1 : most_in_vain)) return;
    }
}

std::vector<Node> Bounder::halves(const Node& node) {
    // The number whose part of the secant errors is greatest; parameters stand in the boxes of many places.
    double most = 0.0;
    int variable = -1, order = -1;
    std::size_t where = 0;
    std::vector<double> of_variable(static_cast<std::size_t>(node.program.variables()), 0.0);
    for (std::size_t place = 0; place < node.boxes.size(); ++place) {
        if (!node.boxes[place].bites) continue;
        for (const Bent& bent : node.boxes[place].bent) {
            if (!bent.over || bent.over->most() <= 0.0) continue;
            for (int i = 0; i < 4; ++i) {
                const double error = bent.over->secant_error(i);
                if (error > most) {
                    most = error;
                    variable = -1;
                    order = i;
                    where = place;
                }
            }
            const std::vector<int>& parameters =
                whole_.model().rules[static_cast<std::size_t>(bent.rule)]->parameters();
            for (std::size_t k = 0; k < parameters.size(); ++k) {
                const double error = bent.over->secant_error(4 + static_cast<int>(k));
                if (error >= most && error > 0.0) {
                    most = error;
                    variable = design_size() + parameters[k];
                }
            }
        }
    }
    std::vector<Node> parts;
    if (!(most > 0.0)) return parts;
    for (const bool upper : {false, true}) {
        Node part = node;
        ++part.depth;
        sync_linear(part);
        sync_places(part);
        BoxStep step;
        step.kind = BoxStep::Kind::split;
        if (variable >= 0) {
            const double low = part.program.lower(variable), high = part.program.upper(variable);
            const double middle = 0.5 * (low + high);
            step.weights = (upper ? -1.0 : 1.0) * Eigen::VectorXd::Unit(part.program.variables(), variable);
            step.side = upper ? -middle : middle;
            part.splits.push_back(log(std::move(step)));
            part.program.set_bounds(variable, upper ? middle : low, upper ? high : middle);
            part.bound_steps[static_cast<std::size_t>(variable)][upper ? 0 : 1] = part.splits.back();
        } else {
            PlaceBox& place = part.boxes[where];
            Interval& box = place.state[static_cast<std::size_t>(order)];
            const StateRow& row = places_[where].state[static_cast<std::size_t>(order)];
            const double middle = 0.5 * (box.lower + box.upper) - row.offset;
            step.weights = upper ? Eigen::VectorXd(-row.weights) : row.weights;
            step.side = upper ? -middle : middle;
            part.splits.push_back(log(std::move(step)));
            const Interval at = Interval(middle) + Interval(row.offset);
            (upper ? box.lower : box.upper) = upper ? at.lower : at.upper;
            place.steps[static_cast<std::size_t>(order)][upper ? 0 : 1] = part.splits.back();
            add_row(part, part.splits.back());
        }
        rebuild_all(part);
        parts.push_back(std::move(part));
    }
    return parts;
}

std::optional<BoxBound> Bounder::run() {
    const Nlp& grid = whole_.grid();
    const CamModel& model = whole_.model();
    // What a follower train makes of the motion is no number of a place: nothing here bounds it.
    const bool responds = std::ranges::any_of(model.parameters, [](const Parameter& parameter) {
        return parameter.kind == Parameter::Kind::response && !parameter.defined_by->whole()->is_one_row();
    });
    if (responds || !grid.shape().linear_cost ||
        std::ranges::none_of(model.rules, [](const PlacedRule& rule) { return can_be_bounded(*rule); }))
        return {};
    const int variables = grid.shape().variables();
    const Box box = whole_.box(incumbent_, 0.0);
    Eigen::VectorXd lower = box.lower.cwiseMax(grid.shape().x_lower);
    Eigen::VectorXd upper = box.upper.cwiseMin(grid.shape().x_upper);
    if (!lower.allFinite() || !upper.allFinite()) return {};
    const Eigen::VectorXd zero = Eigen::VectorXd::Zero(variables);
    cost_.resize(variables);
    grid.gradient(zero, cost_);
    constant_ = grid.cost(zero);
    moves_rule_.assign(static_cast<std::size_t>(variables), 0);
    const auto first_parameter = static_cast<std::size_t>(design_size());
    for (const PlacedRule& rule : model.rules) {
        if (!can_be_bounded(*rule)) continue;
        for (const int parameter : rule->parameters())
            moves_rule_[first_parameter + static_cast<std::size_t>(parameter)] = 1;
    }
    proof_.cost = cost_;
    proof_.constant = constant_;
    proof_.box = {lower, upper};
    for (int j = 0; j < variables; ++j) proof_.variables.push_back(grid.variable_name(j));
    Node root{VertexProgram(std::move(lower), std::move(upper))};
    root.bound_steps.assign(static_cast<std::size_t>(variables), {-1, -1});
    if (bounded()) {
        BoxStep step;
        step.kind = BoxStep::Kind::cost;
        step.weights = cost_;
        step.side = (incumbent_ - constant_) + outward * std::max(1.0, incumbent_);
        add_row(root, log(std::move(step)));
    }
    add_places();
    std::vector<Node> open;
    close(root);
    result_.x = root.x;
    double closed = infinity;  // least bound of what is done with
    const auto put = [&](Node node) {
        if (is_done(node)) {
            if (!node.empty) closed = std::min(closed, node.bound);
            end_part(node);
            return;
        }
        open.push_back(std::move(node));
    };
    put(std::move(root));
    double known = -infinity;
    int in_vain = 0;
    while (!open.empty() && result_.parts < options_.most_parts && !control_.ending()) {
        const auto worst = std::ranges::min_element(open, {}, &Node::bound);
        const double left = bounded() ? incumbent_ - known : std::max(1.0, std::abs(known));
        if (worst->bound > known + worth_a_half * left || known == -infinity) {
            known = worst->bound;
            in_vain = 0;
        } else if (++in_vain == most_halves_in_vain) {
            break;
        }
        Node node = std::move(*worst);
        open.erase(worst);
        std::vector<Node> parts = halves(node);
        if (parts.empty()) {
            open.push_back(std::move(node));
            break;
        }
        ++result_.parts;
        for (Node& part : parts) {
            close(part);
            put(std::move(part));
        }
    }
    for (const Node& node : open) {
        closed = std::min(closed, node.bound);
        end_part(node);
    }
    result_.places = static_cast<int>(places_.size());
    result_.infeasible = !bounded() && open.empty() && closed == infinity;
    result_.bound = bounded() ? std::min(closed, incumbent_) : closed;
    proof_.bound = result_.bound;
    result_.proof = std::make_shared<const BoxProof>(pruned(proof_));
    return result_;
}

}  // namespace camopt::box_bound

namespace camopt {

std::optional<BoxBound> bound_over_boxes(const CamModel& model, double incumbent,
                                         const BoxBoundOptions& options, const SolveControl& control) {
    return box_bound::Bounder(model, incumbent, options, control).run();
}

}  // namespace camopt
