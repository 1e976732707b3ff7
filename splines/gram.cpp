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

QuadraticForm mean_square_form(const DesignVector& design, int order) {
    const SplineSpace& space = design.space();
    const double length = space.end() - space.begin();
    QuadraticForm form;
    form.linear = Eigen::VectorXd::Zero(design.size());
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < space.segments(); ++i) {
        const LocalMap& map = design.local_map(i);
        const Eigen::MatrixXd energy =
            energy_of_monomials(space.degree() + 1, order, space.width(i)) / length;
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
    form.matrix.resize(design.size(), design.size());
    form.matrix.setFromTriplets(entries.begin(), entries.end());
    return form;
}

}  // namespace camopt
