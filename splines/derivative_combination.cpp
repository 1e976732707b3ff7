// SPDX-License-Identifier: MIT
#include "splines/derivative_combination.hpp"

#include "core/errors.hpp"

#include <fmt/format.h>

#include <map>

namespace camopt {

namespace {

/// Row m is (m + order)! / m! of row m + order: the r-th derivative of polynomials that are columns.
Eigen::MatrixXd derived(const Eigen::MatrixXd& polynomials, int order) {
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(polynomials.rows(), polynomials.cols());
    for (Eigen::Index m = 0; m + order < polynomials.rows(); ++m) {
        double factor = 1.0;
        for (int k = 1; k <= order; ++k) factor *= static_cast<double>(m + k);
        result.row(m) = factor * polynomials.row(m + order);
    }
    return result;
}

/// From the highest power down: w_0 a_m = b_m − w_1 (m + 1) a_{m+1} − w_2 (m + 1)(m + 2) a_{m+2}.
Eigen::MatrixXd solved_polynomials(Eigen::MatrixXd polynomials, const DerivativeCombination& of) {
    const Eigen::Index terms = polynomials.rows();
    for (Eigen::Index m = terms - 1; m >= 0; --m) {
        const auto power = static_cast<double>(m);
        if (m + 1 < terms) polynomials.row(m) -= of.weights[1] * (power + 1.0) * polynomials.row(m + 1);
        if (m + 2 < terms)
            polynomials.row(m) -= of.weights[2] * (power + 1.0) * (power + 2.0) * polynomials.row(m + 2);
        polynomials.row(m) /= of.weights[0];
    }
    return polynomials;
}

/// The parts of a motion with other curves and levels: dwells and splines that are neither scaled nor
/// mirrored.
template <class ChangeCurve>
MotionChain with_curves(const MotionChain& motion, double level, ChangeCurve&& changed) {
    std::vector<ChainPart> parts = motion.parts();
    std::map<const Motion*, std::shared_ptr<const SplineCurve>> curves;  // parts of one run share theirs
    for (ChainPart& part : parts) {
        if (!part.shape) {
            part.y0 *= level;
            continue;
        }
        const auto* const own = dynamic_cast<const SplineCurve*>(part.shape.get());
        if (own == nullptr || part.x_scale != 1.0 || part.y_scale != 1.0 || part.y0 != 0.0)
            throw ModelError("the output of a train: a part of the motion is not a plain spline");
        auto& curve = curves[own];
        if (!curve) curve = std::make_shared<const SplineCurve>(changed(*own));
        part.shape = curve;
    }
    return MotionChain(std::move(parts));
}

}  // namespace

Eigen::MatrixXd combined(const Eigen::MatrixXd& polynomials, const DerivativeCombination& of) {
    Eigen::MatrixXd sum = of.weights[0] * polynomials;
    for (int order = 1; order <= of.highest_order(); ++order)
        sum += of.weights[static_cast<std::size_t>(order)] * derived(polynomials, order);
    return sum;
}

LocalMap combined(LocalMap map, const DerivativeCombination& of) {
    map.matrix = combined(map.matrix, of);
    map.offset = combined(map.offset, of);
    return map;
}

SplineSpace combined(const SplineSpace& space, const DerivativeCombination& of) {
    const int continuity = space.continuity() - of.highest_order();
    if (continuity < 0)
        throw InputError(
            fmt::format("the output of a train: found a spline of continuity {}; allowed: {} or more",
                        space.continuity(), of.highest_order()));
    return {space.degree(), continuity, space.breakpoints()};
}

MotionChain combined(const MotionChain& motion, const DerivativeCombination& of) {
    return with_curves(motion, of.weights[0], [&](const SplineCurve& y) {
        return SplineCurve(combined(y.space(), of), combined(y.pieces(), of));
    });
}

MotionChain solved(const MotionChain& motion, const DerivativeCombination& of) {
    return with_curves(motion, 1.0 / of.weights[0], [&](const SplineCurve& s) {
        const SplineSpace& space = s.space();
        const int continuity = std::min(space.degree() - 1, space.continuity() + of.highest_order());
        return SplineCurve(SplineSpace(space.degree(), continuity, space.breakpoints()),
                           solved_polynomials(s.pieces(), of));
    });
}

}  // namespace camopt
