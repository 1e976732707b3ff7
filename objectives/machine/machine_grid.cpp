// SPDX-License-Identifier: MIT
#include "objectives/machine/machine_grid.hpp"

namespace camopt {

MachineProblem::Grid::Grid(const MachineProblem& machine)
    : machine_(machine),
      row_of_(machine.blocks_.size() + machine.clearances_.size()),
      clear_(machine.clearances_.size()) {
    const auto rows = static_cast<Eigen::Index>(machine.rows_.size());
    shape_.x_lower.resize(machine.variables_);
    shape_.x_upper.resize(machine.variables_);
    shape_.g_lower = Eigen::VectorXd::Constant(rows, -infinity);
    shape_.g_upper = Eigen::VectorXd::Zero(rows);
    shape_.rows.resize(machine.rows_.size());
    shape_.convex = shape_.linear_cost = shape_.quadratic_cost = true;
    for (std::size_t i = 0; i < machine.rows_.size(); ++i)
        row_of_[static_cast<std::size_t>(machine.rows_[i].part)].push_back(static_cast<int>(i));
    for (int b = 0; b < machine.axes(); ++b) add_block_pattern(b);
    add_clearances();
}

void MachineProblem::Grid::add_block_pattern(int block) {
    const Block& own = machine_.blocks_[static_cast<std::size_t>(block)];
    const NlpShape& shape = own.problem->grid().shape();
    const std::vector<int>& rows = row_of_[static_cast<std::size_t>(block)];
    shape_.x_lower(own.columns) = shape.x_lower;
    shape_.x_upper(own.columns) = shape.x_upper;
    shape_.g_lower(rows) = shape.g_lower;
    shape_.g_upper(rows) = shape.g_upper;
    shape_.convex = shape_.convex && shape.convex;
    shape_.linear_cost = shape_.linear_cost && shape.linear_cost;
    shape_.quadratic_cost = shape_.quadratic_cost && shape.quadratic_cost;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        RowKind& kind = shape_.rows[static_cast<std::size_t>(rows[i])] = shape.rows[i];
        if (kind.limit && !machine_.relaxed_.empty())
            kind.limit = machine_.is_limit(own.spec.name + ": " +
                                           own.problem->grid().row_origin(static_cast<int>(i)).rule);
    }
    for (const int row : shape.jacobian.rows)
        shape_.jacobian.rows.push_back(rows[static_cast<std::size_t>(row)]);
    for (const int column : shape.jacobian.columns)
        shape_.jacobian.columns.push_back(own.columns[static_cast<std::size_t>(column)]);
    for (int k = 0; k < shape.hessian.size(); ++k) {
        const auto entry = static_cast<std::size_t>(k);
        const int row = own.columns[static_cast<std::size_t>(shape.hessian.rows[entry])];
        const int column = own.columns[static_cast<std::size_t>(shape.hessian.columns[entry])];
        shape_.hessian.rows.push_back(std::max(row, column));
        shape_.hessian.columns.push_back(std::min(row, column));
    }
}

void MachineProblem::Grid::add_clearances() {
    for (std::size_t k = 0; k < machine_.clearances_.size(); ++k) {
        const Clear& clear = machine_.clearances_[k];
        const std::vector<int>& rows = row_of_[machine_.blocks_.size() + k];
        for (std::size_t i = 0; i < rows.size(); ++i) {
            Row row = clearance_row(clear, clear.angles[i]);
            shape_.rows[static_cast<std::size_t>(rows[i])] = {true, machine_.is_limit(clear.rule.name), 1.0};
            shape_.jacobian.rows.insert(shape_.jacobian.rows.end(), row.columns.size(), rows[i]);
            shape_.jacobian.columns.insert(shape_.jacobian.columns.end(), row.columns.begin(),
                                           row.columns.end());
            clear_[k].push_back(std::move(row));
        }
    }
}

MachineProblem::Grid::Row MachineProblem::Grid::clearance_row(const Clear& clear, double angle) const {
    Row row;
    row.offset = clear.rule.at_least / clear.rule.scale;
    for (std::size_t k = 0; k < clear.rule.axes.size(); ++k) {
        const Block& block = machine_.blocks_[static_cast<std::size_t>(clear.rule.axes[k])];
        const CamModel& model = block.problem->model();
        const double size = -clear.rule.factors[k] * block.spec.lift / clear.rule.scale;
        const AffineRow y = model.design.functional(machine_.axis_place(clear.rule.axes[k], angle), 0);
        row.offset += size * y.offset;
        for (std::size_t j = 0; j < y.columns.size(); ++j) {
            if (y.weights[j] == 0.0) continue;
            row.columns.push_back(block.columns[static_cast<std::size_t>(y.columns[j])]);
            row.weights.push_back(size * y.weights[j] * variable_scale(model, y.columns[j]));
        }
    }
    return row;
}

