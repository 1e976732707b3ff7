// SPDX-License-Identifier: MIT
#include "studies/bound/bounder.hpp"

#include "studies/bound/branch_and_bound.hpp"

#include <numeric>

namespace camopt::box_bound {

namespace {

// Rounds of planes at the newest corner.
constexpr int most_cut_rounds = 30;
// Passes in a row that close less than this part of what is left, until the node is halved. Boxes that shrink
// slowly at first may close in at once later.
constexpr double worth_a_pass = 5e-3;
constexpr int most_in_vain = 2;
// A pass that gains less than this, relative, ends them at once: what is left takes a halved box.
constexpr double no_gain = 1e-6;
// Numbers whose halves are bounded before one is halved, and the least error of one beside the largest there.
constexpr std::size_t most_trials = 4;
constexpr double worth_a_trial = 0.5;
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
    if (node.empty) return;
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
        const double gain = node.bound - before;
        in_vain = gain < worth_a_pass * whole ? in_vain + 1 : 0;
        const bool more = passes >= 2 && exchange_places(node);
        if (bounded() && gain < no_gain * std::max(1.0, std::abs(before))) return;
        if (in_vain >= (more ? most_in_vain + 1 : most_in_vain)) return;
    }
}

/// How much the bound's own motion violates a rule at each place, relative to the rule; 0: it does not.
std::vector<double> Bounder::violations_at_places(const Node& node) const {
    std::vector<double> amounts(node.boxes.size(), 0.0);
    for (std::size_t place = 0; place < node.boxes.size() && node.x.size() > 0; ++place) {
        const Eigen::VectorXd state = places_[place].point(node.x);
        const MotionPoint point{places_[place].at, {state[0], state[1], state[2], state[3]}};
        for (const Bent& bent : node.boxes[place].bent) {
            const PlacedRule& rule = whole_.model().rules[static_cast<std::size_t>(bent.rule)];
            Eigen::VectorXd parameters(static_cast<Eigen::Index>(rule->parameters().size()));
            for (Eigen::Index k = 0; k < parameters.size(); ++k)
                parameters[k] = node.x[design_size() + rule->parameters()[static_cast<std::size_t>(k)]];
            const double amount = rule->evaluate(point, parameters).value / rule->scale();
            if (amount > amounts[place]) amounts[place] = amount;
        }
    }
    return amounts;
}

/// The numbers in whose halves a place's rules lie nearest to their planes: those of the largest secant
/// errors.
void Bounder::add_numbers_of(const Node& node, std::size_t place, std::vector<Halved>& numbers) const {
    std::vector<Halved> own;
    for (const Bent& bent : node.boxes[place].bent) {
        if (!node.boxes[place].bites || !bent.over || bent.over->most() <= 0.0) continue;
        const std::vector<int>& parameters =
            whole_.model().rules[static_cast<std::size_t>(bent.rule)]->parameters();
        for (int i = 0; i < 4 + static_cast<int>(parameters.size()); ++i) {
            const int variable = i < 4 ? -1 : design_size() + parameters[static_cast<std::size_t>(i - 4)];
            const double error = bent.over->secant_error(i);
            if (error > 0.0) own.push_back({variable, std::min(i, 4), place, error});
        }
    }
    if (own.empty()) return;
    const double most = std::ranges::max_element(own, {}, &Halved::error)->error;
    for (const Halved& number : own) {
        const auto same = [&](const Halved& one) {
            return one.variable == number.variable && one.order == number.order &&
                   (one.place == place || one.variable >= 0);
        };
        if (number.error >= worth_a_trial * most && std::ranges::none_of(numbers, same))
            numbers.push_back(number);
    }
}

/// Where the bound's own motion violates rules most its relaxation is weakest: of each stretch of violated
/// places the worst, or of all places those of the largest errors where it violates none.
std::vector<Halved> Bounder::worth_halving(const Node& node) const {
    const std::vector<double> amounts = violations_at_places(node);
    std::vector<std::size_t> order(amounts.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {}, [&](std::size_t place) { return places_[place].at; });
    std::vector<std::size_t> worst;
    for (std::size_t k = 0; k < order.size(); ++k) {
        const double amount = amounts[order[k]];
        const bool rises = k == 0 || amount > amounts[order[k - 1]];
        const bool falls = k + 1 == order.size() || amount >= amounts[order[k + 1]];
        if (amount > 0.0 && rises && falls) worst.push_back(order[k]);
    }
    std::ranges::sort(worst, std::greater{}, [&](std::size_t place) { return amounts[place]; });
    std::vector<Halved> numbers;
    for (const std::size_t place : worst)
        if (numbers.size() < most_trials) add_numbers_of(node, place, numbers);
    if (!numbers.empty()) return numbers;
    for (const std::size_t place : order) add_numbers_of(node, place, numbers);
    if (numbers.empty()) return numbers;
    return {*std::ranges::max_element(numbers, {}, &Halved::error)};
}

