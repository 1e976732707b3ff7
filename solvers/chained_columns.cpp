// SPDX-License-Identifier: MIT
#include "solvers/chained_columns.hpp"

#include "core/errors.hpp"

#include <fmt/core.h>

#include <map>

namespace camopt {

namespace {

// Rows whose smallest columns lie this close share a copy. Measured on the states form, three variables per
// knot: from 24 to 48 is fastest; 3 takes half as long again, and from 96 on it causes fill.
constexpr int group_width = 24;

std::vector<bool> in_hessian(const NlpShape& shape) {
    std::vector<bool> found(shape.variables(), false);
    for (int k = 0; k < shape.hessian.size(); ++k)
        found[shape.hessian.rows[k]] = found[shape.hessian.columns[k]] = true;
    return found;
}

/// For each row the smallest of its columns that are not chained; −1 where there is none.
std::vector<int> smallest_columns(const NlpShape& shape, const std::vector<int>& chained) {
    std::vector<bool> left_out(shape.variables(), false);
    for (const int column : chained) left_out[column] = true;
    std::vector<int> smallest(shape.constraints(), -1);
    for (int k = 0; k < shape.jacobian.size(); ++k) {
        const int column = shape.jacobian.columns[k];
        int& least = smallest[shape.jacobian.rows[k]];
        if (!left_out[column] && (least < 0 || column < least)) least = column;
    }
    return smallest;
}

void check_columns(const NlpShape& shape, const std::vector<int>& columns) {
    const std::vector<bool> curved = in_hessian(shape);
    for (const int column : columns) {
        if (column < 0 || column >= shape.variables())
            throw ModelError(fmt::format("chained columns: there is no column {}, allowed are 0 … {}", column,
                                         shape.variables() - 1));
        if (curved[column])
            throw ModelError(
                fmt::format("chained columns: column {} has an entry in the Hessian, allowed are "
                            "columns that enter linearly",
                            column));
    }
}

void append(Eigen::VectorXd& values, Eigen::Index size, double value) {
    const Eigen::Index old = values.size();
    values.conservativeResize(size);
    values.tail(size - old).setConstant(value);
}

}  // namespace

std::vector<int> dense_columns(const NlpShape& shape, double share, int most) {
    std::vector<int> entries(shape.variables(), 0), dense;
    for (const int column : shape.jacobian.columns) ++entries[column];
    const std::vector<bool> curved = in_hessian(shape);
    for (int j = 0; j < shape.variables(); ++j)
        if (entries[j] > 1 && entries[j] >= share * shape.constraints() && !curved[j]) dense.push_back(j);
    if (static_cast<int>(dense.size()) > most) dense.clear();
    return dense;
}

ChainedColumns::ChainedColumns(const Nlp& base, const std::vector<int>& columns, const ConstVectorRef& point)
    : Nlp(base.shape()), base_(base), base_variables_(shape_.variables()), base_rows_(shape_.constraints()) {
    check_columns(shape_, columns);
    std::vector<double> jacobian(shape_.jacobian.rows.size());
    base.jacobian(point, jacobian);
    const std::vector<int> smallest = smallest_columns(shape_, columns);
    for (const int column : columns) chain(column, smallest, jacobian);
    add_ties();
}

void ChainedColumns::chain(int column, const std::vector<int>& smallest,
                           const std::vector<double>& jacobian) {
    std::map<int, std::vector<int>> groups;  // place in the chain → entries of the Jacobian
    for (int k = 0; k < base_.shape().jacobian.size(); ++k) {
        const int row = shape_.jacobian.rows[k];
        if (base_.shape().jacobian.columns[k] == column && smallest[row] >= 0)
            groups[smallest[row] / group_width].push_back(k);
    }
    int previous = column;  // the first group keeps the variable itself
    for (auto group = groups.begin(); group != groups.end(); ++group) {
        if (group == groups.begin()) continue;
        const int copy = base_variables_ + copies();
        copy_of_.push_back(column);
        ties_.push_back({column, previous, copy});
        previous = copy;
        for (const int k : group->second) {
            shape_.jacobian.columns[k] = copy;
            shifts_.push_back({shape_.jacobian.rows[k], column, copy, jacobian[k]});
        }
    }
}

void ChainedColumns::add_ties() {
    const Eigen::Index variables = base_variables_ + copies();
    const Eigen::Index rows = base_rows_ + std::ssize(ties_);
    append(shape_.x_lower, variables, -infinity);
    append(shape_.x_upper, variables, infinity);
    append(shape_.g_lower, rows, 0.0);
    append(shape_.g_upper, rows, 0.0);
    for (std::size_t t = 0; t < ties_.size(); ++t) {
        shape_.rows.push_back({true, false, 1.0});
        for (const int copy : {ties_[t].first, ties_[t].second}) {
            shape_.jacobian.rows.push_back(base_rows_ + static_cast<int>(t));
            shape_.jacobian.columns.push_back(copy);
        }
    }
}

void ChainedColumns::gradient(const ConstVectorRef& x, VectorRef out) const {
    base_.gradient(x.head(base_variables_), out.head(base_variables_));
    out.tail(copies()).setZero();
}

void ChainedColumns::constraints(const ConstVectorRef& x, VectorRef out) const {
    base_.constraints(x.head(base_variables_), out.head(base_rows_));
    for (const Shift& shift : shifts_) out[shift.row] += shift.slope * (x[shift.copy] - x[shift.column]);
    for (std::size_t t = 0; t < ties_.size(); ++t)
        out[base_rows_ + static_cast<Eigen::Index>(t)] = x[ties_[t].first] - x[ties_[t].second];
}

void ChainedColumns::jacobian(const ConstVectorRef& x, std::span<double> out) const {
    const std::size_t own = base_.shape().jacobian.rows.size();
    base_.jacobian(x.head(base_variables_), out.first(own));
    for (std::size_t k = own; k < out.size(); k += 2) {
        out[k] = 1.0;
        out[k + 1] = -1.0;
    }
}

std::string ChainedColumns::variable_name(int index) const {
    if (index < base_variables_) return base_.variable_name(index);
    const int further = index - base_variables_;
    const int column = copy_of_[further];
    const auto number = std::count(copy_of_.begin(), copy_of_.begin() + further, column) + 2;
    return fmt::format("{}, copy {}", base_.variable_name(column), number);
}

std::string ChainedColumns::row_name(int index) const {
    if (index < base_rows_) return base_.row_name(index);
    const Tie& tie = ties_[static_cast<std::size_t>(index - base_rows_)];
    return fmt::format("{} = {}", variable_name(tie.first), variable_name(tie.second));
}

ChainedColumns::Vector ChainedColumns::chained(const ConstVectorRef& base_x) const {
    Vector x(shape_.variables());
    x.head(base_variables_) = base_x;
    for (int copy = 0; copy < copies(); ++copy) x[base_variables_ + copy] = base_x[copy_of_[copy]];
    return x;
}

}  // namespace camopt
