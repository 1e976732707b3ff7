// SPDX-License-Identifier: MIT
#include "studies/compare/matrix_game.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace camopt {

namespace {

// Corners of nearly parallel faces are far away, rounding or no numbers at all (the determinant may round to
// more than this where a pivot is zero); others of the same value stand beside them.
constexpr double singular = 1e-24;
// A share below zero by this much is zero.
constexpr double game_rounding = 1e-12;
// A row lower by less than this changes nothing.
constexpr double same_value = 1e-12;

double least_row(std::span<const std::array<double, 3>> rows, const Eigen::Vector3d& mix) {
    double least = std::numeric_limits<double>::infinity();
    for (const std::array<double, 3>& row : rows)
        least = std::min(least, row[0] * mix[0] + row[1] * mix[1] + row[2] * mix[2]);
    return least;
}

/// Faces over (u, t): row · u − t = 0 for each row, then u_i = 0.
std::vector<Eigen::Vector4d> faces_of(std::span<const std::array<double, 3>> rows) {
    std::vector<Eigen::Vector4d> faces;
    for (const std::array<double, 3>& row : rows) faces.emplace_back(row[0], row[1], row[2], -1.0);
    for (int i = 0; i < 3; ++i) faces.emplace_back(Eigen::Vector4d::Unit(i));
    return faces;
}

/// The most that any column has of these rows mixed.
double most_of_columns(std::span<const std::array<double, 3>> rows, const std::array<std::size_t, 3>& chosen,
                       const Eigen::Vector3d& shares) {
    std::array<double, 3> columns{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 3; ++k)
            if (const double share = shares[static_cast<Eigen::Index>(i)]; share > 0.0)
                columns[k] += share * rows[chosen[i]][k];
    return std::ranges::max(columns);
}

/// Three rows (some of them the same one: fewer) mixed so that `columns` of them are equal.
double bound_by(std::span<const std::array<double, 3>> rows, const std::array<std::size_t, 3>& chosen,
                std::span<const int> columns) {
    const auto count = static_cast<Eigen::Index>(columns.size());
    Eigen::MatrixXd system = Eigen::MatrixXd::Zero(count + 1, count + 1);
    for (Eigen::Index i = 0; i < count; ++i) {
        for (Eigen::Index j = 0; j < count; ++j)
            system(j, i) = rows[chosen[static_cast<std::size_t>(i)]]
                               [static_cast<std::size_t>(columns[static_cast<std::size_t>(j)])];
        system(i, count) = -1.0;
        system(count, i) = 1.0;
    }
    const Eigen::VectorXd solution = system.partialPivLu().solve(Eigen::VectorXd::Unit(count + 1, count));
    Eigen::Vector3d shares = Eigen::Vector3d::Zero();
    shares.head(count) = solution.head(count).cwiseMax(0.0);
    const double sum = shares.sum();
    if (!shares.allFinite() || !(sum > 0.0)) return std::numeric_limits<double>::infinity();
    return most_of_columns(rows, chosen, shares / sum);
}

/// The least bound of all mixes of one, two or three rows.
double least_bound(std::span<const std::array<double, 3>> rows) {
    static constexpr std::array<std::array<int, 2>, 3> pairs = {{{0, 1}, {0, 2}, {1, 2}}};
    static constexpr std::array<int, 3> all = {0, 1, 2};
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < rows.size(); ++i) {
        least = std::min(least, std::ranges::max(rows[i]));
        for (std::size_t j = i + 1; j < rows.size(); ++j) {
            for (const std::array<int, 2>& pair : pairs)
                least = std::min(least, bound_by(rows, {i, j, j}, pair));
            for (std::size_t k = j + 1; k < rows.size(); ++k)
                least = std::min(least, bound_by(rows, {i, j, k}, all));
        }
    }
    return least;
}

}  // namespace

GameValue solve_game(std::span<const std::array<double, 3>> rows) {
    const std::vector<Eigen::Vector4d> faces = faces_of(rows);
    GameValue best{{1.0, 0.0, 0.0}, -std::numeric_limits<double>::infinity(), 0.0};
    Eigen::Matrix4d system;
    system.row(3) << 1.0, 1.0, 1.0, 0.0;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        for (std::size_t j = i + 1; j < faces.size(); ++j) {
            for (std::size_t k = j + 1; k < faces.size(); ++k) {
                system.row(0) = faces[i];
                system.row(1) = faces[j];
                system.row(2) = faces[k];
                if (std::abs(system.determinant()) < singular) continue;
                Eigen::Vector3d mix = system.partialPivLu().solve(Eigen::Vector4d::Unit(3)).head<3>();
                if (!mix.allFinite() || mix.minCoeff() < -game_rounding) continue;
                mix = mix.cwiseMax(0.0) / mix.cwiseMax(0.0).sum();
                const double value = least_row(rows, mix);
                if (value > best.value) best = {{mix[0], mix[1], mix[2]}, value};
            }
        }
    }
    best.bound = least_bound(rows);
    return best;
}

GameValue solve_game_by_cuts(std::span<const std::array<double, 3>> rows) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    GameValue game{{1.0 / 3, 1.0 / 3, 1.0 / 3}, infinity, infinity};
    std::vector<std::array<double, 3>> chosen;
    while (true) {
        const std::array<double, 3>* lowest = nullptr;
        double least = game.value - same_value;
        for (const std::array<double, 3>& row : rows) {
            const double value = game.mix[0] * row[0] + game.mix[1] * row[1] + game.mix[2] * row[2];
            if (!(value < least)) continue;
            least = value;
            lowest = &row;
        }
        // A row that is in the game already is lower by rounding alone.
        if (lowest == nullptr || std::ranges::find(chosen, *lowest) != chosen.end()) return game;
        chosen.push_back(*lowest);
        game = solve_game(chosen);
    }
}

}  // namespace camopt
