// SPDX-License-Identifier: MIT
#include "splines/gram.hpp"

#include <cmath>
#include <vector>

namespace camopt {

namespace {

/// ∫_0^h (Σ_m u_m t^m)(Σ_k v_k t^k) dt as uᵀ W v, for the derivative of `order` of a polynomial with `size`
/// terms.
Eigen::MatrixXd energy_of_monomials(int size, int order, double h) {
    Eigen::MatrixXd energy = Eigen::MatrixXd::Zero(size, size);
    const auto falling = [order](int m) {
        double factor = 1.0;
        for (int r = 0; r < order; ++r) factor *= m - r;
        return factor;
    };
    for (int m = order; m < size; ++m) {
        for (int k = order; k < size; ++k) {
            const int power = m + k - 2 * order + 1;
            energy(m, k) = falling(m) * falling(k) * std::pow(h, power) / power;
        }
    }
    return energy;
}

}  // namespace

void add_energy(const LocalMap& map, int order, double width, double weight, QuadraticForm& form,
                std::vector<Eigen::Triplet<double>>& entries) {
    const Eigen::MatrixXd energy =
        weight * energy_of_monomials(static_cast<int>(map.offset.size()), order, width);
    const Eigen::MatrixXd weighted = energy * map.matrix;
    const Eigen::MatrixXd local = map.matrix.transpose() * weighted;
    const Eigen::VectorXd linear = weighted.transpose() * map.offset;
    for (int a = 0; a < static_cast<int>(map.columns.size()); ++a) {
        form.linear[map.columns[a]] += linear[a];
        for (int b = 0; b < static_cast<int>(map.columns.size()); ++b) {
            entries.emplace_back(map.columns[a], map.columns[b], local(a, b));
        }
    }
    form.constant += map.offset.dot(energy * map.offset);
}

QuadraticForm mean_square_form(const DesignVector& design, int order) {
    const SplineSpace& space = design.space();
    QuadraticForm form;
    form.linear = Eigen::VectorXd::Zero(design.size());
    std::vector<Eigen::Triplet<double>> entries;
    const double part = 1.0 / (space.end() - space.begin());
    for (int i = 0; i < space.segments(); ++i) {
        add_energy(design.local_map(i), order, space.width(i), part, form, entries);
    }
    form.matrix.resize(design.size(), design.size());
    form.matrix.setFromTriplets(entries.begin(), entries.end());
    return form;
}

}  // namespace camopt