Node Bounder::half(const Node& node, const Halved& number, bool upper) {
    Node part = node;
    ++part.depth;
    sync_linear(part);
    sync_places(part);
    BoxStep step;
    step.kind = BoxStep::Kind::split;
    if (number.variable >= 0) {
        const int variable = number.variable;
        const double low = part.program.lower(variable), high = part.program.upper(variable);
        const double middle = 0.5 * (low + high);
        step.weights = (upper ? -1.0 : 1.0) * Eigen::VectorXd::Unit(part.program.variables(), variable);
        step.side = upper ? -middle : middle;
        part.splits.push_back(log(std::move(step)));
        part.program.set_bounds(variable, upper ? middle : low, upper ? high : middle);
        part.bound_steps[static_cast<std::size_t>(variable)][upper ? 0 : 1] = part.splits.back();
    } else {
        const auto order = static_cast<std::size_t>(number.order);
        PlaceBox& place = part.boxes[number.place];
        Interval& box = place.state[order];
        const StateRow& row = places_[number.place].state[order];
        const double middle = 0.5 * (box.lower + box.upper) - row.offset;
        step.weights = upper ? Eigen::VectorXd(-row.weights) : row.weights;
        step.side = upper ? -middle : middle;
        part.splits.push_back(log(std::move(step)));
        const Interval at = Interval(middle) + Interval(row.offset);
        (upper ? box.lower : box.upper) = upper ? at.lower : at.upper;
        place.steps[order][upper ? 0 : 1] = part.splits.back();
        add_row(part, part.splits.back());
    }
    rebuild_all(part);
    return part;
}

/// Of the numbers worth halving that whose halves are bounded best before a pass over their boxes (strong
/// branching).
std::vector<Node> Bounder::halves(const Node& node) {
    std::vector<Node> best;
    double highest = -infinity;
    for (const Halved& number : worth_halving(node)) {
        std::vector<Node> parts;
        double least = infinity;
        for (const bool upper : {false, true}) {
            parts.push_back(half(node, number, upper));
            if (settle(parts.back())) least = std::min(least, parts.back().bound);
        }
        if (!best.empty() && least <= highest) continue;
        highest = least;
        best = std::move(parts);
    }
    return best;
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
    close(root);
    result_.x = root.x;
    std::vector<Node> roots;
    roots.push_back(std::move(root));
    double closed = infinity;  // least bound of what is done with
    const auto still_open = [&](std::vector<Node> nodes) {
        for (const Node& node : nodes) {
            if (!is_done(node)) continue;
            if (!node.empty) closed = std::min(closed, node.bound);
            end_part(node);
        }
        std::erase_if(nodes, [&](const Node& node) { return is_done(node); });
        return nodes;
    };
    std::vector<Node> open = still_open(std::move(roots));
    double known = -infinity;
    int in_vain = 0;
    Branching<Node> by;
    by.is_closed = [](const Node&) { return false; };
    by.goes_on = [&](const Node& worst) {
        if (result_.parts >= options_.most_parts || control_.ending()) return false;
        const double left = bounded() ? incumbent_ - known : std::max(1.0, std::abs(known));
        const bool lifted = worst.bound > known + worth_a_half * left || known == -infinity;
        if (lifted) known = worst.bound;
        in_vain = lifted ? 0 : in_vain + 1;
        return in_vain < most_halves_in_vain;
    };
    by.branch = [&](const Node& node) -> std::optional<std::vector<Node>> {
        std::vector<Node> parts = halves(node);
        if (parts.empty()) return {};
        ++result_.parts;
        for (Node& part : parts) close(part);
        return still_open(std::move(parts));
    };
    branch_and_bound(open, by);
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
