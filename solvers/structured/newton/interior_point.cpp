// SPDX-License-Identifier: MIT

#include "solvers/structured/linearized_problem.hpp"
#include "solvers/structured/newton/newton_step.hpp"
#include "solvers/structured/newton/path_reduction.hpp"

namespace camopt::structured {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

class Iteration {
 public:
    Iteration(const ConvexModel& model, const InteriorPointLimits& limits)
        : model_(model), limits_(limits), ranges_(model), newton_(model, ranges_, limits) {
        for (Direction* direction : {&affine_, &direction_, &trial_})
            direction->resize(model.variables(), ranges_);
        for (Iterate& point : points_) point.resize(model.variables(), ranges_);
    }

    InteriorPointResult run(const VectorXd& start, const SolveControl& control) {
        return initialise(start) ? run(control) : not_evaluated();
    }
    InteriorPointResult run(const CentralPoint& near, const SolveControl& control) {
        return resume(near) ? run(control) : not_evaluated();
    }

 private:
    static InteriorPointResult not_evaluated() {
        InteriorPointResult result;
        result.stop = Stop::evaluation_error;
        return result;
    }
    InteriorPointResult run(const SolveControl& control) {
        InteriorPointResult result = search(control);
        const Iterate& best = points_[best_];
        if (result.has_point()) result.best = {best.x, ranges_.row_multipliers(best.lambda, best.dual)};
        return result;
    }
    InteriorPointResult search(const SolveControl& control) {
        InteriorPointResult result;
        newton_.residuals(point(), rest_);
        if (!rest_.finite() || !std::isfinite(model_.cost->value(point().x))) {
            result.stop = Stop::evaluation_error;
            return result;
        }
        int since_best = 0;
        for (;;) {
            const Errors now = errors();
            since_best = now.worst() < 0.9 * result.errors.worst() ? 0 : since_best + 1;
            if (now.worst() < result.errors.worst() || result.iterations == 0) {
                best_ = now_;
                result.errors = now;
            }
            if (limits_.keep_path) keep_place(now, result.path);
            if (result.errors.worst() <= limits_.tolerance) {
                result.stop = Stop::converged;
                polish_multipliers(result);
            } else if (only_rounding_is_left(result.errors, since_best)) {
                result.stop = Stop::converged;
                return_to_best();
                polish_multipliers(result);
            } else if (since_best > limits_.patience)
                result.stop = Stop::stagnated;
            else if (result.iterations >= limits_.max_iterations)
                result.stop = Stop::iteration_limit;
            else if (control.stopped())
                result.stop = Stop::interrupted;
            else if (limits_.deadline.passed())
                result.stop = Stop::time_limit;
            else if (limits_.suspicious && looks_infeasible())
                result.stop = Stop::suspect_infeasible;
            else if (limits_.suspicious && looks_unbounded())
                result.stop = Stop::suspect_unbounded;
            else if (take_step(result.stop)) {
                ++result.iterations;
                continue;
            }
            return result;
        }
    }
    /// All but the dual residual is as small as asked, and that has stopped to fall: in long sums rounding
    /// leaves more than the tolerance. Further steps and a new start would bring the same.
    [[nodiscard]] bool only_rounding_is_left(const Errors& best, int since_best) const {
        constexpr int waited = 2;
        constexpr double near = 100.0;
        return since_best >= waited && std::max(best.primal, best.gap) <= limits_.tolerance &&
               best.dual <= near * limits_.tolerance;
    }
    void return_to_best() {
        now_ = best_;
        newton_.residuals(point(), rest_);
    }
    /// One least-squares step from the given start, then gaps and multipliers shifted away from zero.
    bool initialise(const VectorXd& start) {
        // Measured: closer starts save linear problems one iteration in fifteen, but cost curved ones some.
        const double away = model_.kind == CostKind::linear ? 0.1 : 1.0;
        push_inside(start);
        Iterate& point = points_[now_];
        bool finite = true;
        if (!newton_.prepare(point, finite)) return finite;
        newton_.residuals(point, rest_);
        if (!rest_.dual.allFinite()) return false;
        rest_.dual = rest_.gradient;
        const VectorXd beyond = rest_.bound + point.gap.cwiseProduct(ranges_.present);
        rest_.bound = beyond.cwiseMin(0.0);  // how far the start is beyond each bound
        full_direction(ChangeRule::none, 0.0, rest_, direction_);
        const bool smooth = model_.kind == CostKind::smooth;
        if (direction_.finite) {
            if (!smooth) point.x += direction_.x;
            point.lambda += direction_.lambda;
        }
        newton_.residuals(point, rest_);
        for (Index b = 0; b < ranges_.sides(); ++b) {
            if (ranges_.present[b] == 0.0) continue;
            const bool of_variable = ranges_.source[static_cast<std::size_t>(b)].row < 0;
            point.gap[b] = std::max(rest_.bound[b] + point.gap[b], smooth && of_variable ? 0.0 : away);
            point.dual[b] = direction_.finite ? std::max(direction_.dual[b], away) : away;
        }
        return true;
    }
    /// Warm start near a point of the central path. Bounds that are new, or that the point violates now, get
    /// the gap and multiplier for its barrier parameter.
    bool resume(const CentralPoint& near) {
        // Of a new bound: sizes are of order 1. Products may differ from the path by this factor.
        constexpr double new_multiplier = 0.1, off_path = 10.0;
        Iterate& point = points_[now_];
        point.x = near.point.x;
        for (std::size_t k = 0; k < ranges_.equalities.size(); ++k)
            point.lambda[static_cast<Index>(k)] = near.point.lambda[ranges_.equalities[k]];
        point.gap.setZero(ranges_.sides());
        point.dual.setZero(ranges_.sides());
        newton_.residuals(point, rest_);
        if (!rest_.bound.allFinite()) return false;
        for (Index b = 0; b < ranges_.sides(); ++b) {
            point.gap[b] = 1.0;
            if (ranges_.present[b] == 0.0) continue;
            const RangeRows::Source& from = ranges_.source[static_cast<std::size_t>(b)];
            const double known = from.row < 0 ? 0.0 : -from.sign * near.point.lambda[from.row];
            point.gap[b] = std::max(rest_.bound[b], near.mu / std::max(known, new_multiplier));
            const double on_path = near.mu / point.gap[b];
            point.dual[b] = std::clamp(known, on_path / off_path, on_path * off_path);
        }
        return true;
    }
    /// Stores the point when the gap has decreased by a factor since the last one stored.
    void keep_place(const Errors& now, std::vector<CentralPoint>& path) const {
        constexpr double first = 1.0, closer = 0.5, last = 1e-9;
        const double before = path.empty() ? 2.0 * first : path.back().gap;
        if (now.gap > closer * before || now.gap < last || now.primal > now.gap) return;
        path.push_back(
            {{point().x, ranges_.row_multipliers(point().lambda, point().dual)}, rest_.mu, now.gap});
    }
    /// The start, moved off the active bounds of the variables.
    void push_inside(const VectorXd& start) {
        constexpr double far = 1e3, away = 1.0;  // scaled problem: everything is of order 1
        VectorXd& x = point().x;
        x = start.unaryExpr([&](double v) { return std::isfinite(v) ? std::clamp(v, -far, far) : 0.0; });
        for (Index j = 0; j < model_.variables(); ++j) {
            const double low = model_.x_lower[j], high = model_.x_upper[j];
            const double margin = std::min(away, 0.25 * (high - low));
            if (std::isfinite(low)) x[j] = std::max(x[j], low + margin);
            if (std::isfinite(high)) x[j] = std::min(x[j], high - margin);
        }
    }
    [[nodiscard]] Errors errors() const { return errors_of(point(), rest_); }
    [[nodiscard]] Errors errors_of(const Iterate& at, const Residuals& rest) const {
        return {std::max(largest(rest.equality), rest.largest_bound) / (1.0 + largest(at.x)),
                largest(rest.dual) / (model_.cost_unit + largest(rest.gradient)),
                static_cast<double>(ranges_.sides_present) * rest.mu / cost_size(at)};
    }
    [[nodiscard]] double cost_size(const Iterate& at) const {
        return std::max(model_.cost_unit, std::abs(model_.cost->value(at.x)));
    }
    bool take_step(Stop& reason) {
        bool finite = true;
        if (!newton_.prepare(point(), finite)) {
            reason = finite ? Stop::breakdown : Stop::evaluation_error;
            return false;
        }
        full_direction(ChangeRule::products, 0.0, rest_, affine_);
        if (!affine_.finite) {
            reason = Stop::breakdown;
            return false;
        }
        const double target = target_after_affine();
        full_direction(ChangeRule::corrected, target, rest_, direction_);
        if (!direction_.finite) std::swap(direction_, affine_);
        add_correctors(target);
        if (model_.kind == CostKind::smooth)
            return take_smooth_step(std::max(target, 0.1 * rest_.mu), reason);

        const double fraction = boundary_fraction();
        NewtonStep::Steps steps{direction_.primal_step(fraction), direction_.dual_step(fraction)};
        if (model_.kind == CostKind::quadratic)
            steps.primal = steps.dual = std::min(steps.primal, steps.dual);
        const std::size_t next = spare();
        newton_.advance(point(), direction_, steps, points_[next], rest_);
        now_ = next;
        if (rest_.finite()) return true;
        reason = Stop::evaluation_error;
        return false;
    }
    /// Backtracking on the norm of all residuals: first along the corrected direction, then along the plain
    /// Newton direction, for which a decrease is guaranteed.
    bool take_smooth_step(double target, Stop& reason) {
        constexpr double shrink = 0.6, decrease = 1e-3;
        bool evaluated = false;
        for (int attempt = 0; attempt < 2; ++attempt) {
            if (attempt == 1) full_direction(ChangeRule::products, target, rest_, direction_);
            if (!direction_.finite) continue;
            const double fraction = boundary_fraction();
            double step = std::min(direction_.primal_step(fraction), direction_.dual_step(fraction));
            const double before = merit(rest_, point());
            const std::size_t tried = spare();
            for (int k = 0; k < (attempt == 0 ? 4 : 40); ++k, step *= shrink) {
                newton_.advance(point(), direction_, {step, step}, points_[tried], tried_rest_);
                if (!tried_rest_.finite()) continue;
                evaluated = true;
                if (merit(tried_rest_, points_[tried]) > (1.0 - decrease * step) * before) continue;
                now_ = tried;
                std::swap(rest_, tried_rest_);
                return true;
            }
        }
        reason = evaluated ? Stop::breakdown : Stop::evaluation_error;
        return false;
    }
    /// Gondzio's centrality corrections, as long as they lengthen the step.
    void add_correctors(double target) {
        constexpr double low = 0.1, high = 10.0, reach = 0.3, worthwhile_gain = 0.02, long_enough = 0.95;
        const double fraction = boundary_fraction();
        double primal = direction_.primal_step(fraction), dual = direction_.dual_step(fraction);
        DirectionRequest request;
        request.base = &direction_;
        request.change.rule = ChangeRule::centrality;
        request.change.least = low * target;
        request.change.most = high * target;
        for (int k = 0; k < limits_.correctors && std::min(primal, dual) < long_enough; ++k) {
            request.change.primal_step = std::min(1.0, primal + reach);
            request.change.dual_step = std::min(1.0, dual + reach);
            request.change.gap_change = direction_.gap.data();
            request.change.dual_change = direction_.dual.data();
            newton_.direction(point(), request, trial_);
            if (!trial_.finite) return;
            const double trial_primal = trial_.primal_step(fraction), trial_dual = trial_.dual_step(fraction);
            if (trial_primal + trial_dual < primal + dual + worthwhile_gain) return;
            std::swap(direction_, trial_);
            primal = trial_primal;
            dual = trial_dual;
        }
    }
    /// The residual of the dual equations, removed by the multipliers alone: in a proof it is multiplied by
    /// the size of the box that contains an optimum. With the factorization of the last step, or, where that
    /// is too close to singular, with one for products g z of a middle size.
    void polish_multipliers(InteriorPointResult& result) {
        constexpr int most = 2;
        constexpr double rounding = 1e-15, negligible = 1e-12;
        bool centred = false;
        for (int k = 0; k < most && result.errors.dual > rounding;) {
            if (polish_once(result, centred)) {
                ++k;
                continue;
            }
            if (centred || result.errors.dual < negligible) return;
            centred = true;
        }
    }
    bool polish_once(InteriorPointResult& result, bool centred) {
        constexpr double most_shrunk = 0.9;
        const std::size_t next = spare();
        Iterate& polished = points_[next];
        polished = point();
        if (centred) centre(polished);
        // Linear costs: any factorization removes it.
        bool finite = true;
        const bool current = model_.kind == CostKind::linear && !centred;
        if (!current && !newton_.prepare(polished, finite)) return false;
        tried_rest_ = rest_;
        tried_rest_.equality.setZero();
        tried_rest_.bound.setZero();
        tried_rest_.mu = 0.0;
        full_direction(polished, ChangeRule::none, 0.0, tried_rest_, direction_);
        if (!direction_.finite) return false;
        polished.gap = point().gap;
        polished.lambda += direction_.lambda;
        polished.dual += direction_.dual.cwiseMax(-most_shrunk * polished.dual);
        newton_.residuals(polished, tried_rest_);
        const Errors now = errors_of(polished, tried_rest_);
        if (!(now.dual < result.errors.dual) || std::max(now.primal, now.gap) > limits_.tolerance)
            return false;
        now_ = best_ = next;
        std::swap(rest_, tried_rest_);
        result.errors = now;
        return true;
    }
    /// Gaps for which every product g z is that of a relative gap of `size`.
    void centre(Iterate& at) const {
        constexpr double size = 1e-4;
        const double mu = size * cost_size(at) / static_cast<double>(ranges_.sides_present);
        for (Index b = 0; b < ranges_.sides(); ++b)
            if (ranges_.present[b] != 0.0) at.gap[b] = mu / at.dual[b];
    }
    /// Mehrotra's choice: the better the affine direction, the smaller the centering parameter.
    [[nodiscard]] double target_after_affine() const {
        const double primal = affine_.primal_step(1.0), dual = affine_.dual_step(1.0);
        const auto sides = static_cast<double>(std::max<Index>(1, ranges_.sides_present));
        const double change =
            dual * affine_.gap_dual + primal * affine_.dual_gap + primal * dual * affine_.change_change;
        const double reached = rest_.mu + change / sides;
        const double ratio = rest_.mu > 0.0 ? std::clamp(reached / rest_.mu, 0.0, 1.0) : 0.0;
        return std::max(ratio * ratio * ratio, 1e-6) * rest_.mu;
    }
    [[nodiscard]] static double merit(const Residuals& rest, const Iterate& point) {
        return std::sqrt(rest.dual.squaredNorm() + rest.equality.squaredNorm() + rest.bound.squaredNorm() +
                         point.gap.cwiseProduct(point.dual).squaredNorm());
    }
    [[nodiscard]] bool looks_infeasible() const {
        const double value = rest_.dual_limit - point().lambda.dot(ranges_.equal_to);
        if (value <= 0.0) return false;
        double rest = 0.0;
        for (Index j = 0; j < rest_.dual.size(); ++j)
            rest = std::max(rest, std::abs(rest_.dual[j] - rest_.gradient[j]));
        return rest * (1.0 + largest(point().x)) < 1e-3 * value && errors().primal > 1e3 * limits_.tolerance;
    }
    [[nodiscard]] bool looks_unbounded() const {
        const double size = largest(point().x);
        return size > 1e7 && rest_.gradient.dot(point().x) < -1e-6 * size &&
               errors().dual > 1e3 * limits_.tolerance;
    }
    [[nodiscard]] double boundary_fraction() const { return std::clamp(1.0 - 10.0 * rest_.mu, 0.99, 0.9995); }
    [[nodiscard]] Iterate& point() { return points_[now_]; }
    [[nodiscard]] const Iterate& point() const { return points_[now_]; }
    /// One that is neither the current nor the best.
    [[nodiscard]] std::size_t spare() const {
        std::size_t place = 0;
        while (place == now_ || place == best_) ++place;
        return place;
    }
    void full_direction(ChangeRule rule, double target, const Residuals& residuals, Direction& out) {
        full_direction(point(), rule, target, residuals, out);
    }
    void full_direction(const Iterate& at, ChangeRule rule, double target, const Residuals& residuals,
                        Direction& out) {
        DirectionRequest request;
        request.residuals = &residuals;
        request.change.rule = rule;
        request.change.target = target;
        request.change.gap_change = affine_.gap.data();
        request.change.dual_change = affine_.dual.data();
        newton_.direction(at, request, out);
    }

