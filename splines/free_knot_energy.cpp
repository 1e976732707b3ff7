// SPDX-License-Identifier: MIT
#include "splines/free_knot_energy.hpp"

namespace camopt {

SegmentEnergy segment_energy(const FreeKnotForm& form, const Eigen::VectorXd& x, int segment, int order) {
    const FreePoint end = form.point(x, {segment, true, 1.0});
    const double h = end.tau;
    const int terms = form.degree() - order + 1;
    const int left = terms, right = terms + 1;
    Eigen::VectorXd a(terms);
    for (int k = 0; k < terms; ++k) a[k] = x[form.coefficient(segment, order + k)];
    Eigen::MatrixXd gram(terms, terms);
    for (int k = 0; k < terms; ++k) {
        for (int l = 0; l < terms; ++l) {
            gram(k, l) = h * FreeKnotForm::power(h, 0, k) * FreeKnotForm::power(h, 0, l) / (k + l + 1);
        }
    }
    SegmentEnergy energy{a.dot(gram * a), Eigen::VectorXd::Zero(terms + 2),
                         Eigen::MatrixXd::Zero(terms + 2, terms + 2)};
    const double at_end = end.derivative[static_cast<std::size_t>(order)];
    const double next = end.derivative[static_cast<std::size_t>(order) + 1];
    energy.slope.head(terms) = 2.0 * gram * a;
    energy.slope[right] = at_end * at_end;
    energy.slope[left] = -energy.slope[right];
    energy.curvature.topLeftCorner(terms, terms) = 2.0 * gram;
    for (int k = 0; k < terms; ++k) {
        const double mixed = 2.0 * at_end * FreeKnotForm::power(h, 0, k);
        energy.curvature(k, right) = energy.curvature(right, k) = mixed;
        energy.curvature(k, left) = energy.curvature(left, k) = -mixed;
    }
    const double by_length = 2.0 * at_end * next;
    energy.curvature(left, left) = energy.curvature(right, right) = by_length;
    energy.curvature(left, right) = energy.curvature(right, left) = -by_length;
    return energy;
}

}  // namespace camopt