double MachineProblem::Grid::cost(const ConstVectorRef& x) const {
    double sum = 0.0;
    for (int b = 0; b < machine_.axes(); ++b)
        sum += machine_.blocks_[static_cast<std::size_t>(b)].spec.weight *
               machine_.axis(b).grid().cost(machine_.axis_x(b, x));
    return sum;
}

void MachineProblem::Grid::gradient(const ConstVectorRef& x, VectorRef out) const {
    for (int b = 0; b < machine_.axes(); ++b) {
        const Block& block = machine_.blocks_[static_cast<std::size_t>(b)];
        const Eigen::VectorXd own = machine_.axis_x(b, x);
        Eigen::VectorXd slope(own.size());
        block.problem->grid().gradient(own, slope);
        out(block.columns) = block.spec.weight * slope;
    }
}

void MachineProblem::Grid::constraints(const ConstVectorRef& x, VectorRef out) const {
    for (int b = 0; b < machine_.axes(); ++b) {
        const Nlp& grid = machine_.axis(b).grid();
        Eigen::VectorXd values(grid.shape().constraints());
        grid.constraints(machine_.axis_x(b, x), values);
        out(row_of_[static_cast<std::size_t>(b)]) = values;
    }
    for (std::size_t k = 0; k < clear_.size(); ++k)
        for (std::size_t i = 0; i < clear_[k].size(); ++i) {
            const Row& row = clear_[k][i];
            double value = row.offset;
            for (std::size_t j = 0; j < row.columns.size(); ++j) value += row.weights[j] * x[row.columns[j]];
            out[row_of_[machine_.blocks_.size() + k][i]] = value;
        }
}

void MachineProblem::Grid::jacobian(const ConstVectorRef& x, std::span<double> out) const {
    std::size_t next = 0;
    for (int b = 0; b < machine_.axes(); ++b) {
        const Nlp& grid = machine_.axis(b).grid();
        const auto count = static_cast<std::size_t>(grid.shape().jacobian.size());
        grid.jacobian(machine_.axis_x(b, x), out.subspan(next, count));
        next += count;
    }
    for (const std::vector<Row>& rows : clear_)
        for (const Row& row : rows)
            for (const double weight : row.weights) out[next++] = weight;
}

void MachineProblem::Grid::hessian(const ConstVectorRef& x, double sigma, const ConstVectorRef& lambda,
                                   std::span<double> out) const {
    std::size_t next = 0;
    for (int b = 0; b < machine_.axes(); ++b) {
        const Block& block = machine_.blocks_[static_cast<std::size_t>(b)];
        const Nlp& grid = block.problem->grid();
        const auto count = static_cast<std::size_t>(grid.shape().hessian.size());
        const Eigen::VectorXd own = lambda(row_of_[static_cast<std::size_t>(b)]);
        grid.hessian(machine_.axis_x(b, x), sigma * block.spec.weight, own, out.subspan(next, count));
        next += count;
    }
}

std::string MachineProblem::Grid::variable_name(int index) const {
    for (const Block& block : machine_.blocks_)
        if (const auto found = std::ranges::find(block.columns, index); found != block.columns.end())
            return block.spec.name + ": " +
                   block.problem->grid().variable_name(static_cast<int>(found - block.columns.begin()));
    return {};
}

RowOrigin MachineProblem::Grid::row_origin(int index) const {
    const RowPlace& place = machine_.rows_[static_cast<std::size_t>(index)];
    const int clearance = place.part - machine_.axes();
    if (clearance >= 0) {
        const Clear& clear = machine_.clearances_[static_cast<std::size_t>(clearance)];
        RowOrigin origin;
        origin.rule = clear.rule.name;
        origin.at = clear.angles[static_cast<std::size_t>(place.row)];
        origin.limit = true;
        origin.order = 0;
        return origin;
    }
    const Block& block = machine_.blocks_[static_cast<std::size_t>(place.part)];
    RowOrigin origin = block.problem->grid().row_origin(place.row);
    origin.rule = block.spec.name + ": " + origin.rule;
    return origin;
}

}  // namespace camopt
