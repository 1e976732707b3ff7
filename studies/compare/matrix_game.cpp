// SPDX-License-Identifier: MIT
#include "studies/compare/matrix_game.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <limits>
#include <vector>

namespace camopt {

namespace {

// Corners of nearly parallel faces are far away or rounding; others of the same value stand beside them.
constexpr double singular = 1e-12;
// A share below zero by this much is zero.
constexpr double game_rounding = 1e-12;

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

}  // namespace

GameValue solve_game(std::span<const std::array<double, 3>> rows) {
    const std::vector<Eigen::Vector4d> faces = faces_of(rows);
    GameValue best{{1.0, 0.0, 0.0}, -std::numeric_limits<double>::infinity()};
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
                if (mix.minCoeff() < -game_rounding) continue;
                mix = mix.cwiseMax(0.0) / mix.cwiseMax(0.0).sum();
                const double value = least_row(rows, mix);
                if (value > best.value) best = {{mix[0], mix[1], mix[2]}, value};
            }
        }
    }
    return best;
}

}  // namespace camopt
