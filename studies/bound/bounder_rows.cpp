// SPDX-License-Identifier: MIT
#include "studies/bound/bounder.hpp"

namespace camopt::box_bound {

namespace {

// A plane this far inside its rule, relative to its own size, is worth a row.
constexpr double worth_a_row = 1e-9;
// A corner this part of a box's width outside of it is cut off.
constexpr double outside_box = 1e-4;
// Rows with more room than this are let go when boxes change; in units of x.
constexpr double idle_room = 0.05;

Eigen::VectorXd with_parameters(const Eigen::VectorXd& state, const std::vector<int>& parameters,
                                const Eigen::VectorXd& x, int design_size) {
    Eigen::VectorXd all(4 + static_cast<Eigen::Index>(parameters.size()));
    all.head(4) = state;
    for (std::size_t k = 0; k < parameters.size(); ++k)
        all[4 + static_cast<Eigen::Index>(k)] = x[design_size + parameters[k]];
    return all;
}

}  // namespace

int Bounder::log(BoxStep step) {
    proof_.steps.push_back(std::move(step));
    return static_cast<int>(proof_.steps.size()) - 1;
}

/// A row of the program whose weights and side are those of a step.
void Bounder::add_row(Node& node, int step, bool may_go) {
    const BoxStep& row = proof_.steps[static_cast<std::size_t>(step)];
    node.program.add_row(row.weights, row.side);
    node.steps.push_back(step);
    node.may_go.push_back(may_go ? 1 : 0);
}

/// Of a row of the grid and a side of it, the same for all parts.
int Bounder::linear_step(int row, int side, const BoxStep& step) {
    const auto [known, fresh] = linear_steps_.try_emplace({row, side}, 0);
    if (fresh) known->second = log(step);
    return known->second;
}

std::vector<std::pair<int, double>> Bounder::named(const Node& node, const VertexBound& found) const {
    std::vector<std::pair<int, double>> steps;
    for (const auto& [row, multiplier] : found.multipliers)
        steps.emplace_back(node.steps[static_cast<std::size_t>(row)], multiplier);
    return steps;
}

std::vector<int> Bounder::bounds_of(const Node& node) const {
    std::vector<int> steps;
    for (const auto& ends : node.bound_steps)
        for (const int step : ends)
            if (step >= 0) steps.push_back(step);
    return steps;
}

void Bounder::keep_bound(Node& node, const VertexBound& found) {
    node.multipliers = named(node, found);
    node.bounds_used = bounds_of(node);
}

/// Of a part that nothing more is done with.
void Bounder::end_part(const Node& node) {
    proof_.parts.push_back(
        {node.splits, node.multipliers, node.bounds_used, node.empty ? infinity : node.bound, node.empty});
}

/// Rows of the linear rules that the grid has and the node has not.
void Bounder::sync_linear(Node& node) {
    const Nlp& grid = linear_.grid();
    const NlpShape& shape = grid.shape();
    if (node.linear_rows == shape.constraints()) return;
    const Eigen::VectorXd zero = Eigen::VectorXd::Zero(shape.variables());
    Eigen::VectorXd offsets(shape.constraints());
    grid.constraints(zero, offsets);
    std::vector<double> values(static_cast<std::size_t>(shape.jacobian.size()));
    grid.jacobian(zero, values);
    std::vector<Eigen::VectorXd> rows(static_cast<std::size_t>(shape.constraints() - node.linear_rows), zero);
    for (int k = 0; k < shape.jacobian.size(); ++k) {
        const int row = shape.jacobian.rows[static_cast<std::size_t>(k)] - node.linear_rows;
        if (row >= 0)
            rows[static_cast<std::size_t>(row)][shape.jacobian.columns[static_cast<std::size_t>(k)]] +=
                values[static_cast<std::size_t>(k)];
    }
    for (int i = node.linear_rows; i < shape.constraints(); ++i) {
        const Eigen::VectorXd& row = rows[static_cast<std::size_t>(i - node.linear_rows)];
        const double rounding = shape.rows[static_cast<std::size_t>(i)].rounding;
        BoxStep step;
        step.origin = grid.row_origin(i);
        if (shape.g_upper[i] < infinity) {
            step.weights = row;
            step.side = shape.g_upper[i] - offsets[i] + rounding;
            add_row(node, linear_step(i, 0, step));
        }
        if (shape.g_lower[i] > -infinity) {
            step.weights = -row;
            step.side = offsets[i] - shape.g_lower[i] + rounding;
            add_row(node, linear_step(i, 1, step));
        }
    }
    node.linear_rows = shape.constraints();
}

bool Bounder::add_plane(Node& node, std::size_t place, const Bent& bent, const Eigen::VectorXd& at,
                        bool always) {
    const std::optional<RulePlane> plane = bent.over->plane(at);
    if (!plane) return false;
    if (!always && plane->slope.dot(at) + plane->constant <= worth_a_row) return false;
    const int variables = node.program.variables();
    Eigen::VectorXd a = Eigen::VectorXd::Zero(variables);
    double b = -plane->constant, size = std::abs(plane->constant);
    for (int order = 0; order < 4; ++order) {
        const StateRow& row = places_[place].state[static_cast<std::size_t>(order)];
        const double slope = plane->slope[order];
        if (slope == 0.0) continue;
        a += slope * row.weights;
        b -= slope * row.offset;
        size += std::abs(slope * row.offset);
    }
    const std::vector<int>& parameters =
        whole_.model().rules[static_cast<std::size_t>(bent.rule)]->parameters();
    for (std::size_t k = 0; k < parameters.size(); ++k)
        a[design_size() + parameters[k]] += plane->slope[4 + static_cast<Eigen::Index>(k)];
    // Rounding of a and b, whatever x in its bounds.
    for (int j = 0; j < variables; ++j)
        if (a[j] != 0.0)
            size +=
                std::abs(a[j]) * std::max(std::abs(node.program.lower(j)), std::abs(node.program.upper(j)));
    constexpr double rounding = 16.0 * std::numeric_limits<double>::epsilon();
    BoxStep step;
    step.kind = BoxStep::Kind::plane;
    step.weights = std::move(a);
    step.side = b + rounding * size;
    step.origin = whole_.model().rules[static_cast<std::size_t>(bent.rule)]->origin();
    step.origin.at = places_[place].at;
    step.origin.side = places_[place].side;
    step.box = bent.over->box();
    const std::array<std::array<int, 2>, 4>& ends = node.boxes[place].steps;
    step.ends.assign(ends.begin(), ends.end());
    for (const int parameter : parameters)
        step.ends.push_back(
            node.bound_steps[static_cast<std::size_t>(design_size()) + static_cast<std::size_t>(parameter)]);
    step.slope = plane->slope;
    step.constant = plane->constant;
    add_row(node, log(std::move(step)), true);
    return true;
}

/// The boxes are proved: what leaves one is cut off.
int Bounder::add_box_rows_at(Node& node, std::size_t place, const Eigen::VectorXd& state) {
    int added = 0;
    for (int order = 0; order < 3; ++order) {
        const Interval& box = node.boxes[place].state[static_cast<std::size_t>(order)];
        const double worth = worth_a_row + outside_box * box.width();
        const std::array<int, 2>& ends = node.boxes[place].steps[static_cast<std::size_t>(order)];
        if (state[order] > box.upper + worth && ends[1] >= 0) {
            add_row(node, ends[1], true);
            ++added;
        }
        if (state[order] < box.lower - worth && ends[0] >= 0) {
            add_row(node, ends[0], true);
            ++added;
        }
    }
    return added;
}

int Bounder::add_planes_at(Node& node, const Eigen::VectorXd& x) {
    int added = 0;
    for (std::size_t place = 0; place < places_.size(); ++place) {
        if (!node.boxes[place].bites) continue;
        const Eigen::VectorXd state = places_[place].point(x);
        added += add_box_rows_at(node, place, state);
        for (const Bent& bent : node.boxes[place].bent) {
            if (!bent.over || bent.over->most() <= 0.0) continue;
            const Eigen::VectorXd at = with_parameters(
                state, whole_.model().rules[static_cast<std::size_t>(bent.rule)]->parameters(), x,
                design_size());
            if (add_plane(node, place, bent, at, false)) ++added;
        }
    }
    return added;
}

void Bounder::rebuild_all(Node& node) {
    // Planes of larger boxes hold on, those near the bound's motion are kept.
    std::vector<char> kept(static_cast<std::size_t>(node.program.rows()), 1);
    if (node.x.size() > 0)
        for (int i = 0; i < node.program.rows(); ++i)
            if (node.may_go[static_cast<std::size_t>(i)] != 0 && node.program.slack(i, node.x) >= idle_room)
                kept[static_cast<std::size_t>(i)] = 0;
    const std::vector<int> stay = node.program.drop_rows(std::move(kept));
    std::vector<char> may_go;
    std::vector<int> steps;
    for (const int row : stay) {
        may_go.push_back(node.may_go[static_cast<std::size_t>(row)]);
        steps.push_back(node.steps[static_cast<std::size_t>(row)]);
    }
    node.may_go = std::move(may_go);
    node.steps = std::move(steps);
    for (std::size_t place = 0; place < places_.size(); ++place) {
        rebuild(node, place);
        const PlaceBox& box = node.boxes[place];
        if (!box.bites) continue;
        for (const Bent& bent : box.bent) {
            if (!bent.over || bent.over->most() <= 0.0) continue;
            const std::vector<Interval>& numbers = bent.over->box();
            Eigen::VectorXd at(static_cast<Eigen::Index>(numbers.size()));
            for (Eigen::Index i = 0; i < at.size(); ++i) {
                const Interval& number = numbers[static_cast<std::size_t>(i)];
                at[i] = std::isfinite(number.width()) ? 0.5 * (number.lower + number.upper) : 0.0;
            }
            add_plane(node, place, bent, at, true);
        }
    }
}

}  // namespace camopt::box_bound