    const ConvexModel& model_;
    const InteriorPointLimits& limits_;
    RangeRows ranges_;
    NewtonStep newton_;
    std::array<Iterate, 3> points_;
    std::size_t now_ = 0, best_ = 0;  ///< in points_
    Residuals rest_, tried_rest_;
    Direction affine_, direction_, trial_;
};

/// Converts the result of the smaller model to the given one.
InteriorPointResult restored(InteriorPointResult result, const PathReduction& reduction) {
    const auto restore = [&](PrimalDualPoint& point) {
        point = {reduction.restored(point.x), reduction.restored_multipliers(point.lambda)};
    };
    if (result.has_point()) restore(result.best);
    for (CentralPoint& place : result.path) restore(place.point);
    return result;
}

}  // namespace

InteriorPointResult interior_point(const ConvexModel& model, const VectorXd& start,
                                   const InteriorPointLimits& limits, const SolveControl& control) {
    const PathReduction reduction(model, start);
    return restored(Iteration(reduction.model(), limits).run(reduction.reduced(start), control), reduction);
}

InteriorPointResult interior_point(const ConvexModel& model, const CentralPoint& near,
                                   const InteriorPointLimits& limits, const SolveControl& control) {
    const PathReduction reduction(model, near.point.x);
    CentralPoint begin = near;
    begin.point = {reduction.reduced(near.point.x), reduction.reduced_multipliers(near.point.lambda)};
    return restored(Iteration(reduction.model(), limits).run(begin, control), reduction);
}

}  // namespace camopt::structured
