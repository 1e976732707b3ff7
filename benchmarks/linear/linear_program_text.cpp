// SPDX-License-Identifier: MIT
#include "benchmarks/linear/linear_program_text.hpp"

#include "core/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <vector>

namespace camopt::benchmarks {

namespace {

void require_linear(const NlpShape& shape) {
    const bool linear_rows = std::ranges::all_of(shape.rows, [](const RowKind& row) { return row.linear; });
    if (!shape.linear_cost || !linear_rows)
        throw ModelError("a linear program was expected, and the cost or a row is not linear");
}

}  // namespace

LinearProgram linear_program(const Nlp& problem) {
    const NlpShape& shape = problem.shape();
    require_linear(shape);
    const int variables = shape.variables(), constraints = shape.constraints();
    const Eigen::VectorXd zero = Eigen::VectorXd::Zero(variables);
    LinearProgram program;
    program.constant = problem.cost(zero);
    program.cost.resize(variables);
    problem.gradient(zero, program.cost);
    program.x_lower = shape.x_lower;
    program.x_upper = shape.x_upper;
    Eigen::VectorXd offset(constraints);
    problem.constraints(zero, offset);
    program.row_lower = shape.g_lower - offset;
    program.row_upper = shape.g_upper - offset;
    program.row_size.resize(constraints);
    for (int row = 0; row < constraints; ++row) program.row_size[row] = shape.rows[row].scale;
    std::vector<double> values(shape.jacobian.size());
    problem.jacobian(zero, values);
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(values.size());
    for (std::size_t k = 0; k < values.size(); ++k)
        entries.emplace_back(shape.jacobian.rows[k], shape.jacobian.columns[k], values[k]);
    program.rows.resize(constraints, variables);
    program.rows.setFromTriplets(entries.begin(), entries.end());
    return program;
}

std::string linear_program_text(const LinearProgram& program) {
    std::string text;
    const auto out = std::back_inserter(text);
    fmt::format_to(out, "{} {} {} {}\n", program.rows.cols(), program.rows.rows(), program.rows.nonZeros(),
                   program.constant);
    for (Eigen::Index i = 0; i < program.cost.size(); ++i)
        fmt::format_to(out, "{} {} {}\n", program.cost[i], program.x_lower[i], program.x_upper[i]);
    for (Eigen::Index i = 0; i < program.row_lower.size(); ++i)
        fmt::format_to(out, "{} {} {}\n", program.row_lower[i], program.row_upper[i], program.row_size[i]);
    for (int column = 0; column < program.rows.outerSize(); ++column)
        for (Eigen::SparseMatrix<double>::InnerIterator entry(program.rows, column); entry; ++entry)
            fmt::format_to(out, "{} {} {}\n", entry.row(), entry.col(), entry.value());
    return text;
}

}  // namespace camopt::benchmarks
