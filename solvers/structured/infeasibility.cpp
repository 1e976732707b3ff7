// SPDX-License-Identifier: MIT
#include "solvers/structured/interior_point.hpp"

namespace camopt::structured {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Triplets = std::vector<Eigen::Triplet<double>>;

/// Every finite side of a row as a separate row, with −t or +t added.
struct Elastic {
    ConvexModel model;
    std::vector<Index> source;  ///< row of the original behind each row
};

Elastic elastic_problem(const ConvexModel& model) {
    const Index n = model.variables();
    Elastic result;
    Triplets entries;
    const Eigen::SparseMatrix<double, Eigen::RowMajor> by_row = model.rows;
    std::vector<double> lower, upper;
    const auto add = [&](Index i, double low, double high, double slack) {
        const auto row = static_cast<int>(lower.size());
        for (Eigen::SparseMatrix<double, Eigen::RowMajor>::InnerIterator entry(by_row, i); entry; ++entry)
            entries.emplace_back(row, static_cast<int>(entry.col()), entry.value());
        entries.emplace_back(row, static_cast<int>(n), slack);
        lower.push_back(low);
        upper.push_back(high);
        result.source.push_back(i);
    };
    for (Index i = 0; i < model.constraints(); ++i) {
        if (std::isfinite(model.row_upper[i])) add(i, -infinity, model.row_upper[i], -1.0);
        if (std::isfinite(model.row_lower[i])) add(i, model.row_lower[i], infinity, 1.0);
    }
    ConvexModel& elastic = result.model;
    const auto rows = static_cast<Index>(lower.size());
    elastic.rows.resize(rows, n + 1);
    elastic.rows.setFromTriplets(entries.begin(), entries.end());
    elastic.row_lower = Eigen::Map<const VectorXd>(lower.data(), rows);
    elastic.row_upper = Eigen::Map<const VectorXd>(upper.data(), rows);
    elastic.x_lower.resize(n + 1);
    elastic.x_lower << model.x_lower, 0.0;
    elastic.x_upper.resize(n + 1);
    elastic.x_upper << model.x_upper, infinity;
    elastic.cost = std::make_unique<LinearCost>(VectorXd::Unit(n + 1, n));
    return result;
}

/// A bound on a quantity that grows from w along d: d is free where there is no bound.
void recession_bounds(double lower, double upper, double& low, double& high) {
    low = std::isfinite(lower) ? 0.0 : -infinity;
    high = std::isfinite(upper) ? 0.0 : infinity;
}

}  // namespace

ElasticResult least_violation(const ConvexModel& model, const VectorXd& start,
                              const InteriorPointLimits& limits, const SolveControl& control) {
    const Index n = model.variables();
    const Elastic elastic = elastic_problem(model);
    VectorXd from(n + 1);
    from << start, 1.0;
    InteriorPointLimits quiet = limits;
    quiet.suspicious = false;
    const InteriorPointResult solved = interior_point(elastic.model, from, quiet, control);
    ElasticResult result;
    result.stop = solved.stop;
    result.iterations = solved.iterations;
    result.accuracy = solved.errors.worst();
    if (!solved.has_point()) return result;
    result.x = solved.best.x.head(n);
    result.violation = solved.best.x[n];
    result.lambda = VectorXd::Zero(model.constraints());
    for (std::size_t k = 0; k < elastic.source.size(); ++k)
        result.lambda[elastic.source[k]] += solved.best.lambda[static_cast<Index>(k)];
    return result;
}

RecessionResult recession(const ConvexModel& model, const VectorXd& point, const InteriorPointLimits& limits,
                          const SolveControl& control) {
    const Index n = model.variables(), m = model.constraints();
    VectorXd gradient(n);
    model.cost->gradient(point, gradient);
    std::vector<double> curvature(static_cast<std::size_t>(model.hessian.size()));
    model.cost->hessian(point, curvature);
    Triplets entries;
    for (Index j = 0; j < n; ++j)
        for (ConvexModel::Matrix::InnerIterator entry(model.rows, j); entry; ++entry)
            entries.emplace_back(static_cast<int>(entry.row()), static_cast<int>(j), entry.value());
    const auto offset = static_cast<int>(m);
    for (std::size_t e = 0; e < curvature.size(); ++e) {
        const int row = model.hessian.rows[e], column = model.hessian.columns[e];
        entries.emplace_back(offset + row, column, curvature[e]);
        if (row != column) entries.emplace_back(offset + column, row, curvature[e]);
    }
    const Index curved = curvature.empty() ? 0 : n;
    ConvexModel cone;
    cone.rows.resize(m + curved, n);
    cone.rows.setFromTriplets(entries.begin(), entries.end());
    cone.row_lower = VectorXd::Zero(m + curved);
    cone.row_upper = VectorXd::Zero(m + curved);
    for (Index i = 0; i < m; ++i)
        recession_bounds(model.row_lower[i], model.row_upper[i], cone.row_lower[i], cone.row_upper[i]);
    cone.x_lower.resize(n);
    cone.x_upper.resize(n);
    VectorXd cost = gradient;
    for (Index j = 0; j < n; ++j) {
        recession_bounds(model.x_lower[j], model.x_upper[j], cone.x_lower[j], cone.x_upper[j]);
        // A variable bounded on both sides cannot move at all; as a tiny interval it stays a ConvexModel.
        const bool pinned = cone.x_lower[j] == cone.x_upper[j];
        cone.x_lower[j] = pinned ? -1e-9 : std::max(cone.x_lower[j], -1.0);
        cone.x_upper[j] = pinned ? 1e-9 : std::min(cone.x_upper[j], 1.0);
        if (pinned) cost[j] = 0.0;
    }
    cone.cost = std::make_unique<LinearCost>(cost);
    InteriorPointLimits quiet = limits;
    quiet.suspicious = false;
    const InteriorPointResult solved = interior_point(cone, VectorXd::Zero(n), quiet, control);
    RecessionResult result;
    result.iterations = solved.iterations;
    if (!solved.has_point()) return result;
    result.direction = solved.best.x.head(n);
    result.descends = solved.errors.worst() <= 1e-7 && cost.dot(result.direction) < -1e-6;
    return result;
}

}  // namespace camopt::structured
